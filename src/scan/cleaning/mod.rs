//! Takes out of a cloud what is none of the part, step by step: outliers, too many points, noise, what was cut off.
//!
//! Each step works on what the one before it left. Places in steps are in the scan's frame, so a cut or a stroke of the
//! brush means the same whatever stands before it. A step whose numbers make no sense (a voxel of 0 mm) changes
//! nothing; the counts show it.

mod cut;
mod outliers;
mod smooth;
mod step;
mod thin;

use super::cloud::Cloud;
use crate::progress::{Cancelled, Progress};
use rayon::prelude::*;
use std::borrow::Cow;

pub use step::{Keep, Step};
pub use thin::{VoxelMeans, voxel_means};

/// A cleaned cloud.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cleaned {
    /// What is left, in the order of the raw cloud.
    pub cloud: Cloud,
    /// Of each point left its index in the raw cloud; of a thinned one that of the first point it stands for.
    pub source: Vec<u32>,
    /// Points before and after each step.
    pub counts: Vec<StepCount>,
}

/// Points before and after a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepCount {
    /// Before.
    pub before: usize,
    /// After.
    pub after: usize,
}

/// Does the steps in their order.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub fn clean(raw: &Cloud, steps: &[Step], progress: &Progress) -> Result<Cleaned, Cancelled> {
    let mut cloud = Cow::Borrowed(raw);
    let mut source: Vec<u32> = (0..raw.len()).map(|i| i as u32).collect();
    let mut counts = Vec::with_capacity(steps.len());
    for step in steps {
        progress.check()?;
        let before = cloud.len();
        match done(&cloud, step, progress)? {
            Outcome::Unchanged => {}
            Outcome::Kept(kept) => {
                cloud = Cow::Owned(cloud.picked(&kept));
                source = of_source(&source, &kept);
            }
            Outcome::Thinned { thinned, first } => {
                cloud = Cow::Owned(thinned);
                source = of_source(&source, &first);
            }
            Outcome::Moved(offsets) => cloud.to_mut().offsets = offsets,
        }
        counts.push(StepCount { before, after: cloud.len() });
    }
    Ok(Cleaned { cloud: cloud.into_owned(), source, counts })
}

/// What a step makes of a cloud.
enum Outcome {
    Unchanged,
    /// Which points are left, ascending.
    Kept(Vec<u32>),
    /// Fewer points, and of each the first one that it stands for.
    Thinned {
        thinned: Cloud,
        first: Vec<u32>,
    },
    /// Each point in another place.
    Moved(Vec<[f32; 3]>),
}

fn done(cloud: &Cloud, step: &Step, progress: &Progress) -> Result<Outcome, Cancelled> {
    match step {
        Step::Outliers { neighbours, sigma } => outliers::without(cloud, *neighbours as usize, *sigma, progress),
        Step::Thin { voxel_mm } => thin::thinned(cloud, *voxel_mm, progress),
        Step::Smooth { radius_mm, noise_mm } => smooth::smoothed(cloud, *radius_mm, *noise_mm, progress),
        Step::CutBox { min, max, keep } => cut::by_box(cloud, min, max, *keep, progress),
        Step::CutPlane { point, normal } => cut::by_plane(cloud, point, normal, progress),
        Step::Erase { centres, radius_mm } => cut::erased(cloud, centres, *radius_mm, progress),
    }
}

fn of_source(source: &[u32], kept: &[u32]) -> Vec<u32> {
    kept.iter().map(|&i| source[i as usize]).collect()
}

/// Points that are one piece of work.
const PIECE: usize = 1 << 15;

/// Which of so many points are to be kept.
fn kept(count: usize, progress: &Progress, keeps: impl Fn(usize) -> bool + Sync) -> Result<Outcome, Cancelled> {
    let pieces: Vec<Vec<u32>> = (0..count.div_ceil(PIECE))
        .into_par_iter()
        .map(|piece| {
            progress.check()?;
            let all = piece * PIECE..count.min((piece + 1) * PIECE);
            Ok(all.filter(|&i| keeps(i)).map(|i| i as u32).collect())
        })
        .collect::<Result<_, Cancelled>>()?;
    Ok(Outcome::Kept(pieces.concat()))
}

#[cfg(test)]
mod tests;
