//! A part on which patches are feature surfaces of their own: its facets are cut along the contour of a depth, and what
//! lies deeper gets numbers behind all others. What is planned on a patch alone ends at its outline.
//!
//! The shape of the part stays: every piece lies in the plane of the facet it comes of; `shaped` moves the pieces to
//! where the scan found them. `layers` tells how many beads fill a patch, and where; `filling` keeps that with the surfaces.
//! Which patches there are, and where the part is refined, is told by whoever measured the depths; here nothing is
//! measured.

mod contour;
mod filling;
mod grinding;
mod layers;
mod levels;
mod normals;
mod shaped;

use super::merge_tree::dihedral_angles;
use super::orient::Orientation;
use super::surface::listed;
use super::{Bvh, Hasher, MergeTree, Mesh, Part, SurfaceId, Surfaces};
use crate::progress::{Cancelled, Progress};
use contour::{NO_PATCH, Piece};
use levels::Levelled;
use nalgebra::Point3;
use normals::kept_normals;
use std::collections::BTreeMap;

pub use filling::{after_layers, fills};
pub use grinding::{GroundPatch, before_pass, grounds, standing};
pub use layers::{LayersError, PatchLayer, layer_count, patch_layers};
pub use shaped::{Lowered, ScannedShape, shaped};

/// Depths over a refined piece of a part, mm, linear within each triangle.
///
/// Indices are in range. Each refined facet is covered once by its triangles, wound like it; neighbours share their
/// vertices, and corners of the part have its exact coordinates. Facets that are not named stay as they are.
#[derive(Clone, Copy, Debug)]
pub struct RefinedFacets<'a> {
    /// Places of the vertices, part frame, mm.
    pub vertices: &'a [Point3<f64>],
    /// Vertices of each triangle.
    pub triangles: &'a [[u32; 3]],
    /// The facet of the part that each triangle is a piece of, ascending.
    pub parent: &'a [u32],
    /// Depth at each vertex, mm; NaN where it is not known, and no triangle of such a vertex is in a patch.
    pub depth_mm: &'a [f64],
}

/// What is cut out of a part as patches.
#[derive(Clone, Copy, Debug)]
pub struct PatchCut<'a> {
    /// What is deeper than this is in a patch, mm.
    pub above_mm: f64,
    /// Deeper contours along which patches are cut as well, so that each piece lies on one side of them, mm, ascending.
    pub levels_mm: &'a [f64],
    /// For each patch, in the order in which their surfaces are numbered, the triangles that it lies in, whole or in
    /// part. What lies deep in no triangle that is named stays where it is.
    pub triangles: &'a [Vec<u32>],
}

/// A part with patches, and its surfaces.
#[derive(Clone, Debug, Default)]
pub struct PatchedPart {
    /// The part; figures of its file are those of the part without patches.
    pub part: Part,
    /// Its surfaces: those of the part without patches, which keep their numbers and have what the patches leave them,
    /// and the patches'.
    pub surfaces: Surfaces,
    /// The facet of the part without patches that each facet is a piece of.
    pub parent: Vec<u32>,
    /// The surfaces of each patch, in the order of the cut.
    pub patches: Vec<Vec<PatchSurface>>,
    /// Depth at each vertex, mm; NaN where it is not known.
    pub depth_mm: Vec<f64>,
}

/// What a patch has of one feature surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchSurface {
    /// Its number.
    pub surface: SurfaceId,
    /// The surface that it was cut out of.
    pub cut_from: SurfaceId,
    /// Its area, mm².
    pub area_mm2: f64,
}

/// Makes patches surfaces of a part: of each one for every feature surface that it touches, in the order of their
/// numbers. All others keep the numbers that they have in `surfaces`; one that is swallowed whole is not listed.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn with_patches(
    part: &Part,
    surfaces: &Surfaces,
    refined: &RefinedFacets<'_>,
    cut: &PatchCut<'_>,
    progress: &Progress,
) -> Result<PatchedPart, Cancelled> {
    let Levelled { pieces, depth_mm: depth_of_refined_mm } = Levelled::new(refined, cut);
    progress.check()?;
    let (vertices, vertex_of) = vertices(part, refined, pieces.cut_points);
    let mut depth_mm = vec![f64::NAN; vertices.len()];
    vertex_of.iter().zip(depth_of_refined_mm).for_each(|(&v, mm)| depth_mm[v as usize] = mm);
    let added_from = part.mesh.vertices.len();
    let (mut facets, mut parent, mut patch_of) = (Vec::new(), Vec::new(), Vec::new());
    let mut rest = pieces.pieces.as_slice();
    for (f, corners) in part.mesh.facets.iter().enumerate() {
        let own = rest.iter().take_while(|p| p.parent == f as u32).count();
        if own == 0 {
            facets.push(*corners);
            parent.push(f as u32);
            patch_of.push(NO_PATCH);
        }
        for Piece { corners, patch, .. } in &rest[..own] {
            facets.push(corners.map(|v| vertex_of[v as usize]));
            parent.push(f as u32);
            patch_of.push(*patch);
        }
        rest = &rest[own..];
    }
    let mesh = Mesh::from_indexed(vertices, facets);
    progress.check()?;
    let (surfaces, patches) = numbered(&mesh, part, surfaces, &parent, &patch_of, cut.triangles.len());
    let mut digest = Hasher::default().digest(part.digest).of(&mesh.vertices[added_from..]);
    digest = digest.u32s(mesh.facets.as_flattened()).u32s(&patch_of);
    for n in &surfaces.vertex_normals {
        digest = digest.u32s(&[n.surface, n.vertex]).of(&n.normal);
    }
    let orientation = Orientation {
        shell_of: parent.iter().map(|&f| part.orientation.shell_of[f as usize]).collect(),
        watertight: (0..mesh.edges.len() as u32).all(|e| mesh.edge_facets(e).len() == 2),
        ..part.orientation.clone()
    };
    let dihedral_deg = dihedral_angles(&mesh);
    progress.check()?;
    let tree = MergeTree::new(&mesh, &dihedral_deg);
    progress.check()?;
    let bvh = Bvh::built(&mesh, progress)?;
    let (figures, sha256, digest) = (part.figures.clone(), part.sha256.clone(), digest.finish());
    let part = Part { mesh, orientation, figures, dihedral_deg, tree, bvh, digest, sha256 };
    Ok(PatchedPart { part, surfaces, parent, patches, depth_mm })
}

/// The part's vertices, then those that were added; and which of them each refined vertex and cut point is.
fn vertices(part: &Part, refined: &RefinedFacets<'_>, cut_points: Vec<Point3<f64>>) -> (Vec<Point3<f64>>, Vec<u32>) {
    let mesh = &part.mesh;
    let mut of_part = vec![None; refined.vertices.len()];
    for (triangle, &f) in refined.triangles.iter().zip(refined.parent) {
        for &v in triangle {
            let is_there = |c: &&u32| mesh.vertices[**c as usize] == refined.vertices[v as usize];
            if let Some(&corner) = mesh.facets[f as usize].iter().find(is_there) {
                of_part[v as usize] = Some(corner);
            }
        }
    }
    let mut all = mesh.vertices.clone();
    let places = refined.vertices.iter().copied().zip(of_part);
    let vertex_of = places.chain(cut_points.into_iter().map(|p| (p, None))).map(|(p, corner)| {
        corner.unwrap_or_else(|| {
            all.push(p);
            all.len() as u32 - 1
        })
    });
    let vertex_of = vertex_of.collect();
    (all, vertex_of)
}

/// The surfaces by the numbers of the facets that the pieces come of, and of the patches.
fn numbered(
    mesh: &Mesh,
    bare: &Part,
    surfaces: &Surfaces,
    parent: &[u32],
    patch_of: &[u32],
    patch_count: usize,
) -> (Surfaces, Vec<Vec<PatchSurface>>) {
    let of_parent = |f: usize| surfaces.of_facet[parent[f] as usize];
    let in_patch = |f: &usize| patch_of[*f] != NO_PATCH;
    let mut numbers: BTreeMap<(u32, u32), u32> =
        (0..parent.len()).filter(in_patch).map(|f| ((patch_of[f], of_parent(f)), 0)).collect();
    let mut last_number = surfaces.last_number;
    for number in numbers.values_mut() {
        last_number += 1;
        *number = last_number;
    }
    let number = |f: usize| numbers.get(&(patch_of[f], of_parent(f))).copied().unwrap_or_else(|| of_parent(f));
    let of_facet: Vec<u32> = (0..parent.len()).map(number).collect();
    let normals = mesh.normals.iter().zip(parent).map(|(n, &f)| {
        let is_turned = surfaces.normals[f as usize] != bare.mesh.normals[f as usize];
        if is_turned { -n } else { *n }
    });
    let is_cut = |f: &usize| mesh.facets[*f] != bare.mesh.facets[parent[*f] as usize];
    let pieces = (0..parent.len()).filter(is_cut).map(|f| (parent[f], of_facet[f], mesh.facets[f]));
    let vertex_normals = kept_normals(bare, surfaces, &mesh.vertices, pieces);
    let (normals, list) = (normals.collect(), listed(mesh, &of_facet));
    let surfaces = Surfaces {
        normals,
        list,
        of_facet,
        last_number,
        worked: None,
        vertex_normals,
        fills: Vec::new(),
        grounds: Vec::new(),
        measured: None,
    };
    let mut patches = vec![Vec::new(); patch_count];
    for ((patch, cut_from), number) in numbers {
        let area_mm2 = surfaces.get(number).map_or(0.0, |s| s.area_mm2);
        let piece = PatchSurface { surface: SurfaceId(number), cut_from: SurfaceId(cut_from), area_mm2 };
        patches[patch as usize].push(piece);
    }
    (surfaces, patches)
}

#[cfg(test)]
mod plan_tests;
#[cfg(test)]
mod tests;
