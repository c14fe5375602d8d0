//! Point to plane on the mesh itself (Chen and Medioni 1992): the foot is the mesh's nearest point, its normal that of
//! the feature surface, so nothing depends on how densely the model was sampled.
//!
//! Weights are Tukey's, of a width that shrinks from the outside: a width from the median at the first step lets a shaft
//! slide, since most of its points lie on cylinders and the walls that hold it along its axis would count for nothing.
//! Where a foot lies on a crease no plane tells how far the point is. Far off, the way to the foot does, and it is what
//! pulls a thin plate back that was laid over its rim. Within the noise a point beside a crease may be of either side of
//! it, and such points do not count: along its rim they would hold a plane face that slides.
//!
//! Sums go in blocks of a fixed size that are added in order, so any number of threads gives the same bytes.

use super::surface::{Row, Surface, is_in};
use crate::progress::{Cancelled, Progress};
use crate::scan::{SIGMA_OF_MEDIAN, TUKEY};
use nalgebra::{
    Isometry3, Matrix6, Point3, Quaternion, SymmetricEigen, Translation3, Unit, UnitQuaternion, Vector3, Vector6,
};
use rayon::prelude::*;

/// Points summed up by one thread at a time.
const BLOCK: usize = 1024;
/// What the width shrinks by a step.
const SHRINK: f64 = 0.75;
/// The least width, mm: of data without noise.
const LEAST_WIDTH_MM: f64 = 1e-3;
/// A step shorter than this share of the median distance is the last.
const STILL: f64 = 1e-3;

/// How a fit goes.
#[derive(Clone, Copy, Debug)]
pub(in crate::scan) struct Schedule {
    pub(in crate::scan) steps: usize,
    /// Width of the weights at the first step, mm.
    pub(in crate::scan) first_width_mm: f64,
    /// Motions with an eigenvalue below this stay as they are.
    pub(in crate::scan) least_held: f64,
}

/// Where a fit arrived.
#[derive(Clone, Debug)]
pub(in crate::scan) struct PlaneFit {
    pub(in crate::scan) model_from_scan: Isometry3<f64>,
    /// Each point at that pose.
    pub(in crate::scan) rows: Vec<Row>,
    /// Which of them count.
    pub(in crate::scan) counts: Vec<bool>,
    /// Weighted rms before each step, and at the end, mm.
    pub(in crate::scan) convergence_mm: Vec<f64>,
    /// What the points hold: JᵀJ over the weights, rows [(y − o) × n / L, n].
    pub(in crate::scan) held: Matrix6<f64>,
    /// o, part frame, and L, mm.
    pub(in crate::scan) centre: Point3<f64>,
    pub(in crate::scan) length_mm: f64,
}

/// Sums over a block.
#[derive(Clone, Copy, Default)]
struct Sums {
    weight: f64,
    squares: f64,
    left: Matrix6<f64>,
    right: Vector6<f64>,
}

/// Lays points on the model, from a pose near to the right one. `passed_over`: points that do not count; those beyond
/// its end do.
///
/// # Errors
/// [`Cancelled`].
pub(in crate::scan) fn plane_fit(
    surface: &impl Surface,
    points: &[Point3<f64>],
    passed_over: &[bool],
    start: &Isometry3<f64>,
    schedule: &Schedule,
    progress: &Progress,
) -> Result<PlaneFit, Cancelled> {
    let count = points.len().max(1) as f64;
    let middle = Point3::from(points.iter().fold(Vector3::zeros(), |s: Vector3<f64>, p| s + p.coords) / count);
    let spread = points.iter().map(|p| (p - middle).norm_squared()).sum::<f64>() / count;
    let length_mm = spread.sqrt().max(f64::MIN_POSITIVE);
    let mut pose = *start;
    let mut rows = placed(surface, points, &pose, &[], progress)?;
    let mut convergence_mm = Vec::with_capacity(schedule.steps + 1);
    let mut shrunk_mm = schedule.first_width_mm;
    loop {
        let counts: Vec<bool> =
            rows.iter().enumerate().map(|(i, r)| r.distance_mm.is_finite() && !is_in(passed_over, i)).collect();
        let median = median_mm(&rows, &counts);
        let by_median = (TUKEY * SIGMA_OF_MEDIAN * median).max(LEAST_WIDTH_MM);
        let width_mm = by_median.max(shrunk_mm);
        let centre = pose * middle;
        let sums = summed(&rows, &counts, &centre, length_mm, [surface.crease_mm(), width_mm]);
        convergence_mm.push((sums.squares / sums.weight).sqrt());
        let held = sums.left / sums.weight;
        let step = step_of(&held, &(sums.right / sums.weight), schedule.least_held, width_mm);
        let is_still = width_mm <= by_median && step.norm() <= STILL * median;
        if convergence_mm.len() > schedule.steps || is_still || sums.weight <= 0.0 {
            return Ok(PlaneFit { model_from_scan: pose, rows, counts, convergence_mm, held, centre, length_mm });
        }
        pose = moved(&pose, &step, &centre, length_mm);
        rows = placed(surface, points, &pose, &rows, progress)?;
        shrunk_mm *= SHRINK;
    }
}

/// Each point at a pose. `before`: the rows of the pose before, or none.
fn placed(
    surface: &impl Surface,
    points: &[Point3<f64>],
    pose: &Isometry3<f64>,
    before: &[Row],
    progress: &Progress,
) -> Result<Vec<Row>, Cancelled> {
    let mut rows = vec![Row::none(); points.len()];
    rows.par_chunks_mut(BLOCK).enumerate().try_for_each(|(block, rows)| {
        for (i, row) in (block * BLOCK..).zip(rows) {
            *row = surface.row(i, &(pose * points[i]), pose, before.get(i)).unwrap_or_else(Row::none);
        }
        progress.check()
    })?;
    Ok(rows)
}

/// The median distance of the points that count; 0 without any.
pub(in crate::scan) fn median_mm(rows: &[Row], counts: &[bool]) -> f64 {
    let mut all: Vec<f64> = rows.iter().zip(counts).filter(|(_, c)| **c).map(|(r, _)| r.distance_mm).collect();
    let middle = all.len() / 2;
    if all.is_empty() { 0.0 } else { *all.select_nth_unstable_by(middle, f64::total_cmp).1 }
}

/// The root of the mean square of min(d, cap) over the points that take part, mm; infinite without any.
pub(in crate::scan) fn capped_rms_mm(rows: &[Row], cap_mm: f64) -> f64 {
    let all = rows.iter().filter(|r| r.distance_mm.is_finite()).map(|r| r.distance_mm.min(cap_mm));
    let (sum, count) = all.fold((0.0, 0usize), |(s, n), d| (s + d * d, n + 1));
    if count == 0 { f64::INFINITY } else { (sum / count as f64).sqrt() }
}

/// `crease_mm`: so near to a crease points count only from as far off on; `width_mm`: where weights end.
fn summed(
    rows: &[Row],
    counts: &[bool],
    centre: &Point3<f64>,
    length_mm: f64,
    [crease_mm, width_mm]: [f64; 2],
) -> Sums {
    let weighs = |r: &Row| r.distance_mm < width_mm && r.to_crease_mm.max(r.distance_mm) > crease_mm;
    let of_block = |(rows, counts): (&[Row], &[bool])| {
        let mut sums = Sums::default();
        for (row, _) in rows.iter().zip(counts).filter(|(r, counts)| **counts && weighs(r)) {
            let share = row.distance_mm / width_mm;
            let weight = (1.0 - share * share) * (1.0 - share * share);
            let lever = (row.at - centre).cross(&row.normal) / length_mm;
            let n = row.normal;
            let j = Vector6::new(lever.x, lever.y, lever.z, n.x, n.y, n.z);
            sums.weight += weight;
            sums.squares += weight * row.off_mm * row.off_mm;
            sums.left += j * j.transpose() * weight;
            sums.right += j * (weight * row.off_mm);
        }
        sums
    };
    let blocks: Vec<Sums> = rows.par_chunks(BLOCK).zip(counts.par_chunks(BLOCK)).map(of_block).collect();
    blocks.into_iter().fold(Sums::default(), |a, b| Sums {
        weight: a.weight + b.weight,
        squares: a.squares + b.squares,
        left: a.left + b.left,
        right: a.right + b.right,
    })
}

/// The step (turn · L, shift) that takes most off, without motions that hardly anything holds. No longer than the width
/// of the weights, since points further off did not count.
fn step_of(held: &Matrix6<f64>, pull: &Vector6<f64>, least_held: f64, width_mm: f64) -> Vector6<f64> {
    if !held.iter().chain(pull).all(|x| x.is_finite()) {
        return Vector6::zeros();
    }
    let eigen = SymmetricEigen::new(*held);
    let mut step = Vector6::zeros();
    for (k, &value) in eigen.eigenvalues.iter().enumerate().filter(|(_, value)| **value >= least_held) {
        let motion = eigen.eigenvectors.column(k);
        step -= motion * (motion.dot(pull) / value);
    }
    let length = step.norm();
    if length > width_mm { step * (width_mm / length) } else { step }
}

/// The pose after a step (turn · L, shift) about `centre` (Rodrigues).
pub(in crate::scan) fn moved(
    pose: &Isometry3<f64>,
    step: &Vector6<f64>,
    centre: &Point3<f64>,
    length_mm: f64,
) -> Isometry3<f64> {
    let turn = Vector3::new(step[0], step[1], step[2]) / length_mm;
    let shift = Vector3::new(step[3], step[4], step[5]);
    let turn = Unit::try_new_and_get(turn, f64::MIN_POSITIVE).map_or_else(UnitQuaternion::identity, |(axis, angle)| {
        let (s, c) = (libm::sin(0.5 * angle), libm::cos(0.5 * angle));
        UnitQuaternion::new_normalize(Quaternion::from_parts(c, axis.into_inner() * s))
    });
    let rotation = UnitQuaternion::new_normalize((turn * pose.rotation).into_inner());
    let at = centre + shift + turn * (pose.translation.vector - centre.coords);
    Isometry3::from_parts(Translation3::from(at.coords), rotation)
}
