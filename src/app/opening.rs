//! Opens a part, a job, or what a killed program left behind, and deals with a part's file that has changed.

use super::App;
use super::derived::Derived;
use super::questions::Question;
use super::reading::{LookedAt, Opened, PartThere, Refused};
use super::session::AfterGuard;
use crate::document::files;
use crate::document::journal::Leftover;
use crate::document::stamps::Stamp;
use crate::document::weld_edit::take_changed;
use crate::document::{Document, Edit, Job};
use crate::part::{Part, PartFinding, Source};
use crate::planning::Failure;
use crate::sample::{SAMPLES, stl_bytes};
use crate::text::{Sentence as _, say};
use std::path::{Path, PathBuf};
use std::sync::Arc;

const RECENT: usize = 8;

impl App {
    /// Opens a part or a job; reading happens on a thread.
    pub(super) fn open(&mut self, path: PathBuf) {
        self.session.said = say!(window_reading, file = path.display().to_string());
        let executor = self.derived.pipeline.executor().clone();
        self.reading.open(path, &*executor);
    }

    /// Opens a job that is in no file yet.
    pub(super) fn open_job(&mut self, job: Job) {
        self.session.said = say!(window_reading, file = &job.part.file);
        let executor = self.derived.pipeline.executor().clone();
        self.reading.open_job(job, &*executor);
    }

    /// Opens a part or a job, once unsaved changes are dealt with.
    pub(super) fn open_guarded(&mut self, path: PathBuf) {
        if self.document.is_dirty() {
            self.session.after_guard = Some(AfterGuard::Open(path));
        } else {
            self.open(path);
        }
    }

    /// Puts a sample into the user's temporary folder, and opens it from there.
    pub(super) fn open_sample(&mut self, name: &str) {
        let Some(sample) = SAMPLES.into_iter().find(|s| s.name == name) else { return };
        let folder = std::env::temp_dir().join("clearbeam-samples");
        let file = folder.join(format!("{name}.stl"));
        let bytes = stl_bytes(&(sample.triangles)());
        let written = std::fs::create_dir_all(&folder)
            .map_err(|e| say!(start_no_folder, folder = folder.display().to_string(), reason = e.to_string()))
            .and_then(|()| files::write_atomic(&file, &bytes).map_err(|e| e.sentence()));
        match written {
            Ok(()) => self.open_guarded(file),
            Err(why) => self.session.error = Some(why),
        }
    }

    /// Opens what a killed program left behind.
    pub(super) fn restore(&mut self, leftover: Leftover) {
        self.session.said = say!(window_restoring, part = leftover.part_name());
        let executor = self.derived.pipeline.executor().clone();
        self.reading.restore(leftover, &*executor);
    }

    /// Takes what was read.
    pub(super) fn take_opened(&mut self) {
        match self.reading.opened() {
            Some(Ok(opened)) => self.opened(opened),
            Some(Err(why)) => self.not_read(&why),
            None => {}
        }
        match self.reading.looked_at() {
            Some(Ok(looked)) => self.looked_at(looked),
            Some(Err(why)) => self.not_read(&why),
            None => {}
        }
    }

    fn not_read(&mut self, why: &Refused) {
        self.session.said.clear();
        if !matches!(why, Failure::Cancelled) {
            self.session.error = Some(why.sentence());
        }
    }

    fn opened(&mut self, opened: Opened) {
        let Opened { document, part, leftover } = opened;
        match part {
            PartThere::Same(source, part, stamp) => {
                self.session.forget_part();
                // What casts doubt on the part stands above the view, until it is cured.
                let told = PartFinding::of(&part).into_iter().next().filter(|worst| !worst.casts_doubt());
                self.session.said =
                    told.map_or_else(|| say!(window_facets_read, count = part.mesh.facets.len()), |f| f.sentence());
                self.show(document, source, Some(*part), stamp, leftover);
            }
            PartThere::Changed(looked) => {
                self.session.said.clear();
                self.question = Some(Question::PartChanged { looked, opening: Some((Box::new(document), leftover)) });
            }
            PartThere::Gone(file) => {
                self.session.said.clear();
                self.question = Some(Question::PartGone { file, document: Box::new(document), leftover });
            }
        }
    }

    /// Shows a document on a part that was read.
    fn show(
        &mut self,
        document: Document,
        source: Arc<Source>,
        built: Option<Part>,
        stamp: Stamp,
        leftover: Option<Leftover>,
    ) {
        self.keep_thumbnail();
        let job = document.job();
        let shown = document.file().map_or_else(|| PathBuf::from(&job.part.file), Path::to_path_buf);
        let mut derived = Derived::new(self.derived.pipeline.executor().clone());
        derived.pipeline.open(source, built.map(|part| (&job.part, part)));
        self.derived = derived;
        self.document = document;
        self.adding.cancel();
        self.reading.took(stamp);
        self.session.fit_pending = true;
        // A depth image by itself is no part that could be opened again.
        let is_on_image = self.document.job().is_on_depth_image();
        if !is_on_image || self.document.file().is_some() {
            self.remember(&shown);
        }
        if let Some(leftover) = leftover
            && let Err(why) = self.journal.take_over(leftover)
        {
            self.session.error = Some(why.sentence());
        }
        self.keep_journal();
    }

    /// Goes on with a changed part file, or with another one: this changes the job, and saves nothing.
    pub(super) fn use_part(&mut self, looked: LookedAt, opening: Option<(Box<Document>, Option<Leftover>)>) {
        if opening.is_none() && *looked.job != *self.document.job() {
            // Something was done meanwhile: what was found is not of the job as it is.
            self.look(self.document.job().clone(), looked.file, self.derived.file_part.clone());
            return;
        }
        let LookedAt { file, source, stamp, carried, .. } = looked;
        let sha256 = source.sha256.clone();
        if let Some((document, leftover)) = opening {
            self.session.forget_part();
            self.show(*document, source, None, stamp, leftover);
        } else {
            self.derived.pipeline.open(source, None);
            self.reading.took(stamp);
            self.session.fit_pending = true;
        }
        let mut job = carried.map_or_else(|| self.document.job().clone(), |c| c.job);
        job.part.file = files::relative_to(&file, self.document.file());
        if job.is_on_depth_image() {
            let depth = job.part.file.clone();
            take_changed(&mut job.weld, &depth, &sha256);
        }
        self.edit(Edit::ChangedPart(Box::new(job)));
    }

    /// Looks at another file, in place of the part that a question is about.
    pub(super) fn look_at_file(&mut self, file: PathBuf) {
        self.session.said = say!(window_reading, file = file.display().to_string());
        match &self.question {
            Some(Question::PartChanged { opening: Some((document, _)), .. } | Question::PartGone { document, .. }) => {
                self.look(document.job().clone(), file, None);
            }
            _ => self.look(self.document.job().clone(), file, self.derived.file_part.clone()),
        }
    }

    /// Looks whether the part's file has changed while its document was open.
    pub(super) fn look_for_changes(&mut self) {
        if !self.reading.is_at_rest() || self.question.is_some() {
            return;
        }
        let Ok(file) = files::part_file(self.document.job(), self.document.file()) else { return };
        if self.reading.has_changed(&file) {
            self.look(self.document.job().clone(), file, self.derived.file_part.clone());
        }
    }

    fn look(&mut self, job: Job, file: PathBuf, shown: Option<Arc<Part>>) {
        let executor = self.derived.pipeline.executor().clone();
        let shown = shown.map(|part| (part, self.derived.part_of.clone()));
        self.reading.look((job, self.document.file()), file, shown, &*executor);
    }

    fn looked_at(&mut self, looked: LookedAt) {
        self.session.said.clear();
        match self.question.take() {
            // Another file was chosen for a part that has changed or is gone.
            Some(Question::PartChanged { opening, .. }) => self.answer_with(looked, opening),
            Some(Question::PartGone { document, leftover, .. }) => {
                self.answer_with(looked, Some((document, leftover)));
            }
            other => {
                self.question = other;
                if self.reading.is_news(&looked) {
                    self.question = Some(Question::PartChanged { looked, opening: None });
                }
            }
        }
    }

    fn answer_with(&mut self, looked: LookedAt, opening: Option<(Box<Document>, Option<Leftover>)>) {
        if looked.carried.is_none() {
            self.use_part(looked, opening);
        } else {
            self.question = Some(Question::PartChanged { looked, opening });
        }
    }

    pub(super) fn remember(&mut self, path: &Path) {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
        self.recent.retain(|p| *p != path);
        self.recent.insert(0, path);
        self.recent.truncate(RECENT);
    }
}
