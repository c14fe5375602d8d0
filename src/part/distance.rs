//! Distances in space: from a point or a ray to a triangle. Exact to rounding, no tolerance.

use nalgebra::{Point3, Vector3};

/// Distance from a point to a triangle, mm.
pub fn point_triangle(p: &Point3<f64>, [a, b, c]: &[Point3<f64>; 3]) -> f64 {
    let n = (b - a).cross(&(c - a));
    let length = n.norm();
    if length > 0.0 && stands_over(p, [a, b, c], &n) {
        return ((p - a).dot(&n) / length).abs();
    }
    let segment = |u: &Point3<f64>, v: &Point3<f64>| point_segment(p, u, v);
    segment(a, b).min(segment(b, c)).min(segment(c, a))
}

/// Whether a point stands over a triangle, seen along its normal.
pub fn stands_over(p: &Point3<f64>, [a, b, c]: [&Point3<f64>; 3], normal: &Vector3<f64>) -> bool {
    let inside = |u: &Point3<f64>, v: &Point3<f64>| (v - u).cross(&(p - u)).dot(normal) >= 0.0;
    inside(a, b) && inside(b, c) && inside(c, a)
}

/// Distance from a point to a segment, mm.
pub fn point_segment(p: &Point3<f64>, a: &Point3<f64>, b: &Point3<f64>) -> f64 {
    let d = b - a;
    let t = ((p - a).dot(&d) / d.norm_squared().max(1e-300)).clamp(0.0, 1.0);
    (a + d * t - p).norm()
}

/// Distance from a point to a ray (unit direction), mm.
pub fn point_ray(p: &Point3<f64>, origin: &Point3<f64>, dir: &Vector3<f64>) -> f64 {
    let off = p - origin;
    (off - dir * off.dot(dir).max(0.0)).norm()
}

/// Distance from the part `t >= t0` of a ray (unit direction) to a triangle, mm.
pub fn ray_triangle(origin: &Point3<f64>, dir: &Vector3<f64>, t0: f64, corners: &[Point3<f64>; 3]) -> f64 {
    if super::bvh::ray_hit_mm(corners, origin, dir).is_some_and(|t| t >= t0) {
        return 0.0;
    }
    let [a, b, c] = corners;
    let start = origin + dir * t0;
    let edges = ray_segment(&start, dir, a, b).min(ray_segment(&start, dir, b, c)).min(ray_segment(&start, dir, c, a));
    // The ray's start may stand over the middle of the triangle.
    edges.min(point_triangle(&start, corners))
}

/// Distance from a segment to a triangle that it does not pass through, mm.
pub fn segment_triangle(p: &Point3<f64>, q: &Point3<f64>, corners: &[Point3<f64>; 3]) -> f64 {
    let [a, b, c] = corners;
    let ends = point_triangle(p, corners).min(point_triangle(q, corners));
    [(a, b), (b, c), (c, a)].iter().map(|(u, v)| segments(p, q, u, v)).fold(ends, f64::min)
}

/// Distance of two triangles, mm.
pub fn triangles(one: &[Point3<f64>; 3], two: &[Point3<f64>; 3]) -> f64 {
    // Where they are nearest, a side of one meets the other, or passes through it.
    let side = |corners: &[Point3<f64>; 3], i: usize, of: &[Point3<f64>; 3]| {
        let (p, q) = (&corners[i], &corners[(i + 1) % 3]);
        let length = (q - p).norm();
        let through = super::bvh::ray_hit_mm(of, p, &((q - p) / length.max(1e-300)));
        if through.is_some_and(|t| (0.0..=length).contains(&t)) { 0.0 } else { segment_triangle(p, q, of) }
    };
    (0..3).map(|i| side(one, i, two).min(side(two, i, one))).fold(f64::INFINITY, f64::min)
}

/// Distance of two segments, mm.
pub fn segments(p: &Point3<f64>, q: &Point3<f64>, a: &Point3<f64>, b: &Point3<f64>) -> f64 {
    squared_of_segments(p, q, a, b).sqrt()
}

/// Distance of two segments, squared, mm² (C. Ericson, Real-Time Collision Detection, 5.1.9).
pub fn squared_of_segments(p: &Point3<f64>, q: &Point3<f64>, a: &Point3<f64>, b: &Point3<f64>) -> f64 {
    let (u, v, w) = (q - p, b - a, p - a);
    let (uu, uv, vv, uw, vw) = (u.norm_squared(), u.dot(&v), v.norm_squared(), u.dot(&w), v.dot(&w));
    let share = |over: f64, of: f64| (over / of.max(1e-300)).clamp(0.0, 1.0);
    let denominator = uu * vv - uv * uv;
    let mut s = share(uv * vw - vv * uw, denominator);
    let mut t = (uv * s + vw) / vv.max(1e-300);
    if !(0.0..=1.0).contains(&t) {
        t = t.clamp(0.0, 1.0);
        s = share(uv * t - uw, uu);
    }
    let found = (w + u * s - v * t).norm_squared();
    if denominator > 1e-10 * uu * vv {
        return found;
    }
    // Where they are all but parallel the nearest points of the lines drown in rounding; an end is as near then.
    let ends = [point_segment(p, a, b), point_segment(q, a, b), point_segment(a, p, q), point_segment(b, p, q)];
    ends.into_iter().map(|mm| mm * mm).fold(found, f64::min)
}

/// A ray with a width, prepared to rule out most triangles that are farther away at little cost.
#[derive(Clone, Copy, Debug)]
pub struct WideRay {
    origin: Point3<f64>,
    dir: Vector3<f64>,
    u: Vector3<f64>,
    v: Vector3<f64>,
    radius_mm: f64,
}

impl WideRay {
    /// The ray from `origin` along the unit vector `dir`.
    pub fn new(origin: &Point3<f64>, dir: &Vector3<f64>, radius_mm: f64) -> WideRay {
        // Duff et al., Building an Orthonormal Basis, Revisited (2017): no root, one division.
        let sign = 1f64.copysign(dir.z);
        let a = -1.0 / (sign + dir.z);
        let b = dir.x * dir.y * a;
        let u = Vector3::new(1.0 + sign * dir.x * dir.x * a, sign * b, -sign * dir.x);
        let v = Vector3::new(b, sign + dir.y * dir.y * a, -dir.y);
        WideRay { origin: *origin, dir: *dir, u, v, radius_mm: 0.0 }.as_wide_as(radius_mm)
    }

    /// This ray with a radius of its own, for what is asked of one axis at several widths.
    #[inline]
    pub fn as_wide_as(&self, radius_mm: f64) -> WideRay {
        // Wider by more than the rounding of what follows.
        WideRay { radius_mm: radius_mm * 1.001 + 1e-9, ..*self }
    }

    /// `true`: the triangle is certainly farther away than the radius. `false`: undecided.
    ///
    /// Seen along the ray, its start is a point: the test looks for a line parallel to a side of the triangle that
    /// separates the two.
    #[inline]
    pub fn surely_misses(&self, corners: &[Point3<f64>; 3]) -> bool {
        let d = corners.map(|c| c - self.origin);
        let r = self.radius_mm;
        if d.iter().all(|d| d.dot(&self.dir) < -r) {
            return true;
        }
        let (x, y) = (d.map(|d| d.dot(&self.u)), d.map(|d| d.dot(&self.v)));
        [(0, 1, 2), (1, 2, 0), (2, 0, 1)].into_iter().any(|(i, j, k)| {
            let (ex, ey) = (x[j] - x[i], y[j] - y[i]);
            let (side, opposite) = (ex * y[i] - ey * x[i], ex * y[k] - ey * x[k]);
            let least = if side.abs() < opposite.abs() { side } else { opposite };
            side * opposite > 0.0 && least * least > r * r * (ex * ex + ey * ey)
        })
    }
}

/// Distance from a ray (unit direction) to a segment, mm.
pub fn ray_segment(origin: &Point3<f64>, dir: &Vector3<f64>, a: &Point3<f64>, b: &Point3<f64>) -> f64 {
    let (d, w) = (b - a, a - origin);
    let (dd, dr, wr, wd) = (d.norm_squared(), d.dot(dir), w.dot(dir), w.dot(&d));
    let denominator = dd - dr * dr;
    // Nearest points of the two lines; where they are parallel any s will do.
    let s = if denominator > 1e-14 * dd { ((dr * wr - wd) / denominator).clamp(0.0, 1.0) } else { 0.0 };
    let mut t = wr + s * dr;
    let mut s = s;
    if t < 0.0 {
        t = 0.0;
        s = (-wd / dd.max(1e-300)).clamp(0.0, 1.0);
    }
    (w + d * s - dir * t).norm()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point(c: [f64; 3]) -> Point3<f64> {
        Point3::from(Vector3::from(c))
    }

    const SIDE: std::ops::Range<f64> = -5.0..5.0;

    proptest! {
        /// No point of triangle and ray is nearer, and some pair is as near.
        #[test]
        fn the_ray_distance_is_the_least(c in prop::array::uniform9(SIDE), o in prop::array::uniform3(SIDE),
                                         d in prop::array::uniform3(-1.0..1.0f64), t0 in 0.0..3.0f64) {
            let corners = [point([c[0], c[1], c[2]]), point([c[3], c[4], c[5]]), point([c[6], c[7], c[8]])];
            let d = Vector3::from(d);
            prop_assume!(d.norm() > 0.1 && (corners[1] - corners[0]).cross(&(corners[2] - corners[0])).norm() > 0.5);
            let (o, d) = (point(o), d.normalize());
            let found = ray_triangle(&o, &d, t0, &corners);
            // Distance to a convex set is convex along a line: a ternary search finds its least.
            let (mut lo, mut hi) = (t0, t0 + 60.0);
            for _ in 0..200 {
                let (a, b) = (lo + (hi - lo) / 3.0, hi - (hi - lo) / 3.0);
                if point_triangle(&(o + d * a), &corners) < point_triangle(&(o + d * b), &corners) { hi = b } else { lo = a }
            }
            let least = point_triangle(&(o + d * lo), &corners);
            prop_assert!((found - least).abs() < 1e-6, "{found} against {least}");
        }

        /// A miss is one.
        #[test]
        fn the_quick_look_never_errs(c in prop::array::uniform9(SIDE), o in prop::array::uniform3(SIDE),
                                     d in prop::array::uniform3(-1.0..1.0f64), radius in 0.0..3.0f64) {
            let corners = [point([c[0], c[1], c[2]]), point([c[3], c[4], c[5]]), point([c[6], c[7], c[8]])];
            let d = Vector3::from(d);
            prop_assume!(d.norm() > 0.1);
            let (o, d) = (point(o), d.normalize());
            if WideRay::new(&o, &d, radius).surely_misses(&corners) {
                prop_assert!(ray_triangle(&o, &d, 0.0, &corners) > radius);
            }
        }

        /// A triangle well off the ray is told, unless it looks like a line that points at the ray's start: only
        /// lines along its sides are tried. Corner and start keep within 17.4 mm of each other before the shift, so a
        /// side that makes asin(20.4 / 400) = 2.9 degrees with the way to it is such a line, and of a triangle
        /// without an angle above 174 degrees one does.
        #[test]
        fn the_quick_look_tells_what_is_far(c in prop::array::uniform9(SIDE), o in prop::array::uniform3(SIDE),
                                            d in prop::array::uniform3(-1.0..1.0f64), radius in 0.0..3.0f64) {
            let d = Vector3::from(d);
            prop_assume!(d.norm() > 0.1);
            let (o, d) = (point(o), d.normalize());
            let aside = super::super::angle::any_square_to(&d);
            let corners = [0, 3, 6].map(|i| point([c[i], c[i + 1], c[i + 2]]) + aside * 400.0);
            let seen = corners.map(|p| p - d * (p - o).dot(&d));
            let angle = |i: usize| (seen[(i + 1) % 3] - seen[i]).angle(&(seen[(i + 2) % 3] - seen[i])).to_degrees();
            prop_assume!((0..3).all(|i| angle(i) < 174.0));
            prop_assert!(WideRay::new(&o, &d, radius).surely_misses(&corners));
        }

        #[test]
        fn a_point_is_as_far_from_a_ray_as_from_a_long_piece_of_it(p in prop::array::uniform3(SIDE), o in prop::array::uniform3(SIDE),
                                                                   d in prop::array::uniform3(-1.0..1.0f64)) {
            let (p, o, d) = (point(p), point(o), Vector3::from(d));
            prop_assume!(d.norm() > 0.1);
            let d = d.normalize();
            prop_assert!((point_ray(&p, &o, &d) - point_segment(&p, &o, &(o + d * 100.0))).abs() < 1e-9);
        }

        #[test]
        fn the_segment_distance_is_the_least(c in prop::array::uniform9(SIDE), d in prop::array::uniform6(SIDE)) {
            let corners = [point([c[0], c[1], c[2]]), point([c[3], c[4], c[5]]), point([c[6], c[7], c[8]])];
            let (p, q) = (point([d[0], d[1], d[2]]), point([d[3], d[4], d[5]]));
            prop_assume!((q - p).norm() > 0.1);
            let dir = (q - p).normalize();
            let through = crate::part::bvh::ray_hit_mm(&corners, &p, &dir).is_some_and(|t| (0.0..=(q - p).norm()).contains(&t));
            prop_assume!(!through);
            let (mut lo, mut hi) = (0.0, 1.0);
            for _ in 0..200 {
                let (a, b) = (lo + (hi - lo) / 3.0, hi - (hi - lo) / 3.0);
                if point_triangle(&(p + (q - p) * a), &corners) < point_triangle(&(p + (q - p) * b), &corners) { hi = b } else { lo = a }
            }
            let least = point_triangle(&(p + (q - p) * lo), &corners);
            prop_assert!((segment_triangle(&p, &q, &corners) - least).abs() < 1e-6);
        }

        /// Distance to a convex set is convex: no point of the other triangle is nearer, and one is as near.
        #[test]
        fn the_triangle_distance_is_the_least(c in prop::array::uniform9(SIDE), d in prop::array::uniform9(SIDE)) {
            let corners = |c: [f64; 9]| [point([c[0], c[1], c[2]]), point([c[3], c[4], c[5]]), point([c[6], c[7], c[8]])];
            let (one, two) = (corners(c), corners(d));
            let area = |t: &[Point3<f64>; 3]| (t[1] - t[0]).cross(&(t[2] - t[0])).norm();
            prop_assume!(area(&one) > 0.5 && area(&two) > 0.5);
            let off = |u: f64, v: f64| {
                point_triangle(&(two[0] + ((two[1] - two[0]) * (1.0 - v) + (two[2] - two[0]) * v) * u), &one)
            };
            let least = |f: &dyn Fn(f64) -> f64| {
                let (mut lo, mut hi) = (0.0, 1.0);
                for _ in 0..60 {
                    let (a, b) = (lo + (hi - lo) / 3.0, hi - (hi - lo) / 3.0);
                    if f(a) < f(b) { hi = b } else { lo = a }
                }
                f(lo)
            };
            let nearest = (0..=100).map(|i| least(&|v| off(f64::from(i) / 100.0, v))).fold(f64::INFINITY, f64::min);
            let found = triangles(&one, &two);
            prop_assert!(found <= nearest + 1e-6 && nearest <= found + 0.2, "{found} against {nearest}");
            prop_assert_eq!(found, triangles(&two, &one));
        }

        #[test]
        fn the_point_distance_is_the_least(c in prop::array::uniform9(SIDE), p in prop::array::uniform3(SIDE)) {
            let corners = [point([c[0], c[1], c[2]]), point([c[3], c[4], c[5]]), point([c[6], c[7], c[8]])];
            let p = point(p);
            let found = point_triangle(&p, &corners);
            let mut least = f64::INFINITY;
            for i in 0..=60 {
                for j in 0..=60 - i {
                    let (u, v) = (f64::from(i) / 60.0, f64::from(j) / 60.0);
                    let q = corners[0] + (corners[1] - corners[0]) * u + (corners[2] - corners[0]) * v;
                    least = least.min((q - p).norm());
                }
            }
            prop_assert!(found <= least + 1e-9 && least <= found + 0.5);
        }
    }
}
