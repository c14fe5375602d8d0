//! From a part's file, or its bytes, straight to a part.

use super::file::PartFileError;
use super::{LoadError, Part, Placement, Source, Units, Weld};
use crate::progress::Progress;
use std::path::Path;

/// Reads a file of facets in a unit, whatever unit it states itself, welded by equal coordinates alone: whatever only
/// stands in the way needs no closed edges.
pub fn load(file: &Path, units: Units, placement: &Placement, flipped_shells: &[u32]) -> Result<Part, LoadError> {
    let source = Source::read(file)?;
    let made = source.part(units, Weld::Exact, placement, flipped_shells, &Progress::default());
    let made = made.map_err(|source| LoadError::Unusable { file: file.display().to_string(), source })?;
    // It cannot have been cancelled: nobody else holds this progress.
    Ok(made.unwrap_or_default())
}

impl Part {
    /// Parses, welds (as new jobs do), places and orients a part.
    pub fn from_bytes(
        bytes: &[u8],
        units: Units,
        placement: &Placement,
        flipped_shells: &[u32],
    ) -> Result<Part, PartFileError> {
        let source = Source::from_bytes(bytes)?;
        let made = source.part(units, Weld::default(), placement, flipped_shells, &Progress::default())?;
        // Nor this.
        Ok(made.unwrap_or_default())
    }
}
