//! The `[part]` table of a job: the part's file, and how it stands.

use crate::document::remembered::Remembered;
use crate::part::{Placement, Source, Units, Weld};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The part of a job: its file, and how it stands.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct JobPart {
    /// Path, relative to the job file.
    pub file: String,
    /// SHA-256 of its bytes when the job was saved; empty: any.
    pub sha256: String,
    /// Unit of its coordinates.
    pub units: Units,
    /// Which of its corners become one vertex.
    pub weld: Weld,
    /// Shells whose other side is to be worked on.
    pub flipped_shells: Vec<u32>,
    /// Where the part stands.
    pub placement: Placement,
    /// What its surfaces looked like when the job was saved.
    #[serde(skip_serializing_if = "Remembered::is_empty")]
    pub landmarks: Remembered,
}

impl JobPart {
    /// Takes what was read of its file: from now on the job is of this part, and of no other under its name. A job
    /// that was just made, so it is in no file and was of no part yet, takes the unit that the file states.
    pub fn begin_with(&mut self, source: &Source, job_file: Option<&Path>) {
        if job_file.is_none() && self.sha256.is_empty() {
            self.units = source.raw.stated_unit.map_or(self.units, |s| s.taken());
        }
        self.sha256.clone_from(&source.sha256);
    }

    /// Whether the job was made for other bytes than those of this SHA-256.
    pub fn is_of_another_file(&self, sha256: &str) -> bool {
        !self.sha256.is_empty() && self.sha256 != sha256
    }
}
