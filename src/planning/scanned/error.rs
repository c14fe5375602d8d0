//! Why a job's scan says nothing of its part. Sentences of it stand in `text`.

use crate::planning::failure::Failure;
use crate::progress::Cancelled;
use crate::scan::continuation::ContinuationError;
use crate::scan::deviation::{Patch, PatchKind};
use crate::scan::file::{ScanFileError, UnitDoubt};
use crate::scan::merging::OverlapError;
use crate::scan::registration::RegistrationError;
use crate::scan::transform_file::MatrixFault;
use nalgebra::Point3;
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
    /// A file cannot be brought to those before it.
    #[error("{file}: {source}")]
    Overlap {
        /// The file.
        file: String,
        /// Why.
        source: OverlapError,
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
    /// The part is off its model by more than the job allows.
    #[error("{} mm beyond the gate of {gate_mm} mm", patch.depth_mm)]
    Gate {
        /// Where it is farthest off.
        patch: Box<BeyondGate>,
        /// What the job allows, mm.
        gate_mm: f64,
    },
    /// What is called sound around a damage does not tell the surface across it.
    #[error("damage {number}: {source}")]
    Continued {
        /// Which damage of the job, from 0.
        number: usize,
        /// Why.
        source: ContinuationError,
    },
    /// The job's bead is too low for what is missing.
    #[error("{layers} layers")]
    BeadTooLow {
        /// So many layers would fill it.
        layers: f64,
    },
    /// The scan lies nowhere on the part.
    #[error(transparent)]
    Registration(RegistrationError),
}

/// Where a part is off its model by more than its job allows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeyondGate {
    /// Whether material is missing there.
    pub kind: PatchKind,
    /// How far it is off, mm, above 0.
    pub depth_mm: f64,
    /// Where that is, part frame.
    pub at: Point3<f64>,
}

impl From<&Patch> for BeyondGate {
    fn from(p: &Patch) -> BeyondGate {
        BeyondGate { kind: p.kind, depth_mm: p.depth_mm, at: p.deepest_at }
    }
}

impl From<ScanError> for Failure<ScanError> {
    fn from(e: ScanError) -> Failure<ScanError> {
        match e {
            ScanError::Registration(RegistrationError::Cancelled) => Failure::Cancelled,
            ScanError::Overlap { source: OverlapError::Cancelled, .. } => Failure::Cancelled,
            ScanError::Continued { source: ContinuationError::Cancelled, .. } => Failure::Cancelled,
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
