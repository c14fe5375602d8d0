//! Whether a beam that moves stays on one side of a plane that a facet lies on the other side of. So a beam that glides
//! along a wall, or past an edge, is told to keep clear of it in one look, however long the motion is.
//!
//! With the spot going straight, p(s) = (1 − s) p₀ + s p₁, and the axis turning at constant rate, a(s) = w₀ a₀ + w₁ a₁ with
//! w₀ ≥ 1 − s, w₁ ≥ s and w₀ + w₁ ≤ 1/cos(θ/2), the height of the point at t over a plane with the unit normal u is
//! `u·(p(s) + t a(s)) ≥ (1 − s) h₀(t) + s h₁(t) − t (1/cos(θ/2) − 1) max|u·aᵢ|`, h₀ and h₁ being those at the ends. Both
//! are linear in t, so where they are high enough at both ends of what of the beam can come near the facet, all between is.

use crate::part::angle;
use crate::pose::Pose;
use nalgebra::{Point3, Vector3};

/// More than the rounding of the heights, as a share of the lengths that they are made of.
pub(super) const ROUNDING: f64 = 1e-12;

/// Whether no point of the beam comes as near to a facet as `grazes_mm`. `sag_mm`: the beam may begin so much before the
/// poses' points, or behind; `stray_mm`: how far a point of it at this distance may stray from such a motion.
pub(super) fn is_separated(
    [from, middle, to]: &[Pose; 3],
    corners: &[Point3<f64>; 3],
    (grazes_mm, sag_mm): (f64, f64),
    stray_mm: impl Fn(f64) -> f64,
) -> bool {
    let away = |q: &Pose| corners.iter().map(|c| (c - q.p).norm()).fold(0.0, f64::max);
    // Beyond that the beam is farther from the facet than it grazes, wherever it points.
    let far_mm = away(from).max(away(to)) + 2.0 * grazes_mm;
    let cosine = from.cosine_of_half_turn(to);
    if cosine < LEAST_COSINE {
        return false;
    }
    let bulge = 1.0 / cosine - 1.0;
    let keeps_mm = grazes_mm + stray_mm(far_mm) + ROUNDING * (far_mm + from.p.coords.amax() + to.p.coords.amax());
    let is_between = |u: Vector3<f64>| {
        let top = corners.iter().map(|c| u.dot(&c.coords)).fold(f64::NEG_INFINITY, f64::max);
        let slopes = [from, to].map(|q| u.dot(&q.a));
        let lost_mm = far_mm * bulge * slopes[0].abs().max(slopes[1].abs());
        [from, to].iter().zip(slopes).all(|(q, slope)| {
            let height = u.dot(&q.p.coords) - top;
            (height - sag_mm * slope.abs()).min(height + (far_mm + sag_mm) * slope) >= keeps_mm + lost_mm
        })
    };
    // Where beam and facet come nearest the facet's inside, an edge or a corner is.
    let sides = [0, 1, 2].map(|k| corners[(k + 1) % 3] - corners[k]);
    let towards = |u: Vector3<f64>, on: &Point3<f64>| {
        let u = angle::unit(u)?;
        Some(if u.dot(&(middle.p - on)) < 0.0 { -u } else { u })
    };
    let inside = std::iter::once((sides[0].cross(&sides[1]), &corners[0]));
    let edges = (0..3).map(|k| (middle.a.cross(&sides[k]), &corners[k]));
    let across = |c: &Point3<f64>| {
        let d = middle.p - c;
        d - middle.a * d.dot(&middle.a)
    };
    let ends = corners.iter().map(|c| (across(c), c));
    inside.chain(edges).chain(ends).filter_map(|(u, on)| towards(u, on)).any(is_between)
}

/// Motions that turn farther are bisected first: the cosine of half a turn, of 57°.
const LEAST_COSINE: f64 = 0.88;

#[cfg(test)]
mod tests {
    use super::super::motions_for_tests::{motion, point};
    use super::*;
    use crate::part::distance::ray_triangle;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        /// No beam of a motion that is told to be separated comes near the facet.
        #[test]
        fn what_is_separated_is_not_met(
            c in prop::array::uniform9(-4.0..4.0f64),
            p in prop::array::uniform3(-4.0..4.0f64),
            step in prop::array::uniform3(-2.0..2.0f64),
            a in prop::array::uniform3(-1.0..1.0f64),
            turn in prop::array::uniform3(-0.5..0.5f64),
            sag_mm in prop_oneof![Just(0.0), 0.0..0.2f64],
        ) {
            let corners = [point([c[0], c[1], c[2]]), point([c[3], c[4], c[5]]), point([c[6], c[7], c[8]])];
            let Some([from, middle, to]) = motion(p, step, a, turn) else { return Ok(()) };
            if is_separated(&[from, middle, to], &corners, (0.02, sag_mm), |_| 0.0) {
                for i in 0..=200 {
                    let q = from.midway(&to, f64::from(i) / 200.0);
                    for begin in [-sag_mm, 0.0, sag_mm] {
                        let near = ray_triangle(&(q.p + q.a * begin), &q.a, 0.0, &corners);
                        prop_assert!(near >= 0.02, "{near} at {i}");
                    }
                }
            }
        }

        /// A beam that glides along a wall, at a distance that it keeps.
        #[test]
        fn a_glide_along_a_wall_is_told_at_once(off in 0.021..0.5f64, tilt in 0.0..0.2f64, way in 0.1..50.0f64) {
            let wall = [point([-60.0, 0.0, 0.0]), point([60.0, 0.0, 0.0]), point([0.0, 0.0, 20.0])];
            let a = Vector3::new(tilt, 0.0, 1.0).normalize();
            let [from, to] = [-0.5 * way, 0.5 * way].map(|x| Pose { p: point([x, off, 1.0]), a });
            let middle = from.midway(&to, 0.5);
            prop_assert!(is_separated(&[from, middle, to], &wall, (0.02, 0.0), |_| 0.0));
        }
    }
}
