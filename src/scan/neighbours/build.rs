//! Builds the k-d tree: halves the points along the longest side of their box until few are left.
//!
//! Its shape follows from the number of points alone and ties are cut by index, so it is the same on any number of
//! threads.

use super::{Bounds, LEAF, Neighbours, Node};
use crate::progress::{Cancelled, Progress};
use crate::scan::cloud::Cloud;

/// Points from which on the two halves are worth a task each.
const WORTH_A_TASK: usize = 8192;

#[derive(Clone, Copy)]
struct Entry {
    place: [f32; 3],
    index: u32,
}

pub(super) fn tree(cloud: &Cloud, progress: &Progress) -> Result<Neighbours, Cancelled> {
    let count = cloud.len();
    let mut height = 0;
    while count > LEAF << height {
        height += 1;
    }
    let mut entries: Vec<Entry> = cloud.offsets.iter().zip(0..).map(|(&place, index)| Entry { place, index }).collect();
    let mut boxes = vec![Bounds::NONE; (2 << height) - 1];
    let mut found = Neighbours { origin: cloud.origin, height, ..Neighbours::default() };
    halve(&Halving { count, height, progress }, found.root(), &mut entries, &mut boxes)?;
    found.boxes = boxes;
    found.places = [0, 1, 2].map(|k| entries.iter().map(|e| e.place[k]).collect());
    found.index = entries.iter().map(|e| e.index).collect();
    Ok(found)
}

/// What is the same for all nodes.
struct Halving<'a> {
    count: usize,
    height: u32,
    progress: &'a Progress,
}

impl Halving<'_> {
    fn start(&self, leaf: u32) -> usize {
        ((self.count as u64 * u64::from(leaf)) >> self.height) as usize
    }
}

fn halve(of: &Halving, node: Node, entries: &mut [Entry], boxes: &mut [Bounds]) -> Result<(), Cancelled> {
    let bounds = entries.iter().fold(Bounds::NONE, |b, e| b.with(&e.place));
    let Some((own, below)) = boxes.split_first_mut() else { return Ok(()) };
    *own = bounds;
    if node.height == 0 {
        entries.sort_unstable_by_key(|e| e.index);
        return Ok(());
    }
    let sides: [f32; 3] = std::array::from_fn(|k| bounds.hi[k] - bounds.lo[k]);
    let k = (1..3).fold(0, |best, k| if sides[k] > sides[best] { k } else { best });
    let [first, second] = node.children();
    let middle = of.start(second.leaf) - of.start(node.leaf);
    entries.select_nth_unstable_by(middle, |a, b| a.place[k].total_cmp(&b.place[k]).then(a.index.cmp(&b.index)));
    let (low, high) = entries.split_at_mut(middle);
    let (boxes_low, boxes_high) = below.split_at_mut(below.len() / 2);
    if low.len() < WORTH_A_TASK {
        halve(of, first, low, boxes_low)?;
        return halve(of, second, high, boxes_high);
    }
    of.progress.check()?;
    let (one, other) = rayon::join(|| halve(of, first, low, boxes_low), || halve(of, second, high, boxes_high));
    one.and(other)
}
