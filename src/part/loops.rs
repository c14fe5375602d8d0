//! Edges chained to loops: the rims of pieces of a mesh.

use std::collections::BTreeSet;

/// Chains edges, each from its first vertex to its second, to loops, each from its lowest vertex on. At every vertex as
/// many edges end as begin, or what does not lead back is a loop that is open. A vertex where two rims touch may be the
/// end of one loop in both.
pub fn loops(mut edges: BTreeSet<(u32, u32)>) -> Vec<Vec<u32>> {
    let mut all = Vec::new();
    while let Some(&(first, _)) = edges.first() {
        let (mut round, mut here) = (Vec::new(), first);
        while let Some(edge) = edges.range((here, 0)..=(here, u32::MAX)).next().copied() {
            edges.remove(&edge);
            round.push(here);
            here = edge.1;
            if here == first {
                break;
            }
        }
        all.push(round);
    }
    all
}
