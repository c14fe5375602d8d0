//! A piece of the part's mesh, refined where it is asked for: facets are cut in two at the middle of their longest
//! side, and whoever shares that side is cut too, so that neighbours always share their vertices (M.-C. Rivara,
//! Algorithms for refining triangular grids suitable for adaptive and multigrid techniques, 1984).
//!
//! Angles stay above half of the facets' smallest, but for those that are cut only to meet their neighbours. What is
//! fine enough, and where, the caller says; nothing here knows of depths.

use crate::part::topology::NO_EDGE;
use crate::part::{Mesh, Part};
use crate::progress::{Cancelled, Progress};
use nalgebra::Point3;
use rayon::prelude::*;
use std::collections::{HashMap, HashSet};
use std::hash::{BuildHasherDefault, Hasher};

/// A refined piece of a mesh; only facets that were cut, or asked for, are in it.
#[derive(Clone, Debug, Default)]
pub struct RefinedPiece {
    /// Places of its vertices, part frame, mm.
    pub vertices: Vec<Point3<f64>>,
    /// Wound as the facets are.
    pub triangles: Vec<[u32; 3]>,
    /// The facet that each triangle is a piece of; ascending.
    pub parent: Vec<u32>,
}

/// Two vertices, the lower index first.
type Side = (u32, u32);

/// Sides are looked up, never listed, so their order in a table does not matter; two multiplications spread them well
/// enough, in a fifth of the time that the standard hash takes.
#[derive(Default)]
struct SideHasher(u64);

impl Hasher for SideHasher {
    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|b| self.write_u32(u32::from(*b)));
    }

    fn write_u32(&mut self, i: u32) {
        self.0 = (self.0.rotate_left(29) ^ u64::from(i)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }

    fn finish(&self) -> u64 {
        self.0 ^ self.0 >> 32
    }
}

type SideMap<T> = HashMap<Side, T, BuildHasherDefault<SideHasher>>;
type SideSet = HashSet<Side, BuildHasherDefault<SideHasher>>;

struct Piece {
    corners: [u32; 3],
    /// The part's edge that each side is the whole of; [`NO_EDGE`] where it is less.
    edges: [u32; 3],
    parent: u32,
    /// It was looked at, and needs no cut for its own sake.
    done: bool,
}

struct Work<'a> {
    mesh: &'a Mesh,
    vertices: Vec<Point3<f64>>,
    pieces: Vec<Piece>,
    of_part: HashMap<u32, u32>,
    is_in: Vec<bool>,
    /// Sides to be cut, and the vertices in their middles.
    cuts: SideMap<u32>,
}

/// Takes in `facets`, and cuts triangles as long as `is_too_large` says so of their corners, or until there are
/// `most` of them: then what is left stays larger than was asked for.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub fn refined(
    part: &Part,
    facets: impl Iterator<Item = u32>,
    most: usize,
    is_too_large: impl Fn(&[Point3<f64>; 3]) -> bool + Sync,
    progress: &Progress,
) -> Result<RefinedPiece, Cancelled> {
    let mut work = Work {
        mesh: &part.mesh,
        vertices: Vec::new(),
        pieces: Vec::new(),
        of_part: HashMap::new(),
        is_in: vec![false; part.mesh.facets.len()],
        cuts: SideMap::default(),
    };
    facets.for_each(|f| work.take_in(f));
    while work.pieces.len() < most {
        let vertices = &work.vertices;
        let look = |chunk: &mut [Piece]| {
            progress.check()?;
            for piece in chunk.iter_mut().filter(|p| !p.done) {
                piece.done = !is_too_large(&piece.corners.map(|v| vertices[v as usize]));
            }
            Ok(())
        };
        work.pieces.par_chunks_mut(256).try_for_each(look)?;
        let wanted: Vec<Side> = work.pieces.iter().filter(|p| !p.done).map(|p| work.longest(p).1).collect();
        if wanted.is_empty() {
            break;
        }
        work.cuts.clear();
        let mut new: SideSet = wanted.into_iter().collect();
        while !new.is_empty() {
            progress.check()?;
            new = work.spread(&new);
        }
        work.cut();
    }
    work.pieces.sort_by_key(|p| p.parent);
    let triangles = work.pieces.iter().map(|p| p.corners).collect();
    Ok(RefinedPiece { vertices: work.vertices, triangles, parent: work.pieces.iter().map(|p| p.parent).collect() })
}

impl Work<'_> {
    /// Takes a facet of the part in, if it is not yet and has three corners.
    fn take_in(&mut self, facet: u32) {
        let f = facet as usize;
        let [a, b, c] = self.mesh.facets[f];
        if self.is_in[f] || a == b || b == c || c == a {
            return;
        }
        self.is_in[f] = true;
        let corners = [a, b, c].map(|v| {
            *self.of_part.entry(v).or_insert_with(|| {
                self.vertices.push(self.mesh.vertices[v as usize]);
                self.vertices.len() as u32 - 1
            })
        });
        self.pieces.push(Piece { corners, edges: self.mesh.facet_edges[f], parent: facet, done: false });
    }

    /// The longest side of a triangle; of equal ones that of the lowest vertices, so that all its triangles agree.
    fn longest(&self, piece: &Piece) -> (usize, Side) {
        let length2 = |(a, b): Side| (self.vertices[b as usize] - self.vertices[a as usize]).norm_squared();
        let mut best = (0, side(&piece.corners, 0));
        for k in 1..3 {
            let other = side(&piece.corners, k);
            let (new, old) = (length2(other), length2(best.1));
            if new > old || new == old && other < best.1 {
                best = (k, other);
            }
        }
        best
    }

    /// Marks sides for a cut, and returns those that have to be cut for it: of a triangle with a side that is cut the
    /// longest one is cut too.
    fn spread(&mut self, new: &SideSet) -> SideSet {
        // In the order of the triangles, so that new vertices have the same numbers each time.
        for at in 0..self.pieces.len() {
            for k in 0..3 {
                let side = side(&self.pieces[at].corners, k);
                if new.contains(&side) && !self.cuts.contains_key(&side) {
                    let [a, b] = [side.0, side.1].map(|v| self.vertices[v as usize]);
                    self.cuts.insert(side, self.vertices.len() as u32);
                    self.vertices.push(a + (b - a) * 0.5);
                }
                let edge = self.pieces[at].edges[k];
                if edge != NO_EDGE && new.contains(&side) {
                    let facets = self.mesh.edge_facets(edge).to_vec();
                    facets.into_iter().for_each(|f| self.take_in(f));
                }
            }
        }
        let is_cut = |p: &Piece| (0..3).any(|k| self.cuts.contains_key(&side(&p.corners, k)));
        let longest = self.pieces.iter().filter(|p| is_cut(p)).map(|p| self.longest(p).1);
        longest.filter(|side| !self.cuts.contains_key(side)).collect()
    }

    /// Cuts all triangles at their marked sides, the longest first.
    fn cut(&mut self) {
        let mut waiting = std::mem::take(&mut self.pieces);
        waiting.reverse();
        while let Some(piece) = waiting.pop() {
            let marked = |k: usize| self.cuts.contains_key(&side(&piece.corners, k));
            let (longest, _) = self.longest(&piece);
            // A half may have a longer side than the one that is marked.
            let Some(k) = (0..3).map(|i| (longest + i) % 3).find(|&k| marked(k)) else {
                self.pieces.push(piece);
                continue;
            };
            let Some(&middle) = self.cuts.get(&side(&piece.corners, k)) else { continue };
            let corner = |i: usize| piece.corners[(k + i) % 3];
            let edge = |i: usize| piece.edges[(k + i) % 3];
            let half = |corners, edges| Piece { corners, edges, parent: piece.parent, done: false };
            waiting.push(half([middle, corner(1), corner(2)], [NO_EDGE, edge(1), NO_EDGE]));
            waiting.push(half([corner(0), middle, corner(2)], [NO_EDGE, NO_EDGE, edge(2)]));
        }
    }
}

/// Side k of a triangle joins its corners k and k + 1.
fn side(corners: &[u32; 3], k: usize) -> Side {
    let (a, b) = (corners[k], corners[(k + 1) % 3]);
    (a.min(b), a.max(b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::{Placement, Units};
    use crate::sample::{solids, stl_bytes};

    fn area([a, b, c]: &[Point3<f64>; 3]) -> f64 {
        0.5 * (b - a).cross(&(c - a)).norm()
    }

    /// Of a cube whose corner is refined: no side has a vertex in its middle, each facet is covered by its pieces, wound
    /// as it is, and only what is near the corner is small.
    #[test]
    fn neighbours_share_their_vertices_and_facets_are_covered() {
        let bytes = stl_bytes(&solids::cube(100.0));
        let part = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]).expect("a cube is a part");
        let corner = part.mesh.vertices[0];
        let near = |c: &[Point3<f64>; 3]| {
            let longest = (0..3).map(|k| (c[k] - c[(k + 1) % 3]).norm()).fold(0.0, f64::max);
            longest > 1.0 && c.iter().any(|p| (p - corner).norm() < 5.0 + longest)
        };
        let first = std::iter::once(0u32).chain(part.mesh.vertex_facets(0).iter().copied());
        let found = refined(&part, first, 100_000, near, &Progress::default()).expect("not cancelled");
        let corners = |t: &[u32; 3]| t.map(|v| found.vertices[v as usize]);
        assert!(found.triangles.len() < 4000, "{}", found.triangles.len());
        let mut covered = vec![0.0; part.mesh.facets.len()];
        let mut sides: HashMap<Side, usize> = HashMap::new();
        for (t, &f) in found.triangles.iter().zip(&found.parent) {
            let [a, b, c] = corners(t);
            assert!((b - a).cross(&(c - a)).dot(&part.mesh.normals[f as usize]) > 0.0);
            assert!(!near(&[a, b, c]));
            covered[f as usize] += area(&[a, b, c]);
            (0..3).for_each(|k| *sides.entry(side(t, k)).or_default() += 1);
        }
        for (f, covered) in covered.iter().enumerate().filter(|(_, c)| **c > 0.0) {
            assert!((covered - part.mesh.areas[f]).abs() < 1e-9);
        }
        // A side of one triangle is the whole of an edge whose other facet was not cut.
        for (side, _) in sides.iter().filter(|(_, n)| **n == 1) {
            let [a, b] = [side.0, side.1].map(|v| found.vertices[v as usize]);
            assert!(part.mesh.vertices.contains(&a) && part.mesh.vertices.contains(&b), "{a} {b}");
        }
        assert!(sides.values().all(|n| *n <= 2));
    }
}
