//! Neighbours of all points of the cloud itself, leaf by leaf: the points of a leaf share one walk through the tree.
//!
//! The walk gathers all points within a reach of the leaf's box. For the `k` nearest ones the reach is a guess from the
//! leaf before; a point that finds fewer than `k` within it (a lonely one, or where the cloud thins out) walks alone.
//! So the guess decides on the time that is taken, never on what is found.

use super::{Neighbour, Neighbours, Node, key, neighbour, squared_limit, squared_norm};
use crate::progress::{Cancelled, Progress};
use rayon::prelude::*;

/// Leaves that are one piece of work, as a power of two: a guess is carried from leaf to leaf within it.
const PIECE_HEIGHT: u32 = 6;

/// The reach of a leaf, from the middle one of the squared distances to the k-th neighbour in the leaf before. With
/// 1.25 more points walk alone: a third slower; 1.5 lies between.
const REACH_OF_MIDDLE: f32 = 2.0;

/// Candidates from which on the points of a leaf walk alone: its box is so large because one of them is lonely.
fn too_many(k: usize) -> usize {
    512usize.saturating_add(k.saturating_mul(16))
}

impl Neighbours {
    /// What `of` makes of each point and its `k` nearest others (fewer where the cloud has fewer), in the cloud's
    /// order. The neighbours come in the same order each time, but not by distance; ties at the k-th go to the lower
    /// index.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn map_nearest<T: Clone + Default + Send + Sync>(
        &self,
        k: usize,
        progress: &Progress,
        of: impl Fn(u32, &[Neighbour]) -> T + Sync,
    ) -> Result<Vec<T>, Cancelled> {
        self.map_leaves(progress, |leaf, work, made| {
            self.gather(leaf, work.guess, work);
            let shared = work.slots.len() <= too_many(k);
            work.last.clear();
            for slot in self.slots(leaf) {
                if !(shared && self.choose_nearest(slot, k, work)) {
                    progress.check()?;
                    self.nearest_others(slot, k, &mut work.chosen);
                }
                let last = work.chosen.iter().map(|n| n.squared.to_bits()).max();
                work.last.push(last.unwrap_or_default());
                made.push(of(self.index[slot], &work.chosen));
            }
            let middle = work.last.len() / 2;
            work.guess = REACH_OF_MIDDLE * f32::from_bits(*work.last.select_nth_unstable(middle).1);
            Ok(())
        })
    }

    /// What `of` makes of each point and all others not further than `radius_mm`, in the cloud's order. The neighbours
    /// come in the same order each time, but not by distance.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn map_within<T: Clone + Default + Send + Sync>(
        &self,
        radius_mm: f64,
        progress: &Progress,
        of: impl Fn(u32, &[Neighbour]) -> T + Sync,
    ) -> Result<Vec<T>, Cancelled> {
        let limit = squared_limit(radius_mm).unwrap_or(-1.0);
        self.map_leaves(progress, |leaf, work, made| {
            self.gather(leaf, limit, work);
            for slot in self.slots(leaf) {
                self.keep_within(slot, limit, work);
                work.choose();
                made.push(of(self.index[slot], &work.chosen));
            }
            Ok(())
        })
    }

    /// What is made of each point, leaf by leaf, brought into the cloud's order.
    fn map_leaves<T: Clone + Default + Send + Sync>(
        &self,
        progress: &Progress,
        make: impl Fn(Node, &mut Work, &mut Vec<T>) -> Result<(), Cancelled> + Sync,
    ) -> Result<Vec<T>, Cancelled> {
        let leaves = if self.is_empty() { 0 } else { 1u32 << self.height };
        let piece = 1u32 << PIECE_HEIGHT.min(self.height);
        let pieces: Vec<Vec<T>> = (0..leaves / piece)
            .into_par_iter()
            .map_init(Work::default, |work, at| {
                work.guess = 0.0;
                let mut made = Vec::new();
                for leaf in at * piece..(at + 1) * piece {
                    progress.check()?;
                    make(self.leaf(leaf), work, &mut made)?;
                }
                Ok(made)
            })
            .collect::<Result<_, Cancelled>>()?;
        let mut in_order = vec![T::default(); self.len()];
        for (made, &index) in pieces.into_iter().flatten().zip(&self.index) {
            in_order[index as usize] = made;
        }
        Ok(in_order)
    }

    fn leaf(&self, leaf: u32) -> Node {
        (0..self.height).rev().fold(self.root(), |node, level| node.children()[(leaf >> level & 1) as usize])
    }

    fn place(&self, slot: usize) -> [f32; 3] {
        self.places.each_ref().map(|along| along[slot])
    }

    /// Gathers the points of all leaves whose box is no further from this leaf's than the root of `reach`.
    fn gather(&self, leaf: Node, reach: f32, work: &mut Work) {
        let own = self.boxes[leaf.at as usize];
        work.near.iter_mut().for_each(Vec::clear);
        work.slots.clear();
        work.stack.clear();
        work.stack.push(self.root());
        while let Some(node) = work.stack.pop() {
            if self.boxes[node.at as usize].squared_gap(&own.lo, &own.hi) > reach {
                continue;
            }
            if node.height == 0 {
                let slots = self.slots(node);
                for (near, along) in work.near.iter_mut().zip(&self.places) {
                    near.extend_from_slice(&along[slots.clone()]);
                }
                work.slots.extend(slots.start as u32..slots.end as u32);
            } else {
                let [a, b] = node.children();
                work.stack.extend([b, a]);
            }
        }
    }

    /// Of the gathered points those within the limit, without the point itself, become keys: distance, then index.
    fn keep_within(&self, slot: usize, limit: f32, work: &mut Work) {
        let from = self.place(slot);
        let [x, y, z] = &work.near;
        work.squared.clear();
        work.squared
            .extend(x.iter().zip(y).zip(z).map(|((x, y), z)| squared_norm([x - from[0], y - from[1], z - from[2]])));
        // Each key is written, and kept or written over: a branch here would be guessed wrong half of the time.
        work.keys.clear();
        work.keys.resize(work.squared.len() + 1, 0);
        let mut count = 0;
        for (&squared, &other) in work.squared.iter().zip(&work.slots) {
            work.keys[count] = key(squared, other);
            count += usize::from(squared <= limit && other as usize != slot);
        }
        work.keys.truncate(count);
        for k in &mut work.keys {
            *k = key(neighbour(*k).squared, self.index[neighbour(*k).index as usize]);
        }
    }

    /// The nearest ones among the gathered points; whether there are enough within the guess.
    fn choose_nearest(&self, slot: usize, k: usize, work: &mut Work) -> bool {
        self.keep_within(slot, work.guess, work);
        if work.keys.len() < k {
            return false;
        }
        if k < work.keys.len() {
            work.keys.select_nth_unstable(k);
            work.keys.truncate(k);
        }
        work.choose();
        true
    }

    /// The nearest ones by a walk of its own.
    fn nearest_others(&self, slot: usize, k: usize, out: &mut Vec<Neighbour>) {
        // The point itself need not be the first: others may stand in the same place. One too many is asked for.
        self.nearest_from(&self.place(slot), k.saturating_add(1), out);
        let own = self.index[slot];
        out.retain(|n| n.index != own);
        out.truncate(k);
    }
}

/// Room that one thread uses again and again.
#[derive(Default)]
struct Work {
    /// Squared reach.
    guess: f32,
    /// Squared distances to the last neighbour of each point of the leaf, as bits, which are ordered alike.
    last: Vec<u32>,
    stack: Vec<Node>,
    /// Places of the gathered points, coordinate by coordinate.
    near: [Vec<f32>; 3],
    slots: Vec<u32>,
    squared: Vec<f32>,
    keys: Vec<u64>,
    chosen: Vec<Neighbour>,
}

impl Work {
    fn choose(&mut self) {
        self.chosen.clear();
        self.chosen.extend(self.keys.iter().copied().map(neighbour));
    }
}
