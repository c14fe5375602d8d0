//! How a contact tool stands along a line: its axis in the plane of normal and travel, and whether it may touch there.
//!
//! It is never tilted out of the way: its lead is what it works with. Where it cannot stand, the line is blocked. It leans
//! where the line goes over the next millimetres, not where its last chord points: behind a disc of 50 mm half a degree more
//! or less would swing the spindle by 0.4 mm.

use super::super::interference::BeamInterference;
use super::super::target::travel;
use super::RUN_END_MM;
use crate::beam::ContactPlace;
use crate::part::angle;
use crate::path::dense::{self, DensePoint};
use nalgebra::Vector3;

/// A contact tool at a point of a dense line.
#[derive(Clone, Copy, Debug)]
pub(super) struct ContactStand {
    pub(super) q: DensePoint,
    /// Its axis there, whether or not it may stand so.
    pub(super) a: Vector3<f64>,
    pub(super) is_free: bool,
}

/// The tool at each point of a dense line, with points added where a run of interference begins or ends.
pub(super) fn contact_stands(
    beam: &BeamInterference<'_>,
    place: &ContactPlace,
    points: &[DensePoint],
    closed: bool,
) -> Vec<ContactStand> {
    if points.len() < 2 {
        return Vec::new();
    }
    let at =
        |q: DensePoint, a: Vector3<f64>| ContactStand { q, a, is_free: beam.is_free(&place.foot(&q.p, &q.n, &a), &a) };
    let midway = |x: &ContactStand, y: &ContactStand| at(dense::midway(&x.q, &y.q, 0.5), angle::slerp(&x.a, &y.a, 0.5));
    let mut out: Vec<ContactStand> = Vec::with_capacity(points.len());
    for (q, tangent) in points.iter().zip(headings(points, closed)) {
        let next = at(*q, place.axis(&q.n, &travel(&tangent, &q.n)));
        if let Some(last) = out.last().copied().filter(|last| last.is_free != next.is_free) {
            let (mut x, mut y) = (last, next);
            while (y.q.p - x.q.p).norm() > RUN_END_MM {
                let middle = midway(&x, &y);
                if middle.is_free == last.is_free { x = middle } else { y = middle }
            }
            out.extend([x, y].into_iter().filter(|end| end.q.p != last.q.p && end.q.p != next.q.p));
        }
        out.push(next);
    }
    out
}

/// The line's direction counts over so much of it to either side, falling off evenly, mm. Chords between the facets that a
/// line crosses are a millimetre long and turn by degrees; the tightest turn of a spiral, of 5 mm, is followed.
const HEADING_MM: f64 = 5.0;

/// Where the line goes at each of its points, not of unit length. A closed line goes on over its seam.
pub(super) fn headings(points: &[DensePoint], closed: bool) -> Vec<Vector3<f64>> {
    let chords: Vec<(Vector3<f64>, f64)> = points.windows(2).map(|w| w[1].p - w[0].p).map(|c| (c, c.norm())).collect();
    let (count, raw) = (chords.len(), dense::tangents(points, closed));
    let along = |start: usize, forward: bool| {
        // Chords from the point on, forward or back, each with how far its middle is away.
        let mut sum = Vector3::zeros();
        let mut way_mm = 0.0;
        for k in 0..count {
            let at = if forward { start + k } else { start + count - 1 - k };
            let is_beyond = if forward { at >= count } else { at < count };
            if way_mm >= HEADING_MM || is_beyond && !closed {
                break;
            }
            let (chord, length) = chords[at % count];
            sum += chord * (1.0 - (way_mm + 0.5 * length) / HEADING_MM).max(0.0);
            way_mm += length;
        }
        sum
    };
    let heading = |(i, raw): (usize, &Vector3<f64>)| {
        let sum = along(i, true) + along(i, false);
        // Where a line turns back the two sides cancel out.
        if sum.norm() > 1e-3 { sum } else { *raw }
    };
    raw.iter().enumerate().map(heading).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Point3;

    fn line(points: impl IntoIterator<Item = [f64; 2]>) -> Vec<DensePoint> {
        points.into_iter().map(|[x, y]| DensePoint { p: Point3::new(x, y, 0.0), n: Vector3::z() }).collect()
    }

    #[test]
    fn a_jagged_line_has_an_even_heading_and_a_circle_its_tangents() {
        let jagged = line((0..60).map(|i| [f64::from(i) * 0.5, if i % 2 == 0 { 0.0 } else { 0.02 }]));
        for heading in headings(&jagged, false) {
            assert!(angle::between_deg(&heading, &Vector3::x()) < 0.5, "{heading}");
        }
        let turn = |k: usize| std::f64::consts::TAU * k as f64 / 120.0;
        let circle = line((0..=120).map(|k| [20.0 * libm::cos(turn(k)), 20.0 * libm::sin(turn(k))]));
        for (k, heading) in headings(&circle, true).iter().enumerate() {
            let tangent = Vector3::new(-libm::sin(turn(k)), libm::cos(turn(k)), 0.0);
            assert!(angle::between_deg(heading, &tangent) < 0.1, "{k}: {heading}");
        }
        let back = line([[0.0, 0.0], [5.0, 0.0], [0.0, 0.0]]);
        assert!(headings(&back, false).iter().all(|h| h.norm() > 0.0 && h.iter().all(|c| c.is_finite())));
    }
}
