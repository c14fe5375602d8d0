//! The spacing that lines really have: from points of each line straight to the neighbouring line.
//!
//! Points stand no farther apart than lines do: on large facets a line has few points of its own.
//! Straight distance falls short of that over a surface of radius R by `s³/24R²`. Points that look past a
//! neighbour's end (at rims and holes) tell nothing and are passed over, as are those without a
//! neighbour within 6 spacings, more than planes leave where they are counted to reach.

use super::super::live_facets::PARALLEL_DEG;
use super::super::normals::between;
use super::super::section::{SectionPoint, TransversalLine};
use super::ranked_segments::{Asked, RankedSegments};
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
/// Points that are measured one after another.
const ALONG: usize = 256;
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
    let segments = RankedSegments::new(lines, ranks);
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
        .par_chunks(ALONG)
        .flat_map_iter(|chunk| {
            // Along a line the neighbour runs along.
            let mut last = None;
            let segments = &segments;
            chunk.iter().filter_map(move |(p, n, rank)| {
                let asked = Asked { p, n, ranks: (rank - 1.5, rank - 0.5) };
                let found = segments.nearest(&asked, REACH * spacing_mm, last)?;
                last = Some(found);
                let s = segments.at(&found);
                let counts = s.beside(p, found.distance_mm) && !missed(&s.n) && !missed(n);
                counts.then_some((*p, found.distance_mm))
            })
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
