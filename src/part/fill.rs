//! What beads are to fill of a surface: depths at its vertices and the bead's height, kept with the surfaces so that
//! whoever plans layers knows where each is needed. Which surfaces those are is told by `patched`.

use std::collections::BTreeMap;

/// What is missing on a surface that was cut out as a patch, and the beads that are to fill it. Lengths mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Fill {
    /// Number of the surface.
    pub surface: u32,
    /// Number of the surface that it was cut out of: what is filled is that again.
    pub cut_from: u32,
    /// Height of a bead.
    pub bead_mm: f64,
    /// How many beads lie on top of each other where the patch is deepest.
    pub layers: u32,
    /// Depth at each of its vertices.
    pub depth_mm: BTreeMap<u32, f64>,
}

/// Depths within this of a bead's upper side are filled by it: contours are cut through vertices there, to the digits of
/// a depth.
const FILLED_MM: f64 = 1e-9;

impl Fill {
    /// What beads have filled at a vertex once so many layers are laid; `None` where nothing is missing.
    pub fn filled_mm(&self, vertex: u32, layers: u32) -> Option<f64> {
        Some(self.depth_mm.get(&vertex)?.min(self.bead_mm * f64::from(layers)))
    }

    /// Whether a facet with these corners is filled once so many layers are laid.
    pub fn is_filled(&self, corners: &[u32; 3], layers: u32) -> bool {
        let filled_mm = self.bead_mm * f64::from(layers) + FILLED_MM;
        corners.iter().all(|v| self.depth_mm.get(v).is_none_or(|depth_mm| *depth_mm <= filled_mm))
    }
}
