//! Why a job, a recipe or the journal cannot be read, kept or saved.

use super::Sentence;
use crate::document::JobError;
use crate::document::journal::JournalError;
use crate::document::library::LibraryError;

impl Sentence for JobError {
    fn sentence(&self) -> String {
        match self {
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
