//! A part's file as it was read: its facets and its digest, before unit and placement. A part is built from it
//! anew whenever those change, without reading again.

use super::digest::file_sha256_under;
use super::file::{self, PartFileError};
use super::merge_tree::{MergeTree, dihedral_angles_under};
use super::orient::orient_under;
use super::part_figures::PartFigures;
use super::raw_part::{FacetFault, RawPart};
use super::topology::FacetDefect;
use super::units::StatedUnit;
use super::weld::{Joined, Weld, Welded};
use super::{Bvh, Hasher, Mesh, Part, Placement, Units};
use crate::progress::{Activity, Progress};
use std::io::Read as _;
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
    /// A folder is no file.
    #[error("{file}: a folder")]
    Folder {
        /// The folder.
        file: String,
    },
    /// It can, but is no usable part.
    #[error("{file}: {source}")]
    Unusable {
        /// The file.
        file: String,
        /// What is wrong.
        source: PartFileError,
    },
    /// It states another unit than it was to be read in.
    #[error("{file}: {stated:?}, not {units:?}")]
    OtherUnit {
        /// The file.
        file: String,
        /// The unit that it states.
        stated: StatedUnit,
        /// The unit that was given.
        units: Units,
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
    /// It cannot be read, or is no usable part; it is named.
    pub fn read(file: &Path) -> Result<Source, LoadError> {
        // It cannot have been cancelled: nobody else holds this progress.
        Source::read_under(&Progress::default(), file).map(Option::unwrap_or_default)
    }

    /// Reads a part's file as long as nobody wants that to end. `None`: the work was cancelled.
    ///
    /// # Errors
    /// It cannot be read, or is no usable part; it is named.
    pub fn read_under(progress: &Progress, file: &Path) -> Result<Option<Source>, LoadError> {
        let name = || file.display().to_string();
        if file.is_dir() {
            return Err(LoadError::Folder { file: name() });
        }
        let read = bytes_of(file, progress).map_err(|source| LoadError::Io { file: name(), source })?;
        let Some(bytes) = read else { return Ok(None) };
        match Source::of(&bytes, progress) {
            Err(PartFileError::Cancelled) => Ok(None),
            made => made.map(Some).map_err(|source| LoadError::Unusable { file: name(), source }),
        }
    }

    /// Takes the bytes of a part's file.
    ///
    /// # Errors
    /// They are no usable part.
    pub fn from_bytes(bytes: &[u8]) -> Result<Source, PartFileError> {
        Source::of(bytes, &Progress::default())
    }

    fn of(bytes: &[u8], progress: &Progress) -> Result<Source, PartFileError> {
        Ok(Source { raw: file::read_under(progress, bytes)?, sha256: file_sha256_under(progress, bytes)? })
    }

    /// The unit that the file states, as a part can have it; millimetres if it states none.
    pub fn units(&self) -> Units {
        self.raw.stated_unit.map_or_else(Units::default, StatedUnit::taken)
    }

    /// Millimetres in one unit of the coordinates, where they are taken in this unit. A file in centimetres, say, is
    /// taken in millimetres, which makes ten of each.
    fn mm_in(&self, units: Units) -> f64 {
        let stated = self.raw.stated_unit.filter(|s| s.taken() == units);
        stated.map_or(1.0, StatedUnit::in_taken) * units.mm()
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
    ) -> Result<Option<Part>, PartFileError> {
        match self.built(units, weld, placement, flipped_shells, progress) {
            Err(PartFileError::Cancelled) => Ok(None),
            made => made.map(Some),
        }
    }

    fn built(
        &self,
        units: Units,
        weld: Weld,
        placement: &Placement,
        flipped_shells: &[u32],
        progress: &Progress,
    ) -> Result<Part, PartFileError> {
        progress.begin(Activity::BuildingPart, 5);
        let welded = Welded::built(&self.raw.facets, weld, progress)?;
        let mm_per_unit = self.mm_in(units);
        let within = welded.joined.within * mm_per_unit * placement.scale;
        let joined = Joined { within, ..welded.joined };
        let mut mesh = Mesh::built(welded, mm_per_unit, progress)?;
        progress.step()?;
        if *placement != Placement::default() {
            for v in &mut mesh.vertices {
                *v = placement.apply(v);
            }
            mesh.update_geometry_under(progress)?;
        }
        if mesh.defects.iter().all(|d| *d != FacetDefect::None) {
            return Err(PartFileError::NoFacet { dropped: mesh.facets.len(), first: Some(FacetFault::NoArea) });
        }
        let orientation = orient_under(progress, &mut mesh)?;
        for f in (0..mesh.facets.len()).filter(|f| flipped_shells.contains(&orientation.shell_of[*f])) {
            mesh.flip(f);
        }
        progress.check()?;
        let figures = PartFigures::new(&self.raw, joined, &mesh, &orientation, units, [mm_per_unit, placement.scale]);
        progress.step()?;
        let dihedral_deg = dihedral_angles_under(progress, &mesh)?;
        let tree = MergeTree::built(&mesh, &dihedral_deg, progress)?;
        progress.step()?;
        let bvh = Bvh::built(&mesh, progress)?;
        let digest = Hasher::default().of(&self.sha256).of(&units).of(&weld).of(placement).of(flipped_shells).finish();
        let sha256 = self.sha256.clone();
        Ok(Part { mesh, orientation, figures, dihedral_deg, tree, bvh, digest, sha256 })
    }
}

/// So many bytes are read between two looks whether that should end.
const READ_AT_ONCE: u64 = 1 << 20;

/// The bytes of a file; `None`: the work was cancelled.
fn bytes_of(file: &Path, progress: &Progress) -> std::io::Result<Option<Vec<u8>>> {
    let mut file = std::fs::File::open(file)?;
    let mut bytes = Vec::new();
    loop {
        if progress.check().is_err() {
            return Ok(None);
        }
        if (&mut file).take(READ_AT_ONCE).read_to_end(&mut bytes)? == 0 {
            return Ok(Some(bytes));
        }
    }
}
