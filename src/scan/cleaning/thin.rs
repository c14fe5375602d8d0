//! Voxel thinning: one point for each voxel, the mean of those in it.
//!
//! Voxels count from the lowest corner of the cloud's box, and come in the order of their first points. Points are put
//! into buckets by voxel, so that each bucket is sorted by one thread.

use super::{Outcome, PIECE};
use crate::progress::{Cancelled, Progress};
use crate::scan::cloud::Cloud;
use nalgebra::Vector3;
use rayon::prelude::*;

/// Bits of a voxel's number along a side. A cloud of more voxels along a side is left as it is: f32 places are hardly
/// finer.
const SIDE_BITS: u32 = 21;

/// Points of a bucket, about.
const BUCKET: usize = PIECE;

/// The means of a cloud's voxels, in the order of their first points.
pub struct VoxelMeans {
    /// One point for each voxel.
    pub cloud: Cloud,
    /// Of each the index of the first point that it stands for.
    pub first: Vec<u32>,
    /// Of each how many points it stands for.
    pub count: Vec<u32>,
}

/// The points of one voxel, made one.
#[derive(Clone, Copy)]
struct Merged {
    /// The first of them.
    first: u32,
    /// How many there were.
    count: u32,
    offset: [f32; 3],
    normal: [f32; 3],
    colour: [u8; 3],
    intensity: f32,
}

pub(super) fn thinned(cloud: &Cloud, voxel_mm: f64, progress: &Progress) -> Result<Outcome, Cancelled> {
    let means = voxel_means(cloud, voxel_mm, progress)?;
    Ok(means.map_or(Outcome::Unchanged, |m| Outcome::Thinned { thinned: m.cloud, first: m.first }))
}

/// Makes the points of each voxel one. `None` where the voxel is none (0 mm) or the cloud far too wide for it.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub fn voxel_means(cloud: &Cloud, voxel_mm: f64, progress: &Progress) -> Result<Option<VoxelMeans>, Cancelled> {
    let (mut lo, mut hi) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for (k, &c) in cloud.offsets.iter().flat_map(|o| o.iter().enumerate()) {
        (lo[k], hi[k]) = (lo[k].min(f64::from(c)), hi[k].max(f64::from(c)));
    }
    let most = f64::from(1u32 << SIDE_BITS);
    if !(voxel_mm > 0.0 && (0..3).all(|k| (hi[k] - lo[k]) / voxel_mm < most)) {
        return Ok(None);
    }
    let voxel_of = |o: &[f32; 3]| {
        let side = |k: usize| ((f64::from(o[k]) - lo[k]) / voxel_mm) as u64;
        side(0) << (2 * SIDE_BITS) | side(1) << SIDE_BITS | side(2)
    };
    let mut buckets: Vec<Vec<(u64, u32)>> = vec![Vec::new(); cloud.len().div_ceil(BUCKET)];
    let count = buckets.len() as u64;
    for (index, offset) in cloud.offsets.iter().enumerate() {
        if index % PIECE == 0 {
            progress.check()?;
        }
        let voxel = voxel_of(offset);
        // Spread over the buckets by the golden ratio, as neighbours would fill one alone.
        let bucket = ((voxel.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32) * count) >> 32;
        buckets[bucket as usize].push((voxel, index as u32));
    }
    let merged: Vec<Vec<Merged>> = buckets
        .into_par_iter()
        .map(|mut bucket| {
            progress.check()?;
            bucket.sort_unstable();
            Ok(bucket.chunk_by(|a, b| a.0 == b.0).map(|voxel| merge(cloud, voxel)).collect())
        })
        .collect::<Result<_, Cancelled>>()?;
    let mut merged = merged.concat();
    progress.check()?;
    merged.par_sort_unstable_by_key(|m| m.first);
    Ok(Some(VoxelMeans {
        first: merged.iter().map(|m| m.first).collect(),
        count: merged.iter().map(|m| m.count).collect(),
        cloud: Cloud {
            origin: cloud.origin,
            offsets: merged.iter().map(|m| m.offset).collect(),
            normals: cloud.normals.as_ref().map(|_| merged.iter().map(|m| m.normal).collect()),
            colours: cloud.colours.as_ref().map(|_| merged.iter().map(|m| m.colour).collect()),
            intensities: cloud.intensities.as_ref().map(|_| merged.iter().map(|m| m.intensity).collect()),
        },
    }))
}

/// The mean of the points of a voxel, which are in ascending order.
fn merge(cloud: &Cloud, voxel: &[(u64, u32)]) -> Merged {
    let share = 1.0 / voxel.len() as f64;
    let indices = || voxel.iter().map(|v| v.1 as usize);
    let sum = |of: &[[f32; 3]]| indices().fold(Vector3::zeros(), |s, i| s + Vector3::from(of[i].map(f64::from)));
    let first = voxel[0].1;
    let normal = cloud.normals.as_deref().map_or([0.0; 3], |normals| {
        // Normals that cancel each other out have no mean: the first one's is taken.
        sum(normals).try_normalize(1e-6).map_or(normals[first as usize], |n| n.map(|c| c as f32).into())
    });
    let colour = cloud.colours.as_deref().map_or([0; 3], |colours| {
        let mean = |k: usize| indices().map(|i| u64::from(colours[i][k])).sum::<u64>() as f64 * share;
        [mean(0), mean(1), mean(2)].map(|c| c.round() as u8)
    });
    let bright = |all: &[f32]| indices().map(|i| f64::from(all[i])).sum::<f64>() * share;
    Merged {
        first,
        count: voxel.len() as u32,
        offset: (sum(&cloud.offsets) * share).map(|c| c as f32).into(),
        normal,
        colour,
        intensity: cloud.intensities.as_deref().map_or(0.0, |all| bright(all) as f32),
    }
}
