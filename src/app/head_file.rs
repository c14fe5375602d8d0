//! Takes a head into the job: one from a file, or one that was put together in the window, which is written first.

use super::App;
use crate::document::Edit;
use crate::document::files;
use crate::text::{Sentence as _, say};
use std::path::Path;

impl App {
    /// Takes a head file into the job.
    pub(super) fn use_head(&mut self, path: &Path) {
        let named = files::relative_to(path, self.document.file());
        self.edit(Edit::Head(named));
    }

    /// Writes the head that is being put together, and takes it into the job. The file has the name that was asked about:
    /// a stack is read from a file of any name that is no part's.
    pub(super) fn save_head(&mut self, path: &Path) {
        let Some(Ok(text)) = self.session.head_draft.as_ref().map(|draft| draft.text()) else { return };
        match files::write_atomic(path, text.as_bytes()) {
            Ok(()) => {
                self.session.head_draft = None;
                self.session.said = say!(window_saved, file = path.display().to_string());
                self.use_head(path);
            }
            Err(e) => self.session.error = Some(e.sentence()),
        }
    }
}
