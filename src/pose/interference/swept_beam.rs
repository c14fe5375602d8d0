//! Where a beam that moves can be: bounds along a few directions, by which whole boxes of facets are ruled out at once.
//!
//! Moving, a beam sweeps a sheet: as long as the motion and as thin as the beam. Among fine facets that is what counts,
//! for a round that holds the motion holds as many facets as its square.

use super::separated::ROUNDING;
use crate::part::angle;
use crate::pose::Pose;
use nalgebra::{Point3, Vector3};

/// Bounds of a stretch of a moving beam, and of what it keeps, in one frame.
pub(super) struct SweptBeam {
    lo: [f64; 3],
    hi: [f64; 3],
    /// Across the sheet, along the travel, along the axis.
    slabs: [Slab; 3],
    /// What lies lower along both axes than these is not asked for.
    floors: [Slab; 2],
}

/// What lies between two places along a direction.
#[derive(Clone, Copy)]
struct Slab {
    /// Unit.
    dir: Vector3<f64>,
    least: f64,
    most: f64,
}

impl Slab {
    /// Least and greatest place of a box along the direction, wider by more than the rounding.
    #[inline(always)]
    fn span(&self, middle: &[f64; 3], half: &[f64; 3]) -> (f64, f64) {
        let d = &self.dir;
        let at = d.x * middle[0] + d.y * middle[1] + d.z * middle[2];
        let off = d.x.abs() * half[0] + d.y.abs() * half[1] + d.z.abs() * half[2];
        let off = off + ROUNDING * (off + middle[0].abs() + middle[1].abs() + middle[2].abs());
        (at - off, at + off)
    }
}

impl SweptBeam {
    /// The stretch from `t_mm[0]` to `t_mm[1]` along the axis, on the motion between two poses: it strays by no more than
    /// `keeps_mm` from one whose point goes straight and whose axis turns at constant rate, by less than half a circle.
    /// Facets that rise by no more than `rise_mm` above the spot at both ends are not asked for.
    pub(super) fn new([from, middle, to]: &[Pose; 3], t_mm: [f64; 2], (keeps_mm, rise_mm): (f64, f64)) -> SweptBeam {
        let longest = t_mm[0].abs().max(t_mm[1].abs());
        // As in `separated`: on the way the axis is w₀ a₀ + w₁ a₁ with weights whose sum is 1 to 1/cos(θ/2).
        let bulge = 1.0 / from.cosine_of_half_turn(to).max(1e-12);
        let keeps_mm = keeps_mm + ROUNDING * (longest * bulge + from.p.coords.amax() + to.p.coords.amax());
        let slab = |dir: Vector3<f64>| {
            let (p, q) = (dir.dot(&from.p.coords), dir.dot(&to.p.coords));
            let (x, y) = (dir.dot(&from.a), dir.dot(&to.a));
            let (least, most) = (x.min(y), x.max(y));
            let (least, most) = (least.min(least * bulge), most.max(most * bulge));
            let [start, end] = t_mm.map(|t| (t * least, t * most));
            let low = start.0.min(start.1).min(end.0).min(end.1);
            let high = start.0.max(start.1).max(end.0).max(end.1);
            Slab { dir, least: p.min(q) + low - keeps_mm, most: p.max(q) + high + keeps_mm }
        };
        // The sheet is spanned by the axis and by the way, or by the turn where that goes wider.
        let sheet = |along: Vector3<f64>| Some(slab(angle::unit(middle.a.cross(&along))?));
        let thick = |s: &Slab| s.most - s.least;
        let sheets = [sheet(to.p - from.p), sheet(to.a - from.a)];
        let thinnest = sheets.into_iter().flatten().min_by(|s, t| thick(s).total_cmp(&thick(t)));
        let across = thinnest.unwrap_or_else(|| slab(angle::any_square_to(&middle.a)));
        let sides = [Vector3::x(), Vector3::y(), Vector3::z()].map(slab);
        let floor = |q: &Pose| Slab { dir: q.a, least: q.a.dot(&q.p.coords) + rise_mm, most: f64::INFINITY };
        SweptBeam {
            lo: sides.map(|s| s.least),
            hi: sides.map(|s| s.most),
            slabs: [across, slab(middle.a.cross(&across.dir)), slab(middle.a)],
            floors: [floor(from), floor(to)],
        }
    }

    /// Whether a box may hold a facet that is asked for; `false` is certain.
    #[inline(always)]
    pub(super) fn meets_box(&self, lo: &[f64; 3], hi: &[f64; 3]) -> bool {
        for k in 0..3 {
            if lo[k] > self.hi[k] || hi[k] < self.lo[k] {
                return false;
            }
        }
        let middle = [0.5 * (lo[0] + hi[0]), 0.5 * (lo[1] + hi[1]), 0.5 * (lo[2] + hi[2])];
        let half = [0.5 * (hi[0] - lo[0]), 0.5 * (hi[1] - lo[1]), 0.5 * (hi[2] - lo[2])];
        for slab in &self.slabs {
            let (low, high) = slab.span(&middle, &half);
            if high < slab.least || low > slab.most {
                return false;
            }
        }
        let [from, to] = &self.floors;
        from.span(&middle, &half).1 > from.least || to.span(&middle, &half).1 > to.least
    }

    /// Whether a facet may come near the beam; `false` is certain.
    #[inline(always)]
    pub(super) fn meets(&self, corners: &[Point3<f64>; 3]) -> bool {
        self.slabs.iter().all(|slab| {
            let [x, y, z] = corners.map(|c| slab.dir.dot(&c.coords));
            x.max(y).max(z) >= slab.least && x.min(y).min(z) <= slab.most
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::motions_for_tests::{motion, point};
    use super::*;
    use crate::part::distance::ray_triangle;
    use crate::part::topology::bounds_of;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        /// A facet that is ruled out, or whose box is, is not met by any beam of the motion, or rises above none of its ends.
        #[test]
        fn what_is_ruled_out_is_not_met(
            c in prop::array::uniform9(-4.0..4.0f64),
            size in prop_oneof![Just(1.0), 0.02..1.0f64],
            p in prop::array::uniform3(-4.0..4.0f64),
            step in prop::array::uniform3(-2.0..2.0f64),
            a in prop::array::uniform3(-1.0..1.0f64),
            turn in prop::array::uniform3(-1.0..1.0f64),
            t_mm in prop_oneof![Just([0.0, 9.0]), Just([0.0, 1.0]), Just([1.0, 9.0])],
            sag_mm in prop_oneof![Just(0.0), 0.0..0.2f64],
        ) {
            // Small facets as well, about a corner.
            let at = [c[0], c[1], c[2]];
            let small = |k: usize| point([0, 1, 2].map(|i| at[i] + size * (c[k + i] - at[i])));
            let corners = [point(at), small(3), small(6)];
            let Some([from, middle, to]) = motion(p, step, a, turn) else { return Ok(()) };
            prop_assume!(from.a.dot(&to.a) > -0.9);
            let swept = SweptBeam::new(&[from, middle, to], [t_mm[0] - sag_mm, t_mm[1] + sag_mm], (0.02, 0.01));
            let bounds = bounds_of(corners.iter().copied());
            let meets_box = swept.meets_box(&bounds.0.into(), &bounds.1.into());
            if meets_box && swept.meets(&corners) {
                return Ok(());
            }
            let rise = |q: &Pose| corners.iter().map(|c| (c - q.p).dot(&q.a)).fold(f64::NEG_INFINITY, f64::max);
            if !meets_box && rise(&from).max(rise(&to)) <= 0.01 {
                return Ok(());
            }
            for i in 0..=100 {
                let q = from.midway(&to, f64::from(i) / 100.0);
                for begin in [-sag_mm, 0.0, sag_mm] {
                    // The stretch alone: what lies beyond its end is another's.
                    let start = q.p + q.a * (t_mm[0] + begin);
                    let near = ray_triangle(&start, &q.a, 0.0, &corners);
                    let ends = corners.iter().all(|c| (c - start).dot(&q.a) <= t_mm[1] - t_mm[0]);
                    prop_assert!(near >= 0.02 || !ends, "{near} at {i}");
                }
            }
        }
    }

    /// Beside a motion of 5 mm a facet is ruled out that a round about the motion would hold.
    #[test]
    fn a_sheet_is_thinner_than_a_round() {
        let pose = |x: f64| Pose { p: Point3::new(x, 0.0, 0.0), a: Vector3::z() };
        let swept = SweptBeam::new(&[pose(-2.5), pose(0.0), pose(2.5)], [0.0, 50.0], (0.02, 0.01));
        let beside = |y: f64| [[-1.0, y, 1.0], [1.0, y, 1.0], [0.0, y + 0.1, 1.5]].map(point);
        assert!(!swept.meets(&beside(0.05)) && swept.meets(&beside(0.01)));
        assert!(
            !swept.meets_box(&[-1.0, 0.05, 1.0], &[1.0, 0.15, 1.5])
                && swept.meets_box(&[-1.0, 0.01, 1.0], &[1.0, 0.15, 1.5])
        );
        assert!(!swept.meets_box(&[-1.0, -1.0, -5.0], &[1.0, 1.0, 0.0]), "nothing in it rises above the spot");
    }
}
