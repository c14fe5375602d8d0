//! Does the tool hit anything at a pose, or on a short motion? The beam's ray, its cone and the head, against the
//! part and the clamps.
//!
//! These questions serve detection, correction and verification alike; `checker` shares no code with them.

mod beam_interference;
mod blocker;
#[cfg(test)]
mod motions_for_tests;
mod ray;
mod separated;
mod skin;
mod swept_beam;
mod tool_body;

pub use beam_interference::BeamInterference;
pub use blocker::{Blocker, Obstruction, ToolBody};
pub use ray::GRAZE_MM;
pub(super) use tool_body::Conflict;
pub use tool_body::FAR_MM;

use nalgebra::{Point3, Vector3};

impl BeamInterference<'_> {
    /// Whether beam and head meet nothing, the spot in the point `p` of the surface, along the unit axis `a`; with a
    /// contact tool, whether it touches nothing but the skin in its contact, the foot of its axis in `p`.
    pub fn is_free(&self, p: &Point3<f64>, a: &Vector3<f64>) -> bool {
        self.check().is_ok() && (!self.has_ray() || self.is_ray_free(p, a)) && self.is_body_free(p, a)
    }

    /// The nearest thing in the way of the ray, or else what is in the way of cone and head.
    pub fn blocker(&self, p: &Point3<f64>, a: &Vector3<f64>) -> Option<Blocker> {
        self.check().ok()?;
        let by_ray = if self.has_ray() { self.ray_blocker(p, a) } else { None };
        by_ray.or_else(|| self.body_blocker(p, a))
    }
}
