//! Which places of a dense line become targets: as few as the chord limits allow, and those evenly.
//!
//! Corners, which no chord can leave out, and points that the caller fixes divide a line into stretches. In a stretch
//! the farthest place that keeps the promise is taken from each place on, as P2 does, checked against all points
//! between: on a circle of radius R that is within one of `ceil(π / acos(1 − dε/R))`. Then its chords share what the
//! last of them would leave over, as far as they keep the promise so: 20.008 mm in steps of 5 mm at most are five of
//! 4.0016 mm, and not four and a rest of 8 µm, which no controller drives at the speed of the others.

use super::chord::{ChordLimits, LinePlace, chord_error_mm, length_mm, share_of_limits, spans};
use super::dense::DensePoint;

/// So many halvings find the end of a chord between two points of the dense line: to a billionth of their gap, so that a
/// part that stands elsewhere has its targets in the same places to less than anything that is written.
const END_HALVINGS: usize = 30;
/// Where the last two chords of a stretch cannot be of one length, the place between them is moved by less: by these
/// shares of the way.
const LESS: [f64; 3] = [0.5, 0.25, 0.125];

/// The places to keep: first and last point always, the points marked in `fixed`, and corners.
///
/// `may_span` is asked last, where all else allows the chord from one place to another.
pub fn simplify(
    points: &[DensePoint],
    fixed: &[bool],
    limits: &ChordLimits,
    may_span: impl FnMut(LinePlace, LinePlace) -> bool,
) -> Vec<LinePlace> {
    let mut reduction = Reduction { points, limits, may_span };
    let last = points.len() - 1;
    let mut kept = vec![LinePlace::point(0)];
    let mut from = 0;
    while from < last {
        let to = (from + 1..last).find(|&i| fixed[i] || reduction.is_corner(i)).unwrap_or(last);
        let farthest = reduction.farthest(from, to);
        kept.extend(reduction.evened(farthest).into_iter().skip(1));
        from = to;
    }
    kept
}

/// A line that is being reduced.
struct Reduction<'a, F> {
    points: &'a [DensePoint],
    limits: &'a ChordLimits,
    may_span: F,
}

impl<F: FnMut(LinePlace, LinePlace) -> bool> Reduction<'_, F> {
    /// Whether even the chord between the neighbours of a point is too far from it.
    fn is_corner(&self, i: usize) -> bool {
        let [before, behind] = [i - 1, i + 1].map(LinePlace::point);
        chord_error_mm(self.points, before, behind) > self.limits.chord_error_mm
    }

    /// From one point to another in chords that are each as long as they may be.
    fn farthest(&mut self, first: usize, last: usize) -> Vec<LinePlace> {
        let mut kept = vec![LinePlace::point(first)];
        let mut from = LinePlace::point(first);
        while from.index < last {
            let end = self.farthest_from(from, last);
            kept.push(end);
            from = end;
        }
        kept
    }

    /// The farthest place that a chord may lead to from another, up to the point `last`.
    fn farthest_from(&mut self, from: LinePlace, last: usize) -> LinePlace {
        let (points, limits) = (self.points, self.limits);
        let mut to = from.index + 1;
        while to < last && spans(points, from, LinePlace::point(to + 1), limits) {
            to += 1;
        }
        let mut end = LinePlace::point(to);
        if to < last {
            // Part of the way to the next point may still do; so few chords reach their limit by chance.
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..END_HALVINGS {
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
        if (end.share > 0.0 || to > good) && !(self.may_span)(from, end) {
            while bad > good + 1 {
                let middle = usize::midpoint(good, bad);
                if (self.may_span)(from, LinePlace::point(middle)) { good = middle } else { bad = middle }
            }
            end = LinePlace::point(good);
        }
        end
    }

    /// Places whose last chord may be short, moved so that the chords share what it leaves over: all of them, or those
    /// behind the last one that would break the promise.
    fn evened(&mut self, mut places: Vec<LinePlace>) -> Vec<LinePlace> {
        let mut first = 0;
        while places.len() - first > 2 {
            let tail = &places[first..];
            let even = self.spread(tail, self.even_share(tail));
            let Some(bad) = self.last_bad(&even) else {
                places.splice(first.., even);
                return places;
            };
            // At least the last two are tried.
            first = (first + bad + 1).min(places.len() - 3).max(first + 1);
        }
        if places.len() > 2 {
            let tail = &places[places.len() - 3..];
            let even = self.even_share(tail);
            let less = LESS.map(|by| self.spread(tail, 1.0 - by * (1.0 - even)));
            if let Some(better) = less.into_iter().find(|tail| self.last_bad(tail).is_none()) {
                places.splice(places.len() - 3.., better);
            }
        }
        places
    }

    /// What share of a full chord each has to be for all to be alike.
    fn even_share(&self, places: &[LinePlace]) -> f64 {
        let [.., before, from, to] = *places else { return 1.0 };
        let of_limits = share_of_limits(self.points, from, to, self.limits);
        // Where something else keeps chords short, the one before tells how short.
        let of_last = length_mm(self.points, from, to) / length_mm(self.points, before, from).max(1e-12);
        let last = of_limits.max(of_last).min(1.0);
        let chords = (places.len() - 1) as f64;
        (chords - 1.0 + last) / chords
    }

    /// The places between the first and the last, each drawn back to so many full chords from the first.
    fn spread(&self, places: &[LinePlace], share: f64) -> Vec<LinePlace> {
        let last = places.len() - 1;
        let at = |k: usize| {
            let at = share * k as f64;
            // Rounding must not lead beyond the places there are.
            let chord = (at as usize).min(last - 2);
            self.between(places[chord], places[chord + 1], (at - chord as f64).min(1.0))
        };
        std::iter::once(places[0]).chain((1..last).map(at)).chain([places[last]]).collect()
    }

    /// The place at a share of the way along the dense line.
    fn between(&self, from: LinePlace, to: LinePlace, share: f64) -> LinePlace {
        let stops: Vec<LinePlace> =
            std::iter::once(from).chain(from.until(to).map(LinePlace::point)).chain([to]).collect();
        let ways: Vec<f64> = stops.windows(2).map(|w| length_mm(self.points, w[0], w[1])).collect();
        let mut left_mm = share * ways.iter().sum::<f64>();
        for (ends, way_mm) in stops.windows(2).zip(&ways) {
            if left_mm < *way_mm {
                // `from` may lie behind its point, and `to` is then the next point.
                let end_share = if ends[1].index > ends[0].index { 1.0 } else { ends[1].share };
                let share = ends[0].share + (end_share - ends[0].share) * left_mm / way_mm;
                return LinePlace { index: ends[0].index, share: if share < 1e-9 { 0.0 } else { share } };
            }
            left_mm -= way_mm;
        }
        to
    }

    /// The last chord that breaks the promise.
    fn last_bad(&mut self, places: &[LinePlace]) -> Option<usize> {
        let fits = |r: &mut Self, w: &[LinePlace]| spans(r.points, w[0], w[1], r.limits) && (r.may_span)(w[0], w[1]);
        (0..places.len() - 1).rev().find(|&i| !fits(self, &places[i..i + 2]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::angle;
    use crate::path::dense::dense;
    use crate::path::section::{SectionPoint, TransversalLine};
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

        /// Straight stretches between corners, each of its own length: its steps are of one length, as long as they
        /// may be; and nothing is longer than allowed.
        #[test]
        fn steps_of_a_straight_stretch_are_alike(legs in prop::collection::vec((0.3..30.0f64, 20.0..160.0f64), 1..6),
                                                 step in 0.5..8.0f64, gap in 0.1..0.5f64) {
            let (mut p, mut heading) = (Point3::origin(), 0.0f64);
            let mut corners = vec![p];
            for (length, turn) in &legs {
                p += Vector3::new(libm::cos(heading), libm::sin(heading), 0.0) * *length;
                heading += turn.to_radians();
                corners.push(p);
            }
            let points: Vec<SectionPoint> = corners.iter().map(|p| SectionPoint { p: *p, n: Vector3::z() }).collect();
            let line = TransversalLine { plane: 0, points, closed: false, dark: vec![] };
            let dense = dense(&line, gap.min(step), 2.0);
            let limits = ChordLimits { chord_error_mm: 0.01, max_step_mm: step, max_turn_deg: 5.0 };
            let kept: Vec<Point3<f64>> =
                simplify(&dense, &vec![false; dense.len()], &limits, |_, _| true).iter().map(|k| k.point_on(&dense).p).collect();
            let mut at = 0;
            for leg in corners.windows(2) {
                let end = at + kept[at..].iter().position(|q| (q - leg[1]).norm() < 1e-9).expect("corners stay");
                let length = (leg[1] - leg[0]).norm();
                let least = (length / step * (1.0 - 1e-9)).ceil().max(1.0) as usize;
                prop_assert!(end - at == least || (end - at == least + 1 && length / step > least as f64 - 0.01));
                for w in kept[at..=end].windows(2) {
                    prop_assert!(((w[1] - w[0]).norm() - length / (end - at) as f64).abs() < 1e-6);
                }
                at = end;
            }
        }

        /// On any line, no two neighbours could be evened further without breaking a bound or a thing fixed: what is
        /// kept is as few chords as before, and a short one stands only beside what forbids to share.
        #[test]
        fn a_short_step_has_a_reason(bends in prop::collection::vec((2.0..12.0f64, -0.12..0.12f64), 1..8), step in 1.0..6.0f64) {
            let (mut p, mut heading) = (Point3::origin(), 0.0f64);
            let mut points = vec![DensePoint { p, n: Vector3::z() }];
            for (length, bend) in &bends {
                for _ in 0..(length / 0.25) as usize {
                    heading += bend * 0.25;
                    p += Vector3::new(libm::cos(heading), libm::sin(heading), 0.0) * 0.25;
                    points.push(DensePoint { p, n: Vector3::z() });
                }
            }
            let limits = ChordLimits { chord_error_mm: 0.02, max_step_mm: step, max_turn_deg: 5.0 };
            let kept = simplify(&points, &vec![false; points.len()], &limits, |_, _| true);
            for w in kept.windows(2) {
                prop_assert!(w[0].until(w[1]).is_empty() || spans(&points, w[0], w[1], &limits));
            }
            let lengths: Vec<f64> = kept.windows(2).map(|w| length_mm(&points, w[0], w[1])).collect();
            for (i, w) in lengths.windows(2).enumerate().filter(|(_, w)| w[1] < 0.1 * w[0]) {
                // Half of what is missing cannot be taken from the longer one.
                let back = Reduction { points: &points, limits: &limits, may_span: |_, _| true }
                    .between(kept[i], kept[i + 1], 1.0 - 0.5 * (1.0 - w[1] / w[0]));
                prop_assert!(!spans(&points, back, kept[i + 2], &limits), "{:?}", w);
            }
        }
    }

    #[test]
    fn a_rest_is_shared_by_all() {
        let at = |x: f64, y: f64| SectionPoint { p: Point3::new(x, y, 0.0), n: Vector3::z() };
        let limits = ChordLimits { chord_error_mm: 0.02, max_step_mm: 5.0, max_turn_deg: 5.0 };
        let lengths = |points: Vec<SectionPoint>, closed: bool| -> Vec<f64> {
            let points = dense(&TransversalLine { plane: 0, points, closed, dark: vec![] }, 0.25, 2.0);
            let kept = simplify(&points, &vec![false; points.len()], &limits, |_, _| true);
            kept.windows(2).map(|w| length_mm(&points, w[0], w[1])).collect()
        };
        let side = 20.008;
        let line = lengths(vec![at(0.0, 0.0), at(side, 0.0)], false);
        assert!(line.len() == 5 && line.iter().all(|l| (l - 4.0016).abs() < 1e-9), "{line:?}");
        let square = lengths(vec![at(0.0, 0.0), at(side, 0.0), at(side, side), at(0.0, side)], true);
        assert!(square.len() == 20 && square.iter().all(|l| (l - 4.0016).abs() < 1e-9), "{square:?}");
    }
}
