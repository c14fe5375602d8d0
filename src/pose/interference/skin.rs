//! What of the part a contact tool lies along, and on which side of it the tool is.

use crate::beam::contact_tool::contact_body::SKIN_COSINE;
use crate::beam::frustum::PlacedFrustum;
use crate::part::angle;
use nalgebra::{Point3, Vector3};

/// Whether a contact tool of this axis lies along a facet; it may touch those. All others are walls.
pub(super) fn is_skin(a: &Vector3<f64>, corners: &[Point3<f64>; 3]) -> bool {
    let n = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
    n.dot(a).abs() >= SKIN_COSINE * n.norm()
}

/// Whether a body is farther than `keeps_mm` in front of a facet's plane, all of it.
pub(super) fn is_before(body: &PlacedFrustum, corners: &[Point3<f64>; 3], keeps_mm: f64) -> bool {
    let n = angle::unit((corners[1] - corners[0]).cross(&(corners[2] - corners[0])));
    n.is_some_and(|n| body.height_over(&corners[0], &n) > keeps_mm)
}
