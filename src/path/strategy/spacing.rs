//! The spacing that lines really have: from points of each line straight to the neighbouring line.
//!
//! Points stand no farther apart than lines do: on large facets a line has few points of its own.
//! Straight distance falls short of that over a surface of radius R by `s³/24R²`. Points that look past a
//! neighbour's end (at rims and holes) tell nothing and are passed over, as are those without a
//! neighbour within 6 spacings, more than planes leave where they are counted to reach.

use super::super::live_facets::PARALLEL_DEG;
use super::super::normals::between;
use super::super::section::{SectionPoint, TransversalLine};
use crate::part::distance::point_segment;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Distances of neighbouring lines, measured on the lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Achieved {
    /// The least, mm.
    pub min_mm: f64,
    /// Where, part frame.
    pub min_at: Point3<f64>,
    /// The greatest, mm.
    pub max_mm: f64,
    /// Where, part frame.
    pub max_at: Point3<f64>,
    /// Points of lines and the distance to the line before, mm, in the order of the lines; at most
    /// some ten thousand, evenly chosen.
    pub samples: Vec<(Point3<f64>, f64)>,
}

impl Achieved {
    fn of(samples: Vec<(Point3<f64>, f64)>) -> Option<Achieved> {
        let min = samples.iter().min_by(|a, b| a.1.total_cmp(&b.1))?;
        let max = samples.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(Achieved { min_mm: min.1, min_at: min.0, max_mm: max.1, max_at: max.0, samples })
    }

    /// The spacing of two rasters, each measured by itself.
    pub(super) fn of_both(one: Option<Achieved>, two: Option<Achieved>) -> Option<Achieved> {
        let samples = [one, two].into_iter().flatten().flat_map(|a| a.samples).collect();
        Achieved::of(samples)
    }
}

/// Points measured at most.
const SAMPLES: usize = 40_000;
/// Segments that share a box.
const BLOCK: usize = 16;
/// Neighbours are looked for so many spacings away.
const REACH: f64 = 6.0;

/// Measures lines of ascending rank, each against the rank before; `None` where no point of a line
/// has a neighbour. Of lines cut by planes what those miss (`coverage`) does not count.
pub fn achieved(lines: &[TransversalLine], planes_normal: Option<&Vector3<f64>>, spacing_mm: f64) -> Option<Achieved> {
    let ranks: Vec<Vec<f64>> = lines.iter().map(|l| vec![l.plane as f64; l.points.len()]).collect();
    measured(lines, &ranks, planes_normal, |_| true, spacing_mm)
}

/// Measures lines with a rank for each point, ascending from line to line or along them: the turn of a spiral.
/// The neighbour is what is half a rank to one and a half before; points of which `counts` says no are not
/// measured.
pub(super) fn measured(
    lines: &[TransversalLine],
    ranks: &[Vec<f64>],
    planes_normal: Option<&Vector3<f64>>,
    counts: impl Fn(&Point3<f64>) -> bool,
    spacing_mm: f64,
) -> Option<Achieved> {
    let parallel_sine = libm::sin(PARALLEL_DEG.to_radians());
    let missed = |n: &Vector3<f64>| planes_normal.is_some_and(|m| n.cross(m).norm() < parallel_sine);
    let (segments, blocks) = blocks(lines, ranks);
    // Blocks by their rank: the widest tells how far back one that reaches here may stand.
    let widest = blocks.iter().map(|b| b.ranks.1 - b.ranks.0).fold(0.0, f64::max);
    let sides = || lines.iter().zip(ranks).flat_map(|(line, ranks)| sides(line, ranks));
    let lengths_mm: Vec<f64> = sides().map(|s| s.length_mm()).collect();
    let gap_mm = spacing_mm.max(lengths_mm.iter().sum::<f64>() / SAMPLES as f64);
    // A hair of tolerance: rounding adds no place.
    let places = |length_mm: f64| (length_mm / gap_mm - 1e-9).ceil().max(1.0) as usize;
    let step = (lengths_mm.iter().map(|&l| places(l)).sum::<usize>() / SAMPLES).max(1);
    let chosen: Vec<(Point3<f64>, Vector3<f64>, f64)> = sides()
        .zip(&lengths_mm)
        .flat_map(|(s, &l)| (0..places(l)).map(move |i| (s, i, l)))
        .step_by(step)
        .map(|(s, i, l)| s.at(i as f64 / places(l) as f64))
        .filter(|x| counts(&x.0))
        .collect();
    let samples = chosen
        .par_iter()
        .filter_map(|(p, n, rank)| {
            let (low, high) = (rank - 1.5, rank - 0.5);
            let start = blocks.partition_point(|b| b.ranks.0 < low - widest);
            let to = blocks.partition_point(|b| b.ranks.0 <= high);
            let mut best: (f64, bool) = (REACH * spacing_mm, false);
            for block in blocks[start..to].iter().filter(|b| b.ranks.1 >= low) {
                if block.distance_mm(p) >= best.0 {
                    continue;
                }
                for s in &segments[block.first..block.end] {
                    let distance = point_segment(p, &s.a, &s.b);
                    // The other side of a thin wall is no neighbour.
                    if distance < best.0 && s.n.dot(n) > 0.0 && s.rank >= low && s.rank <= high {
                        best = (distance, s.beside(p, distance) && !missed(&s.n) && !missed(n));
                    }
                }
            }
            best.1.then_some((*p, best.0))
        })
        .collect();
    Achieved::of(samples)
}

/// A side of a line as it is measured from: its first point up to its second, that one excluded.
#[derive(Clone, Copy)]
struct LineSide<'a> {
    ends: [&'a SectionPoint; 2],
    ranks: [f64; 2],
}

/// The sides of a line; behind the last point of an open one a side without length.
fn sides<'a>(line: &'a TransversalLine, ranks: &'a [f64]) -> impl Iterator<Item = LineSide<'a>> + 'a {
    line.points.iter().zip(ranks).enumerate().map(|(i, (from, rank))| {
        let next = line.points.get(i + 1).zip(ranks.get(i + 1));
        // The closing side has one rank, as all closed lines do.
        let closing = line.points.first().filter(|_| line.closed).map(|first| (first, rank));
        let (to, other) = next.or(closing).unwrap_or((from, rank));
        LineSide { ends: [from, to], ranks: [*rank, *other] }
    })
}

impl LineSide<'_> {
    fn length_mm(&self) -> f64 {
        (self.ends[1].p - self.ends[0].p).norm()
    }

    fn at(&self, t: f64) -> (Point3<f64>, Vector3<f64>, f64) {
        let ([from, to], [rank, other]) = (self.ends, self.ranks);
        if t == 0.0 {
            return (from.p, from.n, rank);
        }
        (from.p + (to.p - from.p) * t, between(&from.n, &to.n, t), rank + (other - rank) * t)
    }
}

struct RankedSegment {
    a: Point3<f64>,
    b: Point3<f64>,
    n: Vector3<f64>,
    rank: f64,
    /// Whether the line ends at `a`, at `b`.
    ends: [bool; 2],
}

impl RankedSegment {
    /// Whether a point lies beside the segment and not beyond an end of its line.
    fn beside(&self, p: &Point3<f64>, distance_mm: f64) -> bool {
        let along = (self.b - self.a).normalize();
        let past = [(self.a - p).dot(&along), (p - self.b).dot(&along)];
        // Some 3° beyond the end is still beside it: a rim is seldom quite square to the lines.
        (0..2).all(|k| !self.ends[k] || past[k] <= 0.05 * distance_mm)
    }
}

struct SegmentBlock {
    low: Point3<f64>,
    high: Point3<f64>,
    ranks: (f64, f64),
    first: usize,
    end: usize,
}

impl SegmentBlock {
    fn distance_mm(&self, p: &Point3<f64>) -> f64 {
        (self.low - p).sup(&(p - self.high)).sup(&Vector3::zeros()).norm()
    }
}

fn blocks(lines: &[TransversalLine], ranks: &[Vec<f64>]) -> (Vec<RankedSegment>, Vec<SegmentBlock>) {
    let mut segments: Vec<RankedSegment> = Vec::new();
    let mut blocks: Vec<SegmentBlock> = Vec::new();
    for (line, ranks) in lines.iter().zip(ranks) {
        let first = segments.len();
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
        let mut at = first;
        while at < segments.len() {
            let end = (at + BLOCK).min(segments.len());
            let of = &segments[at..end];
            let (low, high) = crate::part::topology::bounds_of(of.iter().flat_map(|s| [s.a, s.b]));
            let fold = |init: f64, pick: fn(f64, f64) -> f64| of.iter().map(|s| s.rank).fold(init, pick);
            let ranks = (fold(f64::INFINITY, f64::min), fold(f64::NEG_INFINITY, f64::max));
            blocks.push(SegmentBlock { low, high, ranks, first: at, end });
            at = end;
        }
    }
    blocks.sort_by(|a, b| a.ranks.0.total_cmp(&b.ranks.0));
    (segments, blocks)
}
