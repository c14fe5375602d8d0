//! Patches that are ground off: the part with what stands on them, what each pass takes, and the surfaces that are left for
//! a pass. Heights are given at the vertices of the patches; here nothing is measured.

use super::PatchedPart;
use crate::part::ground::{CentrePoint, Ground};
use crate::part::growth::{Folds, GrownPart, GrowthError, laid_on};
use crate::part::surface::listed;
use crate::part::topology::Mesh;
use crate::part::{Part, Surfaces};
use crate::progress::{Cancelled, Progress};
use std::collections::BTreeMap;

/// What is ground of a patch.
#[derive(Clone, Debug, Default)]
pub struct GroundPatch {
    /// The height that each pass grinds down to, mm, falling; none where nothing stands on the patch.
    pub levels_mm: Vec<f64>,
    /// The centre line of a bead, part frame.
    pub centre_line: Vec<CentrePoint>,
}

/// What is ground of all patches, in their order; heights are the depths that the patches were cut by.
pub fn grounds(patched: &PatchedPart, patches: &[GroundPatch]) -> Vec<Ground> {
    let pieces = patched.patches.iter().zip(patches).flat_map(|(pieces, of)| pieces.iter().map(move |p| (p, of)));
    let ground = |(piece, of): (&super::PatchSurface, &GroundPatch)| {
        let facets = patched.surfaces.get(piece.surface.0).map_or(&[][..], |s| &s.facets);
        let vertices = facets.iter().flat_map(|&f| patched.part.mesh.facets[f as usize]);
        let height_mm: BTreeMap<u32, f64> = match of.levels_mm.is_empty() {
            true => BTreeMap::new(),
            false => vertices.map(|v| (v, patched.depth_mm[v as usize].max(0.0))).collect(),
        };
        let (levels_mm, centre_line) = (of.levels_mm.clone(), of.centre_line.clone());
        Ground { surface: piece.surface.0, cut_from: piece.cut_from.0, height_mm, levels_mm, centre_line }
    };
    pieces.map(ground).collect()
}

/// The part with everything standing on it that is to be ground: what surrounds the tool before the first pass.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn standing(part: &Part, surfaces: &Surfaces, progress: &Progress) -> Result<GrownPart, Cancelled> {
    let height = |facet: u32, vertex: u32| surfaces.ground(surfaces.of_facet[facet as usize])?.standing_mm(vertex, 0);
    // A bead is there, however steep its sides are.
    match laid_on(part, surfaces, &height, Folds::AreTaken, progress) {
        Ok(raised) => Ok(raised),
        // Nothing else is an error where folds are taken.
        Err(GrowthError::Cancelled | GrowthError::Folds(_)) => Err(Cancelled),
    }
}

/// The surfaces that a pass, from 1, grinds: facets on which nothing stands above its level belong to the surface that they
/// were cut out of.
pub fn before_pass(mesh: &Mesh, mut surfaces: Surfaces, pass: u32) -> Surfaces {
    for ground in surfaces.grounds.iter().filter(|g| g.is_bead()) {
        let facets = surfaces.list.iter().find(|s| s.number == ground.surface).map_or(&[][..], |s| &s.facets);
        for &f in facets.iter().filter(|&&f| ground.is_below(&mesh.facets[f as usize], pass)) {
            surfaces.of_facet[f as usize] = ground.cut_from;
        }
    }
    surfaces.list = listed(mesh, &surfaces.of_facet);
    surfaces
}
