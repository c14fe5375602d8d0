//! Disjoint sets, each represented by its lowest member, so that nothing depends on the order of joins.

/// Disjoint sets with path halving.
#[derive(Clone, Debug)]
pub struct UnionFind(Vec<u32>);

impl UnionFind {
    /// `count` sets of one member.
    pub fn new(count: usize) -> UnionFind {
        UnionFind((0..count as u32).collect())
    }

    /// The representative of a member's set: its lowest member.
    pub fn root(&mut self, mut i: u32) -> u32 {
        while self.0[i as usize] != i {
            let up = self.0[self.0[i as usize] as usize];
            self.0[i as usize] = up;
            i = up;
        }
        i
    }

    /// Joins two sets; the lowest member stays the representative.
    pub fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}
