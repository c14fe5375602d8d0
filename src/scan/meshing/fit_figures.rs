//! How far the points lie off the mesh that was made of them.

use crate::part::{Bvh, Mesh};
use crate::progress::{Cancelled, Progress};
use crate::scan::cloud::Cloud;
use rayon::prelude::*;

/// Points measured at most: a root mean square of 20 000 is sure to 0.5 %.
const SAMPLE: usize = 20_000;
/// A point further off, in cells, is a stray that shares its voxel with others.
const FAR: f64 = 2.0;
/// Points of a piece of work.
const PIECE: usize = 64;

/// Mean and root mean square of the distances of an even sample of these points, mm; 0 without any.
pub(super) fn distances_mm(
    mesh: &Mesh,
    cloud: &Cloud,
    points: &[u32],
    cell_mm: f64,
    progress: &Progress,
) -> Result<[f64; 2], Cancelled> {
    let bvh = Bvh::built(mesh, progress)?;
    let looked = points.len().min(SAMPLE);
    let sample: Vec<u32> = (0..looked).map(|i| points[i * points.len() / looked]).collect();
    let pieces: Vec<Vec<f64>> = sample
        .par_chunks(PIECE)
        .map(|piece| {
            progress.check()?;
            let closest = |&i: &u32| bvh.closest(&cloud.point(i as usize), FAR * cell_mm);
            Ok(piece.iter().filter_map(closest).map(|c| c.distance_mm).collect())
        })
        .collect::<Result<_, Cancelled>>()?;
    let all = pieces.concat();
    let share = 1.0 / all.len().max(1) as f64;
    Ok([all.iter().sum::<f64>() * share, (all.iter().map(|d| d * d).sum::<f64>() * share).sqrt()])
}
