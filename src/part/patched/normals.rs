//! Normals where facets are cut into pieces. Between the corners of a facet the normal of its surface turns evenly (P2
//! 4.2.3); pieces of it are flat by themselves, and would hold the beam still over the facet and turn it at its rim.

use super::Part;
use crate::part::surfaces::VertexNormal;
use crate::part::topology::FacetDefect;
use crate::part::{Surfaces, angle};
use nalgebra::{Point3, Vector3};
use std::collections::BTreeMap;

/// The normals at the corners of the pieces, by surface and vertex: those that the facets had there before they were cut.
///
/// `pieces`: of each the facet that it comes of, the surface that it is in now, and its corners in `vertices`.
pub(super) fn kept_normals(
    bare: &Part,
    surfaces: &Surfaces,
    vertices: &[Point3<f64>],
    pieces: impl Iterator<Item = (u32, u32, [u32; 3])>,
) -> Vec<VertexNormal> {
    let mut at_corner: BTreeMap<(u32, u32), Vector3<f64>> = BTreeMap::new();
    let mut kept: BTreeMap<(u32, u32), Vector3<f64>> = BTreeMap::new();
    for (parent, surface, corners) in pieces {
        let f = parent as usize;
        if bare.mesh.defects[f] != FacetDefect::None {
            continue;
        }
        let of = surfaces.of_facet[f];
        let ends = bare.mesh.facets[f];
        let normals = ends.map(|v| *at_corner.entry((of, v)).or_insert_with(|| corner_normal(bare, surfaces, f, v)));
        for v in corners {
            kept.entry((surface, v)).or_insert_with(|| {
                if let Some(k) = ends.iter().position(|&end| end == v) {
                    return normals[k];
                }
                let shares = shares(&bare.mesh.corners(f), &vertices[v as usize]);
                let sum = normals[0] * shares[0] + normals[1] * shares[1] + normals[2] * shares[2];
                angle::unit(sum).unwrap_or(surfaces.normals[f])
            });
        }
    }
    kept.into_iter().map(|((surface, vertex), normal)| VertexNormal { surface, vertex, normal }).collect()
}

/// The normal at a corner of a facet, over the facets of its surface there, weighed by their angles.
fn corner_normal(bare: &Part, surfaces: &Surfaces, facet: usize, vertex: u32) -> Vector3<f64> {
    let mesh = &bare.mesh;
    let mut sum = Vector3::zeros();
    for g in mesh.vertex_facets(vertex).iter().map(|&g| g as usize) {
        if surfaces.of_facet[g] != surfaces.of_facet[facet] || mesh.defects[g] != FacetDefect::None {
            continue;
        }
        let Some(k) = mesh.facets[g].iter().position(|&v| v == vertex) else { continue };
        let c = mesh.corners(g);
        let [here, next, before] = [c[k], c[(k + 1) % 3], c[(k + 2) % 3]];
        sum += surfaces.normals[g] * angle::between_deg(&(next - here), &(before - here));
    }
    // Facets that cancel out: the facet's own.
    if sum.norm() < 1e-6 { surfaces.normals[facet] } else { sum.normalize() }
}

/// The shares of the corners of a triangle at a point of its plane; they add up to 1.
fn shares([a, b, c]: &[Point3<f64>; 3], p: &Point3<f64>) -> [f64; 3] {
    let across = (b - a).cross(&(c - a));
    let whole = across.norm_squared();
    let [second, third] = [(p - a).cross(&(c - a)), (b - a).cross(&(p - a))].map(|v| v.dot(&across) / whole);
    [1.0 - second - third, second, third]
}
