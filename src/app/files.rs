//! Opening, saving, exporting, and the guard over unsaved changes.

use super::App;
use super::dialogs::Purpose;
use super::session::AfterGuard;
use super::worker::{Opened, Outcome};
use crate::beam::Obstacle;
use crate::document::Document;
use crate::document::Job;
use crate::document::files;
use crate::part::{Part, digest_of, stl};
use crate::planning::export::{self, ExportInput};
use crate::progress::Progress;
use eframe::egui;
use std::path::{Path, PathBuf};
use std::sync::Arc;

const RECENT: usize = 8;

impl App {
    /// Opens a part or a job; reading happens on a thread.
    pub(super) fn open(&mut self, path: PathBuf) {
        self.session.said = format!("reading {}…", path.display());
        self.worker.spawn(move || Outcome::Opened(read(&path).map(Box::new)));
    }

    /// The same after asking about unsaved changes.
    pub(super) fn open_guarded(&mut self, path: PathBuf) {
        if self.document.is_dirty() {
            self.session.after_guard = Some(AfterGuard::Open(path));
        } else {
            self.open(path);
        }
    }

    pub(super) fn opened(&mut self, result: Result<Box<Opened>, String>) {
        match result {
            Ok(opened) => {
                let Opened { job, file, raw, part } = *opened;
                let shown = file.clone().unwrap_or_else(|| PathBuf::from(&job.part.file));
                self.remember(&shown);
                self.session.forget_part();
                self.session.said = part
                    .findings
                    .sentences(&part.mesh, &part.orientation)
                    .first()
                    .cloned()
                    .unwrap_or_else(|| format!("{} facets read", part.mesh.facets.len()));
                let of = job.part.clone();
                self.document = Document::new(job, file);
                self.take_part(raw, part, of);
            }
            Err(why) => {
                self.session.said.clear();
                self.session.error = Some(why);
            }
        }
    }

    fn remember(&mut self, path: &Path) {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
        self.recent.retain(|p| *p != path);
        self.recent.insert(0, path);
        self.recent.truncate(RECENT);
    }

    pub(super) fn ask(&mut self, purpose: Purpose) {
        let name = self.part_name().map_or("job.toml".into(), |n| format!("{n}.toml"));
        let reply = self.worker.reply();
        self.dialogs.ask(purpose, &name, Box::new(move |path| reply(Outcome::Picked(purpose, path))));
    }

    pub(super) fn picked(&mut self, purpose: Purpose, path: Option<PathBuf>) {
        let Some(path) = path else {
            self.session.after_guard = None;
            return;
        };
        match purpose {
            Purpose::Open => self.open(path),
            Purpose::SaveJob => self.save_to(path),
            Purpose::Export => self.export(path),
            Purpose::Cell => {
                let beside = self.document.file.clone();
                let named = files::relative_to(&path, beside.as_deref());
                self.edit(crate::document::Edit::Cell(named));
            }
            Purpose::Head => {
                let named = files::relative_to(&path, self.document.file.as_deref());
                self.edit(crate::document::Edit::Head(named));
            }
            Purpose::Clamp => {
                let named = files::relative_to(&path, self.document.file.as_deref());
                let mut clamps = self.document.job().clamps.clone();
                clamps.push(Obstacle::named(named));
                self.edit(crate::document::Edit::Clamps(clamps));
            }
            Purpose::Robot => {
                let named = files::relative_to(&path, self.document.file.as_deref());
                self.choose_robot(&named);
            }
        }
    }

    /// Saves where the job is kept, or asks where.
    pub(super) fn save_job(&mut self) {
        match self.document.file.clone() {
            Some(file) => self.save_to(file),
            None => self.ask(Purpose::SaveJob),
        }
    }

    fn save_to(&mut self, mut path: PathBuf) {
        if path.extension().is_none() {
            path.set_extension("toml");
        }
        let mut job = self.document.job().clone();
        if let Some(part) = &self.derived.part {
            job.part.sha256.clone_from(&part.sha256);
        }
        match files::save(&job, self.document.file.as_deref(), &path) {
            Ok(saved) => {
                // Only paths have changed: what was computed stays true.
                self.derived.part_of = saved.part.clone();
                if let Some(of) = self.derived.plan_of.as_mut() {
                    (of.part, of.cell) = (saved.part.clone(), saved.cell.clone());
                }
                self.document.mark_saved(path.clone(), saved);
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
        let job = self.document.job().clone();
        let d = &self.derived;
        let (Some((plan, _)), Some((_, Ok(setup))), true) = (&d.plan, &d.setup, d.plan_of.as_ref() == Some(&job))
        else {
            self.session.error =
                Some("there is no finished plan for the job as it is; wait for it, or see what is wrong".into());
            return;
        };
        let (plan, setup, surfaces) = (plan.clone(), setup.clone(), d.surfaces.clone());
        let file = self.document.file.clone();
        let mut job = job;
        let Some(part) = d.part.clone() else { return };
        job.part.sha256.clone_from(&part.sha256);
        self.session.said = format!("writing into {}…", dir.display());
        self.worker.spawn(move || {
            let (job, findings) = (&job, &[][..]);
            let input = ExportInput { job, part: &part, surfaces: &surfaces, setup: &setup, plan: &plan, findings };
            let exported = export::write(&dir, &input, file.as_deref(), false, &Progress::default());
            Outcome::Exported(exported.map(|e| e.written).map_err(|e| e.to_string()))
        });
    }

    pub(super) fn exported(&mut self, result: Result<Vec<PathBuf>, String>) {
        match result {
            Ok(written) => {
                let program = written.get(1).map_or(String::new(), |p| p.display().to_string());
                self.session.said = format!("exported {program}");
            }
            Err(why) => self.session.error = Some(why),
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
        let file = self.document.file.as_deref().and_then(Path::file_name).map(|n| n.to_string_lossy().into_owned());
        match file.or_else(|| self.part_name().filter(|n| !n.is_empty())) {
            Some(name) => format!("{dirty}{name} – clearbeam"),
            None => "clearbeam".into(),
        }
    }
}

/// Reads a part or a job with its part.
fn read(path: &Path) -> Result<Opened, String> {
    let (mut job, file) = if files::is_job(path) {
        (files::read(path).map_err(|e| e.to_string())?, Some(path.to_path_buf()))
    } else {
        let mut job = Job::default();
        job.part.file = path.display().to_string();
        (job, None)
    };
    let part_file = files::part_file(&job, file.as_deref()).map_err(|e| e.to_string())?;
    let name = part_file.display();
    let bytes = std::fs::read(&part_file).map_err(|e| format!("{name}: cannot be read: {e}"))?;
    let sha256 = digest_of(&bytes);
    let changed = !job.part.sha256.is_empty() && job.part.sha256 != sha256;
    let raw = stl::read(&bytes).map_err(|e| format!("{name}: {e}"))?;
    let p = &job.part;
    let part = Part::from_raw(&raw, sha256.clone(), p.units, &p.placement, &p.flipped_shells)
        .map_err(|e| format!("{name}: {e}"))?;
    if changed {
        // The window may go on: the operator sees the surfaces and can choose again.
        job.clean = Default::default();
        job.surfaces.edits.clear();
        job.surfaces.flipped.clear();
        job.surfaces.names.clear();
        job.recipe_of.clear();
        job.part.sha256 = sha256;
    }
    Ok(Opened { job, file, raw: Arc::new(raw), part: Arc::new(part) })
}
