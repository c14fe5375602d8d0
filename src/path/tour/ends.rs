//! The lines of a tour: where each is entered and left, and the way between.

use super::sense::Sense;
use crate::path::section::TransversalLine;
use nalgebra::Point3;

/// A visit to a line: entry 0 of an open line is its first point, 1 its last; of a closed line it is the
/// point at which it is begun.
#[derive(Clone, Copy, Debug)]
pub(super) struct LineVisit {
    pub line: usize,
    pub entry: usize,
    /// Where it is entered and left.
    pub enter: Point3<f64>,
    pub leave: Point3<f64>,
}

impl LineVisit {
    /// Way to the next, mm.
    pub fn to(&self, next: &LineVisit) -> f64 {
        (next.enter - self.leave).norm()
    }
}

/// All lines of a tour, with the start and the sense they may be run in.
pub(super) struct TourLines<'a> {
    lines: &'a [TransversalLine],
    pub start: Option<Point3<f64>>,
    pub sense: Sense,
}

impl<'a> TourLines<'a> {
    /// Lines must have points.
    pub fn new(lines: &'a [TransversalLine], start: Option<Point3<f64>>, sense: Sense) -> TourLines<'a> {
        TourLines { lines, start, sense }
    }

    pub fn count(&self) -> usize {
        self.lines.len()
    }

    pub fn is_closed(&self, line: usize) -> bool {
        self.lines[line].closed
    }

    /// How many entries a line has.
    pub fn entries(&self, line: usize) -> usize {
        match (self.lines[line].closed, self.sense) {
            (true, _) => self.lines[line].points.len(),
            (false, Sense::Either) => 2,
            (false, Sense::Kept) => 1,
        }
    }

    /// The visit of a line from one of its entries; an open line has 1 also where its sense is kept.
    pub fn visit(&self, line: usize, entry: usize) -> LineVisit {
        let points = &self.lines[line].points;
        if self.lines[line].closed {
            let seam = points[entry].p;
            return LineVisit { line, entry, enter: seam, leave: seam };
        }
        let (first, last) = (points[0].p, points[points.len() - 1].p);
        let (enter, leave) = if entry == 0 { (first, last) } else { (last, first) };
        LineVisit { line, entry, enter, leave }
    }

    /// This line, run the other way; a closed line has one sense only.
    pub fn turned(&self, visit: LineVisit) -> LineVisit {
        if self.is_closed(visit.line) {
            return visit;
        }
        LineVisit { line: visit.line, entry: 1 - visit.entry, enter: visit.leave, leave: visit.enter }
    }

    /// Way from one line to the next, mm. Before the first: from the start; behind the last: none.
    pub fn hop(&self, from: Option<&LineVisit>, to: Option<&LineVisit>) -> f64 {
        let Some(to) = to else { return 0.0 };
        match (from, self.start) {
            (Some(from), _) => from.to(to),
            (None, Some(start)) => (to.enter - start).norm(),
            (None, None) => 0.0,
        }
    }

    /// Way of a whole order, mm.
    pub fn way_mm(&self, order: &[LineVisit]) -> f64 {
        let first = self.hop(None, order.first());
        order.windows(2).map(|w| w[0].to(&w[1])).fold(first, |a, b| a + b)
    }

    /// Some entries of a line: both ends, or points spread over a closed line.
    pub fn some_entries(&self, line: usize, most: usize) -> impl Iterator<Item = LineVisit> {
        let all = self.entries(line);
        let count = all.min(if self.is_closed(line) { most } else { 2 });
        (0..count).map(move |i| self.visit(line, i * all / count))
    }

    /// The point of a closed line that is nearest to all of these together.
    pub fn nearest_seam(&self, line: usize, to: &[Point3<f64>]) -> usize {
        let far =
            |seam: &usize| to.iter().map(|p| (self.lines[line].points[*seam].p - p).norm()).fold(0.0, |a, b| a + b);
        let mut best = (f64::INFINITY, 0);
        for seam in 0..self.lines[line].points.len() {
            let mm = far(&seam);
            if mm < best.0 {
                best = (mm, seam);
            }
        }
        best.1
    }
}

/// Turns or rotates a line so that it begins at this entry.
pub(super) fn run_from(mut line: TransversalLine, entry: usize) -> TransversalLine {
    if line.closed {
        line.points.rotate_left(entry);
        return line;
    }
    if entry == 0 { line } else { line.reversed() }
}
