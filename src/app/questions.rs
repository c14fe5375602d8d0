//! What waits for the operator's word before anything is done, and what is done at his word.

use super::App;
use super::dialogs::Purpose;
use super::journal::JournalKeeper;
use super::reading::LookedAt;
use crate::document::journal::{LeftBehind, Leftover};
use crate::document::{Document, journal};
use crate::planning::export::FileConflict;
use crate::text::Sentence as _;
use std::path::{Path, PathBuf};

/// A question.
pub(super) enum Question {
    /// The part's file is another one than the job was made for.
    PartChanged {
        /// The file as it is.
        looked: LookedAt,
        /// The document that is being opened on it, and what that is restored from; `None`: it is open.
        opening: Option<(Box<Document>, Option<Leftover>)>,
    },
    /// The part of a job is not there.
    PartGone {
        /// Where it should be.
        file: PathBuf,
        /// The job.
        document: Box<Document>,
        /// What it is restored from.
        leftover: Option<Leftover>,
    },
    /// A killed program left unsaved changes.
    Restore(LeftBehind),
    /// A file would be written over that holds something else than this window knows.
    SaveOver(PathBuf),
    /// Files of a folder are not this export's to replace.
    ExportOver {
        /// The folder.
        dir: PathBuf,
        /// Each of them, and why.
        conflicts: Vec<FileConflict>,
    },
}

impl App {
    /// The window with a journal of unsaved changes in a folder; it asks about those that were left there.
    pub fn with_journal(mut self, folder: Option<PathBuf>) -> App {
        match JournalKeeper::open(folder.as_deref()) {
            Ok(journal) => self.journal = journal,
            Err(why) => self.session.error = Some(why.sentence()),
        }
        let found = folder.as_deref().map(journal::left_behind).unwrap_or_default();
        if let Some(why) = found.unreadable.first() {
            self.session.error = Some(why.sentence());
        }
        if !found.leftovers.is_empty() {
            self.question = Some(Question::Restore(found));
        }
        self
    }

    /// Keeps the unsaved changes, so that a killed program loses nothing.
    pub(super) fn keep_journal(&mut self) {
        if let Some(why) = self.journal.keep(&self.document) {
            self.session.error = Some(why);
        }
    }

    /// Nothing of the unsaved changes is wanted any more.
    pub(super) fn clear_journal(&mut self) {
        if let Err(why) = self.journal.clear() {
            self.session.error = Some(why.sentence());
        }
    }

    /// The changed part's file is not wanted: as long as the document is open it is not asked about again.
    pub(super) fn keep_part(&mut self, looked: &LookedAt) {
        self.reading.refuse(looked);
    }

    /// Asks for another file in the place of the part.
    pub(super) fn ask_for_part(&mut self) {
        self.ask(Purpose::Part);
    }

    /// Whether saving there would overwrite a file that is not the document's.
    pub(super) fn is_anothers(&self, path: &Path) -> bool {
        path.exists() && self.document.file() != Some(path)
    }
}
