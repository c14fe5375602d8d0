//! A cut cone about an axis and its distance from facets.
//!
//! The distance of two convex bodies is found by Gilbert, Johnson and Keerthi's algorithm (1988): each
//! step gives a point of their difference (no farther than it: an upper bound) and a plane that the
//! difference lies behind (no nearer: a lower bound), so a question of yes or no ends as soon as either
//! bound answers it.

use super::simplex::Simplex;
use nalgebra::{Point3, Vector3};

/// A cut cone about the beam's axis, its ends flat: t is measured from the point on the part along a.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frustum {
    /// Where it begins, mm.
    pub t0_mm: f64,
    /// Where it ends.
    pub t1_mm: f64,
    /// Radius where it begins, mm.
    pub r0_mm: f64,
    /// Radius where it ends, mm.
    pub r1_mm: f64,
}

impl Frustum {
    /// The greatest distance of any of its points from t = 0 on the axis, mm.
    pub fn reach_mm(&self) -> f64 {
        let end = |t: f64, r: f64| (t * t + r * r).sqrt();
        end(self.t0_mm, self.r0_mm).max(end(self.t1_mm, self.r1_mm))
    }

    /// Places it with t = 0 at `p` and its axis along the unit vector `a`.
    pub fn placed(&self, p: &Point3<f64>, a: &Vector3<f64>) -> PlacedFrustum {
        let slope = (self.r1_mm - self.r0_mm) / (self.t1_mm - self.t0_mm);
        let [start, end] = [self.t0_mm, self.t1_mm].map(|t| p + a * t);
        let wide = a.map(|x| (1.0 - x * x).max(0.0).sqrt());
        let side = |k: usize, sign: f64| {
            let at = |end: &Point3<f64>, r: f64| sign * end[k] + r * wide[k];
            // Wider by more than the rounding.
            sign * (at(&start, self.r0_mm).max(at(&end, self.r1_mm)) + 1e-9)
        };
        PlacedFrustum {
            origin: *p,
            axis: *a,
            shape: *self,
            slope,
            inverse: a.map(|x| (1.0 / x).clamp(-1e300, 1e300)),
            lo: std::array::from_fn(|k| side(k, -1.0)),
            hi: std::array::from_fn(|k| side(k, 1.0)),
        }
    }
}

/// A cut cone in space.
#[derive(Clone, Copy, Debug)]
pub struct PlacedFrustum {
    origin: Point3<f64>,
    axis: Vector3<f64>,
    shape: Frustum,
    /// By how much its radius grows along the axis.
    slope: f64,
    inverse: Vector3<f64>,
    /// The box around it.
    lo: [f64; 3],
    hi: [f64; 3],
}

/// Maximum number of iterations. Four or five are usual; a case still undecided counts as near.
const MOST_STEPS: usize = 48;

impl PlacedFrustum {
    /// Whether a box might come within `reach_mm`; `false` is certain.
    #[inline]
    pub fn near_box(&self, lo: &[f64; 3], hi: &[f64; 3], reach_mm: f64) -> bool {
        // Most boxes that are far are so along x, y or z.
        if (0..3).any(|k| lo[k] - self.hi[k] > reach_mm || self.lo[k] - hi[k] > reach_mm) {
            return false;
        }
        let (mut middle, mut half) = (0.0, 0.0);
        for k in 0..3 {
            let a = self.axis[k];
            middle += (0.5 * (lo[k] + hi[k]) - self.origin[k]) * a;
            half += 0.5 * (hi[k] - lo[k]) * a.abs();
        }
        let s = &self.shape;
        let from = (middle - half).max(s.t0_mm - reach_mm);
        let to = (middle + half).min(s.t1_mm + reach_mm);
        if from > to + 1e-9 {
            return false;
        }
        // The stretch of the axis beside the box, as wide as the cone gets there.
        let at = |t: f64| s.r0_mm + self.slope * (t.clamp(s.t0_mm, s.t1_mm) - s.t0_mm);
        // A point beside the flank may be nearest to a wider place further along.
        let radius = at(from - reach_mm).max(at(to + reach_mm)) + reach_mm + 1e-9;
        let (mut near, mut far) = (from - 1e-9, to + 1e-9);
        for k in 0..3 {
            let x = (lo[k] - radius - self.origin[k]) * self.inverse[k];
            let y = (hi[k] + radius - self.origin[k]) * self.inverse[k];
            let (x, y) = if x < y { (x, y) } else { (y, x) };
            if x > near {
                near = x;
            }
            if y < far {
                far = y;
            }
        }
        near <= far + 1e-9 * (1.0 + far.abs())
    }

    /// Whether a triangle comes within `reach_mm`.
    pub fn is_near(&self, corners: &[Point3<f64>; 3], reach_mm: f64) -> bool {
        if self.surely_apart(corners, reach_mm) {
            return false;
        }
        let mut near = true;
        self.approach(corners, |low, high, _| {
            near = low <= reach_mm;
            low > reach_mm || high <= reach_mm
        });
        near
    }

    /// Distance from a triangle, mm, never more than the true one by more than rounding, and less by a
    /// millionth at most; 0 where they touch.
    pub fn distance_mm(&self, corners: &[Point3<f64>; 3]) -> f64 {
        let mut least = 0.0;
        self.approach(corners, |low, high, _| {
            least = low;
            high - low <= 1e-6 * (1e-3 + high)
        });
        least.max(0.0)
    }

    /// The shortest way from a triangle to it, mm; zero where they touch.
    pub fn separation(&self, corners: &[Point3<f64>; 3]) -> Vector3<f64> {
        let mut shortest = Vector3::zeros();
        self.approach(corners, |low, high, way| {
            shortest = *way;
            high - low <= 1e-6 * (1e-3 + high)
        });
        shortest
    }

    /// How high its lowest point stands over the plane through `on` with the unit normal `n`, mm.
    pub fn height_over(&self, on: &Point3<f64>, n: &Vector3<f64>) -> f64 {
        (self.support(&-n) - on).dot(n)
    }

    /// A quick test that uses only the axis and the greatest radius.
    #[inline]
    fn surely_apart(&self, corners: &[Point3<f64>; 3], reach_mm: f64) -> bool {
        let s = &self.shape;
        let d = corners.map(|c| c - self.origin);
        let t = d.map(|d| d.dot(&self.axis));
        let (low, high) = (t[0].min(t[1]).min(t[2]), t[0].max(t[1]).max(t[2]));
        if low > s.t1_mm + reach_mm || high < s.t0_mm - reach_mm {
            return true;
        }
        // Seen along the axis: is there a line between it and the triangle?
        let at = |t: f64| s.r0_mm + self.slope * (t.clamp(s.t0_mm, s.t1_mm) - s.t0_mm);
        let radius = at(low - reach_mm).max(at(high + reach_mm)) + reach_mm + 1e-9;
        let q = [d[0] - self.axis * t[0], d[1] - self.axis * t[1], d[2] - self.axis * t[2]];
        [(0, 1, 2), (1, 2, 0), (2, 0, 1)].into_iter().any(|(i, j, k)| {
            let side = q[j] - q[i];
            // Twice the areas on either side of the line: of the axis, and of the third corner.
            let axis = -side.cross(&q[i]).dot(&self.axis);
            let third = side.cross(&(q[k] - q[i])).dot(&self.axis);
            axis * third < 0.0 && axis * axis > radius * radius * side.norm_squared()
        })
    }

    /// The farthest point of the cone along `d`.
    #[inline]
    fn support(&self, d: &Vector3<f64>) -> Point3<f64> {
        let along = d.dot(&self.axis);
        let flat = d - self.axis * along;
        let length = flat.norm();
        // For `d` along the axis the rest is rounding and points anywhere, even along the axis.
        let flat = flat - self.axis * flat.dot(&self.axis);
        let s = &self.shape;
        let (t, r) = if s.t0_mm * along + s.r0_mm * length >= s.t1_mm * along + s.r1_mm * length {
            (s.t0_mm, s.r0_mm)
        } else {
            (s.t1_mm, s.r1_mm)
        };
        let out = if length > 1e-9 * along.abs() { flat * (r / length) } else { Vector3::zeros() };
        self.origin + self.axis * t + out
    }

    /// Passes ever tighter lower and upper bounds of the distance, and the way that the upper one is of, to `enough` until
    /// it returns true.
    fn approach(&self, corners: &[Point3<f64>; 3], mut enough: impl FnMut(f64, f64, &Vector3<f64>) -> bool) {
        let mut v = self.origin + self.axis * (0.5 * (self.shape.t0_mm + self.shape.t1_mm)) - corners[0];
        let mut simplex = Simplex::default();
        let mut low = 0.0f64;
        for _ in 0..MOST_STEPS {
            let high = v.norm();
            if high < 1e-12 {
                enough(0.0, 0.0, &Vector3::zeros());
                return;
            }
            let far = corners.iter().fold(&corners[0], |b, c| if c.coords.dot(&v) > b.coords.dot(&v) { c } else { b });
            let w = self.support(&-v) - far;
            let bound = w.dot(&v) / high;
            low = low.max(bound);
            if enough(low, high, &v) {
                return;
            }
            // No progress beyond rounding, or a point that the simplex already has.
            if high - bound <= 1e-12 * high || simplex.has(&w) {
                return;
            }
            let Some(next) = simplex.added(w) else {
                enough(0.0, 0.0, &Vector3::zeros());
                return;
            };
            if next.norm_squared() >= v.norm_squared() && low > 0.0 && simplex.count > 1 {
                return; // only rounding is left
            }
            v = next;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point(c: [f64; 3]) -> Point3<f64> {
        Point3::from(Vector3::from(c))
    }

    /// Distance of a point from a cut cone, in the half plane of axis and point.
    fn from_point(f: &Frustum, p: &Point3<f64>, a: &Vector3<f64>, q: &Point3<f64>) -> f64 {
        let d = q - p;
        let t = d.dot(a);
        let r = (d - a * t).norm();
        let slope = (f.r1_mm - f.r0_mm) / (f.t1_mm - f.t0_mm);
        if (f.t0_mm..=f.t1_mm).contains(&t) && r <= f.r0_mm + slope * (t - f.t0_mm) {
            return 0.0;
        }
        let to = |u: [f64; 2], v: [f64; 2]| {
            let (dx, dy) = (v[0] - u[0], v[1] - u[1]);
            let s = (((t - u[0]) * dx + (r - u[1]) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
            libm::hypot(t - u[0] - s * dx, r - u[1] - s * dy)
        };
        let (x, y) = ([f.t0_mm, f.r0_mm], [f.t1_mm, f.r1_mm]);
        to([f.t0_mm, 0.0], x).min(to(x, y)).min(to(y, [f.t1_mm, 0.0]))
    }

    /// Over the triangle by two ternary searches: the distance to a convex body is convex.
    fn brute(f: &Frustum, p: &Point3<f64>, a: &Vector3<f64>, c: &[Point3<f64>; 3]) -> f64 {
        let least = |g: &dyn Fn(f64) -> f64| {
            let (mut lo, mut hi) = (0.0, 1.0);
            for _ in 0..80 {
                let (x, y) = (lo + (hi - lo) / 3.0, hi - (hi - lo) / 3.0);
                if g(x) < g(y) { hi = y } else { lo = x }
            }
            g(0.5 * (lo + hi))
        };
        least(&|u| least(&|v| from_point(f, p, a, &(c[0] + ((c[1] - c[0]) * (1.0 - v) + (c[2] - c[0]) * v) * u))))
    }

    const SIDE: std::ops::Range<f64> = -12.0..12.0;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn the_distance_is_the_least(c in prop::array::uniform9(SIDE), p in prop::array::uniform3(-3.0..3.0f64),
                                     a in prop::array::uniform3(-1.0..1.0f64), t0 in -4.0..4.0f64, long in 0.1..20.0f64,
                                     r0 in 0.0..4.0f64, r1 in 0.01..6.0f64, reach in 0.0..5.0f64) {
            let corners = [point([c[0], c[1], c[2]]), point([c[3], c[4], c[5]]), point([c[6], c[7], c[8]])];
            let a = Vector3::from(a);
            prop_assume!(a.norm() > 0.1);
            let (p, a) = (point(p), a.normalize());
            let f = Frustum { t0_mm: t0, t1_mm: t0 + long, r0_mm: r0, r1_mm: r1 };
            let placed = f.placed(&p, &a);
            let (found, least) = (placed.distance_mm(&corners), brute(&f, &p, &a, &corners));
            prop_assert!((found - least).abs() < 2e-5 * (1.0 + least), "{found} against {least}");
            if (least - reach).abs() > 1e-4 {
                prop_assert_eq!(placed.is_near(&corners, reach), least <= reach);
            }
            let lo = [0, 1, 2].map(|k| corners.iter().map(|c| c[k]).fold(f64::INFINITY, f64::min));
            let hi = [0, 1, 2].map(|k| corners.iter().map(|c| c[k]).fold(f64::NEG_INFINITY, f64::max));
            prop_assert!(least > reach || placed.near_box(&lo, &hi, reach));
        }
    }

    #[test]
    fn a_flat_end_is_flat() {
        let f = Frustum { t0_mm: 10.0, t1_mm: 30.0, r0_mm: 8.0, r1_mm: 8.0 };
        let placed = f.placed(&Point3::origin(), &Vector3::z());
        let plate = |z: f64| [Point3::new(-50.0, -50.0, z), Point3::new(50.0, -50.0, z), Point3::new(0.0, 90.0, z)];
        assert!((placed.distance_mm(&plate(7.0)) - 3.0).abs() < 1e-6);
        assert!((placed.distance_mm(&plate(31.5)) - 1.5).abs() < 1e-6);
        assert_eq!(placed.distance_mm(&plate(12.0)), 0.0);
    }
}
