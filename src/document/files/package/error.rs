//! Why a job cannot be packed, or a package not unpacked.

use std::path::PathBuf;
use thiserror::Error;

/// What is wrong with a package, or with what should become one.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum PackageError {
    /// The archive cannot be read: it is cut off, or none.
    #[error("no archive")]
    Archive,
    /// It has no job in it.
    #[error("no job in it")]
    NoJob,
    /// A later version has written it.
    #[error("schema {schema}")]
    Later {
        /// Its schema.
        schema: u32,
    },
    /// An entry would lie outside of the folder.
    #[error("entry {name:?}")]
    Name {
        /// The entry.
        name: String,
    },
    /// It holds more than may be unpacked.
    #[error("more than {most_mib} MiB")]
    TooLarge {
        /// What may be, MiB.
        most_mib: u64,
    },
    /// Something else stands where it would be unpacked.
    #[error("{}: holds something else", .folder.display())]
    Occupied {
        /// The folder.
        folder: PathBuf,
        /// The file that is missing there or differs.
        file: String,
    },
    /// A file names another one that does not lie beside it or below.
    #[error("{of}: names {file}")]
    Outside {
        /// The file.
        of: String,
        /// What it names.
        file: String,
    },
    /// The archive cannot be written.
    #[error("{reason}")]
    Unwritable {
        /// What its writer said.
        reason: String,
    },
}
