//! What is shown before a program is written: where to, what is not done, what is assumed, and which files it replaces.
//! The folder is looked at on a thread.

use super::App;
use super::questions::{ExportReview, Question};
use super::toggle::Toggle;
use crate::cell::Setup;
use crate::document::Job;
use crate::planning::export::{self, ExportOptions, FileConflict};
use crate::planning::report::unverified;
use crate::planning::{Failure, PlannedJob};
use crate::program::Variant;
use crate::progress::Activity;
use crate::text::{Sentence as _, say};
use std::path::{Path, PathBuf};
use std::sync::Arc;

impl ExportReview {
    /// What an export into a folder would do, beside these files.
    pub fn new(dir: PathBuf, conflicts: Vec<FileConflict>, job: &Job, setup: &Setup, options: &ExportOptions) -> Self {
        let standing = export::standing(&dir, job, setup, options);
        let dry_run = options.variant.dry_run;
        ExportReview { dir, dry_run, conflicts, standing, assumed: unverified(job, setup) }
    }
}

impl App {
    /// Looks at the folder that was chosen, and then shows what an export would do.
    pub(super) fn review_export(&mut self, dir: PathBuf, dry_run: bool) {
        let Some(planned) = self.plan_to_export() else { return };
        let options = self.export_options(dry_run);
        let (job, file) = (self.document.job().clone(), self.document.file().map(Path::to_path_buf));
        let executor = self.derived.pipeline.executor().clone();
        self.reviewing.clear();
        self.reviewing.start(planned.key, Activity::Exporting, &*executor, move |_| {
            let setup = &planned.setup;
            let conflicts =
                export::conflicts(&dir, &job, file.as_deref(), setup, &options).map_err(Failure::Refused)?;
            Ok(ExportReview::new(dir, conflicts, &job, setup, &options))
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

    /// The plan of the job as it is; where there is none, that is told.
    pub(super) fn plan_to_export(&mut self) -> Option<Arc<PlannedJob>> {
        // A cell or head that was changed meanwhile is not what was planned with.
        self.derived.pipeline.look_again();
        let planned = self.derived.current_plan(&self.document).cloned();
        if planned.is_none() {
            self.session.error = Some(say!(window_no_finished_plan));
        }
        planned
    }

    /// What is written besides the program.
    pub(super) fn export_options(&self, dry_run: bool) -> ExportOptions {
        let variant = Variant { dry_run, from_pass: self.context().going_on_from() };
        // A dose that is looked at is written as well.
        ExportOptions { dose: self.session.show.is_on(Toggle::Dose), variant, page: self.session.writes_page }
    }
}
