//! The rigid motion that brings points nearest to others (Kabsch), without a mirror.
//!
//! It fits what it is given: whether the points can tell a rotation at all is for the caller to see.

use nalgebra::{Isometry3, Matrix3, Point3, Quaternion, Rotation3, Translation3, UnitQuaternion, Vector3};

/// A point, and where it ought to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedPair {
    /// The point.
    pub from: Point3<f64>,
    /// Where the motion ought to bring it.
    pub onto: Point3<f64>,
    /// How much it counts; above 0.
    pub weight: f64,
}

/// The motion with the least weighted sum of squared distances; `None` where none can be computed
/// (no points, or such as are no numbers). Points on one line leave the turn about it open: some
/// turn is taken.
pub fn rigid(pairs: &[PlacedPair]) -> Option<Isometry3<f64>> {
    let share = 1.0 / pairs.iter().map(|p| p.weight).sum::<f64>();
    let middle = |of: fn(&PlacedPair) -> Point3<f64>| {
        pairs.iter().fold(Vector3::zeros(), |s: Vector3<f64>, p| s + of(p).coords * p.weight) * share
    };
    let (from, onto) = (middle(|p| p.from), middle(|p| p.onto));
    let places = || pairs.iter().map(|p| (p.from.coords - from, p.onto.coords - onto, p.weight));
    let both = places().fold(Matrix3::zeros(), |sum, (f, o, weight)| sum + f * o.transpose() * (weight * share));
    if !both.iter().chain(&from).chain(&onto).all(|x: &f64| x.is_finite()) {
        return None;
    }
    let svd = both.svd(true, true);
    let (u, v) = (svd.u?, svd.v_t?.transpose());
    // The least singular value may turn its sign: what would be a mirror becomes a rotation.
    let sign = if (v * u.transpose()).determinant() < 0.0 { -1.0 } else { 1.0 };
    let least = svd.singular_values.imin();
    let signs = Vector3::from_fn(|k, _| if k == least { sign } else { 1.0 });
    let rotation = Rotation3::from_matrix_unchecked(v * Matrix3::from_diagonal(&signs) * u.transpose());
    let mut rotation = UnitQuaternion::from_rotation_matrix(&rotation);
    // Where the points are nearly on a line the decomposition loses digits: least squares win them back.
    for _ in 0..2 {
        rotation = sharpened(places(), &rotation);
    }
    Some(Isometry3::from_parts(Translation3::from(onto - rotation * from), rotation))
}

/// A rotation with the small turn that brings it nearer to the best one (Gauss and Newton).
fn sharpened(
    places: impl Iterator<Item = (Vector3<f64>, Vector3<f64>, f64)>,
    rotation: &UnitQuaternion<f64>,
) -> UnitQuaternion<f64> {
    let (mut inertia, mut moment) = (Matrix3::zeros(), Vector3::zeros());
    for (from, onto, weight) in places {
        let q = rotation * from;
        inertia += (Matrix3::from_diagonal_element(q.norm_squared()) - q * q.transpose()) * weight;
        moment += q.cross(&(onto - q)) * weight;
    }
    let turn = inertia.try_inverse().map_or_else(Vector3::zeros, |inverse| inverse * moment);
    UnitQuaternion::new_normalize(Quaternion::from_parts(1.0, 0.5 * turn)) * rotation
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Points that were moved as one tell their motion, whatever they weigh.
        #[test]
        fn a_motion_is_found_again(turn in prop::array::uniform3(-3.0..3.0f64), shift in prop::array::uniform3(-90.0..90.0f64),
                                   weights in prop::array::uniform4(0.1..10.0f64)) {
            let motion = Isometry3::new(Vector3::from(shift), Vector3::from(turn));
            let corners = [[0.0, 0.0, 0.0], [30.0, 0.0, 5.0], [0.0, 20.0, -4.0], [7.0, 9.0, 11.0]].map(Point3::from);
            let pairs: Vec<PlacedPair> = corners.iter().zip(weights)
                .map(|(p, weight)| PlacedPair { from: *p, onto: motion * p, weight }).collect();
            let found = rigid(&pairs).expect("these points tell a motion");
            for p in &corners {
                prop_assert!((found * p - motion * p).norm() < 1e-9);
            }
        }
    }

    #[test]
    fn a_mirror_is_no_motion_and_nothing_tells_none() {
        let axes = [Vector3::x(), Vector3::y() * 2.0, Vector3::z() * 3.0, Vector3::zeros()].map(Point3::from);
        let mirrored = |p: &Point3<f64>| Point3::new(-p.x, p.y, p.z);
        let pairs: Vec<PlacedPair> =
            axes.iter().map(|p| PlacedPair { from: *p, onto: mirrored(p), weight: 1.0 }).collect();
        let found = rigid(&pairs).expect("a nearest motion exists");
        assert!((found.rotation.to_rotation_matrix().matrix().determinant() - 1.0).abs() < 1e-12);
        assert_eq!(rigid(&[]), None);
    }
}
