//! Vertex normals within one feature surface (P2 4.2.3).
//!
//! P2's formula weighs facets by area; by the corner angle the normal does not depend on how the
//! face was cut into triangles. Only facets of the same surface count: across a crease the mean
//! would tilt the beam by 45° at a cube's edge. Where a facet was cut into pieces, the normals are those that it had
//! before.

use super::key_index::KeyIndex;
use crate::part::{Mesh, Surfaces, angle, surfaces::Surface, topology::FacetDefect};
use crate::progress::{Cancelled, Progress};
use nalgebra::Vector3;

/// Unit normals at the vertices of one surface.
#[derive(Clone, Debug, Default)]
pub struct VertexNormals {
    vertices: KeyIndex,
    normals: Vec<Vector3<f64>>,
}

impl VertexNormals {
    /// Sums the facets of a surface, weighed by their angle at the vertex.
    pub fn new(mesh: &Mesh, surfaces: &Surfaces, surface: &Surface) -> VertexNormals {
        // Nobody else holds this progress, so it is not cancelled.
        VertexNormals::new_under(&Progress::default(), mesh, surfaces, surface).unwrap_or_default()
    }

    /// The normals of a surface, its facets weighed by their angle, as long as nobody wants the work to end.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn new_under(
        progress: &Progress,
        mesh: &Mesh,
        surfaces: &Surfaces,
        surface: &Surface,
    ) -> Result<VertexNormals, Cancelled> {
        let live = || surface.facets.iter().map(|&f| f as usize).filter(|&f| mesh.defects[f] == FacetDefect::None);
        let mut vertices = KeyIndex::for_keys(surface.facets.len() / 2 + 3);
        let mut sums: Vec<Vector3<f64>> = Vec::new();
        let mut last: Vec<Vector3<f64>> = Vec::new();
        for (number, f) in live().enumerate() {
            progress.check_at(number)?;
            let corners = mesh.corners(f);
            for k in 0..3 {
                let (here, next, before) = (corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]);
                let weight = angle::between_deg(&(next - here), &(before - here));
                let i = vertices.number(mesh.facets[f][k]);
                sums.resize(vertices.len(), Vector3::zeros());
                last.resize(vertices.len(), Vector3::zeros());
                sums[i] += surfaces.normals[f] * weight;
                last[i] = surfaces.normals[f];
            }
        }
        // Facets that cancel out (a blade's edge within one surface): any one of them.
        let mean = |s: Vector3<f64>, last| if s.norm() < 1e-6 { last } else { s.normalize() };
        let normals = vertices.keys().iter().zip(sums.into_iter().zip(last));
        let normals = normals
            .map(|(&v, (s, l))| surfaces.vertex_normal(surface.number, v).unwrap_or_else(|| mean(s, l)))
            .collect();
        Ok(VertexNormals { vertices, normals })
    }

    /// The normals of a surface and of facets around it, on one side of the part.
    ///
    /// The surface's own vertices keep their normals, so lines on it stay as they were. Each of the others has
    /// the normal it has within the surface that it belongs to (of several that of the first facet), so a beam
    /// that runs on over the rim turns over the first facet beyond it.
    pub fn extended(mesh: &Mesh, surfaces: &Surfaces, surface: &Surface, beyond: &[u32]) -> VertexNormals {
        let VertexNormals { mut vertices, mut normals } = VertexNormals::new(mesh, surfaces, surface);
        let is_live = |f: usize| mesh.defects.get(f) == Some(&FacetDefect::None);
        let turned = surface.facets.iter().map(|&f| f as usize).find(|&f| is_live(f));
        let side = if turned.is_some_and(|f| surfaces.normals[f] != mesh.normals[f]) { -1.0 } else { 1.0 };
        for &f in beyond.iter().filter(|&&f| is_live(f as usize)) {
            for v in mesh.facets[f as usize] {
                // Of several normals of a vertex the first stays.
                if vertices.number(v) < normals.len() {
                    continue;
                }
                if let Some(normal) = surfaces.vertex_normal(surfaces.of_facet[f as usize], v) {
                    // On the worked side of its own surface; here that of the one whose lines run on.
                    let own = if surfaces.normals[f as usize] != mesh.normals[f as usize] { -1.0 } else { 1.0 };
                    normals.push(normal * (own * side));
                    continue;
                }
                let mut sum = Vector3::zeros();
                let same = |g: &usize| is_live(*g) && surfaces.of_facet[*g] == surfaces.of_facet[f as usize];
                for g in mesh.vertex_facets(v).iter().map(|&g| g as usize).filter(same) {
                    let Some(k) = mesh.facets[g].iter().position(|&c| c == v) else { continue };
                    let p = [0, 1, 2].map(|i| mesh.vertices[mesh.facets[g][(k + i) % 3] as usize]);
                    sum += mesh.normals[g] * angle::between_deg(&(p[1] - p[0]), &(p[2] - p[0]));
                }
                normals.push(angle::unit(sum).unwrap_or(mesh.normals[f as usize]) * side);
            }
        }
        VertexNormals { vertices, normals }
    }

    /// Normal at a vertex of the mesh; zero if it is not on the surface.
    pub fn at(&self, vertex: u32) -> Vector3<f64> {
        self.vertices.get(vertex).map_or(Vector3::zeros(), |i| self.normals[i])
    }
}

/// Normal between two points, at the share `t` of the way (P2 4.2.3; the print has the weights
/// swapped).
pub fn between(from: &Vector3<f64>, to: &Vector3<f64>, t: f64) -> Vector3<f64> {
    angle::unit(from * (1.0 - t) + to * t).unwrap_or(*from)
}
