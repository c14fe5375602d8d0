//! Where the spot of a path frame should be, and where its beam meets the part. Planner and verification ask both.

use crate::pose::BeamInterference;
use nalgebra::{Isometry3, Point3, Vector3};

/// The beam is looked at from here on, mm above the spot: nearer, the facets that the spot stands on
/// answer at random where the spot is a rounding off.
pub const FROM_MM: f64 = 0.1;

/// Where the spot of a path frame should be: D below the focus, on the part or on the chord between two
/// targets.
pub fn planned_spot(part_from_focus: &Isometry3<f64>, defocus_mm: f64) -> Point3<f64> {
    Point3::from(part_from_focus.translation.vector) - part_from_focus.rotation * Vector3::z() * defocus_mm
}

/// Where the beam of a path frame stands on the part, and its axis. The part is looked for no farther than
/// `window_mm` from where the spot should be: past a rim the axis meets what lies beneath.
pub fn on_part(
    beam: &BeamInterference<'_>,
    part_from_focus: &Isometry3<f64>,
    defocus_mm: f64,
    window_mm: f64,
) -> (Point3<f64>, Vector3<f64>) {
    let a = part_from_focus.rotation * Vector3::z();
    (beam.spot(&planned_spot(part_from_focus, defocus_mm), &a, window_mm), a)
}
