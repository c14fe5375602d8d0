//! Why there is no part and no plan. Sentences of it stand in `text`.

use super::failure::Failure;
use super::scanned::ScanError;
use super::welded::WeldError;
use crate::document::{JobError, ValueError};
use crate::part::file::PartFileError;
use crate::program::DialectError;
use crate::progress::Cancelled;
use std::sync::Arc;
use thiserror::Error;

/// Why there is no part.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PartError {
    /// No facet of the file has any area.
    #[error(transparent)]
    File(#[from] PartFileError),
    /// The job speaks of surfaces of another file.
    #[error("part changed")]
    Changed,
}

/// Why a job cannot be planned.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PlanError {
    /// A value of the job that cannot be.
    #[error(transparent)]
    Parameter(#[from] ValueError),
    /// What the cell asks for cannot be written in the dialect.
    #[error(transparent)]
    Unwritable(#[from] DialectError),
    /// A surface that is not there.
    #[error("no surface {surface}")]
    NoSurface {
        /// The number asked for.
        surface: u32,
        /// The highest number there is; they begin with 1.
        last: u32,
    },
    /// Nothing chosen.
    #[error("nothing chosen")]
    Nothing,
    /// Lines further apart than the part is large.
    #[error("spacing {spacing_mm} mm above size {size_mm} mm")]
    SpacingTooLarge {
        /// The spacing that was asked for, mm.
        spacing_mm: f64,
        /// Diagonal of the part.
        size_mm: f64,
    },
    /// More points than any memory holds.
    #[error("spacing {spacing_mm} mm needs {points} points")]
    SpacingTooSmall {
        /// The spacing that was asked for, mm.
        spacing_mm: f64,
        /// Points of the dense lines, about.
        points: f64,
    },
    /// A coordinate is out of all reason.
    #[error("part size {size_mm} mm")]
    PartTooLarge {
        /// Diagonal of the part.
        size_mm: f64,
    },
    /// A build-up that closes a hollow.
    #[error("surface {surface} folds at layer {layers}")]
    Folds {
        /// The surface.
        surface: u32,
        /// The lowest layer that it has no room for.
        layers: u32,
    },
    /// The user ended it.
    #[error("cancelled")]
    Cancelled,
}

/// Why there is no plan of a job on a part.
#[derive(Clone, Debug, Error)]
pub enum PlanningError {
    /// The part cannot be built.
    #[error(transparent)]
    Part(#[from] Failure<PartError>),
    /// The scan says nothing of the part.
    #[error(transparent)]
    Scan(#[from] Failure<ScanError>),
    /// The images of the weld say nothing.
    #[error(transparent)]
    Weld(#[from] Failure<WeldError>),
    /// Cell, robot or head cannot be used.
    #[error(transparent)]
    Setup(#[from] Failure<Arc<JobError>>),
    /// The job cannot be planned.
    #[error(transparent)]
    Plan(#[from] Failure<PlanError>),
}

impl From<Cancelled> for PlanError {
    fn from(_: Cancelled) -> Self {
        PlanError::Cancelled
    }
}

impl From<PlanError> for Failure<PlanError> {
    fn from(e: PlanError) -> Failure<PlanError> {
        match e {
            PlanError::Cancelled => Failure::Cancelled,
            other => Failure::Refused(other),
        }
    }
}

impl PlanningError {
    /// Whether the user ended it.
    pub fn is_cancelled(&self) -> bool {
        matches!(
            self,
            PlanningError::Part(Failure::Cancelled)
                | PlanningError::Scan(Failure::Cancelled)
                | PlanningError::Weld(Failure::Cancelled)
                | PlanningError::Setup(Failure::Cancelled)
                | PlanningError::Plan(Failure::Cancelled)
        )
    }
}
