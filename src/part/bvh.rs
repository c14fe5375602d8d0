//! Rays and distances against all facets of a part: a bounding volume hierarchy.
//!
//! Boxes are f64 and queries exact to rounding; what a hit means (own neighbourhood, interference) is decided by the
//! caller.

mod aabb;
mod build;
pub mod closest;
pub mod closest_search;
mod facet_block;
mod prepared;
mod proximity;

use super::topology::{FacetDefect, Mesh};
use crate::progress::{Cancelled, Progress};
use aabb::{Aabb, larger, smaller};
use build::{FacetBox, Node, build_tree};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// The hierarchy, with the facets' corners stored in its order.
#[derive(Clone, Debug, Default)]
pub struct Bvh {
    nodes: Vec<Node>,
    corners: Vec<[Point3<f64>; 3]>,
    facet: Vec<u32>,
}

/// A facet met by a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayHit {
    /// Facet index in the mesh.
    pub facet: u32,
    /// Distance along the ray, mm (the direction is a unit vector).
    pub t_mm: f64,
}

impl Bvh {
    /// Builds over all facets with area.
    pub fn new(mesh: &Mesh) -> Bvh {
        // Nobody else holds this progress, so it is not cancelled.
        Bvh::built(mesh, &Progress::default()).unwrap_or_default()
    }

    /// Builds over all facets with area.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn built(mesh: &Mesh, progress: &Progress) -> Result<Bvh, Cancelled> {
        let facet: Vec<u32> =
            (0..mesh.facets.len() as u32).filter(|&f| mesh.defects[f as usize] == FacetDefect::None).collect();
        let bounded = |&facet: &u32| FacetBox { bounds: Aabb::of(&mesh.corners(facet as usize)), facet };
        let mut items: Vec<FacetBox> = facet.par_iter().map(bounded).collect();
        progress.check()?;
        let mut nodes = if items.is_empty() { Vec::new() } else { build_tree(&mut items, (0, 0), progress) };
        progress.check()?;
        let facet: Vec<u32> = items.iter().map(|i| i.facet).collect();
        // Before the corners come: together they would be the most that a part needs while it is built.
        drop(items);
        nodes.shrink_to_fit();
        let corners = facet.iter().map(|&f| mesh.corners(f as usize)).collect();
        Ok(Bvh { nodes, corners, facet })
    }

    /// Diagonal of the box around all facets, mm.
    pub fn diagonal_mm(&self) -> f64 {
        self.nodes.first().map_or(0.0, |n| Vector3::from_fn(|k, _| n.bounds.hi[k] - n.bounds.lo[k]).norm())
    }

    /// Visits every facet whose leaf box the segment `origin + t·dir`, `t` in `[t0, t1]`, comes
    /// within `radius` of (measured per axis). `visit` gets facet and corners, and returns the new
    /// `t1`: below `t0` to stop.
    pub fn visit_ray(
        &self,
        origin: &Point3<f64>,
        dir: &Vector3<f64>,
        t0: f64,
        t1: f64,
        radius: f64,
        mut visit: impl FnMut(u32, &[Point3<f64>; 3]) -> f64,
    ) {
        let Some(root) = self.nodes.first() else { return };
        let slabs = Slabs::new(origin, dir, t0, radius);
        let mut far = t1;
        // Nodes that the ray enters, and where.
        let mut stack = [(0u32, 0.0f64); 96];
        let mut depth = 0;
        if let Some(entry) = slabs.entry(&root.bounds, far) {
            stack[0] = (0, entry);
            depth = 1;
        }
        while depth > 0 {
            depth -= 1;
            let (index, entry) = stack[depth];
            if entry > reach(far) {
                continue; // something nearer was found meanwhile
            }
            let node = &self.nodes[index as usize];
            if node.count > 0 {
                for i in node.at as usize..(node.at + node.count) as usize {
                    far = far.min(visit(self.facet[i], &self.corners[i]));
                    if far < t0 {
                        return;
                    }
                }
                continue;
            }
            let at = node.at;
            let first = slabs.entry(&self.nodes[at as usize].bounds, far);
            let second = slabs.entry(&self.nodes[at as usize + 1].bounds, far);
            let mut push = |index: u32, entry: Option<f64>| {
                if let Some(entry) = entry {
                    stack[depth] = (index, entry);
                    depth += 1;
                }
            };
            // The nearer child last, so that it is taken first.
            if first <= second {
                push(at + 1, second);
                push(at, first);
            } else {
                push(at, first);
                push(at + 1, second);
            }
        }
    }

    /// The nearest facet that the ray meets, `t` in `[t0, t1]`.
    pub fn nearest_hit(&self, origin: &Point3<f64>, dir: &Vector3<f64>, t0: f64, t1: f64) -> Option<RayHit> {
        let mut best: Option<RayHit> = None;
        self.visit_ray(origin, dir, t0, t1, 0.0, |facet, corners| {
            if let Some(t_mm) = ray_hit_mm(corners, origin, dir).filter(|t| (t0..=t1).contains(t)) {
                // Equal distances (a ray through an edge): the lower facet, whatever the order.
                let better = best.is_none_or(|b| t_mm < b.t_mm || (t_mm == b.t_mm && facet < b.facet));
                if better {
                    best = Some(RayHit { facet, t_mm });
                }
            }
            best.map_or(t1, |b| b.t_mm)
        });
        best
    }

    /// Visits every facet whose box comes within `radius` of a point (per axis).
    pub fn visit_near(&self, point: &Point3<f64>, radius: f64, mut visit: impl FnMut(u32, &[Point3<f64>; 3])) {
        let mut stack = [0u32; 96];
        let mut depth = usize::from(!self.nodes.is_empty());
        while depth > 0 {
            depth -= 1;
            let index = stack[depth] as usize;
            let node = &self.nodes[index];
            let b = &node.bounds;
            if (0..3).any(|k| point[k] < b.lo[k] - radius || point[k] > b.hi[k] + radius) {
                continue;
            }
            if node.count > 0 {
                for i in node.at as usize..(node.at + node.count) as usize {
                    visit(self.facet[i], &self.corners[i]);
                }
            } else {
                stack[depth] = node.at;
                stack[depth + 1] = node.at + 1;
                depth += 2;
            }
        }
    }
}

/// A ray prepared for tests against boxes, each widened by `radius` (per axis).
struct Slabs {
    origin: [[f64; 3]; 2],
    inverse: [f64; 3],
    /// Whether it never leaves a slab that it is in: told apart, because 0·1e300 is 0 for an origin on the slab's side.
    is_parallel: [bool; 3],
    t0: f64,
}

impl Slabs {
    fn new(origin: &Point3<f64>, dir: &Vector3<f64>, t0: f64, radius: f64) -> Slabs {
        let at = |off: f64| [0, 1, 2].map(|k| origin[k] + off);
        // Where it is parallel to a slab this is not asked; a number all the same.
        let inverse = [0, 1, 2].map(|k| (1.0 / dir[k]).clamp(-1e300, 1e300));
        let is_parallel = [0, 1, 2].map(|k| dir[k].abs() <= 1e-300);
        Slabs { origin: [at(radius), at(-radius)], inverse, is_parallel, t0 }
    }

    /// Where the ray enters a box before `far`.
    #[inline]
    fn entry(&self, b: &Aabb, far: f64) -> Option<f64> {
        let (mut near, mut far) = (self.t0, far);
        for k in 0..3 {
            if self.is_parallel[k] {
                // In the slab all the way, its sides included, or never.
                if b.lo[k] > self.origin[0][k] || b.hi[k] < self.origin[1][k] {
                    return None;
                }
                continue;
            }
            let x = (b.lo[k] - self.origin[0][k]) * self.inverse[k];
            let y = (b.hi[k] - self.origin[1][k]) * self.inverse[k];
            near = larger(near, smaller(x, y));
            far = smaller(far, larger(x, y));
        }
        (near <= reach(far)).then_some(near)
    }
}

/// Rounding of the slab distances must not lose a facet that lies in a box's side.
fn reach(far: f64) -> f64 {
    far + 1e-9 * (1.0 + smaller(far.abs(), 1e30))
}

/// Möller–Trumbore: distance along the ray to a facet, any sign.
pub fn ray_hit_mm([a, b, c]: &[Point3<f64>; 3], origin: &Point3<f64>, dir: &Vector3<f64>) -> Option<f64> {
    let (e1, e2) = (b - a, c - a);
    let p = dir.cross(&e2);
    let det = e1.dot(&p);
    if det.abs() <= 1e-12 * e1.norm() * e2.norm() {
        return None;
    }
    let s = origin - a;
    let u = s.dot(&p) / det;
    let q = s.cross(&e1);
    let v = dir.dot(&q) / det;
    // Slightly beyond the rim: two facets at an edge must not both miss the ray that runs through it.
    let inside = |slack: f64| u >= -slack && v >= -slack && u + v <= 1.0 + slack;
    if !inside(1.0) {
        return None;
    }
    // From far away and almost along the facet u and v are rounded more coarsely; across the ray it is still nothing.
    let size = |v: &Vector3<f64>| v.x.abs() + v.y.abs() + v.z.abs();
    let rounding = ROUNDING * size(&s) * (size(&e1) + size(&e2)) / det.abs();
    inside(1e-9 + rounding).then(|| e2.dot(&q) / det)
}

/// More than the rounding of a triple product of unit direction, way and side, as a share of the sizes of the last two:
/// five operations on the way to `u` and `v`, each with a share of half `f64::EPSILON` of sums of absolute values.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn soup(numbers: &[f64]) -> Mesh {
        let raw: Vec<[[f32; 3]; 3]> = numbers
            .chunks_exact(9)
            .map(|c| std::array::from_fn(|v| std::array::from_fn(|k| c[3 * v + k] as f32)))
            .collect();
        Mesh::weld(&raw, 1.0)
    }

    proptest! {
        #[test]
        fn the_nearest_hit_is_that_of_all_facets(numbers in prop::collection::vec(-10.0..10.0f64, 9..600),
                                                o in prop::array::uniform3(-12.0..12.0f64), d in prop::array::uniform3(-1.0..1.0f64)) {
            let mesh = soup(&numbers);
            let d = Vector3::from(d);
            prop_assume!(d.norm() > 0.1);
            let (o, d) = (Point3::from(Vector3::from(o)), d.normalize());
            let expected = (0..mesh.facets.len())
                .filter(|&f| mesh.defects[f] == FacetDefect::None)
                .filter_map(|f| ray_hit_mm(&mesh.corners(f), &o, &d).map(|t| (t, f as u32)))
                .filter(|(t, _)| *t >= 0.0)
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let found = Bvh::new(&mesh).nearest_hit(&o, &d, 0.0, f64::INFINITY);
            prop_assert_eq!(found.map(|h| (h.t_mm, h.facet)), expected);
        }
    }

    proptest! {
        /// From near and far, and along the axes, where a slab is never left.
        #[test]
        fn a_wide_ray_visits_all_that_it_touches(numbers in prop::collection::vec(-10.0..10.0f64, 9..900),
                                                 o in prop::array::uniform3(-12.0..12.0f64), d in prop::array::uniform3(-1.0..1.0f64),
                                                 axis in prop::option::of(0usize..3), away in prop_oneof![Just(0.0), 0.0..1e6],
                                                 radius in prop_oneof![Just(0.0), 0.0..2.0f64]) {
            let mesh = soup(&numbers);
            let d = axis.map_or(Vector3::from(d), |k| Vector3::ith(k, if d[k] < 0.0 { -1.0 } else { 1.0 }));
            prop_assume!(d.norm() > 0.1);
            let d = d.normalize();
            let o = Point3::from(Vector3::from(o)) - d * away;
            let bvh = Bvh::new(&mesh);
            let mut visited = std::collections::BTreeSet::new();
            bvh.visit_ray(&o, &d, 0.0, f64::INFINITY, radius, |facet, _| {
                visited.insert(facet);
                f64::INFINITY
            });
            for f in (0..mesh.facets.len()).filter(|&f| mesh.defects[f] == FacetDefect::None) {
                let near = crate::part::distance::ray_triangle(&o, &d, 0.0, &mesh.corners(f)) <= radius;
                prop_assert!(!near || visited.contains(&(f as u32)), "facet {}", f);
            }
        }
    }

    /// Each facet half as far out as the one before: the heuristic alone would split them off one by one.
    #[test]
    fn a_tree_is_never_deeper_than_its_queries_have_room_for() {
        let facet = |i: i32| {
            let x = 2f64.powi(120 - i);
            [x, 0.0, 0.0, x, x, 0.0, x, 0.0, x]
        };
        let numbers: Vec<f64> = (0..250).flat_map(facet).collect();
        let bvh = Bvh::new(&soup(&numbers));
        let mut met = 0;
        bvh.visit_ray(&Point3::new(-1.0, 0.0, 0.0), &Vector3::x(), 0.0, f64::INFINITY, 0.0, |_, _| {
            met += 1;
            f64::INFINITY
        });
        assert!(met > 0);
        bvh.visit_near(&Point3::origin(), 1e30, |_, _| met += 1);
    }

    #[test]
    fn rays_along_the_axes_meet_a_wall_that_lies_in_its_box() {
        let mesh = soup(&[5.0, -1.0, -1.0, 5.0, 3.0, -1.0, 5.0, -1.0, 3.0]);
        let bvh = Bvh::new(&mesh);
        let hit = bvh.nearest_hit(&Point3::origin(), &Vector3::x(), 0.0, f64::INFINITY);
        assert_eq!(hit, Some(RayHit { facet: 0, t_mm: 5.0 }));
        assert_eq!(bvh.nearest_hit(&Point3::origin(), &Vector3::y(), 0.0, f64::INFINITY), None);
        // In a side of the box, and whatever the sign of nothing.
        for zero in [0.0, -0.0] {
            for (y, z) in [(-1.0, -1.0), (3.0, -1.0), (-1.0, 3.0)] {
                let hit = bvh.nearest_hit(&Point3::new(0.0, y, z), &Vector3::new(1.0, zero, zero), 0.0, f64::INFINITY);
                assert_eq!(hit, Some(RayHit { facet: 0, t_mm: 5.0 }), "{y} {z} {zero}");
            }
        }
    }
}
