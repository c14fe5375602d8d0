//! Cuts refined triangles along the contour of a depth (marching triangles), so that each piece lies on one side of it.
//! Cut points are shared over edges, so that the pieces hang together as the triangles did. Triangles of which nothing
//! is cut stay whole.

use super::{PatchCut, RefinedFacets};
use nalgebra::Point3;
use std::collections::BTreeMap;

/// Of pieces in no patch.
pub(super) const NO_PATCH: u32 = u32::MAX;

/// A cut nearer than this share of an edge to its end goes through the end, so that no sliver remains. With triangles
/// as fine as a scan resolves (0.3 to 1 mm) it moves the contour by 1 µm at most, far below what a scan tells; slivers
/// of a thousandth keep ten digits of their normals.
const NEAR_END: f64 = 1e-3;

/// A piece of a refined triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    /// The facet of the part.
    pub parent: u32,
    /// Vertices: refined ones, and behind them the cut points.
    pub corners: [u32; 3],
    /// The patch, or [`NO_PATCH`].
    pub patch: u32,
    /// The triangle that it was cut out of.
    pub triangle: u32,
}

/// All refined triangles in pieces.
#[derive(Clone, Debug, Default)]
pub(super) struct Pieces {
    /// Points where the contour crosses edges.
    pub cut_points: Vec<Point3<f64>>,
    /// The pieces, in the order of the triangles.
    pub pieces: Vec<Piece>,
}

/// Where the contour crosses edges: by the lower and the higher vertex.
struct Crossings<'a> {
    refined: &'a RefinedFacets<'a>,
    above_mm: f64,
    at: BTreeMap<[u32; 2], u32>,
    points: Vec<Point3<f64>>,
}

impl Pieces {
    /// Cuts the triangles of patches, and at shared edges those beside them.
    pub fn new(refined: &RefinedFacets<'_>, cut: &PatchCut<'_>) -> Pieces {
        let mut patch_of = vec![NO_PATCH; refined.triangles.len()];
        let is_known = |t: u32| refined.triangles[t as usize].iter().all(|&v| !refined.depth_mm[v as usize].is_nan());
        for (patch, triangles) in (0..).zip(cut.triangles) {
            triangles.iter().filter(|&&t| is_known(t)).for_each(|&t| patch_of[t as usize] = patch);
        }
        let mut crossings = Crossings { refined, above_mm: cut.above_mm, at: BTreeMap::new(), points: Vec::new() };
        let in_patches = refined.triangles.iter().zip(&patch_of).filter(|(_, patch)| **patch != NO_PATCH);
        in_patches.for_each(|(triangle, _)| crossings.find(triangle));
        let mut pieces = Vec::with_capacity(refined.triangles.len());
        for (triangle, (corners, &patch)) in (0..).zip(refined.triangles.iter().zip(&patch_of)) {
            let parent = refined.parent[triangle as usize];
            let mut push = |corners, patch| pieces.push(Piece { parent, corners, patch, triangle });
            match patch {
                NO_PATCH => crossings.split_beside(corners, |corners| push(corners, NO_PATCH)),
                patch => crossings.split(corners, |corners, deep| push(corners, if deep { patch } else { NO_PATCH })),
            }
        }
        Pieces { cut_points: crossings.points, pieces }
    }
}

impl Crossings<'_> {
    fn is_deep(&self, v: u32) -> bool {
        self.refined.depth_mm[v as usize] > self.above_mm
    }

    /// Notes where the contour crosses the edges of a triangle all of whose depths are known.
    fn find(&mut self, triangle: &[u32; 3]) {
        for k in 0..3 {
            let ends = [triangle[k], triangle[(k + 1) % 3]];
            let [deep, other] = if self.is_deep(ends[0]) { ends } else { [ends[1], ends[0]] };
            let edge = [deep.min(other), deep.max(other)];
            if !self.is_deep(deep) || self.is_deep(other) || self.at.contains_key(&edge) {
                continue;
            }
            let [from_mm, to_mm] = [deep, other].map(|v| self.refined.depth_mm[v as usize]);
            let share = (from_mm - self.above_mm) / (from_mm - to_mm);
            let [from, to] = [deep, other].map(|v| self.refined.vertices[v as usize]);
            let crossing = if share < NEAR_END {
                deep
            } else if share > 1.0 - NEAR_END {
                other
            } else {
                self.points.push(from + (to - from) * share);
                (self.refined.vertices.len() + self.points.len() - 1) as u32
            };
            self.at.insert(edge, crossing);
        }
    }

    fn crossing(&self, a: u32, b: u32) -> Option<u32> {
        self.at.get(&[a.min(b), a.max(b)]).copied()
    }

    /// Cuts a triangle of a patch along the contour, and says of each piece whether it is deep.
    fn split(&self, triangle: &[u32; 3], mut push: impl FnMut([u32; 3], bool)) {
        let deep = triangle.map(|v| self.is_deep(v));
        // The corner that is alone on its side; `None`: all are on one.
        let alone = (0..3).find(|&k| deep[k] != deep[(k + 1) % 3] && deep[k] != deep[(k + 2) % 3]);
        let corners = alone.map(|k| [triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]]);
        let cut = corners.and_then(|[a, b, c]| Some(([a, b, c], self.crossing(a, b)?, self.crossing(a, c)?)));
        let Some(([a, b, c], p, q)) = cut else { return push(*triangle, deep[0]) };
        let is_deep = self.is_deep(a);
        self.fan(&[a, p, q], |piece| push(piece, is_deep));
        self.fan(&[p, b, c, q], |piece| push(piece, !is_deep));
    }

    /// Cuts a triangle of no patch where a neighbour of it is cut: at one edge at most, since none of its own is
    /// known to be crossed at two.
    fn split_beside(&self, triangle: &[u32; 3], push: impl FnMut([u32; 3])) {
        let mut outline = Vec::with_capacity(4);
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            outline.push(a);
            outline.extend(self.crossing(a, b).filter(|&p| p != a && p != b));
        }
        self.fan(&outline, push);
    }

    /// Cuts a convex outline into triangles, none of them flat though corners may lie on one line or come twice: the ear
    /// goes first whose cut leaves the most area on its poorer side, which of four corners is the better diagonal.
    fn fan(&self, outline: &[u32], mut push: impl FnMut([u32; 3])) {
        let mut left: Vec<u32> = outline.to_vec();
        left.dedup();
        if left.len() > 1 && left.first() == left.last() {
            left.pop();
        }
        while left.len() > 3 {
            let at = |k: usize| left[k % left.len()];
            let ear = |k: usize| [at(k), at(k + 1), at(k + 2)];
            let poorer = |k: usize| self.area(&ear(k)).min(self.area(&[at(k + 2), at(k + 3), at(k)]));
            let best = (1..left.len()).fold(0, |best, k| if poorer(k) > poorer(best) { k } else { best });
            push(ear(best));
            left.remove((best + 1) % left.len());
        }
        if let [a, b, c] = left[..] {
            push([a, b, c]);
        }
    }

    fn area(&self, corners: &[u32; 3]) -> f64 {
        let at = |v: u32| {
            let v = v as usize;
            *self.refined.vertices.get(v).unwrap_or_else(|| &self.points[v - self.refined.vertices.len()])
        };
        let [a, b, c] = corners.map(at);
        (b - a).cross(&(c - a)).norm()
    }
}
