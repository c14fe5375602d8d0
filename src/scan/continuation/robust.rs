//! Fits a surface to points of which some lie off it: Gauss and Newton with Tukey's weights, whose width shrinks from a
//! twentieth of the size, as registration does. A width from the median alone, from the first step on, would settle on
//! whatever the start lies on.

use super::profile::Profile;
use super::surface::{Form, Row, Surface};
use crate::progress::{Cancelled, Progress};
use crate::scan::{SIGMA_OF_MEDIAN, TUKEY};
use nalgebra::{DMatrix, DVector, Point3};

/// Steps: after 24 the width has shrunk to a thousandth of where it began.
const STEPS: i32 = 24;
const SHRINK: f64 = 0.75;
/// Width of the first step, as a share of the size.
const FIRST_WIDTH: f64 = 0.05;
/// A step that changes no parameter by more than this share of the size ends the fit, once the width is the points'.
const SETTLED: f64 = 1e-8;
/// Least width, mm.
const LEAST_WIDTH_MM: f64 = 1e-3;
/// What third differences of a spline weigh beside the points of one coefficient: where points are the curve is theirs
/// to the fourth digit.
const STIFFNESS: f64 = 1e-4;
/// Added to the diagonal, as a share of it: parameters that nothing holds stay as they were.
const HELD: f64 = 1e-9;

/// A fitted surface.
pub(super) struct Fit {
    pub surface: Surface,
    /// Root mean square of the distances of the points with a say, mm.
    pub rms_mm: f64,
    /// Share of all points that these are.
    pub share: f64,
    /// Which points have a say.
    pub has_say: Vec<bool>,
    /// Covariance of the parameters for a noise of 1 mm: motions of the frame, then coefficients.
    covariance: DMatrix<f64>,
}

/// Fits, from a start. `None` where no step can be computed.
pub(super) fn fitted(
    points: &[Point3<f64>],
    start: Surface,
    size_mm: f64,
    progress: &Progress,
) -> Result<Option<Fit>, Cancelled> {
    let mut surface = start;
    let mut off = offsets(points, &surface);
    for step in 0..STEPS {
        progress.check()?;
        let shrunk_mm = FIRST_WIDTH * size_mm * (0..step).fold(1.0, |w, _| w * SHRINK);
        let width = width_mm(&off, shrunk_mm);
        let (squares, right) = equations(points, &surface, width);
        let Some(solved) = squares.cholesky() else { return Ok(None) };
        let by = solved.solve(&right);
        if !by.iter().all(|x| x.is_finite()) {
            return Ok(None);
        }
        surface.change(by.as_slice());
        off = offsets(points, &surface);
        if width > shrunk_mm && by.amax() < SETTLED * size_mm {
            break;
        }
    }
    let width = width_mm(&off, 0.0);
    let has_say: Vec<bool> = off.iter().map(|d| d.abs() < width).collect();
    let count = has_say.iter().filter(|s| **s).count();
    let sum: f64 = off.iter().zip(&has_say).filter(|(_, s)| **s).map(|(d, _)| d * d).sum();
    let rms_mm = (sum / count.max(1) as f64).sqrt();
    let Some(solved) = equations(points, &surface, width).0.cholesky() else { return Ok(None) };
    let share = count as f64 / points.len().max(1) as f64;
    Ok(rms_mm.is_finite().then(|| Fit { surface, rms_mm, share, has_say, covariance: solved.inverse() }))
}

impl Fit {
    /// Standard deviation of the surface at a place near it, per mm of noise; infinity where it has no place.
    pub fn spread_at(&self, p: &Point3<f64>) -> f64 {
        let Some(row) = self.surface.row(p) else { return f64::INFINITY };
        let mut slopes = Vec::new();
        entries(&self.surface, &row, &mut slopes);
        let mut sum = 0.0;
        for (i, a) in &slopes {
            for (j, b) in &slopes {
                sum += a * b * self.covariance[(*i, *j)];
            }
        }
        f64::max(sum, 0.0).sqrt()
    }

    /// Standard deviation of the frame's least held turn, radians per mm of noise; 0 where it has none.
    pub fn turn_spread(&self) -> f64 {
        let turns = self.surface.motions().min(2);
        (0..turns).map(|k| self.covariance[(k, k)]).fold(0.0, f64::max).sqrt()
    }
}

fn offsets(points: &[Point3<f64>], surface: &Surface) -> Vec<f64> {
    points.iter().map(|p| surface.row(p).map_or(f64::INFINITY, |r| r.off_mm)).collect()
}

fn width_mm(off: &[f64], shrunk_mm: f64) -> f64 {
    let mut all: Vec<f64> = off.iter().map(|d| d.abs()).collect();
    if all.is_empty() {
        return LEAST_WIDTH_MM;
    }
    let half = all.len() / 2;
    let median = *all.select_nth_unstable_by(half, f64::total_cmp).1;
    shrunk_mm.max(TUKEY * SIGMA_OF_MEDIAN * median).max(LEAST_WIDTH_MM)
}

/// The parameters that a row's distance depends on, with how much.
fn entries(surface: &Surface, row: &Row, into: &mut Vec<(usize, f64)>) {
    let motions = surface.motions();
    into.clear();
    into.extend(row.motion[..motions].iter().copied().enumerate());
    into.extend(row.slopes[..row.count].iter().enumerate().map(|(k, s)| (motions + row.first + k, *s)));
}

/// Normal equations of the step that makes the weighted distances least.
fn equations(points: &[Point3<f64>], surface: &Surface, width: f64) -> (DMatrix<f64>, DVector<f64>) {
    let count = surface.motions() + surface.coefficients.len();
    let (mut squares, mut right, mut whole) = (DMatrix::zeros(count, count), DVector::zeros(count), 0.0);
    let mut slopes = Vec::new();
    for row in points.iter().filter_map(|p| surface.row(p)) {
        let share = row.off_mm / width;
        if share.is_nan() || share.abs() >= 1.0 {
            continue;
        }
        let weight = (1.0 - share * share) * (1.0 - share * share);
        whole += weight;
        entries(surface, &row, &mut slopes);
        for (i, a) in &slopes {
            right[*i] -= weight * a * row.off_mm;
            for (j, b) in &slopes {
                squares[(*i, *j)] += weight * a * b;
            }
        }
    }
    if let Form::Extruded(profile) | Form::Revolved(profile) = surface.form {
        stiffen(&profile, surface, whole, &mut squares, &mut right);
    }
    for k in 0..count {
        squares[(k, k)] += HELD * squares[(k, k)] + f64::MIN_POSITIVE;
    }
    (squares, right)
}

/// Holds third differences of a spline's coefficients small.
fn stiffen(profile: &Profile, surface: &Surface, whole: f64, squares: &mut DMatrix<f64>, right: &mut DVector<f64>) {
    const THIRD: [f64; 4] = [-1.0, 3.0, -3.0, 1.0];
    let (count, motions) = (profile.coefficients(), surface.motions());
    let weight = STIFFNESS * whole / count as f64;
    for first in 0..count.saturating_sub(3) {
        let difference: f64 = (0..4).map(|k| THIRD[k] * surface.coefficients[first + k]).sum();
        for (i, a) in THIRD.iter().enumerate() {
            right[motions + first + i] -= weight * a * difference;
            for (j, b) in THIRD.iter().enumerate() {
                squares[(motions + first + i, motions + first + j)] += weight * a * b;
            }
        }
    }
}
