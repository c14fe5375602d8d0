//! Why a plan was not exported. Sentences of it stand in `text`.

use super::conflict::FileConflict;
use crate::document::JobError;
use crate::planning::verify::{Finding, VerifyError};
use crate::planning::{FromPassError, PlanError};
use crate::program::DialectError;
use crate::progress::Cancelled;
use std::path::PathBuf;
use thiserror::Error;

/// Why a plan was not exported. Unless a file could not be written the folder is as it was.
#[derive(Debug, Error)]
pub enum ExportError {
    /// Something cannot be read or written.
    #[error(transparent)]
    Document(#[from] JobError),
    /// Files of the folder are not this export's to replace or remove.
    #[error("{}: {} files in the way", .dir.display(), .conflicts.len())]
    Conflicts {
        /// The folder.
        dir: PathBuf,
        /// Each of them, and why.
        conflicts: Vec<FileConflict>,
    },
    /// Another export holds the folder.
    #[error("{}: busy", .dir.display())]
    Busy {
        /// The folder.
        dir: PathBuf,
    },
    /// A file would have a name that leads elsewhere, or that another file of the export has.
    #[error("file name {name:?}")]
    Name {
        /// The name.
        name: String,
    },
    /// The controller could not take the program.
    #[error("program unwritable: {0}")]
    Unwritable(#[from] DialectError),
    /// The program that was just made cannot be read.
    #[error("program unreadable: {0}")]
    Unreadable(#[from] VerifyError),
    /// The program would not do what was planned.
    #[error("program is not the plan: {findings} findings, first {first:?}")]
    NotThePlan {
        /// The first thing that is wrong with it.
        first: Box<Finding>,
        /// How many there are.
        findings: usize,
    },
    /// The plan cannot go on from the pass that was asked for.
    #[error(transparent)]
    FromPass(#[from] FromPassError),
    /// The dose cannot be computed.
    #[error("dose: {0}")]
    Dose(#[source] PlanError),
    /// The user ended it.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for ExportError {
    fn from(_: Cancelled) -> Self {
        ExportError::Cancelled
    }
}
