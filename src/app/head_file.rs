//! Writes a head that was put together in the window, and takes it into the job.

use super::App;
use crate::document::Edit;
use crate::document::files;
use crate::text::{Sentence as _, say};
use std::path::PathBuf;

impl App {
    /// Writes the head that is being put together, and takes it into the job.
    pub(super) fn save_head(&mut self, mut path: PathBuf) {
        let Some(Ok(text)) = self.session.head_draft.as_ref().map(|draft| draft.text()) else { return };
        if path.extension().is_none() {
            path.set_extension("toml");
        }
        match files::write_atomic(&path, text.as_bytes()) {
            Ok(()) => {
                self.session.head_draft = None;
                self.session.said = say!(window_saved, file = path.display().to_string());
                let named = files::relative_to(&path, self.document.file());
                self.edit(Edit::Head(named));
            }
            Err(e) => self.session.error = Some(e.sentence()),
        }
    }
}
