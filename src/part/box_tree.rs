//! Boxes, asked for those that hold another: halved along their longest side until few are left.

use super::bounds::bounds_of;
use nalgebra::Point3;

/// A box by its lowest and highest corner.
pub(super) type Bounds = (Point3<f64>, Point3<f64>);

/// Most boxes of a leaf.
const LEAF: usize = 4;

/// Numbered boxes in a tree.
#[derive(Debug, Default)]
pub(super) struct BoxTree {
    nodes: Vec<Node>,
    boxes: Vec<(Bounds, u32)>,
}

/// The box around some boxes, and which they are: of a leaf its own, else those of two children.
#[derive(Debug)]
struct Node {
    bounds: Bounds,
    from: usize,
    to: usize,
    /// The second child; the first one follows its parent. 0: a leaf.
    second: usize,
}

impl BoxTree {
    /// Over boxes with their numbers.
    pub fn new(boxes: Vec<(Bounds, u32)>) -> BoxTree {
        let mut tree = BoxTree { nodes: Vec::with_capacity(boxes.len()), boxes };
        if !tree.boxes.is_empty() {
            tree.split(0, tree.boxes.len());
        }
        tree
    }

    fn split(&mut self, from: usize, to: usize) {
        let boxes = &mut self.boxes[from..to];
        let bounds = bounds_of(boxes.iter().flat_map(|((lo, hi), _)| [*lo, *hi]));
        let me = self.nodes.len();
        self.nodes.push(Node { bounds, from, to, second: 0 });
        if boxes.len() <= LEAF {
            return;
        }
        let k = (bounds.1 - bounds.0).imax();
        let middle = boxes.len() / 2;
        let along = |((lo, hi), n): &(Bounds, u32)| (0.5 * lo[k] + 0.5 * hi[k], *n);
        boxes.select_nth_unstable_by(middle, |a, b| {
            let (a, b) = (along(a), along(b));
            a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))
        });
        self.split(from, from + middle);
        self.nodes[me].second = self.nodes.len();
        self.split(from + middle, to);
    }

    /// Numbers of the boxes that hold this one, ascending. `look` is told of each box that is looked at.
    pub fn around(&self, inner: &Bounds, mut look: impl FnMut()) -> Vec<u32> {
        let mut holds = |(lo, hi): &Bounds| {
            look();
            (0..3).all(|k| lo[k] <= inner.0[k] && inner.1[k] <= hi[k])
        };
        let mut found = Vec::new();
        let mut next: Vec<usize> = (0..self.nodes.len().min(1)).collect();
        while let Some(at) = next.pop() {
            let node = &self.nodes[at];
            if !holds(&node.bounds) {
                continue;
            }
            if node.second > 0 {
                next.extend([node.second, at + 1]);
            } else {
                found.extend(self.boxes[node.from..node.to].iter().filter(|(b, _)| holds(b)).map(|b| b.1));
            }
        }
        found.sort_unstable();
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cube_at([x, y, z]: [f64; 3], size: f64) -> Bounds {
        (Point3::new(x, y, z), Point3::new(x + size, y + size, z + size))
    }

    proptest! {
        #[test]
        fn those_that_hold_a_box_are_found(all in prop::collection::vec((prop::array::uniform3(0..9i32), 0..9i32), 0..60)) {
            let bounds = |(at, size): &([i32; 3], i32)| cube_at(at.map(f64::from), f64::from(*size));
            let tree = BoxTree::new(all.iter().map(bounds).zip(0..).collect());
            for inner in all.iter().map(bounds) {
                let holds = |(lo, hi): &Bounds| (0..3).all(|k| lo[k] <= inner.0[k] && inner.1[k] <= hi[k]);
                let expected: Vec<u32> =
                    all.iter().map(bounds).zip(0..).filter(|(b, _)| holds(b)).map(|(_, n)| n).collect();
                prop_assert_eq!(tree.around(&inner, || {}), expected);
            }
        }
    }

    /// Four times as many separate boxes cost each of them one halving or two more.
    #[test]
    fn separate_boxes_are_told_apart_at_a_glance() {
        let looks_at_each = |side: usize| {
            let place = |i: usize| [i % side, i / side % side, i / side / side].map(|k| 3.0 * k as f64);
            let boxes: Vec<Bounds> = (0..side.pow(3)).map(|i| cube_at(place(i), 2.0)).collect();
            let tree = BoxTree::new(boxes.iter().copied().zip(0..).collect());
            let mut looks = 0;
            for (i, b) in boxes.iter().enumerate() {
                assert_eq!(tree.around(b, || looks += 1), [i as u32]);
            }
            looks as f64 / boxes.len() as f64
        };
        let (few, many) = (looks_at_each(10), looks_at_each(16));
        assert!(many < 1.3 * few, "1000: {few} looks a box, 4096: {many}");
    }
}
