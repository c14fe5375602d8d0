//! The journal of a running window: it keeps the unsaved changes of one document.

use super::error::JournalError;
use super::slot::JournalSlot;
use super::state::JournalState;
use crate::document::undo::Document;
use std::path::Path;

/// The journal of one window. Dropping it leaves its state behind, as a killed program does.
#[derive(Debug, Default)]
pub struct Journal {
    slot: Option<JournalSlot>,
    /// What its state says; `None`: it has no state.
    written: Option<JournalState>,
}

impl Journal {
    /// A journal that goes on in a slot where a state was left behind.
    pub(super) fn taken_over(slot: JournalSlot, state: JournalState) -> Journal {
        Journal { slot: Some(slot), written: Some(state) }
    }

    /// Takes a slot in a folder, which is made; without a folder nothing is kept.
    ///
    /// # Errors
    /// The folder cannot be made, or gives no locks.
    pub fn open(folder: Option<&Path>) -> Result<Journal, JournalError> {
        Ok(Journal { slot: folder.map(JournalSlot::take_free).transpose()?, written: None })
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
        let state = JournalState::of(document)?;
        if self.written.as_ref().is_some_and(|w| w.differs_in_time_at_most(&state)) {
            return Ok(());
        }
        slot.write(&state.to_text()?)?;
        self.written = Some(state);
        Ok(())
    }

    /// Removes what is kept: nothing is unsaved, or the operator gives it up.
    ///
    /// # Errors
    /// The state cannot be removed.
    pub fn clear(&mut self) -> Result<(), JournalError> {
        if self.written.is_some() {
            self.slot.as_ref().map_or(Ok(()), JournalSlot::clear)?;
        }
        self.written = None;
        Ok(())
    }
}
