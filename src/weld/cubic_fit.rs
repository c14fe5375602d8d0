//! A cubic height over a plane, fitted so that points off the surface do not count: least squares with Tukey's
//! weights, of a width that shrinks to that of the noise.
//!
//! Ten coefficients in coordinates that the caller has brought to about −1..1; with any others the digits go.

use crate::scan::{SIGMA_OF_MEDIAN, TUKEY, upper_median};
use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;

/// Steps on some of the points, and the last ones on all of them.
const STEPS: usize = 10;
const LAST_STEPS: usize = 3;
/// About so many points do for the first steps.
const SOME: usize = 10_000;
/// Tukey's width is three times that of the noise at first and shrinks to it by this factor a step: from there at once a
/// bead that stands half out of its mask holds the fit (0.13 mm off instead of 0.02).
const FIRST_WIDTH: f64 = 3.0;
const SHRINK: f64 = 0.6;
/// The least standard deviation, mm: of data without noise.
const LEAST_SIGMA_MM: f64 = 1e-6;
/// Points summed up by one thread at a time, and added in order.
const BLOCK: usize = 4096;

/// Coefficients of 1, x, y, x², xy, y², x³, x²y, xy², y³.
pub(super) type Cubic = SVector<f64, 10>;

/// A fitted cubic.
#[derive(Clone, Copy, Debug)]
pub(super) struct CubicFit {
    pub(super) cubic: Cubic,
    /// Standard deviation of the points, by the median of their distances, mm.
    pub(super) sigma_mm: f64,
    /// Root of the weighted mean square, mm.
    pub(super) rms_mm: f64,
}

/// The terms of a cubic at a place.
pub(super) fn terms(x: f64, y: f64) -> Cubic {
    Cubic::from([1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y])
}

/// Their derivatives by x and by y.
pub(super) fn slopes(x: f64, y: f64) -> [Cubic; 2] {
    [
        Cubic::from([0.0, 1.0, 0.0, 2.0 * x, y, 0.0, 3.0 * x * x, 2.0 * x * y, y * y, 0.0]),
        Cubic::from([0.0, 0.0, 1.0, 0.0, x, 2.0 * y, 0.0, x * x, 2.0 * x * y, 3.0 * y * y]),
    ]
}

/// Fits z over x and y, the latter in about −1..1; `None`: the points do not tell a cubic.
pub(super) fn fit(points: &[[f64; 3]]) -> Option<CubicFit> {
    let mut cubic = Cubic::zeros();
    let (mut width_mm, mut shrunk, mut sigma_mm) = (f64::INFINITY, FIRST_WIDTH, 0.0);
    let some: Vec<[f64; 3]> = points.iter().step_by(points.len().div_ceil(SOME).max(1)).copied().collect();
    for step in 0..STEPS + LAST_STEPS {
        let points = if step < STEPS { &some } else { points };
        let mut offs = vec![0.0; points.len()];
        let sums = summed(points, &cubic, width_mm);
        cubic = sums.left.cholesky()?.solve(&sums.right);
        if !cubic.iter().all(|c| c.is_finite()) {
            return None;
        }
        let off = |[x, y, z]: &[f64; 3]| (z - cubic.dot(&terms(*x, *y))).abs();
        offs.par_iter_mut().zip(points).with_min_len(BLOCK).for_each(|(into, p)| *into = off(p));
        sigma_mm = (SIGMA_OF_MEDIAN * upper_median(&mut offs)?).max(LEAST_SIGMA_MM);
        width_mm = TUKEY * sigma_mm * shrunk;
        shrunk = (shrunk * SHRINK).max(1.0);
    }
    let left = summed(points, &cubic, width_mm);
    Some(CubicFit { cubic, sigma_mm, rms_mm: (left.squares / left.weight).sqrt() })
}

#[derive(Clone, Copy)]
struct Sums {
    left: SMatrix<f64, 10, 10>,
    right: Cubic,
    weight: f64,
    squares: f64,
}

fn summed(points: &[[f64; 3]], cubic: &Cubic, width: f64) -> Sums {
    let nothing = Sums { left: SMatrix::zeros(), right: Cubic::zeros(), weight: 0.0, squares: 0.0 };
    let of_block = |points: &[[f64; 3]]| {
        let mut sums = nothing;
        for [x, y, z] in points {
            let row = terms(*x, *y);
            let off = z - cubic.dot(&row);
            let share = off / width;
            let weight = (1.0 - share * share).max(0.0);
            let weight = weight * weight;
            sums.left.ger(weight, &row, &row, 1.0);
            sums.right.axpy(weight * z, &row, 1.0);
            sums.weight += weight;
            sums.squares += weight * off * off;
        }
        sums
    };
    let blocks: Vec<Sums> = points.par_chunks(BLOCK).map(of_block).collect();
    blocks.into_iter().fold(nothing, |a, b| Sums {
        left: a.left + b.left,
        right: a.right + b.right,
        weight: a.weight + b.weight,
        squares: a.squares + b.squares,
    })
}
