//! Rays and distances against all facets of a part: a bounding volume hierarchy.
//!
//! Nodes are split by the surface area heuristic over 16 bins. Boxes are f64 and queries exact to
//! rounding; what a hit means (own neighbourhood, interference) is decided by the caller.

mod prepared;
mod proximity;

use super::topology::{FacetDefect, Mesh};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

const LEAF: usize = 4;
const BINS: usize = 16;

/// Subtrees of more facets than this are built in parallel.
const SIDE_BY_SIDE: usize = 1 << 13;

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Aabb,
    /// First facet of a leaf, or index of the first child (the second follows it).
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
pub struct RayHit {
    /// Facet index in the mesh.
    pub facet: u32,
    /// Distance along the ray, mm (the direction is a unit vector).
    pub t_mm: f64,
}

impl Bvh {
    /// Builds over all facets with area.
    pub fn new(mesh: &Mesh) -> Bvh {
        let facet: Vec<u32> =
            (0..mesh.facets.len() as u32).filter(|&f| mesh.defects[f as usize] == FacetDefect::None).collect();
        let bounded = |&facet: &u32| FacetBox { bounds: Aabb::of(&mesh.corners(facet as usize)), facet };
        let mut items: Vec<FacetBox> = facet.par_iter().map(bounded).collect();
        let nodes = if items.is_empty() { Vec::new() } else { build_tree(&mut items, 0) };
        let facet: Vec<u32> = items.iter().map(|i| i.facet).collect();
        let corners = facet.iter().map(|&f| mesh.corners(f as usize)).collect();
        Bvh { nodes, corners, facet }
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
    t0: f64,
}

impl Slabs {
    fn new(origin: &Point3<f64>, dir: &Vector3<f64>, t0: f64, radius: f64) -> Slabs {
        let at = |off: f64| [0, 1, 2].map(|k| origin[k] + off);
        // Parallel to a slab: a finite number, because 0·∞ would be NaN for an origin on its side.
        let inverse = [0, 1, 2].map(|k| (1.0 / dir[k]).clamp(-1e300, 1e300));
        Slabs { origin: [at(radius), at(-radius)], inverse, t0 }
    }

    /// Where the ray enters a box before `far`.
    #[inline]
    fn entry(&self, b: &Aabb, far: f64) -> Option<f64> {
        let (mut near, mut far) = (self.t0, far);
        for k in 0..3 {
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
    far + 1e-9 * (1.0 + smaller(far.abs(), 1e12))
}

/// `f64::min` for numbers: one instruction, where that one looks for NaN as well.
fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// `f64::max` for numbers.
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
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
    let slack = 1e-9;
    (u >= -slack && v >= -slack && u + v <= 1.0 + slack).then(|| e2.dot(&q) / det)
}

/// A facet with its box, while the tree is built.
#[derive(Clone, Copy)]
struct FacetBox {
    bounds: Aabb,
    facet: u32,
}

#[derive(Clone, Copy, Debug)]
struct Aabb {
    lo: [f64; 3],
    hi: [f64; 3],
}

impl Aabb {
    const NONE: Aabb = Aabb { lo: [f64::INFINITY; 3], hi: [f64::NEG_INFINITY; 3] };

    fn of(corners: &[Point3<f64>; 3]) -> Aabb {
        corners.iter().fold(Aabb::NONE, |b, p| b.with(&Aabb { lo: [p.x, p.y, p.z], hi: [p.x, p.y, p.z] }))
    }

    fn with(&self, o: &Aabb) -> Aabb {
        Aabb {
            lo: std::array::from_fn(|k| smaller(self.lo[k], o.lo[k])),
            hi: std::array::from_fn(|k| larger(self.hi[k], o.hi[k])),
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

/// The nodes over `items`, which are put in the order of the leaves; the root is the first.
/// `offset`: how many items stand before these.
fn build_tree(items: &mut [FacetBox], offset: u32) -> Vec<Node> {
    let mut nodes = Vec::with_capacity(items.len() / 2 + 1);
    nodes.push(Node { bounds: Aabb::NONE, at: 0, count: 0 });
    build(items, offset, &mut nodes, 0);
    nodes
}

fn build(items: &mut [FacetBox], offset: u32, nodes: &mut Vec<Node>, me: usize) {
    let bounds = items.iter().fold(Aabb::NONE, |b, i| b.with(&i.bounds));
    if items.len() <= LEAF {
        nodes[me] = Node { bounds, at: offset, count: items.len() as u32 };
        return;
    }
    let children = nodes.len();
    nodes[me] = Node { bounds, at: children as u32, count: 0 };
    nodes.extend([nodes[me]; 2]);
    let side_by_side = items.len() > SIDE_BY_SIDE;
    let middle = split(items);
    let (left, right) = items.split_at_mut(middle);
    let behind = offset + middle as u32;
    if side_by_side {
        let pair = rayon::join(|| build_tree(left, offset), || build_tree(right, behind));
        graft(nodes, children, &pair.0);
        graft(nodes, children + 1, &pair.1);
    } else {
        build(left, offset, nodes, children);
        build(right, behind, nodes, children + 1);
    }
}

/// Moves a tree into `nodes`: its root to `place`, the rest to the end.
fn graft(nodes: &mut Vec<Node>, place: usize, tree: &[Node]) {
    // A child's index in `tree` counts the root.
    let shift = nodes.len() as u32 - 1;
    let moved = |n: &Node| if n.count == 0 { Node { at: n.at + shift, ..*n } } else { *n };
    let mut tree = tree.iter().map(moved);
    if let Some(root) = tree.next() {
        nodes[place] = root;
    }
    nodes.extend(tree);
}

/// Orders facets into two groups, and returns where the second begins (neither is empty).
fn split(items: &mut [FacetBox]) -> usize {
    let centres = items.iter().fold(Aabb::NONE, |b, i| {
        let c = [0, 1, 2].map(|k| i.bounds.middle(k));
        b.with(&Aabb { lo: c, hi: c })
    });
    let width = [0, 1, 2].map(|k| centres.hi[k] - centres.lo[k]);
    let scale = width.map(|w| BINS as f64 / w);
    let mut bins = [[(Aabb::NONE, 0usize); BINS]; 3];
    for i in items.iter() {
        for axis in (0..3).filter(|&k| width[k] > 0.0) {
            let bin = &mut bins[axis][bin_of(i.bounds.middle(axis), centres.lo[axis], scale[axis])];
            *bin = (bin.0.with(&i.bounds), bin.1 + 1);
        }
    }
    let mut best = (f64::INFINITY, 0, 0);
    for (axis, bins) in bins.iter().enumerate() {
        let mut right = [(0.0, 0usize); BINS];
        let mut sum = (Aabb::NONE, 0);
        for k in (1..BINS).rev() {
            sum = (sum.0.with(&bins[k].0), sum.1 + bins[k].1);
            right[k] = (sum.0.half_area(), sum.1);
        }
        let mut left = (Aabb::NONE, 0);
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
        return items.len() / 2; // all centres in one point
    }
    let mut middle = 0;
    for i in 0..items.len() {
        if bin_of(items[i].bounds.middle(axis), centres.lo[axis], scale[axis]) < bin {
            items.swap(i, middle);
            middle += 1;
        }
    }
    middle
}

fn bin_of(x: f64, lo: f64, scale: f64) -> usize {
    (((x - lo) * scale) as u32 as usize).min(BINS - 1)
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
                .filter(|&f| mesh.defects[f] == FacetDefect::None)
                .filter_map(|f| ray_hit_mm(&mesh.corners(f), &o, &d).map(|t| (t, f as u32)))
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
        assert_eq!(hit, Some(RayHit { facet: 0, t_mm: 5.0 }));
        assert_eq!(bvh.nearest_hit(&Point3::origin(), &Vector3::y(), 0.0, f64::INFINITY), None);
    }
}
