//! What is shown before a program is written: where to, what is not done, what is assumed, and which files it replaces.
//! The folder is looked at on a thread.

use super::App;
use super::questions::{ExportReview, Question};
use super::toggle::Toggle;
use crate::planning::Failure;
use crate::planning::export::{self, ExportOptions};
use crate::planning::report::unverified;
use crate::program::Variant;
use crate::progress::Activity;
use crate::text::{Sentence as _, say};
use std::path::{Path, PathBuf};

impl App {
    /// Looks at the folder that was chosen, and then shows what an export would do.
    pub(super) fn review_export(&mut self, dir: PathBuf, dry_run: bool) {
        // A cell or head that was changed meanwhile is not what was planned with.
        self.derived.pipeline.look_again();
        let Some(planned) = self.derived.current_plan(&self.document).cloned() else {
            self.session.error = Some(say!(window_no_finished_plan));
            return;
        };
        let options = self.export_options(dry_run);
        let (job, file) = (self.document.job().clone(), self.document.file().map(Path::to_path_buf));
        let executor = self.derived.pipeline.executor().clone();
        self.reviewing.clear();
        self.reviewing.start(planned.key, Activity::Exporting, &*executor, move |_| {
            let setup = &planned.setup;
            let conflicts =
                export::conflicts(&dir, &job, file.as_deref(), setup, &options).map_err(Failure::Refused)?;
            let standing = export::standing(&dir, &job, setup, &options);
            Ok(ExportReview { dir, dry_run, conflicts, standing, assumed: unverified(&job, setup) })
        });
    }

    /// Shows what was found.
    pub(super) fn take_review(&mut self) {
        match self.reviewing.take_result() {
            Some(Ok(review)) => self.question = Some(Question::Export(Box::new(review))),
            Some(Err(Failure::Cancelled)) | None => {}
            Some(Err(why)) => self.session.error = Some(why.sentence()),
        }
    }

    /// What is written besides the program.
    pub(super) fn export_options(&self, dry_run: bool) -> ExportOptions {
        let variant = Variant { dry_run, from_pass: self.context().going_on_from() };
        // A dose that is looked at is written as well.
        ExportOptions { dose: self.session.show.is_on(Toggle::Dose), variant, page: self.session.writes_page }
    }
}
