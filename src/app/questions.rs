//! Questions that wait for the operator's answer before anything is done, and what each answer does.

use super::App;
use super::dialogs::Purpose;
use super::journal::JournalKeeper;
use super::reading::LookedAt;
use crate::document::journal::{LeftBehind, Leftover};
use crate::document::{Document, IfChanged, journal};
use crate::planning::export::FileConflict;
use crate::planning::report::PlanFinding;
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
    /// Saving would overwrite a file that is not the document's, or that has changed since this window read or saved it.
    SaveOver(PathBuf),
    /// Whether the program is to be written, with what that would do.
    Export(Box<ExportReview>),
}

/// What an export would do.
pub(super) struct ExportReview {
    /// The folder.
    pub dir: PathBuf,
    /// Whether it is the dry run that is written.
    pub dry_run: bool,
    /// Files of the folder that are no earlier export of this job, or not as that left them.
    pub conflicts: Vec<FileConflict>,
    /// Names of files that are replaced.
    pub standing: Vec<String>,
    /// What nobody has measured or tried of cell, robot and dialect.
    pub assumed: Vec<PlanFinding>,
}

/// The answer to a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reply {
    /// Takes the part's file as it is now.
    UsePart,
    /// Asks for another file in its place.
    OtherFile,
    /// Opens one of the states that were left behind, by its place in the list.
    Restore(usize),
    /// Deletes one of them.
    Discard(usize),
    /// Writes, and replaces what stands there.
    Overwrite,
    /// Saves the job in another file.
    SaveAs,
    /// Opens the file as it is, instead of overwriting it.
    Reload,
    /// Writes the program into another folder.
    OtherFolder,
    /// Does nothing.
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

    /// Does what the operator answered.
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
            (Reply::Overwrite, Some(Question::Export(review))) => self.export(*review),
            (Reply::OtherFolder, Some(Question::Export(review))) => {
                self.ask(if review.dry_run { Purpose::ExportDryRun } else { Purpose::Export });
            }
            _ => self.session.after_guard = None,
        }
    }

    /// Keeps the unsaved changes, so that a killed program loses nothing.
    pub(super) fn keep_journal(&mut self) {
        if let Some(why) = self.journal.keep(&self.document) {
            self.session.error = Some(why);
        }
    }

    /// Discards the unsaved changes that the journal keeps.
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
