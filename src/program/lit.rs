//! The beam on a lit move as a controller makes it: between two targets the flange goes straight, and
//! the spot a little beside its line. Planner and verification look at it in the same way.

use crate::pose::Beam;
use nalgebra::{Isometry3, Point3, Vector3};

/// The beam is looked at from here on, mm above the spot: nearer, the facets that the spot stands on
/// answer at random where the spot is a rounding off.
pub const FROM_MM: f64 = 0.1;
/// Poses looked at on a move, its end included.
pub const LOOKS: usize = 4;
/// The spot is where the axis meets the part, so far from where it should be at most, mm.
const WINDOW_MM: f64 = 1.0;

/// Where the beam of a path frame stands on the part, and its axis.
pub fn spot(beam: &Beam<'_>, part_from_focus: &Isometry3<f64>, defocus_mm: f64) -> (Point3<f64>, Vector3<f64>) {
    let a = part_from_focus.rotation * Vector3::z();
    let near = Point3::from(part_from_focus.translation.vector) - a * defocus_mm;
    (beam.spot(&near, &a, WINDOW_MM), a)
}

/// The first place on a move, given over 0 to 1 as path frames, whose beam goes through a facet.
pub fn hit(
    beam: &Beam<'_>,
    defocus_mm: f64,
    part_from_focus: impl Fn(f64) -> Isometry3<f64>,
) -> Option<(Point3<f64>, u32)> {
    (1..=LOOKS).find_map(|k| {
        let (spot, a) = spot(beam, &part_from_focus(k as f64 / LOOKS as f64), defocus_mm);
        beam.passes_through(&spot, &a, FROM_MM).map(|facet| (spot, facet))
    })
}
