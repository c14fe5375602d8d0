//! A second opinion, slow and simple: every facet, no hierarchy, no code shared with the planner's
//! own interference routine. Tests and `verify` ask it.

use nalgebra::{Point3, Vector3};

/// The facets of a part, corner by corner.
pub struct Checker {
    facets: Vec<[Point3<f64>; 3]>,
}

impl Checker {
    /// Takes the facets as they are; those without area cannot stop a beam.
    pub fn new(facets: impl IntoIterator<Item = [Point3<f64>; 3]>) -> Checker {
        Checker { facets: facets.into_iter().filter(|[a, b, c]| (b - a).cross(&(c - a)).norm() > 0.0).collect() }
    }

    /// Index of a facet that stops the beam between `from_mm` and infinity along the unit axis, by
    /// Plücker side products.
    pub fn hit(&self, p: &Point3<f64>, a: &Vector3<f64>, from_mm: f64) -> Option<usize> {
        self.facets.iter().position(|[u, v, w]| {
            let (u, v, w) = (u - p, v - p, w - p);
            let sides = [a.dot(&u.cross(&v)), a.dot(&v.cross(&w)), a.dot(&w.cross(&u))];
            let through = sides.iter().all(|s| *s > 0.0) || sides.iter().all(|s| *s < 0.0);
            through && {
                let n = (v - u).cross(&(w - u));
                n.dot(&u) / n.dot(a) > from_mm
            }
        })
    }

    /// Least distance between the beam from `from_mm` on and any facet, mm, by sampling the beam
    /// up to `length_mm` in `steps` and descending from the best sample.
    pub fn clearance(&self, p: &Point3<f64>, a: &Vector3<f64>, from_mm: f64, length_mm: f64, steps: usize) -> f64 {
        let to_facet = |f: &[Point3<f64>; 3], t: f64| nearest(&(p + a * t), f);
        let mut least = f64::INFINITY;
        for f in &self.facets {
            let step = (length_mm - from_mm) / steps as f64;
            let (best, _) = (0..=steps)
                .map(|i| from_mm + i as f64 * step)
                .map(|t| (t, to_facet(f, t)))
                .fold((from_mm, f64::INFINITY), |x, y| if y.1 < x.1 { y } else { x });
            // The distance to one facet is convex along the beam.
            let (mut lo, mut hi) = ((best - step).max(from_mm), best + step);
            for _ in 0..60 {
                let (x, y) = (lo + (hi - lo) / 3.0, hi - (hi - lo) / 3.0);
                if to_facet(f, x) < to_facet(f, y) { hi = y } else { lo = x }
            }
            least = least.min(to_facet(f, lo));
        }
        least
    }
}

/// Distance of a point from a triangle by its barycentric regions.
fn nearest(p: &Point3<f64>, [a, b, c]: &[Point3<f64>; 3]) -> f64 {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    let (d3, d4) = (ab.dot(&(p - b)), ac.dot(&(p - b)));
    let (d5, d6) = (ab.dot(&(p - c)), ac.dot(&(p - c)));
    let (va, vb, vc) = (d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2);
    let foot = if d1 <= 0.0 && d2 <= 0.0 {
        *a
    } else if d3 >= 0.0 && d4 <= d3 {
        *b
    } else if d6 >= 0.0 && d5 <= d6 {
        *c
    } else if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        a + ab * (d1 / (d1 - d3))
    } else if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        a + ac * (d2 / (d2 - d6))
    } else if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)))
    } else {
        let sum = va + vb + vc;
        a + ab * (vb / sum) + ac * (vc / sum)
    };
    (p - foot).norm()
}
