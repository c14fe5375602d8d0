//! The motion between two targets: the point goes straight, the axis turns at constant rate, and
//! the spot is where that axis meets the part.
//!
//! The motion is cut in halves until a piece is clear by more than anything on it can move, or is
//! so short that its middle stands for it. So a fin however thin between two free targets is met.

use super::interference::Beam;
use crate::part::angle;
use nalgebra::{Point3, Vector3};

/// On a piece no point of the beam moves further than this, mm, before its middle is looked at: the
/// beam's own margin (0.02 mm) then covers the piece from end to end.
const PIECE_MM: f64 = 0.02;

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

/// Whether the beam meets nothing between two targets. `sag_mm`: how far the part may lie from the
/// chord between them.
pub fn is_free(beam: &Beam<'_>, from: &Pose, to: &Pose, sag_mm: f64) -> bool {
    hit(beam, from, to, sag_mm).is_none()
}

/// A share of the way at which the beam hits something, if it does.
pub fn hit(beam: &Beam<'_>, from: &Pose, to: &Pose, sag_mm: f64) -> Option<f64> {
    hit_between(beam, (from, 0.0), (to, 1.0), sag_mm)
}

fn hit_between(beam: &Beam<'_>, from: (&Pose, f64), to: (&Pose, f64), sag_mm: f64) -> Option<f64> {
    let middle = midway(from.0, to.0, 0.5);
    let reach_mm = beam.conflict(from.0, to.0, &middle, sag_mm)?;
    let half_turn = 0.5 * angle::between_deg(&from.0.a, &to.0.a).to_radians();
    let moved_mm = (to.0.p - from.0.p).norm() + 2.0 * reach_mm * libm::sin(half_turn);
    let t = 0.5 * (from.1 + to.1);
    if moved_mm <= PIECE_MM {
        let spot = if sag_mm > 1e-9 { beam.spot(&middle.p, &middle.a, 2.0 * sag_mm + 1e-3) } else { middle.p };
        return (!beam.is_free(&spot, &middle.a)).then_some(t);
    }
    hit_between(beam, from, (&middle, t), sag_mm).or_else(|| hit_between(beam, (&middle, t), to, sag_mm))
}
