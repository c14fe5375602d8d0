//! A pose of the beam: spot and axis. The turn about the axis is free.

use crate::part::angle;
use nalgebra::{Point3, Vector3};

/// The beam at a spot: a point on the part (or on a chord of it) and a unit axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Point, mm.
    pub p: Point3<f64>,
    /// Axis.
    pub a: Vector3<f64>,
}

impl Pose {
    /// The pose at a share `t` of the way to another: the point goes straight, the axis turns at constant rate.
    #[inline]
    pub fn midway(&self, to: &Pose, t: f64) -> Pose {
        Pose { p: self.p + (to.p - self.p) * t, a: angle::slerp(&self.a, &to.a, t) }
    }

    /// Sine of half the angle between the axes: half the chord of two unit vectors.
    #[inline]
    pub fn sine_of_half_turn(&self, to: &Pose) -> f64 {
        0.5 * (to.a - self.a).norm()
    }

    /// Cosine of half the angle between the axes.
    #[inline]
    pub fn cosine_of_half_turn(&self, to: &Pose) -> f64 {
        0.5 * (to.a + self.a).norm()
    }
}
