//! Builds the hierarchy: nodes are split by the surface area heuristic over 16 bins.

use super::aabb::Aabb;
use crate::progress::Progress;

/// Most facets of a leaf.
pub(super) const LEAF: usize = 4;
/// Bins of the surface area heuristic.
const BINS: usize = 16;

/// Subtrees of more facets than this are built in parallel.
const SIDE_BY_SIDE: usize = 1 << 13;

/// From this level on nodes are halved by number: the heuristic alone may split off facet by facet, and queries have room
/// for 95 levels; 2³² facets have 32.
const HALVED_FROM: usize = 60;

/// A node of the hierarchy.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) bounds: Aabb,
    /// First facet of a leaf, or index of the first child (the second follows it).
    pub(super) at: u32,
    /// Facets of a leaf; 0 for an inner node.
    pub(super) count: u32,
}

/// A facet with its box, while the tree is built.
#[derive(Clone, Copy)]
pub(super) struct FacetBox {
    pub(super) bounds: Aabb,
    pub(super) facet: u32,
}

/// The nodes over `items`, which are put in the order of the leaves; the root is the first.
/// `offset`: how many items stand before these, `level`: how many nodes above. Once cancelled it ends soon, and the tree
/// is none.
pub(super) fn build_tree(items: &mut [FacetBox], (offset, level): (u32, usize), progress: &Progress) -> Vec<Node> {
    let mut nodes = Vec::with_capacity(items.len() / 2 + 1);
    nodes.push(Node { bounds: Aabb::NONE, at: 0, count: 0 });
    build(items, offset, &mut nodes, (0, level), progress);
    nodes
}

fn build(items: &mut [FacetBox], offset: u32, nodes: &mut Vec<Node>, (me, level): (usize, usize), progress: &Progress) {
    let bounds = items.iter().fold(Aabb::NONE, |b, i| b.with(&i.bounds));
    let side_by_side = items.len() > SIDE_BY_SIDE;
    if items.len() <= LEAF || side_by_side && !progress.goes_on() {
        nodes[me] = Node { bounds, at: offset, count: items.len() as u32 };
        return;
    }
    let children = nodes.len();
    nodes[me] = Node { bounds, at: children as u32, count: 0 };
    nodes.extend([nodes[me]; 2]);
    let middle = if level < HALVED_FROM { split(items) } else { items.len() / 2 };
    let (left, right) = items.split_at_mut(middle);
    let (behind, below) = (offset + middle as u32, level + 1);
    if side_by_side {
        let pair = rayon::join(
            || build_tree(left, (offset, below), progress),
            || build_tree(right, (behind, below), progress),
        );
        graft(nodes, children, &pair.0);
        graft(nodes, children + 1, &pair.1);
    } else {
        build(left, offset, nodes, (children, below), progress);
        build(right, behind, nodes, (children + 1, below), progress);
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
