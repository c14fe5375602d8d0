//! The tree's nodes of about a given size: points that lie together, with the box around them.

use super::{LEAF, Neighbours, Node};
use nalgebra::{Point3, Vector3};

/// Points that lie together.
#[derive(Clone, Copy, Debug)]
pub struct Piece<'a> {
    /// Which ones of the cloud.
    pub indices: &'a [u32],
    /// Lowest corner of their box, in the cloud's frame; of points that are numbers.
    pub lo: Point3<f64>,
    /// Highest corner of their box.
    pub hi: Point3<f64>,
}

impl Neighbours {
    /// All points in pieces of `most` at the most, but no less than a leaf's 16. Each point is in one piece, and pieces
    /// are of numbers of points that differ by a few.
    pub fn pieces(&self, most: usize) -> impl ExactSizeIterator<Item = Piece<'_>> {
        let mut height = 0;
        while height < self.height && LEAF << (height + 1) <= most {
            height += 1;
        }
        let count = if self.is_empty() { 0 } else { 1usize << (self.height - height) };
        (0..count).map(move |at| {
            let down = |node: Node, level: u32| node.children()[at >> level & 1];
            let node = (0..self.height - height).rev().fold(self.root(), down);
            let bounds = self.boxes[node.at as usize];
            let corner = |c: [f32; 3]| self.origin + Vector3::from(c.map(f64::from));
            Piece { indices: &self.index[self.slots(node)], lo: corner(bounds.lo), hi: corner(bounds.hi) }
        })
    }
}
