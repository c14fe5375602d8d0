//! Why a text is no job.

use crate::cell::frame::FrameError;
use crate::document::parameter::ParameterError;
use crate::document::value_error::RecipeError;
use crate::file::{NoText, TomlError};
use crate::part::SurfaceId;
use crate::scan::transform_file::MatrixFault;
use thiserror::Error;

/// Why a text is no job.
#[derive(Debug, Error)]
pub enum JobFileError {
    /// It is no UTF-8.
    #[error(transparent)]
    NoText(#[from] NoText),
    /// It is no TOML, or has a key or value that no job has.
    #[error(transparent)]
    Toml(#[from] Box<TomlError>),
    /// A table is none of a job, where its text is not at hand.
    #[error(transparent)]
    Table(#[from] toml::de::Error),
    /// A number of the table of parameters cannot be.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// A value of a recipe cannot be.
    #[error(transparent)]
    Recipe(#[from] Box<RecipeError>),
    /// Another number is out of its range.
    #[error("{key} = {value}, range {low} to {high}")]
    Range {
        /// The key, with its table's.
        key: &'static str,
        /// What stands there.
        value: f64,
        /// The least that may.
        low: f64,
        /// The most that may.
        high: f64,
    },
    /// One of these, in a line that is known.
    #[error("line {line}: {what}")]
    InLine {
        /// The line, from 1.
        line: usize,
        /// What is wrong there.
        what: Box<JobFileError>,
    },
    /// A frame of the job's own cannot be told from what stands there.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// The transform of the scan is no rigid motion.
    #[error("scan.transform: {0:?}")]
    Transform(MatrixFault),
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
