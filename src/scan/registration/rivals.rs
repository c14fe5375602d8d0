//! Other poses that fit as well: right too where the part is symmetric, and where it is not, the patch that tells which
//! is right.

use super::samples::Sample;
use super::sliding::Held;
use super::thinned::Thinned;
use crate::part::Part;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Isometry3, Point3, Vector3};
use rayon::prelude::*;

/// Share of the model's samples that have to lie on the model again where it is symmetric. A hole of 5 mm through a plate
/// of 80 × 50 mm is more than a hundredth of them.
const LAID_AGAIN: f64 = 0.998;
/// The patch ends where the difference is less than this share of its greatest.
const PATCH_FROM: f64 = 0.5;

/// Another pose that fits nearly as well.
#[derive(Clone, Debug, PartialEq)]
pub struct Rival {
    /// The pose.
    pub model_from_scan: Isometry3<f64>,
    /// As the registration's own, mm.
    pub rms_mm: f64,
    /// Whether the model, laid on itself by the difference of both poses, fits within the noise: then both are right.
    pub same_by_symmetry: bool,
    /// Where the poses can be told apart; `None` where the part is the same in both.
    pub telling: Option<TellingPatch>,
}

/// Where the deviations of two poses differ most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TellingPatch {
    /// Its middle, part frame, at the better pose.
    pub centre: Point3<f64>,
    /// Radius of a ball about that which holds it, mm.
    pub radius_mm: f64,
    /// By how much the distances to the model differ there, mm: above 0 where the better pose is nearer.
    pub difference_mm: f64,
}

/// What poses are compared by.
#[derive(Clone, Debug)]
pub(super) struct Alike<'a> {
    /// All over the model.
    pub(super) samples: Vec<Sample>,
    /// What slides at the best pose.
    pub(super) held: &'a Held,
    /// What is nearer lies on the model, mm.
    pub(super) within_mm: f64,
    /// Distances count up to this in a score, mm.
    pub(super) cap_mm: f64,
}

impl Alike<'_> {
    /// Whether the model, moved, lies on itself.
    pub(super) fn is_symmetry(&self, part: &Part, motion: &Isometry3<f64>) -> bool {
        let is_on = |s: &&Sample| part.bvh.closest(&(motion * s.place), self.within_mm).is_some();
        let on = self.samples.par_iter().filter(is_on).count();
        on as f64 >= LAID_AGAIN * self.samples.len() as f64
    }
}

/// The patch that tells a rival from the best pose; `None` without points.
///
/// # Errors
/// [`Cancelled`].
pub(super) fn telling_patch(
    part: &Part,
    thinned: &Thinned,
    best: &Isometry3<f64>,
    rival: &Isometry3<f64>,
    progress: &Progress,
) -> Result<Option<TellingPatch>, Cancelled> {
    let off = |pose: &Isometry3<f64>, p: &Point3<f64>| {
        part.bvh.closest(&(pose * p), f64::INFINITY).map_or(0.0, |c| c.distance_mm)
    };
    let of_point = |p: &Point3<f64>| off(rival, p) - off(best, p);
    let single: Vec<f64> = thinned.middles.par_iter().map(of_point).collect();
    progress.check()?;
    // Over a voxel and those around it, so that no single one decides.
    let smooth = |v: usize| {
        let (sum, count) = thinned.around(v).fold((0.0, 0usize), |(s, n), w| (s + single[w], n + 1));
        sum / count.max(1) as f64
    };
    let smoothed: Vec<f64> = (0..single.len()).into_par_iter().map(smooth).collect();
    progress.check()?;
    let peak = (0..smoothed.len()).reduce(|a, b| if smoothed[b].abs() > smoothed[a].abs() { b } else { a });
    Ok(peak.map(|peak| {
        let difference_mm = smoothed[peak];
        let voxels = grown(thinned, peak, |v| smoothed[v] / difference_mm >= PATCH_FROM);
        let places: Vec<Point3<f64>> = voxels.iter().map(|&v| best * thinned.middles[v]).collect();
        let sum = places.iter().fold(Vector3::zeros(), |s: Vector3<f64>, p| s + p.coords);
        let centre = Point3::from(sum / places.len().max(1) as f64);
        let radius = places.iter().map(|p| (p - centre).norm()).fold(0.0, f64::max);
        TellingPatch { centre, radius_mm: radius + thinned.cell_mm, difference_mm }
    }))
}

/// The voxels that hang together with one and belong to it.
fn grown(thinned: &Thinned, from: usize, belongs: impl Fn(usize) -> bool) -> Vec<usize> {
    let mut is_in = vec![false; thinned.middles.len()];
    is_in[from] = true;
    let mut out = vec![from];
    let mut next = 0;
    while let Some(&v) = out.get(next) {
        next += 1;
        for w in thinned.around(v) {
            if !is_in[w] && belongs(w) {
                is_in[w] = true;
                out.push(w);
            }
        }
    }
    out
}
