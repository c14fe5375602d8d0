//! How a contact tool stands along a line: its axis in the plane of normal and travel, and whether it may touch there.
//!
//! It is never tilted out of the way: its lead is what it works with. Where it cannot stand, the line is blocked.

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
    for (q, tangent) in points.iter().zip(dense::tangents(points, closed)) {
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
