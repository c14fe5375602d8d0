//! Arch height (P2 4.2.2): what a chord of a dense line may span. Which chords are taken, `reduce` says.
//!
//! The promise: every dropped point lies within the chord error of the kept chord that spans it;
//! no chord is longer, or turns the normal more, than allowed.

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
    /// At a point.
    pub(super) fn point(index: usize) -> LinePlace {
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
    pub(super) fn until(self, to: LinePlace) -> std::ops::Range<usize> {
        self.index + 1..to.index + usize::from(to.share > 0.0)
    }
}

/// Whether the chord from one place to another keeps the promise.
pub(super) fn spans(points: &[DensePoint], from: LinePlace, to: LinePlace, limits: &ChordLimits) -> bool {
    // The tolerance keeps rounding from losing one of a whole number of gaps.
    length_mm(points, from, to) <= limits.max_step_mm * (1.0 + 1e-9)
        && turn_deg(points, from, to) <= limits.max_turn_deg + 1e-9
        && chord_error_mm(points, from, to) <= limits.chord_error_mm
}

/// How much of what it may be the chord from one place to another is: 1 where it can be no longer.
pub(super) fn share_of_limits(points: &[DensePoint], from: LinePlace, to: LinePlace, limits: &ChordLimits) -> f64 {
    // The arch grows with the square of the chord.
    let arch = (chord_error_mm(points, from, to) / limits.chord_error_mm).sqrt();
    let turn = turn_deg(points, from, to) / limits.max_turn_deg;
    (length_mm(points, from, to) / limits.max_step_mm).max(turn).max(arch)
}

/// Length of the chord between two places, mm.
pub(super) fn length_mm(points: &[DensePoint], from: LinePlace, to: LinePlace) -> f64 {
    (to.point_on(points).p - from.point_on(points).p).norm()
}

/// How far the normal turns away from where it stands at the first place, degrees: a bump returns to its first normal,
/// so dropped points count as well.
fn turn_deg(points: &[DensePoint], from: LinePlace, to: LinePlace) -> f64 {
    let (a, b) = (from.point_on(points), to.point_on(points));
    points[from.until(to)].iter().chain([&b]).map(|q| angle::between_deg(&a.n, &q.n)).fold(0.0, f64::max)
}

/// Largest distance of the points between two places from the chord that joins them, mm.
pub fn chord_error_mm(points: &[DensePoint], from: LinePlace, to: LinePlace) -> f64 {
    let (a, b) = (from.point_on(points).p, to.point_on(points).p);
    points[from.until(to)].iter().map(|q| point_segment(&q.p, &a, &b)).fold(0.0, f64::max)
}
