//! Arch height (P2 4.2.2): which points of a dense line are kept.
//!
//! The promise: every dropped point lies within the chord error of the kept chord that spans it;
//! no chord is longer, or turns the normal more, than allowed. From each kept point the farthest
//! one that keeps the promise is taken, as P2 does, checked against all points between: on a
//! circle of radius R that is within one of `ceil(π / acos(1 − dε/R))`.

use super::dense::{DensePoint, midway};
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

crate::part::keyed!(ChordLimits { chord_error_mm, max_step_mm, max_turn_deg });

/// A place on a dense line: at a point, or between it and the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinePlace {
    /// Index of the point.
    pub index: usize,
    /// Share of the way to the next point, 0 to 1 (1 excluded).
    pub share: f64,
}

impl LinePlace {
    fn point(index: usize) -> LinePlace {
        LinePlace { index, share: 0.0 }
    }

    /// The point at this place.
    pub fn point_on(self, points: &[DensePoint]) -> DensePoint {
        if self.share == 0.0 {
            return points[self.index];
        }
        midway(&points[self.index], &points[self.index + 1], self.share)
    }

    /// Points strictly between this place and a later one.
    fn until(self, to: LinePlace) -> std::ops::Range<usize> {
        self.index + 1..to.index + usize::from(to.share > 0.0)
    }
}

/// The places to keep: first and last point always, and the points marked in `fixed`.
///
/// `may_span` is asked last, where all else allows the chord from one place to another.
pub fn simplify(
    points: &[DensePoint],
    fixed: &[bool],
    limits: &ChordLimits,
    mut may_span: impl FnMut(LinePlace, LinePlace) -> bool,
) -> Vec<LinePlace> {
    let mut kept = vec![LinePlace::point(0)];
    let mut from = LinePlace::point(0);
    let last = points.len() - 1;
    while from.index < last {
        let mut to = from.index + 1;
        while to < last && !fixed[to] && spans(points, from, LinePlace::point(to + 1), limits) {
            to += 1;
        }
        let mut end = LinePlace::point(to);
        if to < last && !fixed[to] {
            // Part of the way to the next point may still do; so few chords reach their limit by chance.
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..6 {
                let middle = 0.5 * (low + high);
                if spans(points, from, LinePlace { index: to, share: middle }, limits) {
                    low = middle
                } else {
                    high = middle
                }
            }
            end.share = low;
        }
        // `may_span` is expensive: it is asked of the farthest place first, then by bisection.
        let (mut good, mut bad) = (from.index + 1, to + usize::from(end.share > 0.0));
        if (end.share > 0.0 || to > good) && !may_span(from, end) {
            while bad > good + 1 {
                let middle = usize::midpoint(good, bad);
                if may_span(from, LinePlace::point(middle)) { good = middle } else { bad = middle }
            }
            end = LinePlace::point(good);
        }
        kept.push(end);
        from = end;
    }
    kept
}

fn spans(points: &[DensePoint], from: LinePlace, to: LinePlace, limits: &ChordLimits) -> bool {
    let (a, b) = (from.point_on(points), to.point_on(points));
    let turn = |q: &DensePoint| angle::between_deg(&a.n, &q.n);
    // Dropped points may not lie beyond a chord's turn either: a bump returns to its first normal.
    // The tolerance keeps rounding from losing one of a whole number of gaps.
    (b.p - a.p).norm() <= limits.max_step_mm * (1.0 + 1e-9)
        && points[from.until(to)].iter().chain([&b]).all(|q| turn(q) <= limits.max_turn_deg + 1e-9)
        && chord_error_mm(points, from, to) <= limits.chord_error_mm
}

/// Largest distance of the points between two places from the chord that joins them, mm.
pub fn chord_error_mm(points: &[DensePoint], from: LinePlace, to: LinePlace) -> f64 {
    let (a, b) = (from.point_on(points).p, to.point_on(points).p);
    points[from.until(to)].iter().map(|q| point_segment(&q.p, &a, &b)).fold(0.0, f64::max)
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
        // As dense as the lines of the default spacing, or sparser.
        for (radius, error, gap) in [(23.0, 0.5, 0.25), (23.0, 0.02, 0.25), (10.0, 0.1, 0.5), (5.0, 0.02, 0.17)] {
            let points = circle(radius, (std::f64::consts::TAU * radius / gap) as usize);
            let limits = ChordLimits { chord_error_mm: error, ..WIDE };
            let chords = simplify(&points, &vec![false; points.len()], &limits, |_, _| true).len() - 1;
            let best = (std::f64::consts::PI / libm::acos(1.0 - error / radius)).ceil();
            let over = chords as f64 / best - 1.0;
            assert!((-0.03..=0.07).contains(&over), "R {radius} dε {error}: {chords} against {best}");
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
            prop_assert_eq!((kept[0], kept[kept.len() - 1]), (LinePlace::point(0), LinePlace::point(points.len() - 1)));
            for w in kept.windows(2) {
                // Neighbours of the dense line are not cut further here.
                if w[0].until(w[1]).is_empty() { continue }
                let (a, b) = (w[0].point_on(&points), w[1].point_on(&points));
                prop_assert!(chord_error_mm(&points, w[0], w[1]) <= error);
                prop_assert!((b.p - a.p).norm() <= step * (1.0 + 1e-9));
                prop_assert!(angle::between_deg(&a.n, &b.n) <= turn + 1e-9);
            }
        }
    }
}
