//! From an STL file, or its bytes, straight to a part.

use super::stl::StlError;
use super::{LoadError, Part, Placement, Source, Units, Weld};
use crate::progress::Progress;
use std::path::Path;

/// Reads an STL file, welded as new jobs do.
pub fn load(file: &Path, units: Units, placement: &Placement, flipped_shells: &[u32]) -> Result<Part, LoadError> {
    let name = || file.display().to_string();
    let bytes = std::fs::read(file).map_err(|source| LoadError::Io { file: name(), source })?;
    Part::from_bytes(&bytes, units, placement, flipped_shells).map_err(|source| LoadError::Stl { file: name(), source })
}

impl Part {
    /// Parses, welds (as new jobs do), places and orients a part.
    pub fn from_bytes(
        bytes: &[u8],
        units: Units,
        placement: &Placement,
        flipped_shells: &[u32],
    ) -> Result<Part, StlError> {
        let made =
            Source::from_bytes(bytes)?.part(units, Weld::default(), placement, flipped_shells, &Progress::default())?;
        // It cannot have been cancelled: nobody else holds this progress.
        Ok(made.unwrap_or_default())
    }
}
