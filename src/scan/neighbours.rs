//! Nearest points of a cloud: a static k-d tree over its f32 offsets, the points put in the order of its leaves.
//!
//! Distances are computed in f32, as the places are kept; with that arithmetic every answer is exact and the same each
//! time: of points at the same distance the lower index comes first. Points that are no numbers are never found.
//! An own tree: searched leaf by leaf ([`Neighbours::map_nearest`]) it finds the neighbours of all points of a cloud
//! several times as fast as one by one, which a general tree of a library does not offer.

mod build;
mod of_all;
mod pieces;

pub use pieces::Piece;

use super::cloud::Cloud;
use crate::progress::{Cancelled, Progress};
use nalgebra::Point3;

/// Most points of a leaf: with 32 all takes a sixth longer, with 8 the tree grows and little is won.
const LEAF: usize = 16;

/// A point that was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Neighbour {
    /// Which one of the cloud.
    pub index: u32,
    /// Its squared distance, mm².
    pub squared: f32,
}

/// The points of a cloud, to be asked for the nearest ones. 16 bytes a point and 2 to 3 more for the tree.
#[derive(Clone, Debug, Default)]
pub struct Neighbours {
    origin: Point3<f64>,
    /// Places from the origin, coordinate by coordinate, leaf by leaf.
    places: [Vec<f32>; 3],
    /// Which point of the cloud stands in each slot; ascending within a leaf.
    index: Vec<u32>,
    /// The tree has `1 << height` leaves, of numbers of points that differ by 1 at most.
    height: u32,
    /// Boxes of the nodes. A node is followed by its first child; see [`Node::children`].
    boxes: Vec<Bounds>,
}

/// A box by its lowest and highest corner, from the origin.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    lo: [f32; 3],
    hi: [f32; 3],
}

/// A node: where its box stands, its first leaf, and how many levels there are below it.
#[derive(Clone, Copy, Debug, Default)]
struct Node {
    at: u32,
    leaf: u32,
    height: u32,
}

impl Node {
    fn children(self) -> [Node; 2] {
        let (half, height) = (1 << (self.height - 1), self.height - 1);
        [Node { at: self.at + 1, height, ..self }, Node { at: self.at + 2 * half, leaf: self.leaf + half, height }]
    }
}

impl Neighbours {
    /// Orders the points of a cloud.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn new(cloud: &Cloud, progress: &Progress) -> Result<Neighbours, Cancelled> {
        build::tree(cloud, progress)
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.index.len()
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.index.is_empty()
    }

    /// The `k` nearest points to a place in the cloud's frame, by distance, then index; fewer where the cloud has
    /// fewer. A point of the cloud is its own nearest one.
    pub fn nearest(&self, point: &Point3<f64>, k: usize, out: &mut Vec<Neighbour>) {
        self.nearest_from(&self.offset(point), k, out);
    }

    fn nearest_from(&self, from: &[f32; 3], k: usize, out: &mut Vec<Neighbour>) {
        out.clear();
        if k == 0 {
            return;
        }
        // The nearest ones so far and some more: thrown out together, which costs less than one by one.
        let most = k.saturating_add((k / 2).max(LEAF));
        let mut found: Vec<u64> = Vec::with_capacity(most.min(self.len()));
        let mut limit = f32::INFINITY;
        self.search(from, limit, |squared, index| {
            found.push(key(squared, index));
            if found.len() == most || found.len() == k {
                let (_, &mut last, _) = found.select_nth_unstable(k - 1);
                limit = neighbour(last).squared;
                found.truncate(k);
            }
            limit
        });
        if k < found.len() {
            found.select_nth_unstable(k - 1);
            found.truncate(k);
        }
        found.sort_unstable();
        out.extend(found.into_iter().map(neighbour));
    }

    /// The nearest point not further than `within_mm`; of several the one with the lowest index.
    pub fn nearest_one(&self, point: &Point3<f64>, within_mm: f64) -> Option<Neighbour> {
        let mut best: Option<Neighbour> = None;
        let limit = squared_limit(within_mm)?;
        self.search(&self.offset(point), limit, |squared, index| {
            if best.is_none_or(|b| squared < b.squared || index < b.index) {
                best = Some(Neighbour { index, squared });
            }
            squared
        });
        best
    }

    /// All points not further than `radius_mm`: in the same order each time, but not by distance.
    pub fn within(&self, point: &Point3<f64>, radius_mm: f64, out: &mut Vec<Neighbour>) {
        out.clear();
        let Some(limit) = squared_limit(radius_mm) else { return };
        self.search(&self.offset(point), limit, |squared, index| {
            out.push(Neighbour { index, squared });
            limit
        });
    }

    fn offset(&self, point: &Point3<f64>) -> [f32; 3] {
        let d = point - self.origin;
        [d.x as f32, d.y as f32, d.z as f32]
    }

    fn root(&self) -> Node {
        Node { at: 0, leaf: 0, height: self.height }
    }

    /// The slots of a node's points.
    fn slots(&self, node: Node) -> std::ops::Range<usize> {
        let start = |leaf: u32| ((self.len() as u64 * u64::from(leaf)) >> self.height) as usize;
        start(node.leaf)..start(node.leaf + (1 << node.height))
    }

    /// Tells `take` of the points not further than the limit, which it answers anew each time, never a greater one.
    fn search(&self, from: &[f32; 3], mut limit: f32, mut take: impl FnMut(f32, u32) -> f32) {
        if self.is_empty() {
            return;
        }
        let mut stack = [(self.root(), 0.0f32); 34];
        let mut depth = 1;
        while depth > 0 {
            depth -= 1;
            let (node, gap) = stack[depth];
            if gap > limit {
                continue;
            }
            if node.height == 0 {
                let slots = self.slots(node);
                let squared = self.squared_distances(from, slots.clone());
                for (&squared, &index) in squared.iter().zip(&self.index[slots]) {
                    if squared <= limit {
                        limit = take(squared, index);
                    }
                }
                continue;
            }
            let [a, b] = node.children().map(|child| (child, self.boxes[child.at as usize].squared_gap(from, from)));
            // The nearer one last, so that it is taken first.
            let (far, near) = if a.1 <= b.1 { (b, a) } else { (a, b) };
            for next in [far, near] {
                if next.1 <= limit {
                    stack[depth] = next;
                    depth += 1;
                }
            }
        }
    }

    /// Squared distances to the points of a leaf.
    fn squared_distances(&self, from: &[f32; 3], leaf: std::ops::Range<usize>) -> [f32; LEAF] {
        let mut squared = [f32::INFINITY; LEAF];
        let [x, y, z] = self.places.each_ref().map(|along| &along[leaf.clone()]);
        for (s, ((x, y), z)) in squared.iter_mut().zip(x.iter().zip(y).zip(z)) {
            *s = squared_norm([x - from[0], y - from[1], z - from[2]]);
        }
        squared
    }
}

impl Bounds {
    const NONE: Bounds = Bounds { lo: [f32::INFINITY; 3], hi: [f32::NEG_INFINITY; 3] };

    fn with(&self, place: &[f32; 3]) -> Bounds {
        Bounds {
            lo: std::array::from_fn(|k| self.lo[k].min(place[k])),
            hi: std::array::from_fn(|k| self.hi[k].max(place[k])),
        }
    }

    /// Squared distance to another box: never greater than that of two of their points, rounding included, for it is
    /// computed in the same way from numbers that are not greater.
    fn squared_gap(&self, lo: &[f32; 3], hi: &[f32; 3]) -> f32 {
        let side = |k: usize| (self.lo[k] - hi[k]).max(lo[k] - self.hi[k]).max(0.0);
        squared_norm([side(0), side(1), side(2)])
    }
}

/// Orders by distance, then index: bits of floats that are not below 0 are ordered as they are.
fn key(squared: f32, index: u32) -> u64 {
    u64::from(squared.to_bits()) << 32 | u64::from(index)
}

fn neighbour(key: u64) -> Neighbour {
    Neighbour { index: key as u32, squared: f32::from_bits((key >> 32) as u32) }
}

fn squared_norm([x, y, z]: [f32; 3]) -> f32 {
    x * x + y * y + z * z
}

/// The square of a radius; `None` where it is below 0 or no number.
fn squared_limit(radius_mm: f64) -> Option<f32> {
    (radius_mm >= 0.0).then_some((radius_mm * radius_mm) as f32)
}

#[cfg(test)]
mod tests;
