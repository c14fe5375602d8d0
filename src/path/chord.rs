//! Arch height (P2 4.2.2): which points of a dense line are kept.
//!
//! The promise: every dropped point lies within the chord error of the kept chord that spans it;
//! no chord is longer, or turns the normal more, than allowed. From each kept point the farthest
//! one that keeps the promise is taken, P2's own way, checked against all points between: on a
//! circle of radius R that is within one of `ceil(π / acos(1 − dε/R))`.

use super::dense::DensePoint;
use crate::part::{angle, distance::point_segment};

/// What a chord may span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChordLimits {
    /// Distance of a dropped point from its chord, mm.
    pub chord_error_mm: f64,
    /// Length of a chord, mm.
    pub max_step_mm: f64,
    /// Turn of the surface normal between its ends, degrees.
    pub max_turn_deg: f64,
}

/// Indices of the points to keep: first and last always, and those marked in `fixed`.
///
/// `may_span(i, j)` is asked last, where all else allows the chord from point i to point j.
pub fn simplify(
    points: &[DensePoint],
    fixed: &[bool],
    limits: &ChordLimits,
    mut may_span: impl FnMut(usize, usize) -> bool,
) -> Vec<usize> {
    let mut kept = vec![0];
    let mut from = 0;
    while from + 1 < points.len() {
        let mut to = from + 1;
        while to + 1 < points.len() && !fixed[to] && spans(points, from, to + 1, limits) && may_span(from, to + 1) {
            to += 1;
        }
        kept.push(to);
        from = to;
    }
    kept
}

fn spans(points: &[DensePoint], i: usize, j: usize, limits: &ChordLimits) -> bool {
    let (a, b) = (&points[i], &points[j]);
    // Dropped points may not lie beyond a chord's turn either: a bump returns to its first normal.
    (b.p - a.p).norm() <= limits.max_step_mm
        && points[i + 1..=j].iter().all(|q| angle::between_deg(&a.n, &q.n) <= limits.max_turn_deg)
        && chord_error_mm(points, i, j) <= limits.chord_error_mm
}

/// Largest distance of the points between i and j from the chord i–j, mm.
pub fn chord_error_mm(points: &[DensePoint], i: usize, j: usize) -> f64 {
    points[i + 1..j].iter().map(|q| point_segment(&q.p, &points[i].p, &points[j].p)).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Point3, Vector3};
    use proptest::prelude::*;

    fn circle(radius: f64, count: usize) -> Vec<DensePoint> {
        (0..=count)
            .map(|i| {
                let a = (i % count) as f64 / count as f64 * std::f64::consts::TAU;
                let n = Vector3::new(libm::cos(a), libm::sin(a), 0.0);
                DensePoint { p: Point3::from(n * radius), n }
            })
            .collect()
    }

    const WIDE: ChordLimits = ChordLimits { chord_error_mm: 0.5, max_step_mm: 1e9, max_turn_deg: 90.0 };

    #[test]
    fn a_circle_needs_what_the_closed_form_says() {
        for (radius, error) in [(23.0, 0.5), (23.0, 0.02), (10.0, 0.1), (5.0, 0.5)] {
            let points = circle(radius, 2880);
            let limits = ChordLimits { chord_error_mm: error, ..WIDE };
            let chords = simplify(&points, &vec![false; points.len()], &limits, |_, _| true).len() - 1;
            let best = (std::f64::consts::PI / libm::acos(1.0 - error / radius)).ceil() as usize;
            assert!(chords >= best && chords <= best + 1, "R {radius} dε {error}: {chords} against {best}");
        }
    }

    proptest! {
        #[test]
        fn the_promise_holds(steps in prop::collection::vec((-1.0..1.0f64, -1.0..1.0f64, -0.2..0.2f64), 2..120),
                             error in 0.001..1.0f64, step in 0.5..20.0f64, turn in 1.0..60.0f64) {
            let mut p = Point3::origin();
            let mut a = 0.0f64;
            let points: Vec<DensePoint> = steps.iter().map(|(x, y, t)| {
                p += Vector3::new(x * 0.4, y * 0.4, 0.0);
                a += t;
                DensePoint { p, n: Vector3::new(libm::sin(a), 0.0, libm::cos(a)) }
            }).collect();
            let limits = ChordLimits { chord_error_mm: error, max_step_mm: step, max_turn_deg: turn };
            let kept = simplify(&points, &vec![false; points.len()], &limits, |_, _| true);
            prop_assert_eq!((kept[0], kept[kept.len() - 1]), (0, points.len() - 1));
            for w in kept.windows(2).filter(|w| w[1] > w[0] + 1) {
                prop_assert!(chord_error_mm(&points, w[0], w[1]) <= error);
                prop_assert!((points[w[1]].p - points[w[0]].p).norm() <= step);
                prop_assert!(angle::between_deg(&points[w[0]].n, &points[w[1]].n) <= turn + 1e-9);
            }
        }
    }
}
