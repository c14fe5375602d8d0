//! Pieces of one rank become one line where they face each other over a short gap; what is still short is
//! dropped.

use crate::part::angle::between_deg;
use crate::path::section::TransversalLine;
use nalgebra::{Point3, Vector3};

/// The ends of two pieces and the gap between run the same way within this, degrees.
const FACING_DEG: f64 = 10.0;
/// A line of exactly the length asked for stays, whatever rounding does to its sum, mm.
const HAIR_MM: f64 = 1e-9;
/// A gap of less has no direction of its own, mm.
const TOUCHING_MM: f64 = 1e-6;

/// What was dropped for being short.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DroppedLines {
    /// Number of lines.
    pub count: usize,
    /// Their lit length, mm.
    pub length_mm: f64,
}

/// Joins open lines of one plane where the end of one faces the start of another within `join_mm`, and all run
/// the same way within 10°. The gap is dark: its far side is in [`TransversalLine::dark`].
///
/// Shortest gaps first. Lines of one plane run in one sense as they are cut, so no line is turned for it; a line
/// is never joined with itself. The joined line takes the place of the piece that it begins with.
pub fn joined(lines: Vec<TransversalLine>, join_mm: f64) -> Vec<TransversalLine> {
    let mut gaps: Vec<(f64, usize, usize)> = Vec::new();
    let mut by_plane: Vec<usize> = (0..lines.len()).filter(|&i| !lines[i].closed).collect();
    by_plane.sort_by_key(|&i| (lines[i].plane, i));
    for plane in by_plane.chunk_by(|&a, &b| lines[a].plane == lines[b].plane) {
        for &a in plane {
            let others = plane.iter().filter(|&&b| b != a);
            gaps.extend(others.filter_map(|&b| Some((gap_mm(&lines[a], &lines[b], join_mm)?, a, b))));
        }
    }
    gaps.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut next: Vec<Option<usize>> = vec![None; lines.len()];
    let mut before = next.clone();
    // The piece that each chain of pieces begins with.
    let head = |before: &[Option<usize>], mut i: usize| {
        while let Some(b) = before[i] {
            i = b;
        }
        i
    };
    for (_, a, b) in gaps {
        if next[a].is_none() && before[b].is_none() && head(&before, a) != b {
            (next[a], before[b]) = (Some(b), Some(a));
        }
    }
    let heads: Vec<usize> = (0..lines.len()).filter(|&i| before[i].is_none()).collect();
    let mut left: Vec<Option<TransversalLine>> = lines.into_iter().map(Some).collect();
    let mut out = Vec::with_capacity(heads.len());
    for first in heads {
        let Some(mut line) = left[first].take() else { continue };
        let mut at = next[first];
        while let Some(i) = at {
            at = next[i];
            let Some(piece) = left[i].take() else { break };
            line.dark.push(line.points.len());
            line.append(Vec::new(), piece);
        }
        out.push(line);
    }
    out
}

/// Leaves out lines of less lit length than `shortest_mm`, and says what those were.
pub fn without_short(lines: Vec<TransversalLine>, shortest_mm: f64) -> (Vec<TransversalLine>, DroppedLines) {
    let mut short = DroppedLines::default();
    let long = lines.into_iter().filter(|line| {
        let length_mm = line.length_mm();
        let is_short = length_mm < shortest_mm - HAIR_MM;
        if is_short {
            short.count += 1;
            short.length_mm += length_mm;
        }
        !is_short
    });
    (long.collect(), short)
}

/// The gap from the end of one line to the start of another that it faces, mm.
fn gap_mm(a: &TransversalLine, b: &TransversalLine, join_mm: f64) -> Option<f64> {
    let (from, back) = end(a.points.iter().rev().map(|q| q.p))?;
    let (to, entering) = end(b.points.iter().map(|q| q.p))?;
    let (gap, leaving) = (to - from, -back);
    let along = |x: &Vector3<f64>, y: &Vector3<f64>| between_deg(x, y) < FACING_DEG;
    let straight = gap.norm() <= TOUCHING_MM || along(&leaving, &gap) && along(&gap, &entering);
    (gap.norm() <= join_mm && along(&leaving, &entering) && straight).then(|| gap.norm())
}

/// The first point, and where it goes from there into the line.
fn end(mut points: impl Iterator<Item = Point3<f64>>) -> Option<(Point3<f64>, Vector3<f64>)> {
    let first = points.next()?;
    let inwards = points.map(|p| p - first).find(|d| d.norm() > TOUCHING_MM)?;
    Some((first, inwards))
}
