//! A second opinion, slow and simple: every facet, no hierarchy, no code shared with the planner's
//! interference queries. Tests and `verify` use it.

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

/// A cut cone as numbers: where it begins and ends along a from the spot, and its radii there, mm.
pub type CutCone = [f64; 4];

impl Checker {
    /// Least distance between any facet and a cut cone about the axis, mm, no more than `within_mm`: the
    /// distance from a convex body is convex, so two searches, one in the other, find the nearest point
    /// of a facet.
    pub fn cone_distance(&self, p: &Point3<f64>, a: &Vector3<f64>, cone: &CutCone, within_mm: f64) -> f64 {
        self.facets.iter().fold(within_mm, |least, f| facet_from_cone(f, p, a, cone, least))
    }
}

/// Distance of one facet from a cut cone, mm, no more than `within_mm`.
fn facet_from_cone(f: &[Point3<f64>; 3], p: &Point3<f64>, a: &Vector3<f64>, cone: &CutCone, within_mm: f64) -> f64 {
    let [t0, t1, r0, r1] = *cone;
    let centre = p + a * (0.5 * (t0 + t1));
    let size = 0.5 * (t1 - t0) + r0.max(r1);
    // The bounding balls of cone and facet are farther apart than that.
    let middle = Point3::from((f[0].coords + f[1].coords + f[2].coords) / 3.0);
    let round = f.iter().map(|c| (c - middle).norm()).fold(0.0, f64::max);
    if (middle - centre).norm() - round - size > within_mm {
        return within_mm;
    }
    // Or the facet lies so far below the cone, or above it.
    let [low, high] = [f64::min, f64::max].map(|of| f.iter().map(|c| (c - p).dot(a)).reduce(of).unwrap_or(0.0));
    if (t0 - high).max(low - t1) > within_mm {
        return within_mm;
    }
    let on = |u: f64, v: f64| f[0] + ((f[1] - f[0]) * (1.0 - v) + (f[2] - f[0]) * v) * u;
    let along = |u: f64| lowest(|v| beside_cone(&(on(u, v) - p), a, cone));
    within_mm.min(lowest(along))
}

/// What a contact tool keeps clear of, as numbers.
#[derive(Clone, Debug)]
pub struct KeptByContact {
    /// The tool's core.
    pub cones: Vec<CutCone>,
    /// What it keeps from facets that it rests on, mm.
    pub skin_mm: f64,
    /// What it keeps from all others, mm.
    pub wall_mm: f64,
}

impl Checker {
    /// Index of a facet that a contact tool with the foot of its axis in `p` comes too near to.
    pub fn touched(&self, p: &Point3<f64>, a: &Vector3<f64>, kept: &KeptByContact) -> Option<usize> {
        self.facets.iter().position(|f| {
            kept.cones.iter().any(|cone| {
                let mm = facet_from_cone(f, p, a, cone, kept.wall_mm);
                if mm >= kept.skin_mm.max(kept.wall_mm) {
                    return false;
                }
                // Lifted along the axis it gets away by what the way to it has of the axis: within 60° by half of it.
                let lifted_mm = facet_from_cone(f, &(p + a * LIFT_MM), a, cone, kept.wall_mm + LIFT_MM);
                let rests = lifted_mm - mm >= 0.5 * LIFT_MM;
                mm < if rests { kept.skin_mm } else { kept.wall_mm }
            })
        })
    }
}

/// How far a tool is lifted to see whether it rests on a facet, mm.
const LIFT_MM: f64 = 1e-3;

/// Least value of a convex function over 0 to 1, by golden section.
fn lowest(f: impl Fn(f64) -> f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut lo, mut hi) = (0.0, 1.0);
    let (mut x, mut y) = (1.0 - GOLDEN, GOLDEN);
    let (mut fx, mut fy) = (f(x), f(y));
    for _ in 0..38 {
        if fx < fy {
            (hi, y, fy) = (y, x, fx);
            x = hi - GOLDEN * (hi - lo);
            fx = f(x);
        } else {
            (lo, x, fx) = (x, y, fy);
            y = lo + GOLDEN * (hi - lo);
            fy = f(y);
        }
    }
    fx.min(fy).min(f(0.0)).min(f(1.0))
}

/// Distance of a point from a cut cone, in the half plane of axis and point.
fn beside_cone(d: &Vector3<f64>, a: &Vector3<f64>, [t0, t1, r0, r1]: &CutCone) -> f64 {
    let t = d.dot(a);
    let r = (d - a * t).norm();
    if (*t0..=*t1).contains(&t) && (r - r0) * (t1 - t0) <= (r1 - r0) * (t - t0) {
        return 0.0;
    }
    let to = |[x, y]: [f64; 2], [dx, dy]: [f64; 2]| {
        let s = (((t - x) * dx + (r - y) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        libm::hypot(t - x - s * dx, r - y - s * dy)
    };
    let lids = to([*t0, 0.0], [0.0, r0.max(1e-9)]).min(to([*t1, 0.0], [0.0, r1.max(1e-9)]));
    lids.min(to([*t0, *r0], [t1 - t0, r1 - r0]))
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
