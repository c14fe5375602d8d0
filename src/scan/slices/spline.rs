//! Cubic splines over a way, open or closed, of a place in the plane and a normal together (de Boor 1978).

use super::banded::{Banded, Columns};

/// Fewest spans of a closed spline: the equations of a circle want more than six unknowns.
pub(super) const FEWEST_ROUND: usize = 8;

/// Where the pieces of a spline meet.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Knots {
    /// Ends of the spans, mm, ascending; of a closed spline the last is the first, a round on.
    pub(super) breaks: Vec<f64>,
    /// Whether the end joins the start.
    pub(super) is_round: bool,
}

impl Knots {
    /// Number of spans.
    pub(super) fn spans(&self) -> usize {
        self.breaks.len() - 1
    }

    /// In which span a way is.
    pub(super) fn span_of(&self, way_mm: f64) -> usize {
        self.breaks.partition_point(|b| *b <= way_mm).saturating_sub(1).min(self.spans() - 1)
    }

    /// The knot `by` places from the start of a span: ends are repeated, circles go on.
    fn knot(&self, span: usize, by: isize) -> f64 {
        let (spans, at) = (self.spans() as isize, span as isize + by);
        if self.is_round {
            let round_mm = self.breaks[self.spans()] - self.breaks[0];
            self.breaks[at.rem_euclid(spans) as usize] + at.div_euclid(spans) as f64 * round_mm
        } else {
            self.breaks[at.clamp(0, spans) as usize]
        }
    }

    /// Which coefficients count in a span.
    fn unknowns(&self, span: usize) -> [usize; 4] {
        let count = if self.is_round { self.spans() } else { self.spans() + 3 };
        [0, 1, 2, 3].map(|k| (span + k) % count)
    }

    /// The four cubic basis functions that are not nought at a way, with their first and second derivatives.
    fn basis(&self, span: usize, way_mm: f64) -> [[f64; 4]; 3] {
        // Of degree d the functions that are not nought begin at knots −d to 0 of the span.
        let knot = |k: isize| self.knot(span, k);
        let mut degrees = [[0.0; 4]; 4];
        degrees[0][0] = 1.0;
        for d in 1..=3usize {
            for k in 0..=d {
                let start = k as isize - d as isize;
                let part = |j: Option<usize>, from: isize, to: isize, is_rising: bool| {
                    let value = j.filter(|j| *j < d).map_or(0.0, |j| degrees[d - 1][j]);
                    let (from, to) = (knot(from), knot(to));
                    let share = if is_rising { way_mm - from } else { to - way_mm };
                    if value == 0.0 { 0.0 } else { value * share / (to - from) }
                };
                degrees[d][k] = part(k.checked_sub(1), start, start + d as isize, true)
                    + part(Some(k), start + 1, start + 1 + d as isize, false);
            }
        }
        let slopes = |d: usize, below: &[f64; 4]| {
            let mut out = [0.0; 4];
            for (k, slope) in out.iter_mut().enumerate().take(d + 1) {
                let start = k as isize - d as isize;
                let part = |j: Option<usize>, from: isize| {
                    let value = j.filter(|j| *j < d).map_or(0.0, |j| below[j]);
                    if value == 0.0 { 0.0 } else { value * d as f64 / (knot(from + d as isize) - knot(from)) }
                };
                *slope = part(k.checked_sub(1), start) - part(Some(k), start + 1);
            }
            out
        };
        [degrees[3], slopes(3, &degrees[2]), slopes(3, &slopes(2, &degrees[1]))]
    }
}

/// A spline: values, and how they change with the way.
#[derive(Clone, Debug)]
pub(super) struct Spline {
    pub(super) knots: Knots,
    coefficients: Vec<Columns>,
}

impl Spline {
    /// The nearest one to values at ways with weights, by least squares.
    pub(super) fn fitted(knots: &Knots, ways_mm: &[f64], values: &[Columns], weights: &[f64]) -> Spline {
        let count = if knots.is_round { knots.spans() } else { knots.spans() + 3 };
        let mut sums = Banded::new(count, knots.is_round);
        for ((&way_mm, value), &weight) in ways_mm.iter().zip(values).zip(weights).filter(|(_, w)| **w > 0.0) {
            let span = knots.span_of(way_mm);
            sums.add(knots.unknowns(span), knots.basis(span, way_mm)[0], value, weight);
        }
        Spline { knots: knots.clone(), coefficients: sums.solved() }
    }

    /// Value, first and second derivative at a way.
    pub(super) fn at(&self, way_mm: f64) -> [Columns; 3] {
        let span = self.knots.span_of(way_mm);
        let unknowns = self.knots.unknowns(span);
        self.knots.basis(span, way_mm).map(|factors| {
            unknowns.iter().zip(factors).fold(Columns::zeros(), |s, (&i, f)| s + self.coefficients[i] * f)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn knots(is_round: bool) -> Knots {
        Knots { breaks: vec![0.0, 0.7, 1.6, 2.0, 3.1, 3.9, 4.4, 5.5, TAU], is_round }
    }

    /// Any cubic is a spline of its own: found again with both derivatives.
    #[test]
    fn a_cubic_is_found_again() {
        let cubic = |x: f64| [x * x * x - 2.0 * x, 3.0 * x * x - 2.0, 6.0 * x];
        let ways: Vec<f64> = (0..=200).map(|i| TAU * f64::from(i) / 200.0).collect();
        let values: Vec<Columns> = ways.iter().map(|&x| Columns::repeat(cubic(x)[0])).collect();
        let spline = Spline::fitted(&knots(false), &ways, &values, &vec![1.0; ways.len()]);
        for x in [0.0, 0.3, 1.6, 2.9, 4.4, TAU] {
            for (found, expected) in spline.at(x).iter().zip(cubic(x)) {
                assert!((found[3] - expected).abs() < 1e-6 * (1.0 + expected.abs()), "{x} {} {expected}", found[3]);
            }
        }
    }

    /// A closed one has no seam: value and both derivatives go on over it.
    #[test]
    fn a_closed_spline_has_no_seam_and_follows_a_circle() {
        let ways: Vec<f64> = (0..400).map(|i| TAU * f64::from(i) / 400.0).collect();
        let values: Vec<Columns> =
            ways.iter().map(|&x| Columns::new(libm::cos(x), libm::sin(x), 1.0, 0.0, 0.0)).collect();
        let spline = Spline::fitted(&knots(true), &ways, &values, &vec![1.0; ways.len()]);
        for (a, b) in spline.at(0.0).iter().zip(spline.at(TAU - 1e-12)) {
            assert!((a - b).norm() < 1e-9, "{a} {b}");
        }
        for x in ways {
            let [value, slope, _] = spline.at(x);
            assert!((libm::hypot(value[0], value[1]) - 1.0).abs() < 5e-3 && (value[2] - 1.0).abs() < 1e-9);
            assert!((slope[0] + libm::sin(x)).abs() < 0.02, "{x} {}", slope[0]);
        }
    }
}
