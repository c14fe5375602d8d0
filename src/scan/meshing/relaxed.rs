//! Where the vertices come to stand: on the surface, and evenly apart.
//!
//! A patch that the surface hardly touches has its vertex next to those around it; so inner vertices are drawn halfway
//! to the middle of their neighbours, and brought back onto the surface. Vertices of a rim stay where they are.

use super::dual::Faces;
use super::surfels::{Room, Surfels};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Rounds: after two the shortest sides are a fifth of a cell, and more rounds widen them little.
const ROUNDS: usize = 2;
/// Vertices of a piece of work.
const PIECE: usize = 512;

/// Brings the vertices of faces onto the surface.
pub(super) fn relax(faces: &mut Faces, surfels: &Surfels, cell_mm: f64, progress: &Progress) -> Result<(), Cancelled> {
    let beside = Beside::new(faces);
    // They landed from up to a cell off, which is not exactly on it.
    faces.vertices = moved(&faces.vertices, progress, |i, room| on_surface(faces.vertices[i], surfels, cell_mm, room))?;
    for _ in 0..ROUNDS {
        faces.vertices = moved(&faces.vertices, progress, |i, room| {
            let Some(middle) = beside.middle(i, &faces.vertices) else { return faces.vertices[i] };
            on_surface(nalgebra::center(&faces.vertices[i], &middle), surfels, cell_mm, room)
        })?;
    }
    Ok(())
}

fn on_surface(p: Point3<f64>, surfels: &Surfels, cell_mm: f64, room: &mut Room) -> Point3<f64> {
    surfels.seen(&p, f64::INFINITY, room).map_or(p, |seen| p - seen.normal * seen.off_mm.clamp(-cell_mm, cell_mm))
}

fn moved(
    vertices: &[Point3<f64>],
    progress: &Progress,
    to: impl Fn(usize, &mut Room) -> Point3<f64> + Sync,
) -> Result<Vec<Point3<f64>>, Cancelled> {
    let pieces: Vec<Vec<Point3<f64>>> = (0..vertices.len().div_ceil(PIECE))
        .into_par_iter()
        .map_init(Room::default, |room, piece| {
            progress.check()?;
            let all = piece * PIECE..vertices.len().min((piece + 1) * PIECE);
            Ok(all.map(|i| to(i, room)).collect())
        })
        .collect::<Result<_, Cancelled>>()?;
    Ok(pieces.concat())
}

/// The neighbours of each vertex along the sides of faces.
struct Beside {
    start: Vec<u32>,
    other: Vec<u32>,
    is_rim: Vec<bool>,
}

impl Beside {
    fn new(faces: &Faces) -> Beside {
        let quads = faces.quads.iter().flat_map(|q| (0..4).map(|k| [q[k], q[(k + 1) % 4]]));
        let triangles = faces.triangles.iter().flat_map(|t| (0..3).map(|k| [t[k], t[(k + 1) % 3]]));
        let mut sides: Vec<[u32; 2]> = quads.chain(triangles).flat_map(|[a, b]| [[a, b], [b, a]]).collect();
        sides.par_sort_unstable();
        let count = faces.vertices.len();
        let mut beside = Beside { start: vec![0; count + 1], other: Vec::new(), is_rim: vec![false; count] };
        for side in sides.chunk_by(|a, b| a == b) {
            let [from, to] = side[0];
            beside.start[from as usize + 1] += 1;
            beside.other.push(to);
            beside.is_rim[from as usize] |= side.len() < 2;
        }
        (0..count).for_each(|i| beside.start[i + 1] += beside.start[i]);
        beside
    }

    /// The middle of a vertex's neighbours; `None` on a rim.
    fn middle(&self, i: usize, vertices: &[Point3<f64>]) -> Option<Point3<f64>> {
        let others = &self.other[self.start[i] as usize..self.start[i + 1] as usize];
        if self.is_rim[i] || others.is_empty() {
            return None;
        }
        let from = vertices[i];
        let sum: Vector3<f64> = others.iter().map(|o| vertices[*o as usize] - from).sum();
        Some(from + sum / others.len() as f64)
    }
}
