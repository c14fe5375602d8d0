//! Whether a contact tool rests on a facet or stands beside it, and on which side of it the tool is.

use crate::beam::contact_tool::contact_body::REST_COSINE;
use crate::beam::frustum::PlacedFrustum;
use crate::part::angle;
use nalgebra::{Point3, Vector3};

/// How far a body stands over a facet that it rests on, mm: the shortest way from the facet to it goes up along the
/// axis. `None`: it stands beside the facet, or reaches through a wall.
pub(super) fn rest(body: &PlacedFrustum, a: &Vector3<f64>, corners: &[Point3<f64>; 3]) -> Option<f64> {
    let way = body.separation(corners);
    let mm = way.norm();
    // Where it reaches into the facet, or so near to that that the way is rounding, no way tells, and the facet's own slope
    // does.
    let up = if mm > 1e-6 { way.dot(a) / mm } else { angle::unit(normal(corners))?.dot(a).abs() };
    (up >= REST_COSINE).then_some(mm)
}

/// How far a body that is mounted over the skin stands over a facet, mm: the facet lies along the skin in front of it, or the
/// body rests on it. Of a level skin some facets lie beside what stands over others. `None`: it stands beside a wall.
pub(super) fn over(body: &PlacedFrustum, a: &Vector3<f64>, corners: &[Point3<f64>; 3]) -> Option<f64> {
    let lies_below = || is_before(body, a, corners, 0.0).then(|| body.separation(corners).norm());
    rest(body, a, corners).or_else(lies_below)
}

/// Whether all of a body is farther than `keeps_mm` in front of the plane of a facet that it lies along.
pub(super) fn is_before(body: &PlacedFrustum, a: &Vector3<f64>, corners: &[Point3<f64>; 3], keeps_mm: f64) -> bool {
    let n = angle::unit(normal(corners)).filter(|n| n.dot(a) >= REST_COSINE);
    n.is_some_and(|n| body.height_over(&corners[0], &n) > keeps_mm)
}

fn normal(corners: &[Point3<f64>; 3]) -> Vector3<f64> {
    (corners[1] - corners[0]).cross(&(corners[2] - corners[0]))
}
