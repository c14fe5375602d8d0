//! From crossed cells to a surface: a vertex for each patch of a cell, and around each crossed edge a face of the four
//! patches there (dual marching cubes). Where each vertex comes to stand is settled later.
//!
//! Two neighbouring patches can meet twice, across a face whose four edges are all crossed. Four faces would share
//! that edge; so each meeting has a vertex of its own between them, and no edge has more than two facets.

use super::cell_patches::{CellPatches, EDGES, all_patches, edge_number, joined_on_face};
use super::lattice::{CrossedCell, Lattice, STEP};
use super::surfels::Room;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Pieces of work.
const PIECE: usize = 1024;

/// Faces over vertices, counter-clockwise seen from outside.
#[derive(Default)]
pub(super) struct Faces {
    pub vertices: Vec<Point3<f64>>,
    pub quads: Vec<[u32; 4]>,
    pub triangles: Vec<[u32; 3]>,
}

/// Makes the faces. `land` brings a patch's middle onto the surface; what it does not land has none, so that rims stay
/// where points end.
pub(super) fn faces(
    lattice: &Lattice,
    land: impl Fn(&Point3<f64>, &mut Room) -> Option<Point3<f64>> + Sync,
    progress: &Progress,
) -> Result<Faces, Cancelled> {
    let patches = all_patches();
    let pieces: Vec<Vec<Option<Point3<f64>>>> = lattice
        .cells
        .par_chunks(PIECE)
        .map_init(Room::default, |room, piece| {
            progress.check()?;
            let middles = piece.iter().flat_map(|cell| middles(lattice, cell, &patches[usize::from(cell.inside)]));
            Ok(middles.map(|p| p.and_then(|p| land(&p, room))).collect())
        })
        .collect::<Result<_, Cancelled>>()?;
    let placed = pieces.concat();
    let mut first = Vec::with_capacity(lattice.cells.len());
    let mut next = 0;
    for cell in &lattice.cells {
        first.push(next);
        next += u32::from(patches[usize::from(cell.inside)].count);
    }
    let vertices = placed.iter().map(|p| p.unwrap_or_default()).collect();
    let faces = Faces { vertices, ..Faces::default() };
    let mut dual = Dual { lattice, patches, first, placed, between: BTreeMap::new(), faces };
    for at in 0..lattice.cells.len() {
        progress.check_at(at)?;
        for axis in 0..3 {
            dual.face(at, axis);
        }
    }
    Ok(dual.faces)
}

/// The middle of the crossed edges of each patch of a cell; `None` for what is no surface.
fn middles(lattice: &Lattice, cell: &CrossedCell, patches: &CellPatches) -> Vec<Option<Point3<f64>>> {
    let middle = |patch: u8| {
        let (mut sum, mut edges) = (Vector3::zeros(), 0.0);
        for (edge, (corner, axis)) in EDGES.into_iter().enumerate() {
            if patches.of_edge[edge] == patch {
                sum += cell.crossing(corner, axis)?;
                edges += 1.0;
            }
        }
        Some(lattice.place(cell.key, &(sum / edges)))
    };
    (0..patches.count).map(middle).collect()
}

struct Dual<'a> {
    lattice: &'a Lattice,
    patches: Vec<CellPatches>,
    /// The first patch of each cell.
    first: Vec<u32>,
    placed: Vec<Option<Point3<f64>>>,
    /// Vertices between patches that meet twice, by the face's upper cell, its axis, and which meeting it is.
    between: BTreeMap<(usize, usize, usize), u32>,
    faces: Faces,
}

impl Dual<'_> {
    /// The face around the edge from a cell's lowest corner along an axis, where the surface crosses it.
    fn face(&mut self, at: usize, axis: usize) {
        let cell = self.lattice.cells[at];
        let (here, there) = (cell.inside & 1 == 1, cell.inside >> (1 << axis) & 1 == 1);
        if here == there {
            return;
        }
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        // The cells around the edge, counter-clockwise seen along it from its end, with the edge's corner in each.
        let around = [(0, 0), (STEP[u], 1 << u), (STEP[u] + STEP[v], 1 << u | 1 << v), (STEP[v], 1 << v)];
        let mut cells = [(0, 0); 4];
        for (slot, (back, corner)) in cells.iter_mut().zip(around) {
            let Some(found) = self.lattice.find(cell.key.wrapping_sub(back)) else { return };
            *slot = (found, edge_number(corner, axis));
        }
        let corners = cells.map(|(found, edge)| self.vertex(found, edge));
        if corners.iter().any(|c| self.placed[*c as usize].is_none()) {
            return;
        }
        // Which of two neighbours in the ring is the upper one, and across which axis they meet.
        let meetings = [(0, 1, u), (3, 2, u), (0, 3, v), (1, 2, v)];
        let mut ring = Vec::with_capacity(8);
        for (k, corner) in corners.into_iter().enumerate() {
            ring.push(corner);
            let next = (k + 1) % 4;
            let met = meetings.iter().find(|m| (m.0, m.1) == (k, next) || (m.0, m.1) == (next, k));
            ring.extend(met.and_then(|&(upper, lower, across)| self.meeting(cells[upper], cells[lower], across)));
        }
        if !here {
            ring.reverse();
        }
        self.close(&ring);
    }

    fn vertex(&self, cell: usize, edge: usize) -> u32 {
        let patch = self.patches[usize::from(self.lattice.cells[cell].inside)].of_edge[edge];
        self.first[cell] + u32::from(patch)
    }

    /// The vertex between two patches that meet twice.
    fn meeting(&mut self, upper: (usize, usize), lower: (usize, usize), across: usize) -> Option<u32> {
        let inside = self.lattice.cells[upper.0].inside;
        let joined = joined_on_face(across, 0, &|corner| inside >> corner & 1 == 1);
        let [one, other] = joined[..] else { return None };
        let on_lower = |edge: usize| edge_number(EDGES[edge].0 | 1 << across, EDGES[edge].1);
        let twice = self.vertex(upper.0, one[0]) == self.vertex(upper.0, other[0])
            && self.vertex(lower.0, on_lower(one[0])) == self.vertex(lower.0, on_lower(other[0]));
        if !twice {
            return None;
        }
        let which = usize::from(other.contains(&upper.1));
        if let Some(known) = self.between.get(&(upper.0, across, which)) {
            return Some(*known);
        }
        let cell = &self.lattice.cells[upper.0];
        let [a, b] = [one, other][which].map(|edge| cell.crossing(EDGES[edge].0, EDGES[edge].1));
        let place = self.lattice.place(cell.key, &((a? + b?) * 0.5));
        let made = self.faces.vertices.len() as u32;
        self.faces.vertices.push(place);
        self.between.insert((upper.0, across, which), made);
        Some(made)
    }

    /// A ring of four is a quad; a larger one is cut into a fan from its first vertex between patches.
    fn close(&mut self, ring: &[u32]) {
        if let [a, b, c, d] = *ring {
            self.faces.quads.push([a, b, c, d]);
            return;
        }
        let patches = self.placed.len() as u32;
        let hub = ring.iter().position(|v| *v >= patches).unwrap_or_default();
        let at = |k: usize| ring[(hub + k) % ring.len()];
        self.faces.triangles.extend((1..ring.len() - 1).map(|k| [at(0), at(k), at(k + 1)]));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Corners inside or outside as they fall: every way in which cells can meet, and patches that meet twice.
    fn any_faces(inside: &[bool], side: usize) -> Faces {
        let off = |at: [usize; 3]| if inside[(at[2] * side + at[1]) * side + at[0]] { -0.5 } else { 0.5 };
        faces(&Lattice::of_corners(side, off), |p, _| Some(*p), &Progress::default()).expect("nobody cancels")
    }

    proptest! {
        #[test]
        fn no_edge_has_more_than_two_faces(inside in prop::collection::vec(any::<bool>(), 6 * 6 * 6)) {
            let faces = any_faces(&inside, 6);
            let quads = faces.quads.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]);
            let all: Vec<[u32; 3]> = quads.chain(faces.triangles.iter().copied()).collect();
            let mut sides: Vec<[u32; 2]> = all.iter().flat_map(|f| (0..3).map(|k| [f[k], f[(k + 1) % 3]])).collect();
            sides.sort_unstable();
            prop_assert!(sides.windows(2).all(|w| w[0] != w[1]));
            // Where all around a vertex is looked at, nothing is open.
            let is_inner = |v: u32| faces.vertices[v as usize].iter().all(|c| (1.0..4.0).contains(c));
            for [a, b] in &sides {
                if is_inner(*a) && is_inner(*b) {
                    prop_assert!(sides.binary_search(&[*b, *a]).is_ok());
                }
            }
        }
    }

    /// Two cells beside each other, the four corners of their face inside in turn, and joined on either side.
    #[test]
    fn patches_that_meet_twice_have_vertices_between_them() {
        let mut inside = vec![true; 4 * 4 * 4];
        let mut out = |x: usize, y: usize, z: usize| inside[(z * 4 + y) * 4 + x] = false;
        out(1, 1, 1);
        out(1, 2, 2);
        let faces = any_faces(&inside, 4);
        assert!(!faces.triangles.is_empty());
    }
}
