//! Why a program cannot be compared with its plan.

use crate::program::{ReadError, WriteError};
use crate::progress::Cancelled;
use thiserror::Error;

/// Why a program cannot be compared with its plan.
#[derive(Debug, Error, PartialEq)]
pub enum VerifyError {
    /// No dialect knows the text as its own, or more than one does.
    #[error("{file}: no dialect")]
    NoDialect {
        /// The file.
        file: String,
    },
    /// The plan cannot be written in the program's dialect.
    #[error("plan unwritable: {0}")]
    Unwritable(#[source] WriteError),
    /// The plan has no program.
    #[error("no program")]
    NoProgram,
    /// The plan, written in the program's dialect, cannot be read.
    #[error("own program unreadable: {0}")]
    OwnUnreadable(#[source] ReadError),
    /// The work was cancelled.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for VerifyError {
    fn from(_: Cancelled) -> VerifyError {
        VerifyError::Cancelled
    }
}
