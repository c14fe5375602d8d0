//! Why a job's scan says nothing of its part. Sentences of it stand in `text`.

use crate::planning::failure::Failure;
use crate::progress::Cancelled;
use crate::scan::file::{ScanFileError, UnitDoubt};
use crate::scan::registration::RegistrationError;
use crate::scan::transform_file::MatrixFault;
use std::sync::Arc;
use thiserror::Error;

/// Why a scan says nothing.
#[derive(Clone, Debug, Error)]
pub enum ScanError {
    /// A file cannot be read, or is no scan.
    #[error("{file}: {source}")]
    File {
        /// The file.
        file: String,
        /// Why.
        source: Arc<ScanFileError>,
    },
    /// A file is another one than when the job was saved.
    #[error("{file}: changed")]
    Changed {
        /// The file.
        file: String,
        /// SHA-256 of its bytes now, hexadecimal.
        sha256: String,
    },
    /// Scan and part go together in other units only.
    #[error("{doubt:?}")]
    Units {
        /// In which.
        doubt: UnitDoubt,
        /// Diagonals of scan and part as they were taken, mm.
        diagonals_mm: [f64; 2],
    },
    /// The numbers of the job's transform are no motion.
    #[error("{0:?}")]
    Matrix(MatrixFault),
    /// The scan lies nowhere on the part.
    #[error(transparent)]
    Registration(RegistrationError),
}

impl From<ScanError> for Failure<ScanError> {
    fn from(e: ScanError) -> Failure<ScanError> {
        match e {
            ScanError::Registration(RegistrationError::Cancelled) => Failure::Cancelled,
            ScanError::File { source, .. } if matches!(*source, ScanFileError::Cancelled) => Failure::Cancelled,
            other => Failure::Refused(other),
        }
    }
}

impl From<Cancelled> for ScanError {
    fn from(_: Cancelled) -> ScanError {
        ScanError::Registration(RegistrationError::Cancelled)
    }
}
