//! A part as its scan found it: pieces of patches move along their surface to where the scan has its points. Numbers of
//! facets, vertices and surfaces stay.

use super::PatchedPart;
use crate::part::growth::{Folds, GrownPart, GrowthError, laid_on};
use crate::part::{Part, Surfaces};
use crate::progress::{Cancelled, Progress};

/// What of the depths moves vertices.
#[derive(Clone, Copy, Debug)]
pub struct ScannedShape {
    /// Vertices at which there is so much too much, or more, are raised by it, mm. In triangles at the rim of what is
    /// built up the part is less than this too low.
    pub raised_from_mm: f64,
    /// What is lowered.
    pub lowered: Lowered,
}

/// What of a part is lowered to where its scan found it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lowered {
    /// Nothing: what is missing is taken to be there.
    Nothing,
    /// Patches, to their floor.
    Patches,
    /// Everything whose depth is known.
    All,
}

/// Moves the vertices of a patched part by their depths.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn shaped(patched: &PatchedPart, shape: &ScannedShape, progress: &Progress) -> Result<(Part, Surfaces), Cancelled> {
    let PatchedPart { part, surfaces, patches, depth_mm, .. } = patched;
    let mut is_floor = vec![false; part.mesh.facets.len()];
    if shape.lowered == Lowered::Patches {
        let of_patches = patches.iter().flatten().filter_map(|piece| surfaces.get(piece.surface.0));
        of_patches.flat_map(|s| &s.facets).for_each(|&f| is_floor[f as usize] = true);
    }
    let height = |facet: u32, vertex: u32| {
        let height_mm = -depth_mm[vertex as usize];
        let is_lowered = is_floor[facet as usize] || shape.lowered == Lowered::All;
        let is_moved = height_mm >= shape.raised_from_mm || is_lowered && height_mm < 0.0;
        is_moved.then_some(height_mm)
    };
    // What was scanned is there, however steep its sides are.
    match laid_on(part, surfaces, &height, Folds::AreTaken, progress) {
        Ok(GrownPart { part, surfaces }) => Ok((part, surfaces)),
        // Nothing else is an error where folds are taken.
        Err(GrowthError::Cancelled | GrowthError::Folds(_)) => Err(Cancelled),
    }
}
