//! The part that everything is planned on: its mesh, and what is computed from it once.

use super::orient::Orientation;
use super::part_figures::PartFigures;
use super::{Bvh, Digest, MergeTree, Mesh};

/// A part: its mesh in the part frame, oriented, and what is computed from it once.
#[derive(Clone, Debug, Default)]
pub struct Part {
    /// The mesh, mm.
    pub mesh: Mesh,
    /// Shells and what was turned.
    pub orientation: Orientation,
    /// What was counted in the file.
    pub figures: PartFigures,
    /// Dihedral angle of each edge, degrees.
    pub dihedral_deg: Vec<f64>,
    /// Feature surfaces at every angle.
    pub tree: MergeTree,
    /// Rays against the part.
    pub bvh: Bvh,
    /// Changes with the file, the unit, the placement and the turned shells.
    pub digest: Digest,
    /// SHA-256 of the file.
    pub sha256: String,
}
