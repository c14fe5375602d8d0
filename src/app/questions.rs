//! What waits for the operator's word before anything is done, and what is done at his word.

use super::App;
use super::dialogs::Purpose;
use super::journal::JournalKeeper;
use super::reading::LookedAt;
use crate::document::journal::{LeftBehind, Leftover};
use crate::document::{Document, IfChanged, journal};
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

/// The answer to a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reply {
    /// The part's file is taken as it is now.
    UsePart,
    /// Another file is looked for in its place.
    OtherFile,
    /// One of the states that were left behind is opened, by its place among them.
    Restore(usize),
    /// One of them is thrown away.
    Discard(usize),
    /// What stands there is replaced.
    Overwrite,
    /// The job is saved in another file.
    SaveAs,
    /// The file is opened as it is, instead of being written over.
    Reload,
    /// The program is written into another folder.
    OtherFolder,
    /// Nothing is done.
    Cancel,
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

    /// Does what a question was answered with.
    pub(super) fn take_reply(&mut self, reply: Reply) {
        // A file that is still to be picked leaves the question open.
        if reply == Reply::OtherFile {
            self.ask(Purpose::Part);
            return;
        }
        match (reply, self.question.take()) {
            (Reply::UsePart, Some(Question::PartChanged { looked, opening })) => self.use_part(looked, opening),
            // As long as the document is open, its part's file is not asked about again.
            (Reply::Cancel, Some(Question::PartChanged { looked, opening: None })) => self.reading.refuse(&looked),
            (Reply::Restore(at), Some(Question::Restore(mut found))) if at < found.leftovers.len() => {
                // The others wait for the next start.
                let leftover = found.leftovers.remove(at);
                self.restore(leftover);
            }
            (Reply::Discard(at), Some(Question::Restore(mut found))) if at < found.leftovers.len() => {
                if let Err(why) = found.leftovers.remove(at).discard() {
                    self.session.error = Some(why.sentence());
                }
                self.question = (!found.leftovers.is_empty()).then_some(Question::Restore(found));
            }
            (Reply::Overwrite, Some(Question::SaveOver(path))) => self.save_into(path, IfChanged::Overwrite),
            (Reply::SaveAs, _) => self.ask(Purpose::SaveJob),
            (Reply::Reload, Some(Question::SaveOver(path))) => self.open(path),
            (Reply::Overwrite, Some(Question::ExportOver { dir, .. })) => self.export(dir, true),
            (Reply::OtherFolder, _) => self.ask(Purpose::Export),
            _ => self.session.after_guard = None,
        }
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

    /// Whether saving there would overwrite a file that is not the document's.
    pub(super) fn is_anothers(&self, path: &Path) -> bool {
        path.exists() && self.document.file() != Some(path)
    }
}
