//! Saving, exporting, file dialogs, and the question about unsaved changes.

use super::App;
use super::dialogs::Purpose;
use super::questions::{ExportReview, Question};
use super::scan_files;
use super::session::AfterGuard;
use crate::beam::Obstacle;
use crate::document::files::{self, JobError};
use crate::document::{Edit, IfChanged, Remembered};
use crate::planning::export::{self, ExportError, ExportInput, Page};
use crate::planning::report::PlanFinding;
use crate::planning::{Failure, PlannedJob};
use crate::progress::Activity;
use crate::text::{NamedSentence as _, Naming, Sentence as _, program_comment, report_page, say};
use eframe::egui;
use std::path::{Path, PathBuf};

impl App {
    pub(super) fn ask(&mut self, purpose: Purpose) {
        let name = self.context().part_name().map_or("job.toml".into(), |n| format!("{n}.toml"));
        let answer = self.answers.expect(purpose, &self.ctx);
        self.dialogs.ask(purpose, &name, &self.ctx, answer);
    }

    /// Does what a file was asked for, now that the user has chosen it.
    pub(super) fn take_answers(&mut self) {
        while let Some((purpose, path)) = self.answers.take() {
            self.picked(purpose, path);
        }
    }

    fn picked(&mut self, purpose: Purpose, path: Option<PathBuf>) {
        let Some(path) = path else {
            // Nothing was picked: nothing goes on, and a question that waits for a file stays.
            self.session.after_guard = None;
            return;
        };
        match purpose {
            Purpose::Open => self.open(path),
            Purpose::SaveJob => self.save_to(path),
            Purpose::Export => self.review_export(path, false),
            Purpose::ExportDryRun => self.review_export(path, true),
            Purpose::Part => self.look_at_file(path),
            Purpose::Cell => {
                let named = files::relative_to(&path, self.document.file());
                self.edit(Edit::Cell(named));
            }
            Purpose::Head => self.use_head(&path),
            Purpose::SaveHead => self.save_head(&path),
            Purpose::Clamp => {
                let named = files::relative_to(&path, self.document.file());
                let mut clamps = self.document.job().clamps.clone();
                clamps.push(Obstacle::of_file(named, &path));
                self.edit(Edit::Clamps(clamps));
            }
            Purpose::Scan => self.add_scans([path]),
            Purpose::WeldGray
            | Purpose::WeldDepth
            | Purpose::WeldCamera
            | Purpose::NextGray
            | Purpose::NextDepth
            | Purpose::HandEye
            | Purpose::GrindingTool => self.picked_for_weld(purpose, path),
            Purpose::Robot => {
                let named = files::relative_to(&path, self.document.file());
                self.choose_robot(&named);
            }
        }
    }

    /// Saves where the job is kept, or asks where.
    pub(super) fn save_job(&mut self) {
        match self.document.file().map(Path::to_path_buf) {
            Some(file) => self.save_to(file),
            None => self.ask(Purpose::SaveJob),
        }
    }

    fn save_to(&mut self, mut path: PathBuf) {
        if path.extension().is_none() {
            path.set_extension("toml");
            // The dialog has asked about the name without it.
            if self.is_anothers(&path) {
                self.question = Some(Question::SaveOver(path));
                return;
            }
        }
        if self.is_for_package(&path) {
            self.pack(path);
        } else {
            self.save_into(path, IfChanged::Refuse);
        }
    }

    /// Writes the job into a file.
    pub(super) fn save_into(&mut self, path: PathBuf, if_changed: IfChanged) {
        if let Some(part) = &self.derived.file_part {
            let remembered = Remembered::of(self.document.job(), part, &self.derived.part_of);
            self.document.remember(remembered);
        }
        let before = (self.document.job().clone(), self.document.file().map(Path::to_path_buf));
        match self.document.save(&path, if_changed) {
            Ok(()) => {
                // Only paths have changed: what was computed stays true.
                let now = (self.document.job(), self.document.file());
                self.derived.pipeline.renamed((&before.0, before.1.as_deref()), now);
                self.session.said = say!(window_saved, file = path.display().to_string());
                self.remember(&path);
                self.keep_journal();
                self.go_on();
            }
            Err(JobError::ChangedOnDisk { .. }) => self.question = Some(Question::SaveOver(path)),
            Err(e) => {
                self.session.after_guard = None;
                self.session.error = Some(e.sentence());
            }
        }
    }

    /// Writes program or dry run, path, report and job into a folder, and replaces what the operator was shown.
    pub(super) fn export(&mut self, review: ExportReview) {
        let ExportReview { dir, dry_run, conflicts, .. } = review;
        let overwrite = !conflicts.is_empty();
        let Some(planned) = self.plan_to_export() else { return };
        self.session.exported_dry_run = dry_run;
        let options = self.export_options(dry_run);
        let (job, file) = (self.document.job().clone(), self.document.file().map(Path::to_path_buf));
        self.session.said = say!(window_writing_into, folder = dir.display().to_string());
        let executor = self.derived.pipeline.executor().clone();
        self.exporting.clear();
        self.exporting.start(planned.key, Activity::Exporting, &*executor, move |progress| {
            let PlannedJob { part, surfaces, setup, plan, .. } = &*planned;
            let page = options.page.then(|| report_page(&planned, &job));
            let page = page.as_ref().map(|page| page as Page<'_>);
            let input = ExportInput {
                job: &job,
                part,
                surfaces,
                setup,
                plan,
                findings: &[],
                wording: program_comment,
                options,
                page,
            };
            export::write(&dir, &input, file.as_deref(), overwrite, progress).map_err(|e| match e {
                ExportError::Cancelled => Failure::Cancelled,
                other => Failure::Refused(other),
            })
        });
    }

    /// Tells how an export ended.
    pub(super) fn take_exported(&mut self) {
        let Some(outcome) = self.exporting.take_result() else { return };
        match outcome {
            Ok(exported) => {
                self.session.exports += 1;
                let reason = exported.report.findings.iter().find_map(|f| match f {
                    PlanFinding::NothingPlanned { reason } => Some(reason),
                    _ => None,
                });
                let program = exported.written.get(1).map_or(String::new(), |p| p.display().to_string());
                let naming = Naming::of(self.document.job());
                self.session.said =
                    reason.map_or_else(|| say!(window_exported, program), |reason| reason.sentence_with(&naming));
            }
            Err(Failure::Cancelled) => self.session.said = say!(window_export_cancelled),
            // Something was put there meanwhile, or a subprogram stands in the way: the page tells it.
            Err(Failure::Refused(ExportError::Conflicts { dir, conflicts })) => {
                self.session.said.clear();
                let Some(planned) = self.derived.current_plan(&self.document) else { return };
                let options = self.export_options(self.session.exported_dry_run);
                let review = ExportReview::new(dir, conflicts, self.document.job(), &planned.setup, &options);
                self.question = Some(Question::Export(Box::new(review)));
            }
            Err(why) => self.session.error = Some(why.sentence()),
        }
    }

    pub(super) fn take_dropped_files(&mut self, ctx: &egui::Context) {
        let dropped = ctx.input(|i| i.raw.dropped_files.iter().map(|f| f.path().to_path_buf()).collect::<Vec<_>>());
        let Some(first) = dropped.first() else { return };
        if self.derived.part.is_some() && dropped.iter().all(|path| scan_files::is_scan_alone(path)) {
            self.add_scans(dropped);
        } else {
            self.open_guarded(first.clone());
        }
    }

    /// Keeps the window open while there are unsaved changes.
    pub(super) fn guard_close(&mut self, ctx: &egui::Context) {
        let wants = ctx.input(|i| i.viewport().close_requested());
        if wants && self.document.is_dirty() && !self.session.may_close {
            ctx.send_viewport_cmd(egui::ViewportCommand::CancelClose);
            self.session.after_guard = Some(AfterGuard::Close);
        }
        if self.session.may_close && !wants {
            ctx.send_viewport_cmd(egui::ViewportCommand::Close);
        }
    }

    /// Does what had to wait until unsaved changes were dealt with.
    pub(super) fn go_on(&mut self) {
        match self.session.after_guard.take() {
            Some(AfterGuard::Close) => self.session.may_close = true,
            Some(AfterGuard::Open(path)) => self.open(path),
            Some(AfterGuard::AskOpen) => self.ask(Purpose::Open),
            Some(AfterGuard::AskWeld) => self.ask(Purpose::WeldGray),
            None => {}
        }
    }

    /// What the window's title says.
    pub(super) fn title(&self) -> String {
        let file = self.document.file().and_then(Path::file_name).map(|n| n.to_string_lossy().into_owned());
        match file.or_else(|| self.context().part_name().filter(|n| !n.is_empty())) {
            Some(name) if self.document.is_dirty() => say!(window_title_unsaved, name),
            Some(name) => say!(window_title, name),
            None => say!(window_title_empty),
        }
    }
}
