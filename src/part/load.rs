//! From the bytes of an STL file to a part that can be planned on.

use super::inspect::Findings;
use super::merge_tree::{MergeTree, dihedral_angles};
use super::orient::{Orientation, orient};
use super::stl::{FacetFault, StlError};
use super::topology::Dead;
use super::{Bvh, Digest, Hasher, Mesh, Placement, Source, Units};
use crate::progress::{Activity, Progress};
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
    #[error("{file}: not read: {source}")]
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
        let made = Source::from_bytes(bytes)?.part(units, placement, flipped_shells, &Progress::default())?;
        // Nobody can have cancelled it.
        Ok(made.unwrap_or_default())
    }

    /// Welds, places and orients facets that were read. `None`: the work was cancelled.
    pub(super) fn built(
        source: &Source,
        units: Units,
        placement: &Placement,
        flipped_shells: &[u32],
        progress: &Progress,
    ) -> Result<Option<Part>, StlError> {
        progress.begin(Activity::BuildingPart, 5);
        let mut mesh = Mesh::weld(&source.raw.facets, units.mm());
        if progress.step().is_err() {
            return Ok(None);
        }
        if *placement != Placement::default() {
            for v in &mut mesh.vertices {
                *v = placement.apply(v);
            }
            mesh.update_geometry();
        }
        if mesh.dead.iter().all(|d| *d != Dead::No) {
            return Err(StlError::NoFacet { dropped: mesh.facets.len(), first: Some(FacetFault::NoArea) });
        }
        let orientation = orient(&mut mesh);
        for f in 0..mesh.facets.len() {
            if flipped_shells.contains(&orientation.shell_of[f]) {
                mesh.flip(f);
            }
        }
        let findings = Findings::new(&source.raw, &mesh, &orientation, units);
        if progress.step().is_err() {
            return Ok(None);
        }
        let dihedral_deg = dihedral_angles(&mesh);
        let tree = MergeTree::new(&mesh, &dihedral_deg);
        if progress.step().is_err() {
            return Ok(None);
        }
        let bvh = Bvh::new(&mesh);
        let digest = Hasher::default().of(&source.sha256).of(&units).of(placement).of(flipped_shells).finish();
        let sha256 = source.sha256.clone();
        Ok(Some(Part { mesh, orientation, findings, dihedral_deg, tree, bvh, digest, sha256 }))
    }
}
