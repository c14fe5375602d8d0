//! Why a job, a recipe or the journal cannot be read, kept or saved.

use super::file::one_line;
use super::{Sentence, say};
use crate::document::JobError;
use crate::document::journal::JournalError;
use crate::document::library::LibraryError;
use crate::pose::ToolBody;

impl Sentence for JobError {
    fn sentence(&self) -> String {
        match self {
            JobError::File(e) => e.sentence(),
            JobError::NoJob { file, source } => say!(in_file, file, what = one_line(source)),
            JobError::LaserBlocked { cell, obstacle, by: ToolBody::Beam } => say!(laser_beam_blocked, cell, obstacle),
            JobError::LaserBlocked { cell, obstacle, by: ToolBody::Head } => say!(laser_head_blocked, cell, obstacle),
            JobError::Part(e) => e.sentence(),
            JobError::Cell(e) => e.sentence(),
            JobError::Robot(e) => e.sentence(),
            JobError::Head(e) => e.sentence(),
            other => other.to_string(),
        }
    }
}

impl Sentence for LibraryError {
    fn sentence(&self) -> String {
        match self {
            LibraryError::Write(e) => e.sentence(),
            other => other.to_string(),
        }
    }
}

impl Sentence for JournalError {
    fn sentence(&self) -> String {
        self.to_string()
    }
}
