//! Outliers by statistical distance (Rusu et al., "Towards 3D point cloud based object maps for household
//! environments", 2008; as in PCL, the point itself is none of its neighbours).
//!
//! It finds single points in the air. A cluster of more than `neighbours` points far from the part is none to it.

use super::{Outcome, kept};
use crate::progress::{Cancelled, Progress};
use crate::scan::cloud::Cloud;
use crate::scan::neighbours::Neighbours;

/// Keeps the points whose mean distance to their neighbours is not more than `sigma` standard deviations above the mean
/// of all points.
pub(super) fn without(cloud: &Cloud, neighbours: usize, sigma: f64, progress: &Progress) -> Result<Outcome, Cancelled> {
    let tree = Neighbours::new(cloud, progress)?;
    let means = tree.map_nearest(neighbours, progress, |_, near| {
        let sum: f64 = near.iter().map(|n| f64::from(n.squared.sqrt())).sum();
        sum / (near.len().max(1) as f64)
    })?;
    let count = means.len() as f64;
    let mean = means.iter().sum::<f64>() / count;
    let variance = means.iter().map(|m| (m - mean) * (m - mean)).sum::<f64>() / (count - 1.0);
    let limit = mean + sigma * variance.sqrt();
    // No limit (one point, no number for sigma): all are kept.
    kept(means.len(), progress, |i| limit.is_nan() || means[i] <= limit)
}
