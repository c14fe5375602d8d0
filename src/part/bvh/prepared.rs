//! Segments, motions and boxes prepared for many distance tests. Gaps between boxes are slightly too small, never
//! too large, so a box is skipped only if nothing in it can be nearer.

use super::aabb::Aabb;
use super::ray_hit_mm;
use crate::part::distance::{segment_triangle, squared_of_segments, stands_over};
use nalgebra::{Isometry3, Matrix3, Point3, Vector3};

/// A segment prepared for tests against facets.
pub(super) struct SegmentForFacets {
    pub(super) from: Point3<f64>,
    pub(super) to: Point3<f64>,
    /// Unit; z where the ends are one point.
    pub(super) dir: Vector3<f64>,
    /// Length, mm.
    pub(super) length: f64,
}

impl SegmentForFacets {
    pub(super) fn new(from: &Point3<f64>, to: &Point3<f64>) -> SegmentForFacets {
        let along = to - from;
        let length = along.norm();
        let dir = if length > 0.0 { along / length } else { Vector3::z() };
        SegmentForFacets { from: *from, to: *to, dir, length }
    }

    /// Whether a facet is within `reach_mm`.
    pub(super) fn is_near(&self, corners: &[Point3<f64>; 3], reach_mm: f64) -> bool {
        let [a, b, c] = corners;
        let normal = (b - a).cross(&(c - a));
        let heights = [(&self.from, (self.from - a).dot(&normal)), (&self.to, (self.to - a).dot(&normal))];
        let within = reach_mm * reach_mm * normal.norm_squared();
        let is_level = |height: f64| height * height <= within;
        let is_on_both_sides = heights[0].1 * heights[1].1 <= 0.0;
        if !is_on_both_sides && !is_level(heights[0].1) && !is_level(heights[1].1) {
            return false;
        }
        let is_edge_near = |(u, v)| squared_of_segments(&self.from, &self.to, u, v) <= reach_mm * reach_mm;
        let is_end_near = |(p, height)| is_level(height) && stands_over(p, [a, b, c], &normal);
        is_on_both_sides && self.passes_through(corners)
            || [(a, b), (b, c), (c, a)].into_iter().any(is_edge_near)
            || heights.into_iter().any(is_end_near)
    }

    fn passes_through(&self, corners: &[Point3<f64>; 3]) -> bool {
        ray_hit_mm(corners, &self.from, &self.dir).is_some_and(|t| (0.0..=self.length).contains(&t))
    }

    pub(super) fn distance(&self, corners: &[Point3<f64>; 3]) -> f64 {
        if self.passes_through(corners) { 0.0 } else { segment_triangle(&self.from, &self.to, corners) }
    }
}

/// A segment prepared for tests against boxes.
pub(super) struct SegmentForBoxes {
    from: Point3<f64>,
    bounds: Aabb,
    /// Square to the segment and to an axis each.
    across: [Vector3<f64>; 3],
}

impl SegmentForBoxes {
    pub(super) fn new(s: &SegmentForFacets) -> SegmentForBoxes {
        let across = [0, 1, 2].map(|k| {
            let square = s.dir.cross(&Vector3::ith(k, 1.0));
            let norm = square.norm();
            if norm > 1e-6 { square / norm } else { Vector3::zeros() }
        });
        SegmentForBoxes { from: s.from, bounds: Aabb::of(&[s.from, s.to, s.to]), across }
    }

    /// Lower bound of the distance to a box: the widest gap between the two along any of the directions tried.
    pub(super) fn gap(&self, b: &Aabb) -> f64 {
        let middle = Vector3::from_fn(|k, _| b.middle(k)) - self.from.coords;
        let half = Vector3::from_fn(|k, _| 0.5 * (b.hi[k] - b.lo[k]));
        let beside = self.across.iter().map(|u| less(u.dot(&middle).abs() - u.abs().dot(&half)));
        beside.fold(self.bounds.gap(b), f64::max)
    }
}

/// A gap, reduced by more than the rounding of turned boxes.
fn less(gap: f64) -> f64 {
    gap * (1.0 - 1e-9) - 1e-9
}

/// A motion prepared for boxes.
pub(super) struct Turn {
    rotation: Matrix3<f64>,
    spread: Matrix3<f64>,
    shift: Vector3<f64>,
}

impl Turn {
    pub(super) fn new(motion: &Isometry3<f64>) -> Turn {
        let rotation = *motion.rotation.to_rotation_matrix().matrix();
        Turn { rotation, spread: rotation.abs(), shift: motion.translation.vector }
    }

    /// The box around a moved box.
    pub(super) fn bounds(&self, b: &Aabb) -> Aabb {
        let middle = self.rotation * Vector3::from_fn(|k, _| b.middle(k)) + self.shift;
        let half = self.spread * Vector3::from_fn(|k, _| 0.5 * (b.hi[k] - b.lo[k]));
        Aabb { lo: (middle - half).into(), hi: (middle + half).into() }
    }
}

impl Aabb {
    pub(super) fn is_near(&self, o: &Aabb, reach_mm: f64) -> bool {
        // Wider by more than the rounding of a turned box.
        let reach = reach_mm * (1.0 + 1e-9) + 1e-9;
        (0..3).all(|k| self.lo[k] <= o.hi[k] + reach && o.lo[k] <= self.hi[k] + reach)
    }

    /// Distance of two boxes, less by more than the rounding of a turned one.
    pub(super) fn gap(&self, o: &Aabb) -> f64 {
        let apart = Vector3::from_fn(|k, _| (o.lo[k] - self.hi[k]).max(self.lo[k] - o.hi[k]).max(0.0));
        less(apart.norm())
    }

    /// The least `dir·p` of a box.
    pub(super) fn lowest(&self, dir: &Vector3<f64>) -> f64 {
        (0..3).map(|k| dir[k] * if dir[k] > 0.0 { self.lo[k] } else { self.hi[k] }).sum()
    }
}
