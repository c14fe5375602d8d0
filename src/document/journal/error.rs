//! Why unsaved changes cannot be kept, and why some that were left behind cannot be read.

use crate::document::files::JobError;
use crate::document::job_file::JobFileError;
use std::path::PathBuf;
use thiserror::Error;

/// Why the journal cannot do its work.
#[derive(Debug, Error)]
pub enum JournalError {
    /// Its folder cannot be made, listed or locked in.
    #[error("{}: no journal", .folder.display())]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A state cannot be written or removed.
    #[error("{}: not written", .file.display())]
    Write {
        /// The state.
        file: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The job cannot be put into a state.
    #[error(transparent)]
    Job(#[from] JobError),
    /// Files of the job have names that are no text.
    #[error("file name is no text")]
    Name(#[source] serde_json::Error),
    /// A state that was left behind cannot be read; it stays there.
    #[error("{}: unreadable: {source}", .file.display())]
    Unreadable {
        /// The state.
        file: PathBuf,
        /// What is wrong with it.
        source: StateError,
    },
}

/// Why a state of the journal cannot be read.
#[derive(Debug, Error)]
pub enum StateError {
    /// The system does not let its file be read.
    #[error("not read")]
    Read(#[from] std::io::Error),
    /// It is no UTF-8.
    #[error("no text")]
    NoText(#[from] std::str::Utf8Error),
    /// Its first line does not say whose it is.
    #[error("no owner")]
    NoOwner,
    /// Its first line says whose it is in a way that is not understood.
    #[error("owner not understood")]
    Owner(#[from] serde_json::Error),
    /// The text below the first line is not the one that was written.
    #[error("text damaged")]
    Damaged,
    /// The text below the first line is no job.
    #[error(transparent)]
    Job(#[from] JobFileError),
}
