//! Cuts by box, plane and brush.

use super::{Keep, Outcome, kept};
use crate::progress::{Cancelled, Progress};
use crate::scan::cloud::Cloud;
use crate::scan::neighbours::Neighbours;
use nalgebra::{Point3, Vector3};

pub(super) fn by_box(
    cloud: &Cloud,
    min: &[f64; 3],
    max: &[f64; 3],
    keep: Keep,
    progress: &Progress,
) -> Result<Outcome, Cancelled> {
    kept(cloud.len(), progress, |i| {
        let p = cloud.point(i);
        let inside = (0..3).all(|k| min[k] <= p[k] && p[k] <= max[k]);
        inside == (keep == Keep::Inside)
    })
}

pub(super) fn by_plane(
    cloud: &Cloud,
    point: &[f64; 3],
    normal: &[f64; 3],
    progress: &Progress,
) -> Result<Outcome, Cancelled> {
    let (point, normal) = (Point3::from(*point), Vector3::from(*normal));
    if !(normal.norm_squared() > 0.0 && point.coords.norm_squared().is_finite()) {
        return Ok(Outcome::Unchanged);
    }
    kept(cloud.len(), progress, |i| (cloud.point(i) - point).dot(&normal) >= 0.0)
}

/// A stroke has many middles: each point looks for the nearest one.
pub(super) fn erased(
    cloud: &Cloud,
    centres: &[[f64; 3]],
    radius_mm: f64,
    progress: &Progress,
) -> Result<Outcome, Cancelled> {
    let centres: Vec<Point3<f64>> = centres.iter().copied().map(Point3::from).collect();
    let brush = Neighbours::new(&Cloud::of_points(&centres), progress)?;
    kept(cloud.len(), progress, |i| brush.nearest_one(&cloud.point(i), radius_mm).is_none())
}
