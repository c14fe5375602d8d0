//! A part's file as it was read: its facets and its digest, before unit and placement. A part is built from it
//! anew whenever those change, without reading again.

use super::merge_tree::{MergeTree, dihedral_angles};
use super::orient::orient;
use super::part_figures::PartFigures;
use super::stl::{self, FacetFault, RawPart, StlError};
use super::topology::FacetDefect;
use super::weld::{Joined, Weld, Welded};
use super::{Bvh, Hasher, Mesh, Part, Placement, Units, digest_of};
use crate::progress::{Activity, Progress};
use std::path::Path;
use thiserror::Error;

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

/// What a part is built from.
#[derive(Debug, Default)]
pub struct Source {
    /// Facets as stored, file units.
    pub raw: RawPart,
    /// SHA-256 of the file's bytes, hexadecimal.
    pub sha256: String,
}

impl Source {
    /// Reads a part's file.
    ///
    /// # Errors
    /// It cannot be read, or is no usable STL; it is named.
    pub fn read(file: &Path) -> Result<Source, LoadError> {
        let name = || file.display().to_string();
        let bytes = std::fs::read(file).map_err(|source| LoadError::Io { file: name(), source })?;
        Source::from_bytes(&bytes).map_err(|source| LoadError::Stl { file: name(), source })
    }

    /// Takes the bytes of a part's file.
    ///
    /// # Errors
    /// They are no usable STL.
    pub fn from_bytes(bytes: &[u8]) -> Result<Source, StlError> {
        Ok(Source { raw: stl::read(bytes)?, sha256: digest_of(bytes) })
    }

    /// Welds, places and orients the part. `None`: the work was cancelled.
    ///
    /// # Errors
    /// No facet has any area.
    pub fn part(
        &self,
        units: Units,
        weld: Weld,
        placement: &Placement,
        flipped_shells: &[u32],
        progress: &Progress,
    ) -> Result<Option<Part>, StlError> {
        progress.begin(Activity::BuildingPart, 5);
        let welded = Welded::new(&self.raw.facets, weld);
        let within = welded.joined.within * units.mm() * placement.scale;
        let joined = Joined { within, ..welded.joined };
        let mut mesh = Mesh::from_welded(welded, units.mm());
        if progress.step().is_err() {
            return Ok(None);
        }
        if *placement != Placement::default() {
            for v in &mut mesh.vertices {
                *v = placement.apply(v);
            }
            mesh.update_geometry();
        }
        if mesh.defects.iter().all(|d| *d != FacetDefect::None) {
            return Err(StlError::NoFacet { dropped: mesh.facets.len(), first: Some(FacetFault::NoArea) });
        }
        let orientation = orient(&mut mesh);
        for f in 0..mesh.facets.len() {
            if flipped_shells.contains(&orientation.shell_of[f]) {
                mesh.flip(f);
            }
        }
        let figures = PartFigures::new(&self.raw, joined, &mesh, &orientation, units);
        if progress.step().is_err() {
            return Ok(None);
        }
        let dihedral_deg = dihedral_angles(&mesh);
        if progress.check().is_err() {
            return Ok(None);
        }
        let tree = MergeTree::new(&mesh, &dihedral_deg);
        if progress.step().is_err() {
            return Ok(None);
        }
        let Ok(bvh) = Bvh::built(&mesh, progress) else { return Ok(None) };
        let digest = Hasher::default().of(&self.sha256).of(&units).of(&weld).of(placement).of(flipped_shells).finish();
        let sha256 = self.sha256.clone();
        Ok(Some(Part { mesh, orientation, figures, dihedral_deg, tree, bvh, digest, sha256 }))
    }
}
