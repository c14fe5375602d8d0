//! From a part's file, or its bytes, straight to a part.

use super::file::PartFileError;
use super::{LoadError, Part, Placement, Source, Units};
use crate::progress::Progress;
use std::path::Path;

/// Reads a part's file in a unit, whatever unit it states itself.
pub fn load(file: &Path, units: Units, placement: &Placement, flipped_shells: &[u32]) -> Result<Part, LoadError> {
    let made = Source::read(file)?.part(units, placement, flipped_shells, &Progress::default());
    let part = made.map_err(|source| LoadError::Unusable { file: file.display().to_string(), source })?;
    // It cannot have been cancelled: nobody else holds this progress.
    Ok(part.unwrap_or_default())
}

impl Part {
    /// Parses, welds, places and orients a part.
    pub fn from_bytes(
        bytes: &[u8],
        units: Units,
        placement: &Placement,
        flipped_shells: &[u32],
    ) -> Result<Part, PartFileError> {
        let made = Source::from_bytes(bytes)?.part(units, placement, flipped_shells, &Progress::default())?;
        Ok(made.unwrap_or_default())
    }
}
