//! The nearest point of the mesh for very many points, as a scan has them: a hierarchy of four boxes a node in f32,
//! over leaves of planes in f32, that rules out nearly all facets; what is left is measured in f64. The answers are
//! those of [`Bvh::closest`], bit by bit; only the time differs.

use super::Bvh;
use super::build::Node;
use super::closest::{Best, Closest, squared_distance};
use super::facet_block::{FacetBlock, larger, shortened};
use nalgebra::{Point3, Vector3};

/// Boxes a node.
const WIDTH: usize = 4;
/// Added to the number of a leaf, where a node's child is one.
const LEAF_BIT: u32 = 1 << 31;
/// Room for the nodes that wait: more than three for each of the levels that a million facets make.
const STACK: usize = 96;
/// Coordinates whose squares are numbers in f32.
const LARGEST_MM: f64 = 1e15;

/// Where the search begins: at the facet that was found for the point before. It changes how long the search takes,
/// never what it finds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClosestHint {
    /// Place of the facet in the order of the hierarchy.
    slot: u32,
}

/// A hierarchy prepared for the nearest points of very many points.
pub struct ClosestSearch<'a> {
    bvh: &'a Bvh,
    /// What f32 coordinates are told from.
    middle: Point3<f64>,
    /// More than the rounding of a coordinate, and of its product with a unit vector.
    slack: f32,
    nodes: Vec<WideNode>,
    leaves: Vec<Leaf>,
}

struct Leaf {
    planes: FacetBlock,
    first: u32,
    count: u32,
}

/// Boxes of up to four children, and what they are; of children that are missing the box is infinitely far away.
#[derive(Clone, Copy)]
struct WideNode {
    lo: [[f32; WIDTH]; 3],
    hi: [[f32; WIDTH]; 3],
    child: [u32; WIDTH],
}

impl<'a> ClosestSearch<'a> {
    /// Prepares the search: about 150 bytes a facet, and as long as some ten thousand searches take.
    pub fn new(bvh: &'a Bvh) -> ClosestSearch<'a> {
        let mut search =
            ClosestSearch { bvh, middle: Point3::origin(), slack: 0.0, nodes: Vec::new(), leaves: Vec::new() };
        let Some(root) = bvh.nodes.first() else { return search };
        let half = Vector3::from_fn(|k, _| 0.5 * (root.bounds.hi[k] - root.bounds.lo[k]));
        search.middle = Point3::from([0, 1, 2].map(|k| root.bounds.middle(k)));
        // Some five roundings of half of 2⁻²³, on coordinates up to twice as far out as the mesh.
        search.slack = (2e-6 * half.norm()) as f32;
        search.widen(&[*root]);
        search
    }

    /// Makes a node over up to four of the hierarchy, and returns its number.
    fn widen(&mut self, over: &[Node]) -> u32 {
        let mut over = over.to_vec();
        // The largest inner one is replaced by its children, until four are there.
        while over.len() < WIDTH {
            let inner = over.iter().enumerate().filter(|(_, n)| n.count == 0);
            let Some((i, _)) = inner.max_by(|a, b| a.1.bounds.half_area().total_cmp(&b.1.bounds.half_area())) else {
                break;
            };
            let at = over.remove(i).at as usize;
            over.extend_from_slice(&self.bvh.nodes[at..at + 2]);
        }
        let me = self.nodes.len();
        let away = [[f32::INFINITY; WIDTH]; 3];
        self.nodes.push(WideNode { lo: away, hi: away, child: [0; WIDTH] });
        for (lane, node) in over.iter().enumerate() {
            let child = if node.count > 0 {
                self.leaves.push(self.leaf(node));
                LEAF_BIT | (self.leaves.len() - 1) as u32
            } else {
                let at = node.at as usize;
                let children = [self.bvh.nodes[at], self.bvh.nodes[at + 1]];
                self.widen(&children)
            };
            let wide = &mut self.nodes[me];
            wide.child[lane] = child;
            for k in 0..3 {
                wide.lo[k][lane] = (node.bounds.lo[k] - self.middle[k]) as f32;
                wide.hi[k][lane] = (node.bounds.hi[k] - self.middle[k]) as f32;
            }
        }
        me as u32
    }

    fn leaf(&self, node: &Node) -> Leaf {
        let slots = node.at as usize..(node.at + node.count) as usize;
        Leaf { planes: FacetBlock::of(&self.bvh.corners[slots], &self.middle), first: node.at, count: node.count }
    }

    /// As [`Bvh::closest`] tells it, and quicker where the point lies near the one that `hint` was used for before.
    pub fn closest(&self, point: &Point3<f64>, within_mm: f64, hint: &mut ClosestHint) -> Option<Closest> {
        let from_middle = point - self.middle;
        let reach = from_middle.amax() + f64::from(self.slack);
        if reach.is_nan() || reach >= LARGEST_MM {
            return self.bvh.closest(point, within_mm);
        }
        let p: [f32; 3] = [0, 1, 2].map(|k| from_middle[k] as f32);
        let mut best = Best::within(within_mm);
        let measure = |slot: u32, best: &mut Best| {
            let i = slot as usize;
            best.offer(squared_distance(&self.bvh.corners[i], point), self.bvh.facet[i], slot);
        };
        let first = hint.slot;
        if (first as usize) < self.bvh.corners.len() {
            measure(first, &mut best);
        }
        let mut stack = [(0u32, 0f32); STACK];
        let mut depth = usize::from(!self.nodes.is_empty());
        while depth > 0 {
            depth -= 1;
            let (child, gap) = stack[depth];
            if f64::from(gap) > best.limit {
                continue;
            }
            if child & LEAF_BIT != 0 {
                let leaf = &self.leaves[(child ^ LEAF_BIT) as usize];
                let gaps = leaf.planes.squared_gaps(p, self.slack);
                for (slot, gap) in (leaf.first..leaf.first + leaf.count).zip(gaps) {
                    if f64::from(gap) <= best.limit && slot != first {
                        measure(slot, &mut best);
                    }
                }
                continue;
            }
            if depth + WIDTH > STACK {
                // A hierarchy so lopsided is left to the search that needs less room.
                return self.bvh.closest(point, within_mm);
            }
            let node = &self.nodes[child as usize];
            let gaps = node.squared_gaps(p, self.slack);
            let bottom = depth;
            for (gap, child) in gaps.into_iter().zip(node.child) {
                if f64::from(gap) <= best.limit && gap < f32::INFINITY {
                    // The nearest last, so that it is taken first.
                    let mut at = depth;
                    while at > bottom && stack[at - 1].1 < gap {
                        stack[at] = stack[at - 1];
                        at -= 1;
                    }
                    stack[at] = (child, gap);
                    depth += 1;
                }
            }
        }
        if let Some(slot) = best.slot() {
            hint.slot = slot;
        }
        best.closest(self.bvh, point)
    }
}

impl WideNode {
    #[inline]
    fn squared_gaps(&self, p: [f32; 3], slack: f32) -> [f32; WIDTH] {
        std::array::from_fn(|j| {
            let side = |k: usize| shortened(larger(self.lo[k][j] - p[k], p[k] - self.hi[k][j]), slack);
            let [x, y, z] = [side(0), side(1), side(2)];
            x * x + y * y + z * z
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::topology::Mesh;
    use proptest::prelude::*;

    proptest! {
        /// Neither f32 nor a hint changes an answer, and the lowest of equal facets is told.
        #[test]
        fn answers_are_those_of_all_facets(numbers in prop::collection::vec(-8..8i32, 9..900),
                                           at in prop::collection::vec(prop::array::uniform3(-20..20i32), 1..70),
                                           size in 0.01..2.0f64, far in prop::sample::select(vec![0.0, 1e3, 1e6]),
                                           within in prop::option::of(0.1..3.0f64)) {
            let raw: Vec<[[f32; 3]; 3]> = numbers.chunks_exact(9)
                .map(|c| std::array::from_fn(|v| std::array::from_fn(|k| c[3 * v + k] as f32 + far as f32))).collect();
            let mesh = Mesh::weld(&raw, 1.0);
            let bvh = Bvh::new(&mesh);
            let search = ClosestSearch::new(&bvh);
            let within = within.unwrap_or(f64::INFINITY);
            let mut hint = ClosestHint::default();
            for p in at {
                // On a grid, so that many facets are equally near.
                let p = Point3::from(p.map(|c| far + f64::from(c) * 0.25 * size));
                let proper = |f: &usize| mesh.defects[*f] == crate::part::topology::FacetDefect::None;
                let all = (0..mesh.facets.len()).filter(proper);
                let all = all.map(|f| (squared_distance(&mesh.corners(f), &p), f as u32));
                let least = all.filter(|(d, _)| *d < within * within).min_by(|a, b| a.partial_cmp(b).expect("numbers"));
                let found = bvh.closest(&p, within);
                prop_assert_eq!(found.map(|c| c.facet), least.map(|l| l.1));
                prop_assert_eq!(search.closest(&p, within, &mut hint), found);
            }
        }
    }

    #[test]
    fn what_is_no_place_has_no_nearest_point() {
        let mesh = Mesh::weld(&[[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]], 1.0);
        let bvh = Bvh::new(&mesh);
        let search = ClosestSearch::new(&bvh);
        let at = |x: f64| search.closest(&Point3::new(x, 0.0, 0.0), f64::INFINITY, &mut ClosestHint::default());
        assert_eq!(at(f64::NAN), None);
        assert_eq!(at(f64::INFINITY), None);
        assert_eq!(at(1e20).map(|c| c.foot), Some(Point3::new(1.0, 0.0, 0.0)));
        let nothing = Bvh::default();
        assert_eq!(ClosestSearch::new(&nothing).closest(&Point3::origin(), 1.0, &mut ClosestHint::default()), None);
    }
}
