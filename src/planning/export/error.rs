//! Why a plan was not exported.

use super::ownership::FileConflict;
use crate::document::JobError;
use crate::planning::PlanError;
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
    #[error("{}: nothing was written: {}", .dir.display(), listed(.conflicts))]
    Conflicts {
        /// The folder.
        dir: PathBuf,
        /// Each of them, and why.
        conflicts: Vec<FileConflict>,
    },
    /// Another export holds the folder.
    #[error("{}: another export into this folder is under way; wait for it, or choose another folder", .dir.display())]
    Busy {
        /// The folder.
        dir: PathBuf,
    },
    /// A file would have a name that leads elsewhere, or that another file of the export has.
    #[error(
        "the program would be written as {name:?}, which is no name of its own within a folder; \
         give another in the cell file"
    )]
    Name {
        /// The name.
        name: String,
    },
    /// The controller could not take the program.
    #[error("the program cannot be written: {0}")]
    Unwritable(String),
    /// The program that was just made cannot be read.
    #[error("the program cannot be read back: {0}")]
    Unreadable(String),
    /// The program would not do what was planned.
    #[error(
        "the program, read back, is not the plan: {file}:{line}: {what} ({findings} findings); nothing was written"
    )]
    NotThePlan {
        /// File of the first finding.
        file: String,
        /// Its line, from 1.
        line: usize,
        /// What is wrong with it.
        what: String,
        /// How many there are.
        findings: usize,
    },
    /// The dose cannot be computed.
    #[error("the dose: {0}")]
    Dose(PlanError),
    /// The user ended it.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for ExportError {
    fn from(_: Cancelled) -> Self {
        ExportError::Cancelled
    }
}

fn listed(conflicts: &[FileConflict]) -> String {
    conflicts.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}
