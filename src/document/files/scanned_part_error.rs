//! Why no part can be made of a scan. Sentences of it stand in `text`.

use crate::scan::file::ScanFileError;
use crate::scan::meshing::MeshingError;
use thiserror::Error;

/// Why the scan of a part is none that facets can be laid through.
#[derive(Debug, Error)]
pub enum ScannedPartError {
    /// It cannot be read as a scan either.
    #[error(transparent)]
    File(#[from] ScanFileError),
    /// Its points tell no surface.
    #[error(transparent)]
    Meshing(#[from] MeshingError),
}

impl ScannedPartError {
    /// Whether somebody ended it.
    pub fn is_cancelled(&self) -> bool {
        use ScannedPartError as E;
        matches!(self, E::File(ScanFileError::Cancelled) | E::Meshing(MeshingError::Cancelled))
    }
}
