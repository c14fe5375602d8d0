//! Keeps unsaved changes in the journal with every edit, so that a killed program loses nothing.

use crate::document::journal::{JournalError, Leftover};
use crate::document::{Document, Journal};
use crate::text::Sentence;
use std::path::Path;

/// The window's journal.
#[derive(Default)]
pub(super) struct JournalKeeper {
    journal: Journal,
    /// Why changes could not be kept, once the user was told.
    told: Option<String>,
}

impl JournalKeeper {
    /// A journal in a folder; without one nothing is kept.
    ///
    /// # Errors
    /// No slot of the folder can be had.
    pub fn open(folder: Option<&Path>) -> Result<JournalKeeper, JournalError> {
        Ok(JournalKeeper { journal: Journal::open(folder)?, told: None })
    }

    /// Keeps the unsaved changes of a document. A failure is returned once, though every edit tries again.
    pub fn keep(&mut self, document: &Document) -> Option<String> {
        let why = self.journal.record(document).err()?.sentence();
        let is_new = self.told.as_ref() != Some(&why);
        self.told = Some(why.clone());
        is_new.then_some(why)
    }

    /// Deletes the unsaved changes that are kept: nobody wants them any more.
    ///
    /// # Errors
    /// The file cannot be removed.
    pub fn clear(&mut self) -> Result<(), JournalError> {
        self.journal.clear()
    }

    /// Goes on in the slot of what a killed program left behind.
    ///
    /// # Errors
    /// The slot cannot be taken.
    pub fn take_over(&mut self, leftover: Leftover) -> Result<(), JournalError> {
        leftover.take_over(&mut self.journal)
    }
}
