//! The journal: what is not saved yet, written beside the user's data after every edit, so that a
//! killed program loses nothing.
//!
//! Each window has a slot: a lock that the system gives back when its process ends, however it ends,
//! and a state that is there only while the document is dirty. A state whose lock is free was left
//! behind ([`left_behind`]). States are replaced by rename and not synced to the disk: they outlive
//! the process, not a power cut; one that a power cut has torn is told, and not taken for a job.

mod leftover;
mod slot;
mod state;

pub use leftover::{LeftBehind, Leftover, left_behind};

use super::files::JobError;
use super::undo::Document;
use slot::Slot;
use state::State;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why the journal cannot do its work.
#[derive(Debug, Error)]
pub enum JournalError {
    /// Its folder cannot be made, listed or locked in.
    #[error("{}: the journal of unsaved changes cannot be kept there: {source}; save often, or mend the folder", .folder.display())]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A state cannot be written or removed.
    #[error("{}: unsaved changes cannot be kept there: {source}; save the job, then look at the disk", .file.display())]
    Write {
        /// The state.
        file: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The job cannot be put into a state.
    #[error("unsaved changes cannot be kept in the journal: {0}")]
    Job(#[from] JobError),
    /// Files of the job have names that are no text.
    #[error("unsaved changes cannot be kept in the journal: {what}; save the job under a plain name")]
    Name {
        /// Which.
        what: String,
    },
    /// A state that was left behind cannot be read; it stays there.
    #[error("{}: was left behind by a program that ended early, and cannot be read: {why}; look into it, then remove it", .file.display())]
    Unreadable {
        /// The state.
        file: PathBuf,
        /// What is wrong.
        why: String,
    },
}

/// The journal of one window. Dropping it leaves its state behind, as a killed program does.
#[derive(Debug, Default)]
pub struct Journal {
    slot: Option<Slot>,
    /// What its state says; `None`: it has no state.
    written: Option<State>,
}

impl Journal {
    /// Takes a slot in a folder, which is made; without a folder nothing is kept.
    ///
    /// # Errors
    /// The folder cannot be made, or gives no locks.
    pub fn open(folder: Option<&Path>) -> Result<Journal, JournalError> {
        Ok(Journal { slot: folder.map(Slot::take_free).transpose()?, written: None })
    }

    /// Keeps a document as it is now; a clean one has nothing to keep. Cheap where nothing has changed.
    ///
    /// # Errors
    /// Why it cannot be kept; what was kept before still is.
    pub fn record(&mut self, document: &Document) -> Result<(), JournalError> {
        let Some(slot) = &self.slot else { return Ok(()) };
        if !document.is_dirty() {
            return self.clear();
        }
        let state = State::of(document)?;
        if self.written.as_ref().is_some_and(|w| w.tells_the_same(&state)) {
            return Ok(());
        }
        slot.write(&state.to_text()?)?;
        self.written = Some(state);
        Ok(())
    }

    /// Nothing is unsaved, or the operator gives it up.
    ///
    /// # Errors
    /// The state cannot be removed.
    pub fn clear(&mut self) -> Result<(), JournalError> {
        if self.written.is_some() {
            self.slot.as_ref().map_or(Ok(()), Slot::clear)?;
        }
        self.written = None;
        Ok(())
    }
}

#[cfg(test)]
mod tests;
