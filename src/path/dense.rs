//! The dense line: section points plus points between, so that no gap and no turn of the normal is
//! large. Interference is looked for on it, and chord error is measured against it.

use super::normals::between;
use super::section::TransversalLine;
use crate::part::angle;
use nalgebra::{Point3, Vector3};

/// A point of a dense line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DensePoint {
    /// On the part, mm.
    pub p: Point3<f64>,
    /// Unit normal of the surface.
    pub n: Vector3<f64>,
}

/// Largest turn of the normal between two points of a dense line, degrees; less where targets may
/// turn less.
pub const MAX_TURN_DEG: f64 = 2.0;

/// Largest gap, mm: half a line spacing, at most 0.5 mm, the radius of P1's spot (Table 1).
pub fn max_gap_mm(spacing_mm: f64) -> f64 {
    (0.5 * spacing_mm).min(0.5)
}

/// The dense line of a transversal line without dark gaps; a closed one ends with its first point again.
pub fn dense(line: &TransversalLine, max_gap_mm: f64, max_turn_deg: f64) -> Vec<DensePoint> {
    // A hair of tolerance: four gaps that a turned part makes a little longer stay four.
    let pieces = |whole: f64, most: f64| (whole / most - 1e-9).ceil().max(1.0);
    let mut out: Vec<DensePoint> = Vec::new();
    let closing = line.closed.then(|| line.points[0]);
    for q in line.points.iter().copied().chain(closing) {
        let to = DensePoint { p: q.p, n: q.n };
        if let Some(from) = out.last().copied() {
            let gap = (to.p - from.p).norm();
            let turn = angle::between_deg(&from.n, &to.n);
            let steps = pieces(gap, max_gap_mm).max(pieces(turn, max_turn_deg));
            for i in 1..steps as usize {
                out.push(midway(&from, &to, i as f64 / steps));
            }
        }
        out.push(to);
    }
    out
}

/// The point at a share `t` of the way.
pub fn midway(from: &DensePoint, to: &DensePoint, t: f64) -> DensePoint {
    DensePoint { p: from.p + (to.p - from.p) * t, n: between(&from.n, &to.n, t) }
}

/// Unit tangent at each point: from the point before to the point behind. `closed`: the last point
/// is the first again.
pub fn tangents(points: &[DensePoint], closed: bool) -> Vec<Vector3<f64>> {
    let last = points.len() - 1;
    (0..points.len())
        .map(|i| {
            let before = if i > 0 {
                i - 1
            } else if closed {
                last - 1
            } else {
                0
            };
            let behind = if i < last {
                i + 1
            } else if closed {
                1
            } else {
                last
            };
            let from = |a: usize, b: usize| angle::unit(points[b].p - points[a].p);
            // A line that turns back on itself (a blade's tip) has no mean direction: the leaving one is taken.
            from(before, behind).or_else(|| from(i.min(last - 1), (i + 1).min(last))).unwrap_or_else(Vector3::x)
        })
        .collect()
}
