//! A surface's facets by themselves, cut where asked. Every piece lies in the facet it was cut
//! from, so what is found on the surface mesh is on the part, with the normals of the whole surface.

use super::super::live_facets::live;
use super::super::normals::{VertexNormals, between};
use super::super::section::SectionPoint;
use crate::part::angle::unit;
use crate::part::union_find::UnionFind;
use crate::part::{Mesh, surfaces::Surface};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};

/// A copy of one surface.
pub(super) struct SurfaceMesh {
    /// Its proper facets and what they were cut into.
    pub mesh: Mesh,
    /// Unit normals at the vertices.
    pub normals: Vec<Vector3<f64>>,
}

impl SurfaceMesh {
    /// The surface as it is.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn new(
        mesh: &Mesh,
        surface: &Surface,
        normals: &VertexNormals,
        progress: &Progress,
    ) -> Result<SurfaceMesh, Cancelled> {
        let mut vertices: Vec<u32> = live(mesh, surface).flat_map(|f| mesh.facets[f]).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let mut local = vec![0u32; mesh.vertices.len()];
        for (i, &v) in vertices.iter().enumerate() {
            local[v as usize] = i as u32;
        }
        let facets = live(mesh, surface).map(|f| mesh.facets[f].map(|v| local[v as usize])).collect();
        let points = vertices.iter().map(|&v| mesh.vertices[v as usize]).collect();
        let mesh = Mesh::from_indexed_under(progress, points, facets)?;
        Ok(SurfaceMesh { mesh, normals: vertices.iter().map(|&v| normals.at(v)).collect() })
    }

    /// Cuts edges, each at a share of the way from its lower vertex, and the facets beside them. Also
    /// the number of the first new vertex: they follow in the order of `cuts` (ascending by edge).
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn cut(&self, cuts: &[(u32, f64)], progress: &Progress) -> Result<(SurfaceMesh, u32), Cancelled> {
        let first = self.mesh.vertices.len() as u32;
        let mut middle = vec![u32::MAX; self.mesh.edges.len()];
        let (mut vertices, mut normals) = (self.mesh.vertices.clone(), self.normals.clone());
        for &(e, share) in cuts {
            middle[e as usize] = vertices.len() as u32;
            let q = self.on_edge(e, share);
            vertices.push(q.p);
            normals.push(q.n);
        }
        let mut facets: Vec<[u32; 3]> = Vec::with_capacity(self.mesh.facets.len() + 3 * cuts.len());
        for (corners, edges) in self.mesh.facets.iter().zip(&self.mesh.facet_edges) {
            let cut = edges.map(|e| middle.get(e as usize).copied().filter(|&v| v != u32::MAX));
            split(corners, cut, &vertices, &mut facets);
        }
        Ok((SurfaceMesh { mesh: Mesh::from_indexed_under(progress, vertices, facets)?, normals }, first))
    }

    /// Makes a point of a facet, told by its three weights, a vertex, unless it is one; and its number.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn with_vertex(
        self,
        facet: u32,
        weights: [f64; 3],
        progress: &Progress,
    ) -> Result<(SurfaceMesh, u32), Cancelled> {
        let corners = self.mesh.facets[facet as usize];
        let near = 1e-6;
        if let Some(k) = (0..3).find(|&k| weights[k] > 1.0 - near) {
            return Ok((self, corners[k]));
        }
        if let Some(k) = (0..3).find(|&k| weights[(k + 2) % 3] < near) {
            let edge = self.mesh.facet_edges[facet as usize][k];
            let share = weights[(k + 1) % 3] / (weights[k] + weights[(k + 1) % 3]);
            let forward = self.mesh.edges[edge as usize][0] == corners[k];
            return self.cut(&[(edge, if forward { share } else { 1.0 - share })], progress);
        }
        let SurfaceMesh { mesh, mut normals } = self;
        let mut p = Vector3::zeros();
        let mut n = Vector3::zeros();
        for k in 0..3 {
            p += mesh.vertices[corners[k] as usize].coords * weights[k];
            n += normals[corners[k] as usize] * weights[k];
        }
        let (mut vertices, mut facets) = (mesh.vertices, mesh.facets);
        let new = vertices.len() as u32;
        vertices.push(Point3::from(p));
        normals.push(unit(n).unwrap_or(normals[corners[0] as usize]));
        let [a, b, c] = corners;
        facets[facet as usize] = [a, b, new];
        facets.extend([[b, c, new], [c, a, new]]);
        Ok((SurfaceMesh { mesh: Mesh::from_indexed_under(progress, vertices, facets)?, normals }, new))
    }

    /// Length of an edge, mm.
    pub fn length_mm(&self, edge: u32) -> f64 {
        let [a, b] = self.mesh.edges[edge as usize];
        (self.mesh.vertices[b as usize] - self.mesh.vertices[a as usize]).norm()
    }

    /// The point at a share of the way from an edge's lower vertex, with its normal.
    pub fn on_edge(&self, edge: u32, share: f64) -> SectionPoint {
        let [a, b] = self.mesh.edges[edge as usize].map(|v| v as usize);
        let (from, to) = (self.mesh.vertices[a], self.mesh.vertices[b]);
        SectionPoint { p: from + (to - from) * share, n: between(&self.normals[a], &self.normals[b], share) }
    }

    /// The edges of the outline: of one facet only.
    pub fn rim(&self) -> Vec<u32> {
        (0..self.mesh.edges.len() as u32).filter(|&e| self.mesh.edge_facets(e).len() == 1).collect()
    }

    /// The outline's loops as sets of edges, the longest first. Loops that touch are one.
    pub fn loops(&self) -> Vec<(f64, Vec<u32>)> {
        let rim = self.rim();
        let mut sets = UnionFind::new(self.mesh.vertices.len());
        for &e in &rim {
            let [a, b] = self.mesh.edges[e as usize];
            sets.join(a, b);
        }
        let mut of: Vec<(u32, u32)> = rim.iter().map(|&e| (sets.root(self.mesh.edges[e as usize][0]), e)).collect();
        of.sort_unstable();
        let mut loops: Vec<(f64, u32, Vec<u32>)> = of
            .chunk_by(|a, b| a.0 == b.0)
            .map(|c| (c.iter().map(|x| self.length_mm(x.1)).sum(), c[0].0, c.iter().map(|x| x.1).collect()))
            .collect();
        // In steps of a micrometre fraction: of equal loops the one with the lowest vertex is first,
        // however finely they are cut.
        loops.sort_by_key(|l| (-(l.0 * 1e5).round() as i64, l.1));
        loops.into_iter().map(|(length, _, edges)| (length, edges)).collect()
    }
}

/// The pieces of a facet, some of whose edges are cut by a vertex: the edge from each corner to the next.
pub(super) fn split(corners: &[u32; 3], cut: [Option<u32>; 3], vertices: &[Point3<f64>], out: &mut Vec<[u32; 3]>) {
    // Turned so that its first cut follows an edge that is whole, if there is one.
    let turn = (0..3).find(|&k| cut[k].is_some() && cut[(k + 2) % 3].is_none()).unwrap_or(0);
    let at = |k: usize| (corners[(turn + k) % 3], cut[(turn + k) % 3]);
    let [(a, ab), (b, bc), (c, ca)] = [at(0), at(1), at(2)];
    match (ab, bc, ca) {
        (Some(p), None, None) => out.extend([[a, p, c], [p, b, c]]),
        (Some(p), Some(q), None) => {
            out.push([p, b, q]);
            let far = |u: u32, v: u32| (vertices[u as usize] - vertices[v as usize]).norm_squared();
            out.extend(if far(a, q) <= far(p, c) { [[a, p, q], [a, q, c]] } else { [[a, p, c], [p, q, c]] });
        }
        (Some(p), Some(q), Some(r)) => out.extend([[a, p, r], [p, b, q], [r, q, c], [p, q, r]]),
        _ => out.push(*corners),
    }
}
