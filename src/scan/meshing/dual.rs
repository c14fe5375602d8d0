//! From crossed cells to a surface: a vertex for each patch of a cell, and around each crossed edge a face of the four
//! patches there (dual marching cubes). Where each vertex comes to stand is settled later.
//!
//! Two neighbouring patches can meet twice, across a face whose four edges are all crossed. Four faces would share
//! that edge; so each meeting has a vertex of its own between them, and no edge has more than two facets.

use super::cell_patches::{CellPatches, EDGES, NO_PATCH, all_patches, edge_number, joined_on_face};
use super::lattice::{Lattice, STEP};
use super::surfels::{Room, Surfels};
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

/// Makes the faces. A patch that no piece of the surface reaches has none, so that rims stay where points end.
pub(super) fn faces(lattice: &Lattice, surfels: &Surfels, progress: &Progress) -> Result<Faces, Cancelled> {
    let patches = all_patches();
    let pieces: Vec<Vec<Option<Point3<f64>>>> = lattice
        .cells
        .par_chunks(PIECE)
        .map_init(Room::default, |room, piece| {
            progress.check()?;
            let at = |i: usize| patch_vertices(lattice, piece[i].key, i, piece, &patches);
            let all = (0..piece.len()).flat_map(at);
            Ok(all.map(|p| p.and_then(|p| reached(surfels, p, lattice.cell_mm, room))).collect())
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
fn patch_vertices(
    lattice: &Lattice,
    key: u64,
    at: usize,
    piece: &[super::lattice::CrossedCell],
    patches: &[CellPatches],
) -> Vec<Option<Point3<f64>>> {
    let cell = &piece[at];
    let CellPatches { count, of_edge } = patches[usize::from(cell.inside)];
    let middle = |patch: u8| {
        let (mut sum, mut edges) = (Vector3::zeros(), 0.0);
        for (edge, (corner, axis)) in EDGES.into_iter().enumerate() {
            if of_edge[edge] == patch {
                sum += cell.crossing(corner, axis)?;
                edges += 1.0;
            }
        }
        Some(lattice.place(key, &(sum / edges)))
    };
    (0..count).map(middle).collect()
}

/// The place itself, where the surface beneath it goes on as far.
fn reached(surfels: &Surfels, p: Point3<f64>, cell_mm: f64, room: &mut Room) -> Option<Point3<f64>> {
    let seen = surfels.seen(&p, room)?;
    let foot = p - seen.normal * seen.off_mm.clamp(-cell_mm, cell_mm);
    surfels.reach(&foot, cell_mm, room).then_some(p)
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
            let Some(found) = self.lattice.find(cell.key - back) else { return };
            *slot = (found, edge_number(corner, axis));
        }
        let corners = cells.map(|(found, edge)| self.vertex(found, edge));
        if corners.iter().any(|c| self.placed[*c as usize].is_none()) {
            return;
        }
        // Which of two neighbours in the ring is the upper one, and across which axis they meet.
        let meetings = [(0, 1, u), (3, 2, u), (0, 3, v), (1, 2, v)];
        let mut ring = Vec::with_capacity(8);
        for k in 0..4 {
            ring.push(corners[k]);
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
        debug_assert_ne!(patch, NO_PATCH);
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
