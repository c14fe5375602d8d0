//! A part's file as it was read: its facets and its digest, before unit and placement. A part is built from it
//! anew whenever those change, without reading again.

use super::stl::{self, RawPart};
use super::{LoadError, Part, Placement, Units, digest_of, stl::StlError};
use crate::progress::Progress;
use std::path::Path;

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
        placement: &Placement,
        flipped_shells: &[u32],
        progress: &Progress,
    ) -> Result<Option<Part>, StlError> {
        Part::built(self, units, placement, flipped_shells, progress)
    }
}
