//! Why a job cannot be opened or saved.

use super::package::PackageError;
use super::scanned_part_error::ScannedPartError;
use crate::beam::{ContactToolError, HeadError};
use crate::cell::{CellError, RobotError};
use crate::document::job_file::JobFileError;
use crate::file::FileError;
use crate::part::LoadError;
use crate::pose::ToolBody;
use crate::weld::camera_file::CameraFileError;
use crate::weld::image_file::ImageFileError;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why a job, or a file that it names, cannot be read or written.
#[derive(Debug, Error)]
pub enum JobError {
    /// The job file cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// It is no job.
    #[error("{file}: no job")]
    NoJob {
        /// The file.
        file: String,
        /// What is wrong with it.
        source: Box<JobFileError>,
    },
    /// The part is not where the job says.
    #[error("{file}: part gone")]
    PartGone {
        /// Where it was looked for.
        file: String,
    },
    /// The part is another one now.
    #[error("{file}: part changed")]
    PartChanged {
        /// The file.
        file: String,
    },
    /// The part cannot be used.
    #[error(transparent)]
    Part(#[from] LoadError),
    /// It is a scan, and no part can be made of it.
    #[error("{file}: {source}")]
    ScannedPart {
        /// The file.
        file: String,
        /// Why.
        source: ScannedPartError,
    },
    /// The part is a depth image that cannot be used.
    #[error(transparent)]
    DepthImage(#[from] ImageFileError),
    /// The camera that took it cannot be used.
    #[error(transparent)]
    Camera(#[from] CameraFileError),
    /// The grinding tool cannot be used.
    #[error(transparent)]
    Grinder(#[from] ContactToolError),
    /// The cell cannot be used.
    #[error(transparent)]
    Cell(#[from] CellError),
    /// The robot cannot be used.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// The head cannot be used.
    #[error(transparent)]
    Head(#[from] HeadError),
    /// The laser stands still, and an obstacle of the cell stands in its way.
    #[error("{cell}: {obstacle} blocks the laser")]
    LaserBlocked {
        /// Name of the cell.
        cell: String,
        /// The obstacle's file.
        obstacle: String,
        /// What of the tool it touches.
        by: ToolBody,
    },
    /// Somebody else has saved meanwhile.
    #[error("{file}: changed on disk")]
    ChangedOnDisk {
        /// The job file.
        file: String,
    },
    /// The job cannot be turned into TOML.
    #[error("job not serialized")]
    Unwritable(#[source] toml::ser::Error),
    /// A job cannot be packed, or its package not unpacked.
    #[error("{file}: {what}")]
    Package {
        /// The package, or the file that does not go into it.
        file: String,
        /// What is wrong.
        what: PackageError,
    },
    /// A file cannot be written.
    #[error("{}: not written", .file.display())]
    Write {
        /// The file.
        file: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A file cannot be removed.
    #[error("{}: not removed", .file.display())]
    Remove {
        /// The file.
        file: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
}

impl JobError {
    /// A file that cannot be written.
    pub(crate) fn write(file: &Path, source: std::io::Error) -> JobError {
        JobError::Write { file: file.to_path_buf(), source }
    }
}
