//! What the journal keeps of a document, as text: a line that says whose it is, and the job below it.
//! The line is a comment, so that the file by itself is a job that can be looked at and opened.

use super::error::{JournalError, StateError};
use super::slot::JournalSlot;
use crate::document::files::save::JobFile;
use crate::document::files::{self, JobError};
use crate::document::job_file;
use crate::document::model::Job;
use crate::document::undo::Document;
use crate::part::digest_of;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};

/// Opens the first line.
const MARK: &str = "# clearbeam journal ";

/// A document that is not saved.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct JournalState {
    /// When it was edited last, and its files.
    pub(super) about: About,
    /// Its paths are seen from the job file; whole where there is none.
    pub(super) job: Job,
}

/// The first line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct About {
    /// Time of the last edit, seconds since 1970 UTC.
    pub(super) edited_s: u64,
    /// The job's file, whole, and what it held when the edits began; `None`: it was never saved.
    pub(super) job_file: Option<JobFile>,
    /// The part's file, whole; empty: the job has none.
    pub(super) part_file: PathBuf,
    /// SHA-256 of the text below, so that half a job is not taken for a whole one.
    text_sha256: String,
}

impl JournalState {
    /// What there is to keep of a document now.
    pub(super) fn of(document: &Document) -> Result<JournalState, JournalError> {
        let job_file = document.job_file().map(absolute_job_file).transpose()?;
        let job = match &job_file {
            Some(_) => document.job().clone(),
            None => files::with_whole_paths(document.job())?,
        };
        let job_path = job_file.as_ref().map(|f| f.path.as_path());
        let part_file = match job.part.file.as_str() {
            "" => PathBuf::new(),
            // A part that is gone for a moment is still the one that the job names.
            named => {
                let file = files::part_file(&job, job_path).unwrap_or_else(|_| files::resolved(job_path, named));
                files::absolute(&file)?
            }
        };
        let edited_s = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |t| t.as_secs());
        let about = About { edited_s, job_file, part_file, text_sha256: String::new() };
        Ok(JournalState { about, job })
    }

    /// Whether two states differ in the time of the last edit at most.
    pub(super) fn differs_in_time_at_most(&self, other: &JournalState) -> bool {
        let files = |s: &JournalState| (s.about.job_file.clone(), s.about.part_file.clone());
        files(self) == files(other) && self.job == other.job
    }

    /// The state as text.
    pub(super) fn to_text(&self) -> Result<String, JournalError> {
        let job = files::to_toml(&self.job)?;
        let about = About { text_sha256: digest_of(job.as_bytes()), ..self.about.clone() };
        let about = serde_json::to_string(&about).map_err(JournalError::Name)?;
        Ok(format!("{MARK}{about}\n{job}"))
    }

    /// The state of a slot; `None` where there is none.
    pub(super) fn read(slot: &JournalSlot) -> Result<Option<JournalState>, JournalError> {
        let unreadable = |source| JournalError::Unreadable { file: slot.state_file(), source };
        let bytes = slot.read().map_err(|e| unreadable(e.into()))?;
        bytes.map(|bytes| JournalState::from_bytes(&bytes).map_err(unreadable)).transpose()
    }

    fn from_bytes(bytes: &[u8]) -> Result<JournalState, StateError> {
        let parts = std::str::from_utf8(bytes)?.strip_prefix(MARK).and_then(|t| t.split_once('\n'));
        let (about, job) = parts.ok_or(StateError::NoOwner)?;
        let mut about: About = serde_json::from_str(about)?;
        if std::mem::take(&mut about.text_sha256) != digest_of(job.as_bytes()) {
            return Err(StateError::Damaged);
        }
        Ok(JournalState { about, job: job_file::parse(job)? })
    }
}

/// The job's file, from whatever folder the program is started next.
fn absolute_job_file(file: &JobFile) -> Result<JobFile, JobError> {
    Ok(JobFile { path: files::absolute(&file.path)?, sha256: file.sha256.clone() })
}
