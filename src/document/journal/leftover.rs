//! What programs that ended early have left in the journal: to show, to take over, or to discard.

use super::error::JournalError;
use super::recording::Journal;
use super::slot::JournalSlot;
use super::state::JournalState;
use crate::document::files;
use crate::document::model::{Job, JobPart};
use crate::document::undo::Document;
use std::path::Path;

/// What was found in a journal.
#[derive(Debug, Default)]
pub struct LeftBehind {
    /// Unsaved changes, the latest first.
    pub leftovers: Vec<Leftover>,
    /// States that cannot be read, and why. They stay where they are.
    pub unreadable: Vec<JournalError>,
}

/// Unsaved changes of a program that has ended. While this lives no other window finds them; dropped,
/// they wait for the next start.
#[derive(Debug)]
pub struct Leftover {
    slot: JournalSlot,
    state: JournalState,
}

/// Looks for unsaved changes that no running program owns. States that hold no more than their job
/// file does are removed: there is nothing to restore.
pub fn left_behind(folder: &Path) -> LeftBehind {
    let mut found = LeftBehind::default();
    let numbers = JournalSlot::with_state(folder).unwrap_or_else(|e| {
        found.unreadable.push(e);
        Vec::new()
    });
    for number in numbers {
        match unsaved_in_slot(folder, number) {
            Ok(leftover) => found.leftovers.extend(leftover),
            Err(e) => found.unreadable.push(e),
        }
    }
    found.leftovers.sort_by_key(|l| std::cmp::Reverse(l.edited_s()));
    found
}

fn unsaved_in_slot(folder: &Path, number: u32) -> Result<Option<Leftover>, JournalError> {
    let Some(slot) = JournalSlot::take(folder, number)? else { return Ok(None) };
    // Another window may have taken it over between listing and locking.
    let Some(state) = JournalState::read(&slot)? else { return Ok(None) };
    let leftover = Leftover { slot, state };
    if leftover.is_saved() {
        leftover.discard()?;
        return Ok(None);
    }
    Ok(Some(leftover))
}

impl Leftover {
    /// The job as it was edited last. Its paths are seen from [`Leftover::job_file`]; whole where there is none.
    pub fn job(&self) -> &Job {
        &self.state.job
    }

    /// The job's file; `None`: it was never saved.
    pub fn job_file(&self) -> Option<&Path> {
        self.state.about.job_file.as_ref().map(|f| f.path.as_path())
    }

    /// The part's file.
    pub fn part_file(&self) -> &Path {
        &self.state.about.part_file
    }

    /// Name of the part without folder and ending.
    pub fn part_name(&self) -> String {
        self.part_file().file_stem().map_or(String::new(), |n| n.to_string_lossy().into_owned())
    }

    /// Time of the last edit, seconds since 1970 UTC.
    pub fn edited_s(&self) -> u64 {
        self.state.about.edited_s
    }

    /// The document: as its file has it now, with the unsaved changes as one step over it. Where the
    /// file has changed since, the document knows, and a save asks; where it is gone or no job any
    /// more, or there never was one, the changes stand over an empty job on the part.
    pub fn restored(&self) -> Document {
        let empty = || {
            let JobPart { file, sha256, .. } = self.state.job.part.clone();
            Job { part: JobPart { file, sha256, ..JobPart::default() }, ..Job::default() }
        };
        let saved = self.job_file().and_then(|f| files::read(f).ok()).unwrap_or_else(empty);
        Document::restored(saved, self.state.about.job_file.clone(), self.state.job.clone())
    }

    /// Hands the changes over to a running window: its journal goes on in their slot, so that there is no moment at
    /// which they are not kept. Do this once the window shows [`Leftover::restored`];
    /// what the journal kept until then is given up.
    ///
    /// # Errors
    /// What was kept until then cannot be removed; the changes are taken over all the same.
    pub fn take_over(self, journal: &mut Journal) -> Result<(), JournalError> {
        std::mem::replace(journal, Journal::taken_over(self.slot, self.state)).clear()
    }

    /// Removes the changes for good, as the operator does not want them.
    ///
    /// # Errors
    /// They cannot be removed.
    pub fn discard(self) -> Result<(), JournalError> {
        self.slot.clear()
    }

    /// Whether the job's file holds all changes: the program ended between saving and clearing the journal.
    fn is_saved(&self) -> bool {
        let Some(saved) = self.job_file().and_then(|f| files::read(f).ok()) else { return false };
        let mut job = self.state.job.clone();
        if job.part.sha256.is_empty() {
            // A save fills that in.
            job.part.sha256.clone_from(&saved.part.sha256);
        }
        job == saved
    }
}
