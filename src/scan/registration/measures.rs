//! How much of scan and model lie on each other.

use super::samples::Sample;
use super::surface::Row;
use rayon::prelude::*;

/// A sample is covered by a point within so many voxels (the next voxel's, wherever in it), and with a normal within 60°
/// of its own: the other side of a thin wall is another surface.
const REACH: f64 = 1.5;
const LEAST_COSINE: f64 = 0.5;

/// The share of the points that take part which are nearer to the model than `within_mm`; 0 without points.
pub(super) fn overlap(rows: &[Row], within_mm: f64) -> f64 {
    let all = rows.iter().filter(|r| r.distance_mm.is_finite()).count();
    rows.iter().filter(|r| r.distance_mm < within_mm).count() as f64 / all.max(1) as f64
}

/// The share of the model's samples with a point near; 0 without samples. A point's normal is that of its foot.
pub(super) fn coverage(samples: &[Sample], rows: &[Row], cell_mm: f64) -> f64 {
    let reach_mm = REACH * cell_mm;
    let mut near: Vec<&Row> = rows.iter().filter(|r| r.distance_mm < reach_mm).collect();
    near.sort_by(|a, b| a.at.x.total_cmp(&b.at.x));
    let is_covered = |sample: &&Sample| {
        let from = near.partition_point(|r| r.at.x < sample.place.x - reach_mm);
        near[from..].iter().take_while(|r| r.at.x <= sample.place.x + reach_mm).any(|r| {
            (r.at - sample.place).norm_squared() <= reach_mm * reach_mm && r.normal.dot(&sample.normal) >= LEAST_COSINE
        })
    };
    samples.par_iter().filter(is_covered).count() as f64 / samples.len().max(1) as f64
}
