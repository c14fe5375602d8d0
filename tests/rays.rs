//! Rays through vertices, edges and almost along facets of closed solids: none of them slips through where two facets
//! meet. What a ray truly meets is told facet by facet in exact arithmetic.
//!
//! `CLEARBEAM_RAYS=10000000 cargo test --test rays` looks at as many.

#[path = "common/random.rs"]
mod random;

use clearbeam::part::topology::FacetDefect;
use clearbeam::part::{Bvh, Mesh};
use clearbeam::sample::{Triangles, solids};
use nalgebra::{Isometry3, Point3, Rotation3, Vector3};
use proptest::prelude::*;
use random::Random;
use rayon::prelude::*;

/// Rays that are looked at without the variable.
const RAYS: usize = 20_000;

/// A sum of f64 that is known exactly: parts that do not overlap, the smallest first (Shewchuk 1997).
#[derive(Default)]
struct Exact(Vec<f64>);

/// A sum and its rounding.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let virtual_b = sum - a;
    (sum, (a - (sum - virtual_b)) + (b - virtual_b))
}

/// A number as a sum of two with half as many digits.
fn halves(a: f64) -> (f64, f64) {
    let large = 134_217_729.0 * a;
    let high = large - (large - a);
    (high, a - high)
}

/// A product and its rounding (Dekker 1971).
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
    (product, a2 * b2 - (((product - a1 * b1) - a2 * b1) - a1 * b2))
}

impl Exact {
    fn add(&mut self, x: f64) {
        let mut sum = x;
        let mut kept = 0;
        for i in 0..self.0.len() {
            let (more, low) = two_sum(sum, self.0[i]);
            sum = more;
            if low != 0.0 {
                self.0[kept] = low;
                kept += 1;
            }
        }
        self.0.truncate(kept);
        if sum != 0.0 {
            self.0.push(sum);
        }
    }

    /// Adds `sign·x·y·z`.
    fn add_product(&mut self, sign: f64, x: f64, y: f64, z: f64) {
        let (high, low) = two_product(x, y);
        for part in [low, high] {
            let (high, low) = two_product(part, z);
            self.add(sign * low);
            self.add(sign * high);
        }
    }

    /// Adds `sign·(u × v)·w`.
    fn add_determinant(&mut self, sign: f64, u: [f64; 3], v: [f64; 3], w: [f64; 3]) {
        for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            self.add_product(sign, u[i], v[j], w[k]);
            self.add_product(-sign, u[j], v[i], w[k]);
        }
    }

    /// −1, 0 or 1.
    fn sign(&self) -> i32 {
        self.0.last().map_or(0, |largest| if *largest > 0.0 { 1 } else { -1 })
    }
}

type Vector = [f64; 3];

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn size(a: Vector) -> f64 {
    a[0].abs() + a[1].abs() + a[2].abs()
}

/// More than the rounding of a determinant of differences, as a share of the product of their sizes.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// On which side the line from `o` along `d` passes the edge from `a` to `b`: the sign of `d·((a − o) × (b − o))`.
fn side(o: Vector, d: Vector, a: Vector, b: Vector) -> i32 {
    let (u, v) = (minus(a, o), minus(b, o));
    let about = dot(d, cross(u, v));
    if about.abs() > ROUNDING * size(d) * size(u) * size(v) {
        return if about > 0.0 { 1 } else { -1 };
    }
    let mut exact = Exact::default();
    exact.add_determinant(1.0, a, b, d);
    exact.add_determinant(-1.0, a, o, d);
    exact.add_determinant(-1.0, o, b, d);
    exact.sign()
}

/// The sign of `(a − o)·((b − o) × (c − o))`: on which side of a facet the point `o` is.
fn beyond(o: Vector, [a, b, c]: [Vector; 3]) -> i32 {
    let (u, v, w) = (minus(a, o), minus(b, o), minus(c, o));
    let about = dot(u, cross(v, w));
    if about.abs() > ROUNDING * size(u) * size(v) * size(w) {
        return if about > 0.0 { 1 } else { -1 };
    }
    let mut exact = Exact::default();
    exact.add_determinant(1.0, a, b, c);
    exact.add_determinant(-1.0, o, b, c);
    exact.add_determinant(-1.0, a, o, c);
    exact.add_determinant(-1.0, a, b, o);
    exact.sign()
}

/// Whether a ray meets a facet, its rim included. Not one that it runs in the plane of: where such a ray comes to the
/// facet it meets a neighbour of a closed solid.
fn meets(o: Vector, d: Vector, facet: [Vector; 3]) -> bool {
    let [a, b, c] = facet;
    let first = side(o, d, a, b);
    let second = side(o, d, b, c);
    if first * second < 0 {
        return false;
    }
    let third = side(o, d, c, a);
    let all = first + second + third;
    // The sides add up to the facet's normal times the ray's direction.
    all != 0 && first * third >= 0 && second * third >= 0 && all.signum() * beyond(o, facet) >= 0
}

/// A direction, each as likely as the others.
fn direction(random: &mut Random) -> Vector3<f64> {
    loop {
        let v = Vector3::from_fn(|_, _| 2.0 * random.share() - 1.0);
        if (0.01..=1.0).contains(&v.norm_squared()) {
            return v.normalize();
        }
    }
}

/// A closed solid somewhere.
struct Solid {
    mesh: Mesh,
    bvh: Bvh,
    facets: Vec<[Vector; 3]>,
    centre: Point3<f64>,
    size_mm: f64,
}

impl Solid {
    fn new(triangles: &Triangles, scale: f64, place: &Isometry3<f64>) -> Solid {
        let raw: Vec<[[f32; 3]; 3]> = triangles.iter().map(|t| t.map(|c| c.map(|x| x as f32))).collect();
        let welded = Mesh::weld(&raw, 1.0);
        let vertices = welded.vertices.iter().map(|v| place * (v * scale)).collect();
        let mesh = Mesh::from_indexed(vertices, welded.facets);
        assert!((0..mesh.edges.len() as u32).all(|e| mesh.smooth_pair(e).is_some()), "a closed skin");
        assert!(mesh.defects.iter().all(|d| *d == FacetDefect::None), "every facet has an area");
        let (lo, hi) = mesh.bounds();
        let facets = (0..mesh.facets.len()).map(|f| mesh.corners(f).map(Into::into)).collect();
        Solid { bvh: Bvh::new(&mesh), facets, centre: nalgebra::center(&lo, &hi), size_mm: (hi - lo).norm(), mesh }
    }

    /// A ray that is aimed at a vertex, at a point of an edge, or almost along a facet.
    fn ray(&self, random: &mut Random) -> (Point3<f64>, Vector3<f64>) {
        let facet = random.below(self.facets.len());
        let corners = self.mesh.corners(facet);
        let first = random.below(3);
        let (a, b, c) = (corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3]);
        let kind = random.below(8);
        let target = match kind {
            0..=2 => a,
            3..=5 => a + (b - a) * random.share(),
            _ => {
                let (s, t) = (random.share(), random.share());
                let (s, t) = if s + t > 1.0 { (1.0 - s, 1.0 - t) } else { (s, t) };
                a + (b - a) * s + (c - a) * t
            }
        };
        // From inside up to a thousand sizes away.
        let away = self.size_mm * libm::exp2(12.0 * random.share() - 2.0);
        let back = match kind {
            // Along an axis the boxes' sides are met exactly.
            2 | 5 => {
                let mut axis = Vector3::zeros();
                axis[random.below(3)] = if random.below(2) == 0 { 1.0 } else { -1.0 };
                axis
            }
            // Almost in the facet's plane, or so that rounding decides.
            4 | 6 | 7 => {
                let along = (b - a) * (2.0 * random.share() - 1.0) + (c - a) * (2.0 * random.share() - 1.0);
                // Where rounding loses most: between a thousandth and a billionth.
                let steep = if kind == 7 { -10.0 - 22.0 * random.share() } else { -50.0 * random.share() };
                let steep = libm::exp2(steep);
                let along = along.try_normalize(1e-12).unwrap_or_else(Vector3::x);
                (along + self.mesh.normals[facet] * steep).normalize()
            }
            _ => direction(random),
        };
        let origin = target + back * away;
        // Aimed anew from where rounding has put the origin.
        let dir = if matches!(kind, 2 | 5) { -back } else { (target - origin).normalize() };
        (origin, dir)
    }

    /// What the tree misses of what the ray meets.
    fn missed(&self, o: &Point3<f64>, d: &Vector3<f64>) -> Option<String> {
        let (from, along): (Vector, Vector) = ((*o).into(), (*d).into());
        let found = self.bvh.nearest_hit(o, d, 0.0, f64::INFINITY);
        let reach_mm = (o - self.centre).norm() + self.size_mm;
        let exact_mm = 1e-9 * reach_mm;
        (0..self.facets.len()).filter(|&f| meets(from, along, self.facets[f])).find_map(|f| {
            let Some(found) = found else { return Some(format!("facet {f} of {o} along {d}, and nothing is found")) };
            let a = self.mesh.corners(f)[0];
            let n = self.mesh.normals[f];
            let t_mm = n.dot(&(a - o)) / n.dot(d);
            // Where it grazes a facet the place of the hit is not told; how far the ray goes beneath the facet is.
            let beneath_mm = n.dot(&(o + d * found.t_mm - a)).abs();
            let is_far = found.t_mm > t_mm + exact_mm && beneath_mm > exact_mm;
            is_far.then(|| format!("facet {f} of {o} along {d} at {t_mm}, and {found:?} is found"))
        })
    }
}

/// Solids as they are made, turned, scaled, and far from the origin.
fn all_solids() -> Vec<Solid> {
    let made = [
        solids::cube(10.0),
        solids::cylinder(5.0, 12.0, 24),
        solids::cone(6.0, 9.0, 17),
        solids::sphere(7.0, 12, 8),
        solids::torus(9.0, 3.0, 14, 8),
        solids::fin_row(3, 2.0, 4.0, 15.0, 50.0, 7.0),
        solids::blind_hole(40.0, 5.0, 10.0, 24),
    ];
    let places = [
        (1.0, Isometry3::identity()),
        (0.37, Isometry3::from_parts(Vector3::new(0.1, -0.2, 0.3).into(), turn(0.4, -1.1, 0.7))),
        (1000.0 / 3.0, Isometry3::from_parts(Vector3::new(-1e3, 2e3, 7e2).into(), turn(-2.0, 0.3, 1.9))),
        (1.0, Isometry3::from_parts(Vector3::new(1e6 / 3.0, -2e6 / 7.0, 1e5 / 9.0).into(), turn(1.0, 2.0, 3.0))),
    ];
    made.iter().flat_map(|t| places.iter().map(|(scale, place)| Solid::new(t, *scale, place))).collect()
}

fn turn(x: f64, y: f64, z: f64) -> nalgebra::UnitQuaternion<f64> {
    Rotation3::from_scaled_axis(Vector3::new(x, y, z)).into()
}

#[test]
fn no_ray_slips_through_a_closed_solid() {
    let count = std::env::var("CLEARBEAM_RAYS").ok().and_then(|n| n.parse().ok()).unwrap_or(RAYS);
    let solids = all_solids();
    const CHUNK: usize = 1000;
    let met: usize = (0..count.div_ceil(CHUNK))
        .into_par_iter()
        .map(|chunk| {
            let mut random = Random(chunk as u64);
            let rays = CHUNK.min(count - chunk * CHUNK);
            let solid = &solids[chunk % solids.len()];
            (0..rays)
                .filter(|_| {
                    let (o, d) = solid.ray(&mut random);
                    let missed = solid.missed(&o, &d);
                    assert!(missed.is_none(), "{}", missed.unwrap_or_default());
                    solid.bvh.nearest_hit(&o, &d, 0.0, f64::INFINITY).is_some()
                })
                .count()
        })
        .sum();
    println!("{count} rays, {met} of them meet something, none is missed");
    assert!(met > count / 2, "most rays are aimed well: {met}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// The exact signs are those of integers.
    #[test]
    fn the_exact_arithmetic_is_exact(o in prop::array::uniform3(-2000..2000i128), d in prop::array::uniform3(-2000..2000i128),
                                     a in prop::array::uniform3(-2000..2000i128), b in prop::array::uniform3(-2000..2000i128),
                                     along in -3..=3i128) {
        // Half of them on the very edge.
        let d = if along > 0 { [0, 1, 2].map(|k| a[k] + along * (b[k] - a[k]) - o[k]) } else { d };
        let of = |x: [i128; 3], y: [i128; 3]| [0, 1, 2].map(|k| x[k] - y[k]);
        let det = |u: [i128; 3], v: [i128; 3], w: [i128; 3]| {
            w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) + w[2] * (u[0] * v[1] - u[1] * v[0])
        };
        // Scaled by what is no power of two, so that the products round.
        const SCALE: f64 = 94_906_267.0;
        let real = |x: [i128; 3]| x.map(|x| x as f64 * SCALE);
        prop_assert_eq!(side(real(o), real(d), real(a), real(b)), det(of(a, o), of(b, o), d).signum() as i32);
        let c = d;
        prop_assert_eq!(beyond(real(o), [a, b, c].map(real)), det(of(a, o), of(b, o), of(c, o)).signum() as i32);
    }
}
