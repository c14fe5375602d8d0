//! The box around points.

use nalgebra::Point3;

/// The box around points; empty input gives a box of zero size at the origin.
pub fn bounds_of(points: impl Iterator<Item = Point3<f64>>) -> (Point3<f64>, Point3<f64>) {
    points
        .map(|p| (p, p))
        .reduce(|(lo, hi), (p, _)| (lo.inf(&p), hi.sup(&p)))
        .unwrap_or((Point3::origin(), Point3::origin()))
}
