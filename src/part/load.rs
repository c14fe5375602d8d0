//! From the bytes of an STL file to a part that can be planned on.

use super::inspect::Findings;
use super::merge_tree::{MergeTree, dihedral_angles};
use super::orient::{Orientation, orient};
use super::stl::{self, RawPart, StlError};
use super::topology::Dead;
use super::{Bvh, Digest, Hasher, Mesh, Placement, Units};
use std::path::Path;
use thiserror::Error;

/// A part: its mesh in the part frame, oriented, and what is computed from it once.
#[derive(Clone, Debug, Default)]
pub struct Part {
    /// The mesh, mm.
    pub mesh: Mesh,
    /// Shells and what was turned.
    pub orientation: Orientation,
    /// What the file held and what was dropped.
    pub findings: Findings,
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

/// Why a part cannot be loaded.
#[derive(Debug, Error)]
pub enum LoadError {
    /// The file cannot be read.
    #[error("{file}: cannot be read: {source}")]
    Io {
        /// The file.
        file: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// It can, but is no usable STL.
    #[error("{file}: {source}")]
    Stl {
        /// The file.
        file: String,
        /// What is wrong.
        source: StlError,
    },
}

/// Reads an STL file.
pub fn load(file: &Path, units: Units, placement: &Placement, flipped_shells: &[u32]) -> Result<Part, LoadError> {
    let name = || file.display().to_string();
    let bytes = std::fs::read(file).map_err(|source| LoadError::Io { file: name(), source })?;
    Part::from_bytes(&bytes, units, placement, flipped_shells).map_err(|source| LoadError::Stl { file: name(), source })
}

impl Part {
    /// Parses, welds, places and orients a part.
    pub fn from_bytes(
        bytes: &[u8],
        units: Units,
        placement: &Placement,
        flipped_shells: &[u32],
    ) -> Result<Part, StlError> {
        let raw = stl::read(bytes)?;
        let sha256 = super::digest::file_sha256(bytes);
        Part::from_raw(&raw, sha256, units, placement, flipped_shells)
    }

    /// The same from facets that were read already.
    ///
    /// # Errors
    /// No facet has any area.
    pub fn from_raw(
        raw: &RawPart,
        sha256: String,
        units: Units,
        placement: &Placement,
        flipped_shells: &[u32],
    ) -> Result<Part, StlError> {
        let mut mesh = Mesh::weld(&raw.facets, units.mm());
        if *placement != Placement::default() {
            for v in &mut mesh.vertices {
                *v = placement.apply(v);
            }
            mesh.update_geometry();
        }
        if mesh.dead.iter().all(|d| *d != Dead::No) {
            return Err(StlError::NoFacet { dropped: mesh.facets.len(), first: "no area" });
        }
        let orientation = orient(&mut mesh);
        for f in 0..mesh.facets.len() {
            if flipped_shells.contains(&orientation.shell_of[f]) {
                mesh.flip(f);
            }
        }
        let findings = Findings::new(raw, &mesh, &orientation, units);
        let dihedral_deg = dihedral_angles(&mesh);
        let tree = MergeTree::new(&mesh, &dihedral_deg);
        let bvh = Bvh::new(&mesh);
        let p = placement;
        let digest = Hasher::default()
            .bytes(sha256.as_bytes())
            .f64s(&[units.mm(), p.scale])
            .f64s(&p.rotation_deg)
            .f64s(&p.translation_mm)
            .u32s(flipped_shells)
            .finish();
        Ok(Part { mesh, orientation, findings, dihedral_deg, tree, bvh, digest, sha256 })
    }
}
