//! How high a bead stands at a place of its line: the greatest value of a robust quadric over the points near its crest.
//!
//! Never the highest point: noise alone puts that up by 0.7 to 2.8 mm, and each costs a pass. A wide quadric tells where
//! the crest is, one of 2.5 mm either way how high. Where noise asks for more points its window grows, along the bead
//! first: across, a quadric rounds the flat top of a bead that was ground (0.35 mm too high over the whole width). A lump
//! shorter than the window is smoothed.

use super::line::{Placed, between};
use crate::scan::{SIGMA_OF_MEDIAN, TUKEY, upper_median};
use nalgebra::{SMatrix, SVector};

/// Half the length of the window either way, mm: the least, and the greatest along the bead.
const HALF_MM: [f64; 2] = [2.5, 6.0];
/// What the noise should leave of uncertainty in a height, mm; by it the window is chosen.
const UNCERTAINTY_MM: f64 = 0.08;
/// Variance of a quadric's middle over that of the mean of as many points: 9/4 either way.
const OF_QUADRIC: f64 = 81.0 / 16.0;
/// Half the width of the widest window by the width of the bead: the flanks bend otherwise than the crest.
const HALF_OF_WIDTH: f64 = 0.42;
/// Robust steps; fewer points tell no quadric.
const STEPS: usize = 5;
const LEAST_POINTS: usize = 12;

/// The height at a place of the line, mm. `middle_mm`: how far left of the line the bead's middle lies; `ends_mm`: where the
/// bead begins and ends, which the window does not pass: at its rim a quadric is nine times less certain.
pub(super) fn height_mm(
    placed: &[Placed],
    along_mm: f64,
    ends_mm: [f64; 2],
    [middle_mm, width_mm]: [f64; 2],
    noise_mm: f64,
) -> Option<f64> {
    let inside = |half: f64| along_mm.min(ends_mm[1] - half).max(ends_mm[0] + half);
    if !(width_mm > 0.0 && width_mm.is_finite()) {
        return None;
    }
    let most_across = HALF_OF_WIDTH * width_mm;
    let wide = Window { along_mm: inside(HALF_MM[1]), left_mm: middle_mm, half_mm: [HALF_MM[1], most_across] };
    let rows = wide.rows(placed);
    let shape = quadric(&rows)?;
    let per_mm2 = rows.len() as f64 / (4.0 * HALF_MM[1] * most_across);
    let needed_mm2 = OF_QUADRIC * (noise_mm / UNCERTAINTY_MM) * (noise_mm / UNCERTAINTY_MM) / per_mm2;
    let along = (0.25 * needed_mm2 / HALF_MM[0]).clamp(HALF_MM[0], HALF_MM[1]);
    let across = (0.25 * needed_mm2 / along).max(HALF_MM[0]).min(most_across);
    // A flat top has no crest: where it would not be higher the middle is as good, and no window passes the wide one.
    let at = Window::crest(&shape);
    let is_higher = at * (shape[2] + at * shape[5]) > 2.0 * UNCERTAINTY_MM;
    let most_off = most_across - across;
    let crest_mm = middle_mm + if is_higher { (most_across * at).clamp(-most_off, most_off) } else { 0.0 };
    let narrow = Window { along_mm: inside(along), left_mm: crest_mm, half_mm: [along, across] };
    let quadric = quadric(&narrow.rows(placed))?;
    let at = Window::crest(&quadric);
    Some(quadric[0] + at * (quadric[2] + at * quadric[5])).filter(|h| h.is_finite())
}

/// Where points are taken from: a place by the line, and how far either way along it and across.
struct Window {
    along_mm: f64,
    left_mm: f64,
    half_mm: [f64; 2],
}

impl Window {
    /// Its points, in −1..1, and their heights.
    fn rows(&self, placed: &[Placed]) -> Vec<[f64; 3]> {
        let [along, across] = self.half_mm;
        let near = between(placed, self.along_mm - along, self.along_mm + along).iter();
        let scaled =
            |p: &Placed| [(p.along_mm - self.along_mm) / along, (p.left_mm - self.left_mm) / across, p.height_mm];
        near.map(scaled).filter(|row| row[1].abs() <= 1.0).collect()
    }

    /// The highest place across, at the middle along, in −0.5..0.5: further out a quadric guesses. The middle where there
    /// is none.
    fn crest(quadric: &SVector<f64, 6>) -> f64 {
        let (slope, bend) = (quadric[2], quadric[5]);
        if bend < 0.0 { (-0.5 * slope / bend).clamp(-0.5, 0.5) } else { 0.0 }
    }
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
        let width = (TUKEY * SIGMA_OF_MEDIAN * upper_median(&mut offs.clone())?).max(1e-6);
        for (weight, off) in weights.iter_mut().zip(offs) {
            *weight = (1.0 - (off / width) * (off / width)).max(0.0).powi(2);
        }
    }
    Some(found)
}
