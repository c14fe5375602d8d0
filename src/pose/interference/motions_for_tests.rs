//! Motions of a beam that tests of the bounds about it are made with.

use crate::part::angle;
use crate::pose::Pose;
use nalgebra::{Point3, Vector3};

pub(super) fn point(c: [f64; 3]) -> Point3<f64> {
    Point3::from(Vector3::from(c))
}

/// Beginning, middle and end of a motion from `p` on by `step`, the axis from along `a` to along `a + turn`; `None`: one of
/// these is no direction.
pub(super) fn motion(p: [f64; 3], step: [f64; 3], a: [f64; 3], turn: [f64; 3]) -> Option<[Pose; 3]> {
    let from = Pose { p: point(p), a: angle::unit(Vector3::from(a))? };
    let to = Pose { p: from.p + Vector3::from(step), a: angle::unit(Vector3::from(a) + Vector3::from(turn))? };
    Some([from, from.midway(&to, 0.5), to])
}
