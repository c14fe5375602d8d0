//! Levenberg and Marquardt's steps over the camera and the target together.
//!
//! Small turns are put on from the right, so the derivatives are those at nothing; they are taken by central differences,
//! which at 1e-6 are good to ten digits here.

use super::turns::{rotation_of, turn};
use nalgebra::{Isometry3, SMatrix, SVector, Translation3, Vector3};

/// Noise of a target's pose as depth cameras have it: turns in degrees, shifts in mm. Only their ratio moves the result.
const NOISE_DEG: f64 = 0.1;
const NOISE_MM: f64 = 0.3;
/// Steps; from Park and Martin's guess four to eight do.
const STEPS: usize = 60;
/// Width of a difference: radians, and mm over a hundred.
const DIFFERENCE: f64 = 1e-6;
/// A step with less of this does nothing: radians and mm.
const STILL: f64 = 1e-11;

/// Both unknown frames.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solved {
    pub(super) mount_from_camera: Isometry3<f64>,
    pub(super) other_from_target: Isometry3<f64>,
}

type Step = SVector<f64, 12>;

impl Solved {
    fn stepped(&self, step: &Step) -> Solved {
        let moved = |of: &Isometry3<f64>, k: usize| {
            let by = Isometry3::from_parts(
                Translation3::from(Vector3::new(step[k + 3], step[k + 4], step[k + 5])),
                rotation_of(&Vector3::new(step[k], step[k + 1], step[k + 2])),
            );
            let mut of = of * by;
            of.rotation.renormalize();
            of
        };
        Solved {
            mount_from_camera: moved(&self.mount_from_camera, 0),
            other_from_target: moved(&self.other_from_target, 6),
        }
    }

    /// Turn and shift that are left over in a pose, in units of their noise.
    fn left_over(&self, [g, c]: &[Isometry3<f64>; 2]) -> SVector<f64, 6> {
        let off = self.other_from_target.inverse() * g * self.mount_from_camera * c;
        let (turn, shift) = (turn(&off.rotation) / NOISE_DEG.to_radians(), off.translation.vector / NOISE_MM);
        SVector::from([turn.x, turn.y, turn.z, shift.x, shift.y, shift.z])
    }

    fn squares(&self, pairs: &[[Isometry3<f64>; 2]]) -> f64 {
        pairs.iter().map(|p| self.left_over(p).norm_squared()).sum()
    }
}

/// The frames with the least squares, from a guess of the camera.
pub(super) fn refined(pairs: &[[Isometry3<f64>; 2]], mount_from_camera: &Isometry3<f64>) -> Option<Solved> {
    let [g, c] = pairs.first()?;
    let mut at = Solved { mount_from_camera: *mount_from_camera, other_from_target: g * mount_from_camera * c };
    let mut squares = at.squares(pairs);
    let mut damping = 1e-3;
    for _ in 0..STEPS {
        let (mut left, mut right) = (SMatrix::<f64, 12, 12>::zeros(), Step::zeros());
        for pair in pairs {
            let mut slopes = SMatrix::<f64, 6, 12>::zeros();
            for k in 0..12 {
                let width = if k % 6 < 3 { DIFFERENCE } else { 100.0 * DIFFERENCE };
                let step = Step::ith(k, width);
                let difference = at.stepped(&step).left_over(pair) - at.stepped(&-step).left_over(pair);
                slopes.set_column(k, &(difference / (2.0 * width)));
            }
            left += slopes.transpose() * slopes;
            right -= slopes.transpose() * at.left_over(pair);
        }
        let damped = left + SMatrix::from_diagonal(&(left.diagonal() * damping));
        let step = damped.cholesky()?.solve(&right);
        if !step.iter().all(|x| x.is_finite()) {
            return None;
        }
        let next = at.stepped(&step);
        let after = next.squares(pairs);
        if after <= squares {
            (at, squares) = (next, after);
            damping = (0.1 * damping).max(1e-12);
        } else {
            damping *= 10.0;
        }
        if step.amax() < STILL || damping > 1e9 {
            break;
        }
    }
    squares.is_finite().then_some(at)
}
