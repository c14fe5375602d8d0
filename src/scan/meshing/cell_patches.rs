//! Which crossed edges of a cell are one patch of the surface, for all 256 ways in which its corners can lie inside or
//! outside.
//!
//! Each face joins its crossed edges in pairs: two are one pair, and of four those beside the same inner corner are.
//! That is the same seen from both cells of the face, so the surface has no gaps (dual marching cubes; Nielson 2004).

use crate::part::union_find::UnionFind;

/// Corners of a cell: bit k of the number is its place along axis k. Edges: the corner that they start from, and axis.
pub(super) const EDGES: [(usize, usize); 12] =
    [(0, 0), (2, 0), (4, 0), (6, 0), (0, 1), (1, 1), (4, 1), (5, 1), (0, 2), (1, 2), (2, 2), (3, 2)];

/// The patch of an edge that is not crossed.
pub(super) const NO_PATCH: u8 = u8::MAX;

/// Patches of a cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellPatches {
    /// Number of them.
    pub count: u8,
    /// Of each edge the patch that it belongs to.
    pub of_edge: [u8; 12],
}

/// The number of an edge of a cell.
pub(super) fn edge_number(corner: usize, axis: usize) -> usize {
    EDGES.iter().position(|e| *e == (corner & !(1 << axis), axis)).unwrap_or_default()
}

/// For each set of inner corners (bit k: corner k is inside) the patches.
pub(super) fn all_patches() -> Vec<CellPatches> {
    (0..256).map(patches_of).collect()
}

fn patches_of(inside: usize) -> CellPatches {
    let is_inside = |corner: usize| inside >> corner & 1 == 1;
    let is_crossed = |edge: usize| is_inside(EDGES[edge].0) != is_inside(EDGES[edge].0 | 1 << EDGES[edge].1);
    let mut sets = UnionFind::new(12);
    for axis in 0..3 {
        for side in 0..2 {
            for [a, b] in joined_on_face(axis, side, &is_inside) {
                sets.join(a as u32, b as u32);
            }
        }
    }
    let mut found = CellPatches { count: 0, of_edge: [NO_PATCH; 12] };
    for edge in (0..12).filter(|e| is_crossed(*e)) {
        let root = sets.root(edge as u32) as usize;
        if root == edge {
            found.of_edge[edge] = found.count;
            found.count += 1;
        } else {
            found.of_edge[edge] = found.of_edge[root];
        }
    }
    found
}

/// The pairs of crossed edges that a face joins.
pub(super) fn joined_on_face(axis: usize, side: usize, is_inside: &dyn Fn(usize) -> bool) -> Vec<[usize; 2]> {
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let corner = |k: usize| side << axis | (k & 1) << u | (k >> 1) << v;
    let is_crossed = |a: usize, b: usize| is_inside(a) != is_inside(b);
    // Of each corner the two edges of the face that meet there.
    let at = |k: usize| [edge_number(corner(k), u), edge_number(corner(k), v)];
    let corners: Vec<usize> = (0..4).collect();
    let inner: Vec<usize> = corners.iter().copied().filter(|k| is_inside(corner(*k))).collect();
    match inner.len() {
        1 => vec![at(inner[0])],
        2 if inner[0] + inner[1] == 3 => vec![at(inner[0]), at(inner[1])],
        3 => corners.into_iter().filter(|k| !inner.contains(k)).map(at).collect(),
        2 => {
            // The two edges that lead from the inner pair to the outer one.
            let along = if is_crossed(corner(0), corner(1)) { u } else { v };
            let (from, to) = if along == u { (corner(0), corner(2)) } else { (corner(0), corner(1)) };
            vec![[edge_number(from, along), edge_number(to, along)]]
        }
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every crossed edge lies on two faces of its cell, and each joins it to one other: patches are closed loops.
    #[test]
    fn every_crossed_edge_is_joined_twice() {
        for inside in 0..256usize {
            let is_inside = |corner: usize| inside >> corner & 1 == 1;
            let mut joins = [0; 12];
            for face in 0..6 {
                joined_on_face(face / 2, face % 2, &is_inside).iter().flatten().for_each(|e| joins[*e] += 1);
            }
            let patches = patches_of(inside);
            for (edge, (corner, axis)) in EDGES.into_iter().enumerate() {
                let is_crossed = is_inside(corner) != is_inside(corner | 1 << axis);
                assert_eq!(joins[edge], if is_crossed { 2 } else { 0 }, "{inside:08b}, edge {edge}");
                assert_eq!(patches.of_edge[edge] != NO_PATCH, is_crossed);
            }
        }
    }

    #[test]
    fn single_corners_apart_are_patches_apart() {
        assert_eq!(patches_of(0b0000_0001).count, 1);
        assert_eq!(patches_of(0b1000_0001).count, 2);
        // Two opposite corners of a face inside: not joined across it.
        assert_eq!(patches_of(0b0000_1001).count, 2);
        // All the four corners of even parity.
        assert_eq!(patches_of(0b0110_1001).count, 4);
        assert_eq!(patches_of(0).count + patches_of(255).count, 0);
    }
}
