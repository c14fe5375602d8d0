//! A surface mesh cut finer, until its edges are no longer than asked, or as fine as the limit of pieces allows.

use super::super::normals::between;
use super::surface_mesh::{SurfaceMesh, split};
use crate::part::Mesh;
use crate::progress::{Cancelled, Progress};
use nalgebra::Point3;
use rayon::prelude::*;

/// Greatest number of pieces of a surface; at least a fifth more than it has facets are allowed.
const MOST_PIECES: f64 = 150_000.0;
/// Every pass halves what is too long: these are more than any f64 length needs.
const PASSES: usize = 40;

impl SurfaceMesh {
    /// Cuts facets until no edge is longer than `size_mm` at its middle. Where that takes more pieces
    /// than there is time for, all sizes grow alike. `even`: slivers in one plane are turned into better
    /// facets on the way.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn refined(
        self,
        even: bool,
        size_mm: impl Fn(&Point3<f64>) -> f64 + Sync,
        progress: &Progress,
    ) -> Result<SurfaceMesh, Cancelled> {
        let most = MOST_PIECES.max(1.2 * self.mesh.facets.len() as f64);
        let mut scale = 1.0;
        while self.pieces(&size_mm, scale) > most {
            progress.check()?;
            scale *= 1.2;
        }
        if !even {
            return self.halved(most, |p| scale * size_mm(p), progress);
        }
        let mut surface_mesh = self;
        // Slivers between coplanar facets first: what they are cut into would be slivers too.
        for _ in 0..60 {
            let Some(turned) = surface_mesh.flipped(progress)? else { break };
            surface_mesh = turned;
        }
        for _ in 0..PASSES {
            let long: Vec<u32> = (0..surface_mesh.mesh.edges.len() as u32)
                .filter(|&e| surface_mesh.length_mm(e) > scale * size_mm(&surface_mesh.on_edge(e, 0.5).p))
                .collect();
            if long.is_empty() || surface_mesh.mesh.facets.len() as f64 > 4.0 * most {
                break;
            }
            surface_mesh = surface_mesh.cut(&long.iter().map(|&e| (e, 0.5)).collect::<Vec<_>>(), progress)?.0;
            surface_mesh = surface_mesh.flipped(progress)?.unwrap_or(surface_mesh);
        }
        Ok(surface_mesh)
    }

    /// Halves edges that are longer than a size at their middle, and cuts the facets beside them, until none is
    /// left. The topology is built once, behind the last pass.
    fn halved(
        self,
        most: f64,
        size_mm: impl Fn(&Point3<f64>) -> f64 + Sync,
        progress: &Progress,
    ) -> Result<SurfaceMesh, Cancelled> {
        let SurfaceMesh { mesh, mut normals } = self;
        let Mesh { mut vertices, mut facets, .. } = mesh;
        // A facet that was not cut has no long edge: only the pieces of the last pass are looked at.
        let mut fresh: Vec<u32> = (0..facets.len() as u32).collect();
        for _ in 0..PASSES {
            progress.check()?;
            let long_edges = |&f: &u32| {
                let corners = facets[f as usize];
                let long = [0, 1, 2].map(|k| {
                    let [a, b] = ends(&corners, k);
                    let (p, q) = (vertices[a as usize], vertices[b as usize]);
                    (q - p).norm() > size_mm(&(p + (q - p) * 0.5))
                });
                long.contains(&true).then_some((f, long))
            };
            let found: Vec<(u32, [bool; 3])> = fresh.par_iter().filter_map(long_edges).collect();
            let edges = |&(f, long): &(u32, [bool; 3])| {
                let corners = facets[f as usize];
                (0..3).filter(move |&k| long[k]).map(move |k| ends(&corners, k))
            };
            let mut cuts: Vec<[u32; 2]> = found.iter().flat_map(edges).collect();
            cuts.par_sort_unstable();
            cuts.dedup();
            if cuts.is_empty() || facets.len() as f64 > 4.0 * most {
                break;
            }
            let first = vertices.len() as u32;
            for &[a, b] in &cuts {
                let (p, q) = (vertices[a as usize], vertices[b as usize]);
                vertices.push(p + (q - p) * 0.5);
                normals.push(between(&normals[a as usize], &normals[b as usize], 0.5));
            }
            fresh.clear();
            for (number, (f, long)) in found.into_iter().enumerate() {
                progress.check_at(number)?;
                let corners = facets[f as usize];
                let middle = |k: usize| cuts.binary_search(&ends(&corners, k)).ok().map(|i| first + i as u32);
                let cut = [0, 1, 2].map(|k| long[k].then(|| middle(k)).flatten());
                let from = facets.len() as u32;
                split(&corners, cut, &vertices, &mut facets);
                // The last piece takes the place of the whole.
                facets.swap_remove(f as usize);
                fresh.push(f);
                fresh.extend(from..facets.len() as u32);
            }
        }
        Ok(SurfaceMesh { mesh: Mesh::from_indexed_under(progress, vertices, facets)?, normals })
    }

    /// The other diagonal for pairs of facets in one plane, where it makes their angles wider (Delaunay);
    /// no facet twice. `None` where there is nothing to turn.
    fn flipped(&self, progress: &Progress) -> Result<Option<SurfaceMesh>, Cancelled> {
        let mesh = &self.mesh;
        let mut facets = mesh.facets.clone();
        let mut touched = vec![false; facets.len()];
        let mut any = false;
        for e in 0..mesh.edges.len() as u32 {
            progress.check_at(e as usize)?;
            let Some([f, g]) = mesh.smooth_pair(e).map(|p| p.map(|f| f as usize)) else { continue };
            if touched[f] || touched[g] || mesh.normals[f].dot(&mesh.normals[g]) < 1.0 - 1e-9 {
                continue;
            }
            let side = |h: usize| mesh.facet_edges[h].iter().position(|&x| x == e);
            let (Some(i), Some(j)) = (side(f), side(g)) else { continue };
            let [a, b, c] = [0, 1, 2].map(|k| mesh.facets[f][(i + k) % 3]);
            let d = mesh.facets[g][(j + 2) % 3];
            let at = |v: u32| mesh.vertices[v as usize];
            let n = &mesh.normals[f];
            let angle = |p: u32, q: u32, r: u32| {
                let (u, v) = (at(p) - at(q), at(r) - at(q));
                libm::atan2(u.cross(&v).norm(), u.dot(&v))
            };
            let turns = |p: u32, q: u32, r: u32| (at(q) - at(p)).cross(&(at(r) - at(p))).dot(n);
            // Points of the new diagonal stay on the part: within what coordinates can tell.
            let flat = (at(d) - at(a)).dot(n).abs() < 3e-7;
            let wide = angle(a, c, b) + angle(b, d, a) > std::f64::consts::PI + 1e-6;
            if flat && wide && turns(d, b, c) > 0.0 && turns(c, a, d) > 0.0 {
                (facets[f], facets[g]) = ([d, b, c], [c, a, d]);
                (touched[f], touched[g]) = (true, true);
                any = true;
            }
        }
        if !any {
            return Ok(None);
        }
        let mesh = Mesh::from_indexed_under(progress, mesh.vertices.clone(), facets)?;
        Ok(Some(SurfaceMesh { mesh, normals: self.normals.clone() }))
    }

    /// About how many pieces that takes.
    fn pieces(&self, size_mm: &(impl Fn(&Point3<f64>) -> f64 + Sync), scale: f64) -> f64 {
        let size = |p: &Point3<f64>| scale * size_mm(p);
        let facets = (0..self.mesh.facets.len()).into_par_iter();
        // Added up in their order: the same sum on any number of threads.
        facets.map(|f| pieces(&self.mesh.corners(f), &size, 8)).collect::<Vec<f64>>().iter().sum()
    }
}

/// The edge of a facet from a corner to the next, by lower and higher vertex.
fn ends(corners: &[u32; 3], k: usize) -> [u32; 2] {
    let (a, b) = (corners[k], corners[(k + 1) % 3]);
    [a.min(b), a.max(b)]
}

/// About how many pieces a facet is cut into; looked at in quarters while sizes differ much in it.
fn pieces(corners: &[Point3<f64>; 3], size_mm: &impl Fn(&Point3<f64>) -> f64, depth: usize) -> f64 {
    let [a, b, c] = *corners;
    let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
    let sizes = [size_mm(&a), size_mm(&b), size_mm(&c), size_mm(&(a + ((b - a) + (c - a)) / 3.0))];
    let (least, most) = sizes.iter().fold((f64::INFINITY, 0.0f64), |(l, m), &s| (l.min(s), m.max(s)));
    if longest <= least {
        return 1.0;
    }
    if most > 1.5 * least && depth > 0 {
        let (p, q, r) = (nalgebra::center(&a, &b), nalgebra::center(&b, &c), nalgebra::center(&c, &a));
        return [[a, p, r], [p, b, q], [r, q, c], [p, q, r]].iter().map(|t| pieces(t, size_mm, depth - 1)).sum();
    }
    let mean = sizes.iter().sum::<f64>() / 4.0;
    let area = 0.5 * (b - a).cross(&(c - a)).norm();
    (5.0 * area / (mean * mean)).max(2.0 * longest / mean).max(1.0)
}
