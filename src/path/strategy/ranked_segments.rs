//! The segments of lines, each with its line's rank, asked for the one nearest to a point among some ranks.
//!
//! Sixteen segments that follow one another share a box, eight boxes in the order of their ranks another one, and so on.

use super::super::section::TransversalLine;
use crate::part::distance::point_segment;
use crate::part::topology::bounds_of;
use nalgebra::{Point3, Vector3};

/// Segments that share a box.
const BLOCK: usize = 16;
/// Boxes that share a box.
const FAN: usize = 8;

/// A segment of a line.
pub(super) struct RankedSegment {
    a: Point3<f64>,
    b: Point3<f64>,
    /// The normal at `a`.
    pub(super) n: Vector3<f64>,
    rank: f64,
    /// Whether the line ends at `a`, at `b`.
    ends: [bool; 2],
}

impl RankedSegment {
    /// Whether a point lies beside the segment and not beyond an end of its line.
    pub(super) fn beside(&self, p: &Point3<f64>, distance_mm: f64) -> bool {
        let along = (self.b - self.a).normalize();
        let past = [(self.a - p).dot(&along), (p - self.b).dot(&along)];
        // Some 3° beyond the end is still beside it: a rim is seldom quite square to the lines.
        (0..2).all(|k| !self.ends[k] || past[k] <= 0.05 * distance_mm)
    }
}

/// The box around some segments, and their least and greatest rank.
#[derive(Clone, Copy)]
struct Around {
    low: Point3<f64>,
    high: Point3<f64>,
    ranks: (f64, f64),
}

impl Around {
    fn of(segments: &[RankedSegment]) -> Around {
        let (low, high) = bounds_of(segments.iter().flat_map(|s| [s.a, s.b]));
        let fold = |init: f64, pick: fn(f64, f64) -> f64| segments.iter().map(|s| s.rank).fold(init, pick);
        Around { low, high, ranks: (fold(f64::INFINITY, f64::min), fold(f64::NEG_INFINITY, f64::max)) }
    }

    fn of_all(some: &[Around]) -> Around {
        let with = |a: Around, b: &Around| Around {
            low: a.low.inf(&b.low),
            high: a.high.sup(&b.high),
            ranks: (a.ranks.0.min(b.ranks.0), a.ranks.1.max(b.ranks.1)),
        };
        some[1..].iter().fold(some[0], with)
    }

    fn distance_mm(&self, p: &Point3<f64>) -> f64 {
        (self.low - p).sup(&(p - self.high)).sup(&Vector3::zeros()).norm()
    }
}

/// What is asked for: the segment nearest to a point, with a rank between two, on the side of `n`.
#[derive(Clone, Copy)]
pub(super) struct Asked<'a> {
    /// The point, mm.
    pub(super) p: &'a Point3<f64>,
    /// The normal there: the other side of a thin wall is no neighbour.
    pub(super) n: &'a Vector3<f64>,
    /// Least and greatest rank.
    pub(super) ranks: (f64, f64),
}

/// The nearest segment that was found: how far, and where it stands.
#[derive(Clone, Copy)]
pub(super) struct NearestSegment {
    pub(super) distance_mm: f64,
    block: usize,
    segment: usize,
}

/// Segments of lines in the order of their ranks.
pub(super) struct RankedSegments {
    segments: Vec<RankedSegment>,
    /// First segment of each block, and the one behind its last.
    blocks: Vec<(usize, usize)>,
    /// The blocks' boxes, then level after level those around them.
    levels: Vec<Vec<Around>>,
}

impl RankedSegments {
    /// Of lines with a rank for each point.
    pub(super) fn new(lines: &[TransversalLine], ranks: &[Vec<f64>]) -> RankedSegments {
        let mut segments: Vec<RankedSegment> = Vec::new();
        let mut blocks: Vec<(Around, (usize, usize))> = Vec::new();
        for (line, ranks) in lines.iter().zip(ranks) {
            let mut at = segments.len();
            push_segments(&mut segments, line, ranks);
            while at < segments.len() {
                let end = (at + BLOCK).min(segments.len());
                blocks.push((Around::of(&segments[at..end]), (at, end)));
                at = end;
            }
        }
        blocks.sort_by(|a, b| a.0.ranks.0.total_cmp(&b.0.ranks.0));
        let mut levels = vec![blocks.iter().map(|b| b.0).collect::<Vec<Around>>()];
        while let Some(last) = levels.last().filter(|last| last.len() > FAN) {
            levels.push(last.chunks(FAN).map(Around::of_all).collect());
        }
        RankedSegments { segments, blocks: blocks.into_iter().map(|b| b.1).collect(), levels }
    }

    /// The segment that was found.
    pub(super) fn at(&self, found: &NearestSegment) -> &RankedSegment {
        &self.segments[found.segment]
    }

    /// The nearest one, the first of several; `None`: none is nearer than `reach_mm`. `guess`: one that is likely to be
    /// near.
    pub(super) fn nearest(
        &self,
        asked: &Asked<'_>,
        reach_mm: f64,
        guess: Option<NearestSegment>,
    ) -> Option<NearestSegment> {
        let mut best: Option<NearestSegment> = None;
        if let Some(guess) = guess {
            self.look(asked, guess.block, reach_mm, &mut best);
        }
        let top = self.levels.len() - 1;
        let mut next: Vec<(usize, usize)> = (0..self.levels[top].len()).rev().map(|i| (top, i)).collect();
        while let Some((level, i)) = next.pop() {
            let around = &self.levels[level][i];
            let is_of_rank = around.ranks.0 <= asked.ranks.1 && around.ranks.1 >= asked.ranks.0;
            if !is_of_rank || around.distance_mm(asked.p) > best.map_or(reach_mm, |b| b.distance_mm) {
                continue;
            }
            if level == 0 {
                self.look(asked, i, reach_mm, &mut best);
            } else {
                let end = (FAN * (i + 1)).min(self.levels[level - 1].len());
                next.extend((FAN * i..end).rev().map(|i| (level - 1, i)));
            }
        }
        best
    }

    fn look(&self, asked: &Asked<'_>, block: usize, reach_mm: f64, best: &mut Option<NearestSegment>) {
        let (first, end) = self.blocks[block];
        for segment in first..end {
            let s = &self.segments[segment];
            let distance_mm = point_segment(asked.p, &s.a, &s.b);
            let is_better = match best {
                None => distance_mm < reach_mm,
                Some(b) => (distance_mm, block, segment) < (b.distance_mm, b.block, b.segment),
            };
            if is_better && s.n.dot(asked.n) > 0.0 && s.rank >= asked.ranks.0 && s.rank <= asked.ranks.1 {
                *best = Some(NearestSegment { distance_mm, block, segment });
            }
        }
    }
}

fn push_segments(segments: &mut Vec<RankedSegment>, line: &TransversalLine, ranks: &[f64]) {
    let count = line.points.len();
    let pieces = if line.closed { count } else { count.saturating_sub(1) };
    for i in 0..pieces {
        let (Some(a), Some(b), Some(rank)) = (line.points.get(i), line.points.get((i + 1) % count), ranks.get(i))
        else {
            continue;
        };
        if a.p != b.p {
            let ends = [!line.closed && i == 0, !line.closed && i + 1 == pieces];
            segments.push(RankedSegment { a: a.p, b: b.p, n: a.n, rank: *rank, ends });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::section::SectionPoint;
    use proptest::prelude::*;

    proptest! {
        /// The nearest is that of all, the first of several, whatever is guessed.
        #[test]
        fn the_nearest_is_that_of_all(places in prop::collection::vec(prop::array::uniform3(-4..4i32), 2..400),
                                      length in 2..60usize, p in prop::array::uniform3(-4..4i32), rank in 0..9usize) {
            let point = |c: &[i32; 3]| Point3::from(c.map(f64::from));
            let lines: Vec<TransversalLine> = places
                .chunks(length)
                .enumerate()
                .map(|(plane, c)| {
                    let points = c.iter().map(|c| SectionPoint { p: point(c), n: Vector3::z() }).collect();
                    TransversalLine { plane, points, closed: false, dark: Vec::new() }
                })
                .collect();
            let ranks: Vec<Vec<f64>> = lines.iter().map(|l| vec![l.plane as f64; l.points.len()]).collect();
            let all = RankedSegments::new(&lines, &ranks);
            let (p, n) = (point(&p), Vector3::z());
            let asked = Asked { p: &p, n: &n, ranks: (rank as f64 - 0.5, rank as f64 + 0.5) };
            let of_rank = all.segments.iter().enumerate().filter(|(_, s)| s.rank == rank as f64);
            let expected = of_rank
                .map(|(i, s)| (point_segment(&p, &s.a, &s.b), i))
                .filter(|(mm, _)| *mm < 3.0)
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let found = |guess| all.nearest(&asked, 3.0, guess).map(|f| (f.distance_mm, f.segment));
            prop_assert_eq!(found(None), expected);
            for block in 0..all.blocks.len() {
                let guess = NearestSegment { distance_mm: 0.0, block, segment: 0 };
                prop_assert_eq!(found(Some(guess)), expected);
            }
        }
    }
}
