//! The fine fit: few points for most of the way, many for the rest, and once more without what is worn.
//!
//! Wear is told from noise by the median of a voxel's points, so single points that lie off are not taken for it. Missing
//! and surplus material both count as worn: either would pull the fit to its side.

use super::super::Cloud;
use super::plane_fit::{PlaneFit, Schedule, median_mm, plane_fit};
use super::surface::{Model, Row};
use super::thinned::Thinned;
use crate::progress::{Cancelled, Progress};
use crate::scan::{SIGMA_OF_MEDIAN, TUKEY};
use nalgebra::{Isometry3, Point3};

/// Points and steps of the way, and of the end. 60 000 points leave 2 µm of 0.03 mm noise on a camshaft's axis, its
/// weakest; 15 000 leave 4.
const WAY: (usize, usize) = (5_000, 30);
const END: (usize, usize) = (60_000, 8);
/// Motions with a lesser eigenvalue slide, and stay as they are: those of plane, cylinder and extrusion, faceted too, are
/// below it (interpolated normals), a camshaft's axis has 3e-3.
pub(in crate::scan) const SLIDES_BELOW: f64 = 3e-4;
/// A voxel's median beyond so many standard deviations is wear: three of five points of noise alone lie there, on one
/// side, once in 20 million voxels.
pub(super) const WORN_SIGMAS: f64 = 3.0;
/// Fewest points of a median; of a voxel with fewer those around it count with it.
const FEWEST_OF_MEDIAN: usize = 5;
/// With more than this share worn nobody can say what the sound part is, and the first fit stays.
const MOST_WORN: f64 = 0.4;

/// A fine fit.
#[derive(Clone, Debug)]
pub(super) struct Fine {
    pub(super) fit: PlaneFit,
    /// Voxel of each row.
    pub(super) voxels: Vec<u32>,
    /// Standard deviation of the sound points, mm.
    pub(super) sigma_mm: f64,
    /// Where it was before what is worn was left out, and the share of points that is; `None`: nothing is worn.
    pub(super) with_worn: Option<(Isometry3<f64>, f64)>,
    /// The steps of all fits.
    pub(super) convergence_mm: Vec<f64>,
}

impl Fine {
    /// The first row of each voxel.
    pub(super) fn firsts(&self) -> impl Iterator<Item = Row> + '_ {
        let is_first = |i: &usize| *i == 0 || self.voxels[*i] != self.voxels[*i - 1];
        (0..self.voxels.len()).filter(is_first).map(|i| self.fit.rows[i])
    }
}

/// The standard deviation of the points that count, by their median, mm.
pub(super) fn sigma_mm(fit: &PlaneFit) -> f64 {
    SIGMA_OF_MEDIAN * median_mm(&fit.rows, &fit.counts)
}

/// Most of the way, from a pose whose points are off by `first_width_mm` at most.
///
/// # Errors
/// [`Cancelled`].
pub(super) fn way(
    model: &Model<'_>,
    cloud: &Cloud,
    thinned: &Thinned,
    start: &Isometry3<f64>,
    first_width_mm: f64,
    progress: &Progress,
) -> Result<PlaneFit, Cancelled> {
    let points: Vec<Point3<f64>> = thinned.spread(WAY.0).iter().map(|s| cloud.point(s.1 as usize)).collect();
    let schedule = Schedule { steps: WAY.1, first_width_mm, least_held: SLIDES_BELOW };
    plane_fit(model, &points, &[], start, &schedule, progress)
}

/// The end, from where [`way`] arrived.
///
/// # Errors
/// [`Cancelled`].
pub(super) fn end(
    model: &Model<'_>,
    cloud: &Cloud,
    thinned: &Thinned,
    way: &PlaneFit,
    progress: &Progress,
) -> Result<Fine, Cancelled> {
    let (voxels, numbers): (Vec<u32>, Vec<u32>) = thinned.spread(END.0).into_iter().unzip();
    let points: Vec<Point3<f64>> = numbers.iter().map(|&i| cloud.point(i as usize)).collect();
    let fitted = |start: &Isometry3<f64>, sigma_mm: f64, passed_over: &[bool]| {
        let schedule = Schedule { steps: END.1, first_width_mm: TUKEY * sigma_mm, least_held: SLIDES_BELOW };
        plane_fit(model, &points, passed_over, start, &schedule, progress)
    };
    let first = fitted(&way.model_from_scan, sigma_mm(way), &[])?;
    let mut convergence_mm = way.convergence_mm.clone();
    convergence_mm.extend(&first.convergence_mm);
    let sigma = sigma_mm(&first);
    let worn = worn_rows(&first, &voxels, thinned, WORN_SIGMAS * sigma);
    let share = worn.iter().filter(|w| **w).count() as f64 / worn.len().max(1) as f64;
    if share == 0.0 || share > MOST_WORN {
        return Ok(Fine { sigma_mm: sigma, fit: first, voxels, with_worn: None, convergence_mm });
    }
    let second = fitted(&first.model_from_scan, sigma, &worn)?;
    convergence_mm.extend(&second.convergence_mm);
    let with_worn = Some((first.model_from_scan, share));
    Ok(Fine { sigma_mm: sigma_mm(&second), fit: second, voxels, with_worn, convergence_mm })
}

/// Which points lie in voxels whose median is off by more than `beyond_mm`.
fn worn_rows(fit: &PlaneFit, voxels: &[u32], thinned: &Thinned, beyond_mm: f64) -> Vec<bool> {
    let mut offs: Vec<Vec<f64>> = vec![Vec::new(); thinned.middles.len()];
    for ((row, counts), &voxel) in fit.rows.iter().zip(&fit.counts).zip(voxels) {
        if *counts {
            // Beside an edge the plane of the foot does not tell how far a point is.
            offs[voxel as usize].push(row.distance_mm.copysign(row.off_mm));
        }
    }
    let is_worn: Vec<bool> = (0..offs.len())
        .map(|v| {
            let mut near = offs[v].clone();
            if !near.is_empty() && near.len() < FEWEST_OF_MEDIAN {
                near = thinned.around(v).flat_map(|w| &offs[w]).copied().collect();
            }
            let middle = near.len() / 2;
            near.len() >= FEWEST_OF_MEDIAN && near.select_nth_unstable_by(middle, f64::total_cmp).1.abs() > beyond_mm
        })
        .collect();
    voxels.iter().map(|&v| is_worn[v as usize]).collect()
}
