//! Why a text is no job.

use crate::cell::frame::FrameError;
use crate::part::SurfaceId;
use thiserror::Error;

/// Why a text is no job.
#[derive(Debug, Error)]
pub enum JobFileError {
    /// It is no UTF-8.
    #[error("no text")]
    NoText(#[from] std::str::Utf8Error),
    /// It is no TOML, or has a key or value that no job has.
    #[error(transparent)]
    Toml(#[from] toml::de::Error),
    /// A frame of the job's own cannot be told from what stands there.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// It is of a version that is not known yet.
    #[error("version {0} is unknown")]
    Later(i64),
    /// There is no such version.
    #[error("no version {0}")]
    NoVersion(String),
    /// A list names a surface twice.
    #[error("{key}: surface {surface} repeated")]
    Twice {
        /// Key of the list.
        key: &'static str,
        /// The surface.
        surface: SurfaceId,
    },
    /// A key that should be the number of a surface is none.
    #[error("{key}: {text:?} is no number")]
    NoNumber {
        /// Key of the table.
        key: &'static str,
        /// What stands there.
        text: String,
    },
}
