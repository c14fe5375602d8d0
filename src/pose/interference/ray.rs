//! The beam as a ray (P1 3.1) against all facets, with what P1 leaves open: a beam that grazes a facet, and one
//! that starts in it.

use super::beam_interference::{BeamInterference, RISE_MM, into_frame, motion_into_frame};
use super::blocker::{Blocker, Obstruction, ToolBody};
use super::separated::is_separated;
use super::swept_beam::SweptBeam;
use crate::part::{Bvh, distance};
use crate::pose::Pose;
use nalgebra::{Isometry3, Point3, Vector3};

/// A beam closer than this to a facet interferes, mm. Two hundredths are well above the error of
/// f32 coordinates on a metre of part, and well below any spot.
pub const GRAZE_MM: f64 = 0.02;

/// Near its own point the beam counts as a cone of 1° to each side until that is as wide
/// as `GRAZE_MM`. At the foot of a 90° wall the floor's normal lies in the wall (0°: interferes); a
/// draft of 2° is free; and the facets that the point stands on or beside never count.
///
/// This is its tangent.
const TOUCH_SLOPE: f64 = 0.017_455_064_928_217_585;

/// Where along the beam the width of that cone is taken for the stretch behind, mm; the first is
/// the offset at which the test starts, and from the last on the cone is `GRAZE_MM` wide.
const STRETCHES_MM: [f64; 5] = [1.146, 0.6, 0.2, 0.05, 0.01];

/// A beam that rises from a facet's plane by 2°, twice the cone's half angle, leaves it: its sine.
const LEAVES_SINE: f64 = 0.035;

/// A beam that runs along a facet by less than 5° does not stand on it: the sine. Beams are tilted by 80° at
/// most; just past a rim the axis would meet the side below it.
const STANDS_SINE: f64 = 0.087;

/// So far the spot is looked for beside where a sag may have put it, mm.
const SPOT_MM: f64 = 1e-3;

/// Length of the first stretch of a moving beam that is looked at by itself, mm.
const FIRST_STRETCH_MM: f64 = 1.0;

impl BeamInterference<'_> {
    /// Whether the ray meets nothing.
    pub(super) fn is_ray_free(&self, p: &Point3<f64>, a: &Vector3<f64>) -> bool {
        let ray = distance::WideRay::new(p, a, GRAZE_MM);
        let stops = |corners: &[Point3<f64>; 3]| !ray.surely_misses(corners) && interferes(p, a, corners);
        if self.last_ray_facet.get().is_some_and(|corners| stops(&corners)) {
            return false;
        }
        let mut free = true;
        self.bvh.visit_ray(p, a, 0.0, f64::INFINITY, GRAZE_MM, |_, corners| {
            if stops(corners) {
                self.last_ray_facet.set(Some(*corners));
                free = false;
                return -1.0;
            }
            f64::INFINITY
        });
        free && self.obstacles().skip(1).all(|(_, bvh, at)| first_ray_hit(bvh, at.as_ref(), p, a).is_none())
    }

    /// The nearest thing in the way of the ray.
    pub(super) fn ray_blocker(&self, p: &Point3<f64>, a: &Vector3<f64>) -> Option<Blocker> {
        self.obstacles()
            .filter_map(|(clamp, bvh, at)| {
                let (facet, t_mm) = first_ray_hit(bvh, at.as_ref(), p, a)?;
                let obstruction = clamp.unwrap_or(Obstruction::Facet(facet));
                Some(Blocker { tool_body: ToolBody::Beam, obstruction, t_mm })
            })
            .min_by(|x, y| x.t_mm.total_cmp(&y.t_mm))
    }

    /// How far along the beam the farthest facet lies that the motion between two poses may touch,
    /// mm; `None` if it can touch none, of part or clamps. `motion`: the poses at its beginning, half way and at its end;
    /// `sag_mm`: how far the part may lie from the chord.
    pub(in crate::pose) fn ray_conflict(
        &self,
        motion: [&Pose; 3],
        sag_mm: f64,
        stray_mm: impl Fn(f64) -> f64,
    ) -> Option<f64> {
        if !self.has_ray() {
            return None;
        }
        self.obstacles()
            .filter_map(|(_, bvh, at)| conflict_with(bvh, &motion_into_frame(at.as_ref(), motion), sag_mm, &stray_mm))
            .reduce(f64::max)
    }

    /// The nearest of what the ray from `from_mm` above `p` on goes through, or comes nearer to than a
    /// share of what a beam keeps at a target.
    pub fn passes_near(&self, p: &Point3<f64>, a: &Vector3<f64>, from_mm: f64, share: f64) -> Option<Obstruction> {
        if !self.has_ray() {
            return None;
        }
        let mut first: Option<(f64, Obstruction)> = None;
        for (clamp, bvh, at) in self.obstacles() {
            let (p, a) = &into_frame(at.as_ref(), p, a);
            bvh.visit_ray(p, a, from_mm, f64::INFINITY, share * GRAZE_MM, |facet, corners| {
                let through = crate::part::bvh::ray_hit_mm(corners, p, a).filter(|t| *t > from_mm);
                let beside = || {
                    let near = share > 0.0 && is_beside(p, a, corners, from_mm, share);
                    near.then(|| corners.iter().map(|c| (c - p).dot(a)).fold(f64::INFINITY, f64::min).max(from_mm))
                };
                let what = clamp.unwrap_or(Obstruction::Facet(facet));
                if let Some(t) = through.or_else(beside)
                    && first.is_none_or(|f| (t, what) < f)
                {
                    first = Some((t, what));
                }
                f64::INFINITY
            });
        }
        first.map(|f| f.1)
    }

    /// The point nearest to `p` at which the line through `p` along `a` meets the part, within
    /// `window_mm` either way; `p` itself where it meets none, and for a contact tool, whose foot is not on the part.
    pub fn spot(&self, p: &Point3<f64>, a: &Vector3<f64>, window_mm: f64) -> Point3<f64> {
        if !self.has_ray() {
            return *p;
        }
        let start = p - a * window_mm;
        let mut best: Option<f64> = None;
        self.bvh.visit_ray(&start, a, 0.0, 2.0 * window_mm, 0.0, |_, corners| {
            let n = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
            let stands = n.dot(a).abs() > STANDS_SINE * n.norm();
            if let Some(t) = crate::part::bvh::ray_hit_mm(corners, &start, a).filter(|_| stands) {
                let off = t - window_mm;
                if off.abs() <= window_mm && best.is_none_or(|b| (off.abs(), off) < (b.abs(), b)) {
                    best = Some(off);
                }
            }
            2.0 * window_mm
        });
        best.map_or(*p, |off| p + a * off)
    }
}

/// How far along the beam the farthest facet of one body lies that a motion in its frame may touch, mm.
///
/// Two kinds of facets cannot be touched: those that the beam leaves on their face at both ends
/// (the points between lie on that side too, and so do the axes between), and those that do not
/// rise above the spot, such as the rest of a convex surface.
fn conflict_with(bvh: &Bvh, motion: &[Pose; 3], sag_mm: f64, stray_mm: impl Fn(f64) -> f64) -> Option<f64> {
    let [from, middle, to] = motion;
    let half_mm = 0.5 * (to.p - from.p).norm();
    let half_turn = from.sine_of_half_turn(to);
    let radius = |t: f64| half_mm + t.max(0.0) * half_turn + GRAZE_MM + stray_mm(t.max(0.0));
    let (centre, round_mm) = bvh.sphere_of_box()?;
    // Nothing of the body lies further along the beam, and where even the widest beam passes beside it, nothing is met.
    let size_mm = (centre - middle.p).norm() + round_mm + half_mm;
    if distance::point_ray(&centre, &middle.p, &middle.a) > round_mm + radius(size_mm) {
        return None;
    }
    let mut farthest: Option<f64> = None;
    let axis = distance::WideRay::new(&middle.p, &middle.a, 0.0);
    let (rise_mm, begins_mm) = (RISE_MM + 2.0 * sag_mm, 2.0 * sag_mm + SPOT_MM);
    // A turning beam sweeps wide only far out: each stretch is looked at as wide as it gets, so
    // that the surface around the spot is not visited for the sake of the far end.
    // To where the turn has made it twice as wide it is one stretch; without a turn, all of it.
    let twice_mm = (half_mm + GRAZE_MM) / half_turn;
    let (mut near, mut far) = (0.0, (FIRST_STRETCH_MM + 2.0 * half_mm).max(twice_mm).min(size_mm));
    while near < size_mm {
        let keeps_mm = GRAZE_MM + stray_mm(far + begins_mm);
        let swept = SweptBeam::new(motion, [near - begins_mm, far + begins_mm], (keeps_mm, rise_mm));
        let mut visit = |corners: &[Point3<f64>; 3]| {
            let n = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
            let length = n.norm();
            let side = n.dot(&middle.a).signum();
            let leaves = |q: &Pose| {
                side * n.dot(&q.a) > LEAVES_SINE * length && side * n.dot(&(q.p - corners[0])) >= -1e-7 * length
            };
            if leaves(from) && leaves(to) {
                return;
            }
            let rise = |q: &Pose| corners.iter().map(|c| (c - q.p).dot(&q.a)).fold(f64::NEG_INFINITY, f64::max);
            let top = rise(from).max(rise(to));
            // The dearest look comes last.
            let misses = || axis.as_wide_as(radius(top)).surely_misses(corners);
            let is_clear = || is_separated(motion, corners, (GRAZE_MM, begins_mm), &stray_mm);
            let touchable = || distance::ray_triangle(&middle.p, &middle.a, 0.0, corners) <= radius(top);
            if top > rise_mm && !misses() && !is_clear() && touchable() {
                farthest = Some(farthest.map_or(top, |f| f.max(top)));
            }
        };
        bvh.visit_near_boxes(
            |lo, hi| swept.meets_box(lo, hi),
            |_, corners| {
                if swept.meets(corners) {
                    visit(corners);
                }
                true
            },
        );
        (near, far) = (far, (6.0 * far).min(size_mm));
    }
    farthest
}

/// The first facet that the ray interferes with, and where, mm along it; the facets stand at `at`.
fn first_ray_hit(bvh: &Bvh, at: Option<&Isometry3<f64>>, p: &Point3<f64>, a: &Vector3<f64>) -> Option<(u32, f64)> {
    let (p, a) = &into_frame(at, p, a);
    let ray = distance::WideRay::new(p, a, GRAZE_MM);
    let mut first: Option<(f64, u32)> = None;
    bvh.visit_ray(p, a, 0.0, f64::INFINITY, GRAZE_MM, |facet, corners| {
        if !ray.surely_misses(corners) && interferes(p, a, corners) {
            let t_mm = crate::part::bvh::ray_hit_mm(corners, p, a)
                .filter(|t| *t > 0.0)
                .unwrap_or_else(|| corners.iter().map(|c| (c - p).dot(a)).fold(f64::INFINITY, f64::min).max(0.0));
            if first.is_none_or(|f| (t_mm, facet) < f) {
                first = Some((t_mm, facet));
            }
        }
        f64::INFINITY
    });
    first.map(|(t_mm, facet)| (facet, t_mm))
}

/// Whether the beam from `p` along `a` interferes with one facet.
fn interferes(p: &Point3<f64>, a: &Vector3<f64>, corners: &[Point3<f64>; 3]) -> bool {
    // Most facets near a beam are those it stands on: it leaves their plane, from in front of it.
    let n = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
    let (rise, height) = (n.dot(a), n.dot(&(p - corners[0])));
    let length = n.norm();
    let leaves = rise.abs() > LEAVES_SINE * length;
    if leaves && (height * rise > 0.0 || height.abs() <= 1e-7 * length) {
        return false;
    }
    if distance::ray_triangle(p, a, 0.0, corners) > GRAZE_MM {
        return false;
    }
    is_beside(p, a, corners, 0.0, 1.0)
}

/// Whether a facet is nearer to the ray than a share of what that keeps, from `from_mm` on.
fn is_beside(p: &Point3<f64>, a: &Vector3<f64>, corners: &[Point3<f64>; 3], from_mm: f64, share: f64) -> bool {
    STRETCHES_MM.iter().filter(|t| **t >= from_mm).any(|&t| {
        let allowed = t * TOUCH_SLOPE;
        distance::ray_triangle(p, a, t, corners) <= share * allowed.min(GRAZE_MM)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slope_is_that_of_one_degree() {
        assert_eq!(TOUCH_SLOPE, libm::tan(1f64.to_radians()));
    }
}
