//! How high a bead stands at a place of its line: the greatest value of a robust quadric over the points near its crest.
//!
//! Never the highest point: noise alone puts that up by 0.7 to 2.8 mm, and each costs a pass. The window is 2.5 mm long
//! either way where noise allows it and grows with the noise up to 6 mm; a lump shorter than that is smoothed.

use super::line::{Placed, between};
use crate::scan::{SIGMA_OF_MEDIAN, TUKEY};
use crate::weld::parent::median;
use nalgebra::{SMatrix, SVector};

/// Half the length of the window, mm: the least, and the greatest.
const HALF_MM: [f64; 2] = [2.5, 6.0];
/// What the noise should leave of uncertainty in a height, mm; by it the window is chosen.
const UNCERTAINTY_MM: f64 = 0.08;
/// Variance of a quadric's middle over that of the mean of as many points: 9/4 either way.
const OF_QUADRIC: f64 = 81.0 / 16.0;
/// Half the width of the window by the width of the bead: the flanks bend otherwise than the crest.
const HALF_OF_WIDTH: f64 = 0.42;
/// Robust steps; fewer points tell no quadric.
const STEPS: usize = 5;
const LEAST_POINTS: usize = 12;

/// The height at a place of the line, mm. `middle_mm`: how far left of the line the bead's middle lies.
pub(super) fn height_mm(placed: &[Placed], along_mm: f64, middle_mm: f64, width_mm: f64, noise_mm: f64) -> Option<f64> {
    let half_width = HALF_OF_WIDTH * width_mm;
    let within = |half: f64| {
        let near = between(placed, along_mm - half, along_mm + half).iter();
        near.filter(move |p| (p.left_mm - middle_mm).abs() <= half_width)
    };
    let per_mm = within(HALF_MM[1]).count() as f64 / (2.0 * HALF_MM[1]);
    let needed = OF_QUADRIC * (noise_mm / UNCERTAINTY_MM) * (noise_mm / UNCERTAINTY_MM);
    let half = (0.5 * needed / per_mm.max(1e-9)).clamp(HALF_MM[0], HALF_MM[1]);
    let scaled = |p: &Placed| [(p.along_mm - along_mm) / half, (p.left_mm - middle_mm) / half_width, p.height_mm];
    let rows: Vec<[f64; 3]> = within(half).map(scaled).collect();
    let quadric = quadric(&rows)?;
    // The crest: the highest value across, at the middle of the window.
    let (slope, bend) = (quadric[2], quadric[5]);
    let at = if bend < 0.0 { (-0.5 * slope / bend).clamp(-1.0, 1.0) } else { 0.0 };
    Some(quadric[0] + at * (slope + at * bend)).filter(|h| h.is_finite())
}

fn terms([x, y, _]: &[f64; 3]) -> SVector<f64, 6> {
    SVector::from([1.0, *x, *y, x * x, x * y, y * y])
}

fn quadric(rows: &[[f64; 3]]) -> Option<SVector<f64, 6>> {
    if rows.len() < LEAST_POINTS {
        return None;
    }
    let mut weights = vec![1.0; rows.len()];
    let mut found = SVector::zeros();
    for _ in 0..STEPS {
        let (mut left, mut right) = (SMatrix::<f64, 6, 6>::zeros(), SVector::<f64, 6>::zeros());
        for (row, weight) in rows.iter().zip(&weights) {
            let t = terms(row);
            left.ger(*weight, &t, &t, 1.0);
            right.axpy(weight * row[2], &t, 1.0);
        }
        found = left.cholesky()?.solve(&right);
        let offs: Vec<f64> = rows.iter().map(|r| (r[2] - found.dot(&terms(r))).abs()).collect();
        let width = (TUKEY * SIGMA_OF_MEDIAN * median(offs.clone())?).max(1e-6);
        for (weight, off) in weights.iter_mut().zip(offs) {
            *weight = (1.0 - (off / width) * (off / width)).max(0.0).powi(2);
        }
    }
    Some(found)
}
