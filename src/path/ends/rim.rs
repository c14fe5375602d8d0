//! The outline of a surface: its edges with no neighbour within the surface, as loops, and which of those are
//! holes.

use crate::part::angle::between_deg;
use crate::part::{Mesh, surfaces::Surface, topology::FacetDefect, topology::NO_EDGE};
use nalgebra::{Point3, Vector3};

/// The outline of a surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rim {
    /// Its loops in the order of their lowest facets.
    pub loops: Vec<RimLoop>,
}

/// One closed line of the outline.
#[derive(Clone, Debug, PartialEq)]
pub struct RimLoop {
    /// Its edges in the mesh, in order.
    pub edges: Vec<u32>,
    /// Their ends, mm.
    pub segments: Vec<[Point3<f64>; 2]>,
    /// Its length, mm.
    pub length_mm: f64,
    /// How far it turns within the surface, the surface to its inner side, degrees: 360 for the outline of a
    /// flat surface, −360 for a hole in it, 0 for the rim of a cylinder's wall.
    pub turning_deg: f64,
}

impl RimLoop {
    /// Whether the surface lies around it: the loop turns to the outside by more than half a turn.
    pub fn is_hole(&self) -> bool {
        self.turning_deg < -180.0
    }

    /// Whether it is a hole of less length than a circle of this diameter.
    pub fn is_hole_below(&self, diameter_mm: f64) -> bool {
        self.is_hole() && self.length_mm < std::f64::consts::PI * diameter_mm
    }

    /// Whether it is a slit without width, where a facet without area joins others: lines need not keep off it.
    fn is_slit(&self) -> bool {
        let Some(origin) = self.segments.first().map(|s| s[0]) else { return true };
        let around = self.segments.iter().map(|[a, b]| (a - origin).cross(&(b - origin)));
        self.is_hole() && around.fold(Vector3::zeros(), |a, b| a + b).norm() < 1e-9 * self.length_mm * self.length_mm
    }
}

impl Rim {
    /// All its edges, mm, but those of holes smaller than a circle of this diameter; 0: all.
    pub fn segments(&self, ignore_holes_mm: f64) -> impl Iterator<Item = [Point3<f64>; 2]> {
        let counts = move |l: &&RimLoop| !l.is_hole_below(ignore_holes_mm);
        self.loops.iter().filter(counts).flat_map(|l| l.segments.iter().copied())
    }
}

/// The outline of a surface: edges with one live facet of it, or with more than two.
///
/// A facet's file order makes the order of loops. Slits without width are left out.
pub fn rim(mesh: &Mesh, surface: &Surface) -> Rim {
    let facets = SurfaceFacets { mesh, surface };
    let sides: Vec<(u32, usize)> = surface
        .facets
        .iter()
        .filter(|&&f| facets.has(f))
        .flat_map(|&f| (0..3).map(move |k| (f, k)))
        .filter(|&(f, k)| facets.is_rim(mesh.facet_edges[f as usize][k]))
        .collect();
    let mut done = vec![false; sides.len()];
    let mut loops = Vec::new();
    for start in 0..sides.len() {
        let mut found = RimLoop { edges: Vec::new(), segments: Vec::new(), length_mm: 0.0, turning_deg: 0.0 };
        let mut at = Some(start);
        let mut from = mesh.facets[sides[start].0 as usize][sides[start].1];
        while let Some(i) = at.filter(|&i| !std::mem::replace(&mut done[i], true)) {
            let (facet, k) = sides[i];
            let edge = mesh.facet_edges[facet as usize][k];
            let [a, b] = mesh.edges[edge as usize];
            let to = if a == from { b } else { a };
            let segment = [from, to].map(|v| mesh.vertices[v as usize]);
            found.edges.push(edge);
            found.segments.push(segment);
            found.length_mm += (segment[1] - segment[0]).norm();
            let (next, inner_deg) = facets.next_side(facet, edge, to);
            found.turning_deg += 180.0 - inner_deg;
            from = to;
            at = next.and_then(|next| sides.binary_search(&next).ok());
        }
        if !found.edges.is_empty() && !found.is_slit() {
            loops.push(found);
        }
    }
    Rim { loops }
}

/// The live facets of a surface.
struct SurfaceFacets<'a> {
    mesh: &'a Mesh,
    surface: &'a Surface,
}

impl SurfaceFacets<'_> {
    fn has(&self, facet: u32) -> bool {
        self.mesh.defects[facet as usize] == FacetDefect::None && self.surface.facets.binary_search(&facet).is_ok()
    }

    fn at_edge(&self, edge: u32) -> impl Iterator<Item = u32> {
        let facets = if edge == NO_EDGE { &[][..] } else { self.mesh.edge_facets(edge) };
        facets.iter().copied().filter(|&f| self.has(f))
    }

    fn is_rim(&self, edge: u32) -> bool {
        edge != NO_EDGE && self.at_edge(edge).count() != 2
    }

    /// The next side of the outline around the end of a side, and the angle within the surface between them, degrees.
    fn next_side(&self, mut facet: u32, mut edge: u32, vertex: u32) -> (Option<(u32, usize)>, f64) {
        let mut inner_deg = 0.0;
        for _ in 0..=self.mesh.vertex_facets(vertex).len() {
            let corners = self.mesh.facets[facet as usize];
            let edges = self.mesh.facet_edges[facet as usize];
            let Some(corner) = corners.iter().position(|&v| v == vertex) else { break };
            let p = [0, 1, 2].map(|i| self.mesh.vertices[corners[(corner + i) % 3] as usize]);
            inner_deg += between_deg(&(p[1] - p[0]), &(p[2] - p[0]));
            // The two edges at this corner are those before and behind it.
            let Some(k) = [corner, (corner + 2) % 3].into_iter().find(|&k| edges[k] != edge) else { break };
            edge = edges[k];
            if self.is_rim(edge) {
                return (Some((facet, k)), inner_deg);
            }
            let Some(other) = self.at_edge(edge).find(|&g| g != facet) else { break };
            facet = other;
        }
        (None, inner_deg)
    }
}
