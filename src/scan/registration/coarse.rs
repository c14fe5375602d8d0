//! Poses that a scan may have, from anywhere: turns everywhere, each walked in the field, the best of what differs laid
//! on the mesh. Flips and symmetries come out as poses beside the best, never in its place unseen.

use super::super::Cloud;
use super::field::Field;
use super::in_field::Walk;
use super::measures::overlap;
use super::plane_fit::{PlaneFit, Schedule, capped_rms_mm, moved, plane_fit};
use super::sliding::motions;
use super::starts::{Skin, turns};
use super::surface::{Model, Row};
use super::thinned::Thinned;
use crate::part::bvh::closest_search::ClosestHint;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Isometry3, Matrix3, Point3, Vector3};
use rayon::prelude::*;

/// Points walked with.
const WALKED_POINTS: usize = 400;
/// Steps of all starts, and steps in all; after the former the best go on.
const FIRST_STEPS: i32 = 8;
const STEPS: i32 = 20;
const GO_ON: usize = 400;
/// Poses laid on the mesh, points of that, and how many of them once more.
const LAID: usize = 24;
const LAID_POINTS: usize = 1000;
const LAID_TWICE: usize = 8;
const LAID_STEPS: usize = 14;
/// First widths of the two, shares of the model's diagonal; a third of it caps the score.
const LAID_WIDTHS: [f64; 2] = [1.0 / 20.0, 1.0 / 60.0];
/// The best are tried again from both sides along their weakest motions, so far off (shares of the diagonal) one round
/// after the other: half a shaft lies well on its cylinders a shoulder too far along, half a tray on its floor with its
/// rims beside the model's, and all poses found first may. With none the front shaft with half missing is 8 mm off in 1
/// pose of 5, with the first round alone the tray in 2 of 20.
const SHAKEN_MOTIONS: usize = 2;
const SHAKES: [f64; 3] = [0.05, 0.05, 0.0125];
/// With this share of the points within the noise of the model there is no need to: half a tray with its rims a few
/// millimetres beside the model's has 0.99.
const LIES_ON: f64 = 0.995;
/// Motions less held than this stay: nothing but rounding moves them. Not as strict as in the fine fit, since a thousand
/// points may by chance miss what holds the part.
const LEAST_HELD: f64 = 1e-6;
/// From which turn, and which share of the diagonal, two poses are others. A gear of 40 teeth turns by 0.157.
const OTHER_TURN: f64 = 0.1;
const OTHER_SHIFT: f64 = 0.03;

/// A pose, and how good it is.
#[derive(Clone, Copy, Debug)]
pub(in crate::scan) struct Candidate {
    pub(in crate::scan) model_from_scan: Isometry3<f64>,
    /// Root of the mean square of min(d, D/180), mm.
    pub(in crate::scan) score_mm: f64,
}

/// Tells poses apart.
#[derive(Clone, Copy, Debug)]
pub(in crate::scan) struct Apart {
    /// Middle of the scan, scan frame.
    pub(in crate::scan) middle: Point3<f64>,
    pub(in crate::scan) diagonal_mm: f64,
}

impl Apart {
    /// Whether two poses are others, and not one that has not quite arrived.
    pub(in crate::scan) fn are_others(&self, a: &Isometry3<f64>, b: &Isometry3<f64>) -> bool {
        a.rotation.angle_to(&b.rotation) > OTHER_TURN
            || (a * self.middle - b * self.middle).norm() > OTHER_SHIFT * self.diagonal_mm
    }

    /// The first of each pose, in order.
    pub(in crate::scan) fn distinct<T>(&self, all: Vec<T>, pose: impl Fn(&T) -> Isometry3<f64>, most: usize) -> Vec<T> {
        let mut out: Vec<T> = Vec::new();
        for one in all {
            if out.len() < most && out.iter().all(|o| self.are_others(&pose(o), &pose(&one))) {
                out.push(one);
            }
        }
        out
    }
}

/// The poses found, the best first; none where there is no scan or no model.
///
/// # Errors
/// [`Cancelled`].
pub(in crate::scan) fn candidates(
    model: &Model<'_>,
    cloud: &Cloud,
    thinned: &Thinned,
    apart: &Apart,
    progress: &Progress,
) -> Result<Vec<Candidate>, Cancelled> {
    let closest =
        |at: &Point3<f64>, within: f64| model.search.closest(at, within, &mut ClosestHint::default()).map(|c| c.foot);
    let field = Field::new(model.part.mesh.bounds(), closest, progress)?;
    let walked = walked(&Skin::of(&model.part.mesh), &field, thinned, apart, progress)?;
    let poses = apart.distinct(walked, |p| *p, LAID);
    // Points as they were measured: the middle of a voxel lies inside what is round.
    let points: Vec<Point3<f64>> = thinned.spread(LAID_POINTS).iter().map(|s| cloud.point(s.1 as usize)).collect();
    let laid = |poses: &[Isometry3<f64>], width: f64| -> Result<Vec<Laid>, Cancelled> {
        let first_width_mm = width * apart.diagonal_mm;
        let schedule = Schedule { steps: LAID_STEPS, first_width_mm, least_held: LEAST_HELD };
        let one = |pose: &Isometry3<f64>| {
            let fit = plane_fit(model, &points, &[], pose, &schedule, progress)?;
            Ok(Laid { score_mm: capped_rms_mm(&fit.rows, first_width_mm / 3.0), fit })
        };
        poses.par_iter().map(one).collect()
    };
    let best = |mut all: Vec<Laid>| {
        // Stable, so of equal ones the earlier.
        all.sort_by(|a, b| a.score_mm.total_cmp(&b.score_mm));
        apart.distinct(all, |l| l.fit.model_from_scan, LAID_TWICE)
    };
    let mut once = best(laid(&poses, LAID_WIDTHS[0])?);
    for share in SHAKES {
        if once.first().is_none_or(|best| lies_on(&best.fit.rows, model.crease_mm)) {
            break;
        }
        let moved: Vec<Isometry3<f64>> = once.iter().flat_map(|l| shaken(&l.fit, share * apart.diagonal_mm)).collect();
        once.extend(laid(&moved, LAID_WIDTHS[0])?);
        once = best(once);
    }
    let again: Vec<Isometry3<f64>> = once.iter().map(|l| l.fit.model_from_scan).collect();
    let twice = best(laid(&again, LAID_WIDTHS[1])?);
    Ok(twice.iter().map(|l| Candidate { model_from_scan: l.fit.model_from_scan, score_mm: l.score_mm }).collect())
}

/// A pose laid on the mesh.
struct Laid {
    score_mm: f64,
    fit: PlaneFit,
}

/// Whether all but a few points lie on the model, within their noise: nothing lies better.
fn lies_on(rows: &[Row], within_mm: f64) -> bool {
    overlap(rows, within_mm) >= LIES_ON
}

/// The poses to both sides of one along the motions that it holds least.
fn shaken(fit: &PlaneFit, by_mm: f64) -> Vec<Isometry3<f64>> {
    let weakest = motions(&fit.held).into_iter().take(SHAKEN_MOTIONS);
    let both = weakest.flat_map(|(_, motion)| [motion * by_mm, motion * -by_mm]);
    both.map(|step| moved(&fit.model_from_scan, &step, &fit.centre, fit.length_mm)).collect()
}

/// Walks from all starts; the poses of the best, the best first, many of them the same.
pub(in crate::scan) fn walked(
    skin: &Skin,
    field: &Field,
    thinned: &Thinned,
    apart: &Apart,
    progress: &Progress,
) -> Result<Vec<Isometry3<f64>>, Cancelled> {
    let middle = apart.middle.coords;
    let points: Vec<Vector3<f64>> = thinned.spread_middles(WALKED_POINTS).map(|p| p.coords - middle).collect();
    let mut walks: Vec<Walk> = Vec::new();
    let starts = turns();
    for place in skin.middles(apart.diagonal_mm) {
        let start = |turn: Matrix3<f64>| Walk { turn, shift: place - field.lo, score: f64::INFINITY };
        walks.extend(starts.iter().map(|t| start(t.to_rotation_matrix().into_inner())));
    }
    for steps in [0..FIRST_STEPS, FIRST_STEPS..STEPS] {
        walks.par_iter_mut().try_for_each(|w| {
            *w = w.walked(field, &points, steps.clone(), apart.diagonal_mm);
            progress.check()
        })?;
        // Stable, so of equal ones the earlier start.
        walks.sort_by(|a, b| a.score.total_cmp(&b.score));
        walks.truncate(GO_ON);
    }
    Ok(walks.iter().map(|w| w.model_from_scan(field, &middle)).collect())
}
