//! Opening, saving, exporting, and the guard over unsaved changes.

use super::App;
use super::derived::Derived;
use super::dialogs::Purpose;
use super::session::AfterGuard;
use crate::beam::Obstacle;
use crate::document::files::{self, JobError};
use crate::document::{Document, IfChanged, Job, JobFile, save};
use crate::part::{Hasher, LoadError, Part, Source};
use crate::planning::export::{self, ExportError, ExportInput};
use crate::planning::{Failure, PlannedJob};
use crate::progress::Progress;
use eframe::egui;
use std::path::{Path, PathBuf};
use std::sync::Arc;

const RECENT: usize = 8;

impl App {
    /// Opens a part or a job; reading happens on a thread.
    pub(super) fn open(&mut self, path: PathBuf) {
        self.session.said = format!("reading {}…", path.display());
        let key = Hasher::default().of(&*path.to_string_lossy()).finish();
        let executor = self.derived.pipeline.executor().clone();
        self.opening.clear();
        self.opening.start(key, "reading", &*executor, move |progress| read(&path, progress));
    }

    /// The same after asking about unsaved changes.
    pub(super) fn open_guarded(&mut self, path: PathBuf) {
        if self.document.is_dirty() {
            self.session.after_guard = Some(AfterGuard::Open(path));
        } else {
            self.open(path);
        }
    }

    /// Takes a part or job that was read.
    pub(super) fn take_opened(&mut self) {
        if !self.opening.poll() {
            return;
        }
        match self.opening.taken() {
            Some(Ok(opened)) => self.opened(opened),
            Some(Err(Failure::Cancelled)) | None => self.session.said.clear(),
            Some(Err(why)) => {
                self.session.said.clear();
                self.session.error = Some(why.to_string());
            }
        }
    }

    fn opened(&mut self, opened: Opened) {
        let Opened { job, file, source, part } = opened;
        let shown = file.as_ref().map_or_else(|| PathBuf::from(&job.part.file), |f| f.path.clone());
        self.remember(&shown);
        self.session.forget_part();
        self.session.said = part
            .findings
            .sentences(&part.mesh, &part.orientation)
            .first()
            .cloned()
            .unwrap_or_else(|| format!("{} facets read", part.mesh.facets.len()));
        let mut derived = Derived::new(self.derived.pipeline.executor().clone());
        derived.pipeline.open(source, Some((&job.part, part)));
        self.derived = derived;
        self.document = Document::new(job, file);
        self.session.fit_pending = true;
    }

    fn remember(&mut self, path: &Path) {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
        self.recent.retain(|p| *p != path);
        self.recent.insert(0, path);
        self.recent.truncate(RECENT);
    }

    pub(super) fn ask(&mut self, purpose: Purpose) {
        let name = self.part_name().map_or("job.toml".into(), |n| format!("{n}.toml"));
        let answer = self.answers.expect(purpose, &self.ctx);
        self.dialogs.ask(purpose, &name, answer);
    }

    /// Does what files were asked for.
    pub(super) fn take_answers(&mut self) {
        while let Some((purpose, path)) = self.answers.take() {
            self.picked(purpose, path);
        }
    }

    fn picked(&mut self, purpose: Purpose, path: Option<PathBuf>) {
        let Some(path) = path else {
            self.session.after_guard = None;
            return;
        };
        match purpose {
            Purpose::Open => self.open(path),
            Purpose::SaveJob => self.save_to(path),
            Purpose::Export => self.export(path),
            Purpose::Cell => {
                let named = files::relative_to(&path, self.document.file());
                self.edit(crate::document::Edit::Cell(named));
            }
            Purpose::Head => {
                let named = files::relative_to(&path, self.document.file());
                self.edit(crate::document::Edit::Head(named));
            }
            Purpose::Clamp => {
                let named = files::relative_to(&path, self.document.file());
                let mut clamps = self.document.job().clamps.clone();
                clamps.push(Obstacle::named(named));
                self.edit(crate::document::Edit::Clamps(clamps));
            }
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
        }
        let before = (self.document.job().clone(), self.document.file().map(Path::to_path_buf));
        match self.document.save(&path, IfChanged::Refuse) {
            Ok(()) => {
                // Only paths have changed: what was computed stays true.
                let now = (self.document.job(), self.document.file());
                self.derived.pipeline.renamed((&before.0, before.1.as_deref()), now);
                self.session.said = format!("saved {}", path.display());
                self.remember(&path);
                self.go_on();
            }
            Err(e) => {
                self.session.after_guard = None;
                self.session.error = Some(e.to_string());
            }
        }
    }

    /// Writes program, path, report and job into a folder.
    fn export(&mut self, dir: PathBuf) {
        let Some(planned) = self.derived.current_plan(&self.document).cloned() else {
            self.session.error =
                Some("there is no finished plan for the job as it is; wait for it, or see what is wrong".into());
            return;
        };
        let (job, file) = (self.document.job().clone(), self.document.file().map(Path::to_path_buf));
        self.session.said = format!("writing into {}…", dir.display());
        let executor = self.derived.pipeline.executor().clone();
        self.exporting.clear();
        self.exporting.start(planned.key, "exporting", &*executor, move |progress| {
            let PlannedJob { part, surfaces, setup, plan, .. } = &*planned;
            let input = ExportInput { job: &job, part, surfaces, setup, plan, findings: &[] };
            let exported = export::write(&dir, &input, file.as_deref(), false, progress);
            exported.map(|e| e.written).map_err(|e| match e {
                ExportError::Cancelled => Failure::Cancelled,
                other => Failure::Refused(Arc::new(other)),
            })
        });
    }

    /// Tells how an export ended.
    pub(super) fn take_exported(&mut self) {
        if !self.exporting.poll() {
            return;
        }
        match self.exporting.taken() {
            Some(Ok(written)) => {
                let program = written.get(1).map_or(String::new(), |p| p.display().to_string());
                self.session.said = format!("exported {program}");
            }
            Some(Err(Failure::Cancelled)) | None => self.session.said = "the export was cancelled".into(),
            Some(Err(why)) => self.session.error = Some(why.to_string()),
        }
    }

    pub(super) fn take_dropped_files(&mut self, ctx: &egui::Context) {
        let dropped = ctx.input(|i| i.raw.dropped_files.first().map(|f| f.path().to_path_buf()));
        if let Some(path) = dropped {
            self.open_guarded(path);
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

    /// Does what waited for the unsaved changes.
    pub(super) fn go_on(&mut self) {
        match self.session.after_guard.take() {
            Some(AfterGuard::Close) => self.session.may_close = true,
            Some(AfterGuard::Open(path)) => self.open(path),
            Some(AfterGuard::AskOpen) => self.ask(Purpose::Open),
            None => {}
        }
    }

    /// Name of the part without folder and ending.
    pub(super) fn part_name(&self) -> Option<String> {
        Path::new(&self.document.job().part.file).file_stem().map(|n| n.to_string_lossy().into_owned())
    }

    /// Name of the part's file, as the program's head says it.
    pub(super) fn part_file_name(&self) -> String {
        let name = Path::new(&self.document.job().part.file).file_name().map(|n| n.to_string_lossy().into_owned());
        name.unwrap_or_default()
    }

    pub(super) fn title(&self) -> String {
        let dirty = if self.document.is_dirty() { "● " } else { "" };
        let file = self.document.file().and_then(Path::file_name).map(|n| n.to_string_lossy().into_owned());
        match file.or_else(|| self.part_name().filter(|n| !n.is_empty())) {
            Some(name) => format!("{dirty}{name} – clearbeam"),
            None => "clearbeam".into(),
        }
    }
}

/// A part with its job.
pub(super) struct Opened {
    job: Job,
    file: Option<JobFile>,
    source: Arc<Source>,
    part: Part,
}

/// Reads a part or a job with its part.
fn read(path: &Path, progress: &Progress) -> Result<Opened, Failure<Arc<JobError>>> {
    let refused = |e: JobError| Failure::Refused(Arc::new(e));
    let (mut job, file) = if files::is_job(path) {
        save::open(path).map(|(job, file)| (job, Some(file))).map_err(refused)?
    } else {
        let mut job = Job::default();
        job.part.file = path.display().to_string();
        (job, None)
    };
    let part_file = files::part_file(&job, file.as_ref().map(|f| f.path.as_path())).map_err(refused)?;
    let source = Source::read(&part_file).map_err(|e| refused(e.into()))?;
    if job.part.sha256.is_empty() {
        // From now on the job is of this part, and of no other under its name.
        job.part.sha256.clone_from(&source.sha256);
    } else if job.part.sha256 != source.sha256 {
        return Err(refused(JobError::PartChanged { file: part_file.display().to_string() }));
    }
    let p = &job.part;
    let built = source.part(p.units, &p.placement, &p.flipped_shells, progress);
    let named = |source| refused(LoadError::Stl { file: part_file.display().to_string(), source }.into());
    let part = built.map_err(named)?.ok_or(Failure::Cancelled)?;
    Ok(Opened { job, file, source: Arc::new(source), part })
}
