//! Rays and distances against all facets of a part: a bounding volume hierarchy.
//!
//! Nodes are split by the surface area heuristic over 16 bins. Boxes are f64 and queries exact to
//! rounding; what a hit means (own neighbourhood, interference) is decided by the caller.

use super::topology::{Dead, Mesh};
use nalgebra::{Point3, Vector3};

const LEAF: usize = 4;
const BINS: usize = 16;

#[derive(Clone, Copy, Debug)]
struct Node {
    lo: [f64; 3],
    hi: [f64; 3],
    /// First facet of a leaf, or index of the second child (the first follows its parent).
    at: u32,
    /// Facets of a leaf; 0 for an inner node.
    count: u32,
}

/// The hierarchy, with the facets' corners stored in its order.
#[derive(Clone, Debug, Default)]
pub struct Bvh {
    nodes: Vec<Node>,
    corners: Vec<[Point3<f64>; 3]>,
    facet: Vec<u32>,
}

/// A facet met by a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Facet index in the mesh.
    pub facet: u32,
    /// Distance along the ray, mm (the direction is a unit vector).
    pub t_mm: f64,
}

impl Bvh {
    /// Builds over all facets with area.
    pub fn new(mesh: &Mesh) -> Bvh {
        let facet: Vec<u32> = (0..mesh.facets.len() as u32).filter(|&f| mesh.dead[f as usize] == Dead::No).collect();
        let boxes: Vec<Bounds> = facet.iter().map(|&f| Bounds::of(&mesh.corners(f as usize))).collect();
        let mut order: Vec<u32> = (0..facet.len() as u32).collect();
        let mut nodes = Vec::with_capacity(facet.len());
        if !facet.is_empty() {
            build(&boxes, &mut order, 0, &mut nodes);
        }
        let facet: Vec<u32> = order.iter().map(|&i| facet[i as usize]).collect();
        let corners = facet.iter().map(|&f| mesh.corners(f as usize)).collect();
        Bvh { nodes, corners, facet }
    }

    /// Diagonal of the box around all facets, mm.
    pub fn diagonal_mm(&self) -> f64 {
        self.nodes.first().map_or(0.0, |n| Vector3::from_fn(|k, _| n.hi[k] - n.lo[k]).norm())
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
        if self.nodes.is_empty() {
            return;
        }
        let inverse = dir.map(|d| 1.0 / d);
        let mut far = t1;
        let mut stack = [0u32; 96];
        let mut depth = 1;
        while depth > 0 {
            depth -= 1;
            let index = stack[depth] as usize;
            let node = &self.nodes[index];
            if !node.meets(origin, &inverse, t0, far, radius) {
                continue;
            }
            if node.count > 0 {
                for i in node.at as usize..(node.at + node.count) as usize {
                    far = far.min(visit(self.facet[i], &self.corners[i]));
                    if far < t0 {
                        return;
                    }
                }
            } else {
                // The nearer child last, so that it is taken first.
                let (first, second) = (index as u32 + 1, node.at);
                let along = |n: u32| {
                    let n = &self.nodes[n as usize];
                    (0..3).map(|k| (n.lo[k] + n.hi[k]) * dir[k]).sum::<f64>()
                };
                let (near, later) = if along(first) <= along(second) { (first, second) } else { (second, first) };
                stack[depth] = later;
                stack[depth + 1] = near;
                depth += 2;
            }
        }
    }

    /// The nearest facet that the ray meets, `t` in `[t0, t1]`.
    pub fn nearest_hit(&self, origin: &Point3<f64>, dir: &Vector3<f64>, t0: f64, t1: f64) -> Option<Hit> {
        let mut best: Option<Hit> = None;
        self.visit_ray(origin, dir, t0, t1, 0.0, |facet, corners| {
            if let Some(t_mm) = meet(corners, origin, dir).filter(|t| (t0..=t1).contains(t)) {
                // Equal distances (a ray through an edge): the lower facet, whatever the order.
                let better = best.is_none_or(|b| t_mm < b.t_mm || (t_mm == b.t_mm && facet < b.facet));
                if better {
                    best = Some(Hit { facet, t_mm });
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
            if (0..3).any(|k| point[k] < node.lo[k] - radius || point[k] > node.hi[k] + radius) {
                continue;
            }
            if node.count > 0 {
                for i in node.at as usize..(node.at + node.count) as usize {
                    visit(self.facet[i], &self.corners[i]);
                }
            } else {
                stack[depth] = index as u32 + 1;
                stack[depth + 1] = node.at;
                depth += 2;
            }
        }
    }
}

impl Node {
    fn meets(&self, origin: &Point3<f64>, inverse: &Vector3<f64>, t0: f64, t1: f64, radius: f64) -> bool {
        let (mut near, mut far) = (t0, t1);
        for k in 0..3 {
            let (lo, hi) = (self.lo[k] - radius, self.hi[k] + radius);
            if inverse[k].is_infinite() {
                // Parallel: 0·∞ below would be NaN for an origin on the slab.
                if origin[k] < lo || origin[k] > hi {
                    return false;
                }
                continue;
            }
            let (a, b) = ((lo - origin[k]) * inverse[k], (hi - origin[k]) * inverse[k]);
            near = near.max(a.min(b));
            far = far.min(a.max(b));
        }
        // Rounding of the slab distances must not lose a facet that lies in the box's side.
        near <= far + 1e-9 * (1.0 + far.abs().min(1e12))
    }
}

/// Möller–Trumbore: distance along the ray to a facet, any sign.
pub fn meet([a, b, c]: &[Point3<f64>; 3], origin: &Point3<f64>, dir: &Vector3<f64>) -> Option<f64> {
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
    // A hair over the rim: two facets at an edge must not both miss the ray that runs through it.
    let slack = 1e-9;
    (u >= -slack && v >= -slack && u + v <= 1.0 + slack).then(|| e2.dot(&q) / det)
}

#[derive(Clone, Copy)]
struct Bounds {
    lo: [f64; 3],
    hi: [f64; 3],
}

impl Bounds {
    const NONE: Bounds = Bounds { lo: [f64::INFINITY; 3], hi: [f64::NEG_INFINITY; 3] };

    fn of(corners: &[Point3<f64>; 3]) -> Bounds {
        corners.iter().fold(Bounds::NONE, |b, p| b.with(&Bounds { lo: [p.x, p.y, p.z], hi: [p.x, p.y, p.z] }))
    }

    fn with(&self, o: &Bounds) -> Bounds {
        Bounds {
            lo: std::array::from_fn(|k| self.lo[k].min(o.lo[k])),
            hi: std::array::from_fn(|k| self.hi[k].max(o.hi[k])),
        }
    }

    fn middle(&self, k: usize) -> f64 {
        0.5 * (self.lo[k] + self.hi[k])
    }

    fn half_area(&self) -> f64 {
        let d: [f64; 3] = std::array::from_fn(|k| (self.hi[k] - self.lo[k]).max(0.0));
        d[0] * d[1] + d[1] * d[2] + d[2] * d[0]
    }
}

fn build(boxes: &[Bounds], order: &mut [u32], offset: u32, nodes: &mut Vec<Node>) {
    let all = order.iter().fold(Bounds::NONE, |b, &i| b.with(&boxes[i as usize]));
    let me = nodes.len();
    nodes.push(Node { lo: all.lo, hi: all.hi, at: offset, count: order.len() as u32 });
    if order.len() <= LEAF {
        return;
    }
    let middle = split(boxes, order, &all);
    let (left, right) = order.split_at_mut(middle);
    build(boxes, left, offset, nodes);
    nodes[me].at = nodes.len() as u32;
    nodes[me].count = 0;
    build(boxes, right, offset + middle as u32, nodes);
}

/// Orders facets into two groups and tells where the second begins (neither is empty).
fn split(boxes: &[Bounds], order: &mut [u32], all: &Bounds) -> usize {
    let centres = order.iter().fold(Bounds::NONE, |b, &i| {
        let c = std::array::from_fn(|k| boxes[i as usize].middle(k));
        b.with(&Bounds { lo: c, hi: c })
    });
    let mut best = (f64::INFINITY, 0, 0);
    for axis in 0..3 {
        let (lo, width) = (centres.lo[axis], centres.hi[axis] - centres.lo[axis]);
        if width <= 0.0 {
            continue;
        }
        let mut bins = [(Bounds::NONE, 0usize); BINS];
        for &i in order.iter() {
            let b = &boxes[i as usize];
            let bin = bin_of(b.middle(axis), lo, width);
            bins[bin] = (bins[bin].0.with(b), bins[bin].1 + 1);
        }
        let mut right = [(0.0, 0usize); BINS];
        let mut sum = (Bounds::NONE, 0);
        for k in (1..BINS).rev() {
            sum = (sum.0.with(&bins[k].0), sum.1 + bins[k].1);
            right[k] = (sum.0.half_area(), sum.1);
        }
        let mut left = (Bounds::NONE, 0);
        for k in 1..BINS {
            left = (left.0.with(&bins[k - 1].0), left.1 + bins[k - 1].1);
            if left.1 == 0 || right[k].1 == 0 {
                continue;
            }
            let cost = left.0.half_area() * left.1 as f64 + right[k].0 * right[k].1 as f64;
            if cost < best.0 {
                best = (cost, axis, k);
            }
        }
    }
    let (cost, axis, bin) = best;
    if cost.is_infinite() {
        return order.len() / 2; // all centres in one point
    }
    let (lo, width) = (centres.lo[axis], centres.hi[axis] - centres.lo[axis]);
    debug_assert!(all.half_area() >= 0.0);
    let mut middle = 0;
    for i in 0..order.len() {
        if bin_of(boxes[order[i] as usize].middle(axis), lo, width) < bin {
            order.swap(i, middle);
            middle += 1;
        }
    }
    middle
}

fn bin_of(x: f64, lo: f64, width: f64) -> usize {
    (((x - lo) / width * BINS as f64) as usize).min(BINS - 1)
}

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
                .filter(|&f| mesh.dead[f] == Dead::No)
                .filter_map(|f| meet(&mesh.corners(f), &o, &d).map(|t| (t, f as u32)))
                .filter(|(t, _)| *t >= 0.0)
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let found = Bvh::new(&mesh).nearest_hit(&o, &d, 0.0, f64::INFINITY);
            prop_assert_eq!(found.map(|h| (h.t_mm, h.facet)), expected);
        }
    }

    #[test]
    fn rays_along_the_axes_meet_a_wall_that_lies_in_its_box() {
        let mesh = soup(&[5.0, -1.0, -1.0, 5.0, 3.0, -1.0, 5.0, -1.0, 3.0]);
        let bvh = Bvh::new(&mesh);
        let hit = bvh.nearest_hit(&Point3::origin(), &Vector3::x(), 0.0, f64::INFINITY);
        assert_eq!(hit, Some(Hit { facet: 0, t_mm: 5.0 }));
        assert_eq!(bvh.nearest_hit(&Point3::origin(), &Vector3::y(), 0.0, f64::INFINITY), None);
    }
}
