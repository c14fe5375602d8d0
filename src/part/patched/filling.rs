//! Patches that beads fill: what each of their surfaces needs, and the surfaces that are left once some layers are laid.

use super::{PatchSurface, PatchedPart, layer_count};
use crate::part::Surfaces;
use crate::part::fill::Fill;
use crate::part::surface::listed;
use crate::part::topology::Mesh;
use std::collections::BTreeMap;

/// What beads of a height are to fill of all patches, whose depths are these, mm. One for which the bead is too low by far
/// gets none.
pub fn fills(patched: &PatchedPart, depths_mm: &[f64], bead_mm: f64) -> Vec<Fill> {
    let pieces = patched.patches.iter().zip(depths_mm).flat_map(|(pieces, mm)| pieces.iter().map(move |p| (p, *mm)));
    pieces.filter_map(|(piece, depth_mm)| fill(patched, piece, depth_mm, bead_mm)).collect()
}

/// A surface of a patch is filled in as many layers as all of the patch.
fn fill(patched: &PatchedPart, piece: &PatchSurface, depth_mm: f64, bead_mm: f64) -> Option<Fill> {
    let layers = layer_count(depth_mm, bead_mm).ok()?;
    let facets = &patched.surfaces.get(piece.surface.0)?.facets;
    let vertices = facets.iter().flat_map(|&f| patched.part.mesh.facets[f as usize]);
    let depth_mm: BTreeMap<u32, f64> = vertices.map(|v| (v, patched.depth_mm[v as usize].max(0.0))).collect();
    Some(Fill { surface: piece.surface.0, cut_from: piece.cut_from.0, bead_mm, layers, depth_mm })
}

/// The surfaces once so many layers are laid: facets that are filled belong to the surface that they were cut out of.
pub fn after_layers(mesh: &Mesh, mut surfaces: Surfaces, layers: u32) -> Surfaces {
    if surfaces.fills.is_empty() {
        return surfaces;
    }
    for fill in &surfaces.fills {
        let facets = surfaces.list.iter().find(|s| s.number == fill.surface).map_or(&[][..], |s| &s.facets);
        for &f in facets.iter().filter(|&&f| fill.is_filled(&mesh.facets[f as usize], layers)) {
            surfaces.of_facet[f as usize] = fill.cut_from;
        }
    }
    surfaces.list = listed(mesh, &surfaces.of_facet);
    surfaces
}
