//! Whether poses can tell a camera, and a first guess of it: Park and Martin's rotation, then the place by least squares.

use super::error::HandEyeError;
use super::turns::turn;
use crate::fit::{self, PlacedPair};
use nalgebra::{Isometry3, Matrix3, Point3, SymmetricEigen, Translation3, Vector3};

/// Where no pose is turned against another by this, nothing is told: within ±5° a camera comes out 5 mm off, and closed
/// forms 28 mm.
const LEAST_TURN_DEG: f64 = 15.0;
/// Axes of turns have to differ: the second singular value of the unit axes, over the root of their number. Axes within 2°
/// of one another have 0.035 at most, two axes that are 8° apart 0.07; poses turned at will have about 0.5.
const LEAST_SPREAD: f64 = 0.1;
/// Relative turns below this tell no axis, degrees: noise of 0.1° would turn it by 1°.
const NO_AXIS_DEG: f64 = 5.0;

/// The motion of the mount and that of the camera between two poses: A X = X B.
pub(super) struct Motion {
    a: Isometry3<f64>,
    b: Isometry3<f64>,
}

/// Motions between all pairs of poses: neighbours alone might hardly turn.
pub(super) fn motions(pairs: &[[Isometry3<f64>; 2]]) -> Vec<Motion> {
    let mut all = Vec::with_capacity(pairs.len() * pairs.len() / 2);
    for (i, [g, c]) in pairs.iter().enumerate() {
        for [h, d] in pairs.iter().skip(i + 1) {
            all.push(Motion { a: h.inverse() * g, b: d * c.inverse() });
        }
    }
    all
}

/// Whether turns are large enough and of more than one axis.
pub(super) fn check_turns(motions: &[Motion]) -> Result<(), HandEyeError> {
    let turns: Vec<Vector3<f64>> = motions.iter().map(|m| turn(&m.a.rotation)).collect();
    if !turns.iter().all(|t| t.norm().is_finite()) {
        return Err(HandEyeError::NoFit);
    }
    let most_deg = turns.iter().map(|t| t.norm().to_degrees()).fold(0.0, f64::max);
    if most_deg < LEAST_TURN_DEG {
        return Err(HandEyeError::SmallTurns { most_deg });
    }
    let axes = turns.iter().filter(|t| t.norm().to_degrees() >= NO_AXIS_DEG).map(|t| t.normalize());
    let (sum, count) = axes.fold((Matrix3::zeros(), 0.0), |(m, n), axis| (m + axis * axis.transpose(), n + 1.0));
    // Singular values of the stacked axes over √N are the roots of these eigenvalues.
    let eigen = SymmetricEigen::new(sum / count);
    let mut values: Vec<f64> = eigen.eigenvalues.iter().map(|v| v.max(0.0).sqrt()).collect();
    values.sort_by(f64::total_cmp);
    if values.get(1).is_none_or(|second| *second < LEAST_SPREAD) {
        let axis = eigen.eigenvectors.column(eigen.eigenvalues.imax());
        return Err(HandEyeError::OneAxis { axis: [axis[0], axis[1], axis[2]] });
    }
    Ok(())
}

/// The rotation that lays the axes of B on those of A, and the place that fits with it.
pub(super) fn park_martin(motions: &[Motion]) -> Option<Isometry3<f64>> {
    // log A = X log B: rotations of points about the origin, which a motion with their mirror images keeps there.
    let on = |m: &Motion, sign: f64| {
        let (b, a) = (turn(&m.b.rotation) * sign, turn(&m.a.rotation) * sign);
        PlacedPair { from: Point3::from(b), onto: Point3::from(a), weight: 1.0 }
    };
    let pairs: Vec<PlacedPair> = motions.iter().flat_map(|m| [on(m, 1.0), on(m, -1.0)]).collect();
    let rotation = fit::rigid(&pairs)?.rotation;
    // (R_A − 1) t_X = R_X t_B − t_A.
    let (mut left, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for m in motions {
        let row = m.a.rotation.to_rotation_matrix().into_inner() - Matrix3::identity();
        left += row.transpose() * row;
        right += row.transpose() * (rotation * m.b.translation.vector - m.a.translation.vector);
    }
    let place = left.cholesky()?.solve(&right);
    place.iter().all(|x| x.is_finite()).then(|| Isometry3::from_parts(Translation3::from(place), rotation))
}
