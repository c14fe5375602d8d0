//! Neighbours of all points of the cloud itself, leaf by leaf: the points of a leaf share one walk through the tree.
//!
//! For each leaf the candidates are gathered once: all leaves whose box is no further from the leaf's own than the
//! widest limit of its points. For `k` neighbours a point's limit is the k-th distance among the points of the lowest
//! ancestor that has enough.

use super::{Neighbour, Neighbours, Node, squared_limit, squared_norm};
use crate::progress::{Cancelled, Progress};
use rayon::prelude::*;

/// Levels of the tree that are one piece of work.
const PIECE_HEIGHT: u32 = 6;

/// Limits of a leaf's points come from an ancestor of at least so many times k points: 1 gives limits that are too
/// wide, 4 costs more than it saves.
const POINTS_PER_NEIGHBOUR: usize = 2;

impl Neighbours {
    /// What `of` makes of each point and its `k` nearest others (fewer where the cloud has fewer), in the cloud's order.
    /// The neighbours come in the same order each time, but not by distance; ties at the k-th go to the lower index.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn map_nearest<T: Clone + Default + Send + Sync>(
        &self,
        k: usize,
        progress: &Progress,
        of: impl Fn(u32, &[Neighbour]) -> T + Sync,
    ) -> Result<Vec<T>, Cancelled> {
        self.map_leaves(progress, |leaf, work| self.limits_of_nearest(leaf, k, work), k, of)
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
        let limits = |leaf: Node, work: &mut Work| {
            work.limits.clear();
            work.limits.resize(self.slots(leaf).len(), limit);
        };
        self.map_leaves(progress, limits, usize::MAX, of)
    }

    fn map_leaves<T: Clone + Default + Send + Sync>(
        &self,
        progress: &Progress,
        limits: impl Fn(Node, &mut Work) + Sync,
        k: usize,
        of: impl Fn(u32, &[Neighbour]) -> T + Sync,
    ) -> Result<Vec<T>, Cancelled> {
        let leaves = if self.is_empty() { 0 } else { 1u32 << self.height };
        let piece = 1u32 << PIECE_HEIGHT.min(self.height);
        let pieces: Vec<Vec<T>> = (0..leaves / piece)
            .into_par_iter()
            .map_init(Work::default, |work, at| {
                let mut made = Vec::new();
                for leaf in at * piece..(at + 1) * piece {
                    progress.check()?;
                    let path = self.path_to(leaf);
                    let Some(&node) = path.last() else { continue };
                    limits(node, work);
                    self.gather(node, work);
                    for (slot, i) in self.slots(node).zip(0..) {
                        self.choose(slot, work.limits[i], k, work);
                        made.push(of(self.index[slot], &work.chosen));
                    }
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

    /// The nodes from the root to a leaf.
    fn path_to(&self, leaf: u32) -> Vec<Node> {
        let mut path = vec![self.root()];
        for level in (0..self.height).rev() {
            let next = path[path.len() - 1].children()[(leaf >> level & 1) as usize];
            path.push(next);
        }
        path
    }

    /// For each point of a leaf a squared distance within which it has `k` others, or infinity.
    fn limits_of_nearest(&self, leaf: Node, k: usize, work: &mut Work) {
        work.limits.clear();
        let path = self.path_to(leaf.leaf);
        let enough = |n: &&Node| self.slots(**n).len() > POINTS_PER_NEIGHBOUR * k;
        let around = self.slots(*path.iter().rev().find(enough).unwrap_or(&path[0]));
        for slot in self.slots(leaf) {
            let from = self.place(slot);
            let distances = around.clone().filter(|&other| other != slot).map(|other| {
                let to = self.place(other);
                squared_norm(std::array::from_fn(|k| to[k] - from[k])).to_bits()
            });
            work.distances.clear();
            work.distances.extend(distances);
            // What is no number stands behind all numbers: a limit of none is none.
            let last = if k == 0 || work.distances.len() < k {
                f32::INFINITY
            } else {
                f32::from_bits(*work.distances.select_nth_unstable(k - 1).1)
            };
            let is_place = from.iter().all(|c| c.is_finite());
            work.limits.push(if !is_place {
                -1.0
            } else if last.is_nan() {
                f32::INFINITY
            } else {
                last
            });
        }
    }

    fn place(&self, slot: usize) -> [f32; 3] {
        self.places.each_ref().map(|along| along[slot])
    }

    /// The slots of all leaves that may hold points within the limits of this leaf's points.
    fn gather(&self, leaf: Node, work: &mut Work) {
        let reach = work.limits.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        let own = self.boxes[leaf.at as usize];
        work.candidates.clear();
        let mut stack = vec![self.root()];
        while let Some(node) = stack.pop() {
            if self.boxes[node.at as usize].squared_gap(&own.lo, &own.hi) > reach {
                continue;
            }
            if node.height == 0 {
                work.candidates.extend(self.slots(node).map(|s| s as u32));
            } else {
                let [a, b] = node.children();
                stack.extend([b, a]);
            }
        }
    }

    /// The neighbours of one point among the candidates.
    fn choose(&self, slot: usize, limit: f32, k: usize, work: &mut Work) {
        let from = self.place(slot);
        work.keys.clear();
        for &other in &work.candidates {
            let to = self.place(other as usize);
            let squared = squared_norm(std::array::from_fn(|k| to[k] - from[k]));
            if squared <= limit && other as usize != slot {
                work.keys.push(u64::from(squared.to_bits()) << 32 | u64::from(self.index[other as usize]));
            }
        }
        if k < work.keys.len() {
            work.keys.select_nth_unstable(k);
            work.keys.truncate(k);
        }
        work.chosen.clear();
        let neighbour = |key: &u64| Neighbour { index: *key as u32, squared: f32::from_bits((key >> 32) as u32) };
        work.chosen.extend(work.keys.iter().map(neighbour));
    }
}

/// Room that one thread uses again and again.
#[derive(Default)]
struct Work {
    limits: Vec<f32>,
    distances: Vec<u32>,
    candidates: Vec<u32>,
    keys: Vec<u64>,
    chosen: Vec<Neighbour>,
}
