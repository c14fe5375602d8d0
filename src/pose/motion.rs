//! The motion between two targets: the point goes straight, the axis turns at constant rate, and
//! the spot is where that axis meets the part.

use super::interference::Beam;
use crate::part::angle;
use nalgebra::{Point3, Vector3};

/// Poses looked at are no further apart than this: ten of them to P1's spot of 1 mm.
const STEP_MM: f64 = 0.1;
/// Nor turned by more than this: 0.9 mm at the far end of a beam of 200 mm.
const STEP_DEG: f64 = 0.25;

/// A beam: point on the part (or on a chord of it) and unit axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Point, mm.
    pub p: Point3<f64>,
    /// Axis.
    pub a: Vector3<f64>,
}

/// The pose at a share `t` of the way.
pub fn midway(from: &Pose, to: &Pose, t: f64) -> Pose {
    Pose { p: from.p + (to.p - from.p) * t, a: angle::slerp(&from.a, &to.a, t) }
}

/// Shares of the way at which the motion is looked at, ends excluded.
pub fn shares(from: &Pose, to: &Pose) -> impl Iterator<Item = f64> + use<> {
    let steps = ((to.p - from.p).norm() / STEP_MM).max(angle::between_deg(&from.a, &to.a) / STEP_DEG).ceil().max(1.0);
    (1..steps as usize).map(move |i| i as f64 / steps)
}

/// Whether the beam meets nothing between two targets. `sag_mm`: how far the part may lie from the
/// chord between them.
pub fn is_free(beam: &Beam<'_>, from: &Pose, to: &Pose, sag_mm: f64) -> bool {
    first_hit(beam, from, to, sag_mm).is_none()
}

/// The first share of the way at which the beam meets something.
pub fn first_hit(beam: &Beam<'_>, from: &Pose, to: &Pose, sag_mm: f64) -> Option<f64> {
    let arc = angle::Arc::new(&from.a, &to.a);
    shares(from, to).find(|&t| {
        let (p, a) = (from.p + (to.p - from.p) * t, arc.at(t));
        let spot = if sag_mm > 1e-9 { beam.spot(&p, &a, 2.0 * sag_mm + 1e-3) } else { p };
        !beam.is_free(&spot, &a)
    })
}
