//! Opening a part, a job, or what a killed program left behind; and a part whose file is another one by now.

use super::App;
use super::derived::Derived;
use super::questions::Question;
use crate::document::files::{self, JobError};
use crate::document::journal::Leftover;
use crate::document::stamps::{Stamp, stamp_of};
use crate::document::{CarriedOver, Document, Edit, Job, JobFile, save};
use crate::part::{Hasher, Part, PartFinding, Source};
use crate::planning::{Failure, Stage};
use crate::progress::{Activity, Progress};
use crate::text::Sentence;
use std::path::{Path, PathBuf};
use std::sync::Arc;

const RECENT: usize = 8;

/// Why a file cannot be opened.
pub(super) type Refused = Failure<Arc<JobError>>;

/// What is read on a thread.
#[derive(Default)]
pub(super) struct Reading {
    /// The document that is being opened.
    pub opening: Stage<Opened, Arc<JobError>>,
    /// The part's file, looked at again while its document is open.
    pub looking: Stage<LookedAt, Arc<JobError>>,
    /// How the part's file was when it was read last.
    pub stamp: Option<Stamp>,
    /// A changed file that the operator does not want, by its SHA-256.
    pub unwanted: Option<String>,
}

/// A document with its part.
pub(super) struct Opened {
    document: Document,
    part: PartThere,
    /// What it was restored from: taken over once it is shown.
    leftover: Option<Leftover>,
}

/// What stands where the part of a job should be.
enum PartThere {
    /// The file that the job was made for.
    Same(Arc<Source>, Box<Part>, Stamp),
    /// Another.
    Changed(LookedAt),
    /// Nothing.
    Gone(PathBuf),
}

/// A part's file that is not the one that the job was made for, or another file that may be it.
pub(super) struct LookedAt {
    pub file: PathBuf,
    pub source: Arc<Source>,
    pub stamp: Stamp,
    /// The job that was asked about.
    job: Box<Job>,
    /// What becomes of it there; `None`: the same bytes under another name, nothing changes.
    pub carried: Option<Box<CarriedOver>>,
}

impl App {
    /// Opens a part or a job; reading happens on a thread.
    pub(super) fn open(&mut self, path: PathBuf) {
        self.session.said = format!("reading {}…", path.display());
        self.start_opening(move |progress| {
            let (mut job, file) = job_of(&path)?;
            let part = part_there(&job, file.as_ref().map(|f| f.path.as_path()), progress)?;
            if let PartThere::Same(source, ..) = &part {
                // From now on the job is of this part, and of no other under its name.
                job.part.sha256.clone_from(&source.sha256);
            }
            Ok(Opened { part, document: Document::new(job, file), leftover: None })
        });
    }

    /// The same after asking about unsaved changes.
    pub(super) fn open_guarded(&mut self, path: PathBuf) {
        if self.document.is_dirty() {
            self.session.after_guard = Some(super::session::AfterGuard::Open(path));
        } else {
            self.open(path);
        }
    }

    /// Opens what a killed program left behind.
    pub(super) fn restore(&mut self, leftover: Leftover) {
        self.session.said = format!("restoring {}…", leftover.part_name());
        self.start_opening(move |progress| {
            let document = leftover.restored();
            let part = part_there(document.job(), document.file(), progress)?;
            Ok(Opened { part, document, leftover: Some(leftover) })
        });
    }

    fn start_opening(&mut self, work: impl FnOnce(&Progress) -> Result<Opened, Refused> + Send + 'static) {
        let executor = self.derived.pipeline.executor().clone();
        self.reading.opening.clear();
        self.reading.opening.start(Hasher::default().finish(), Activity::Reading, &*executor, work);
    }

    /// Takes what was read.
    pub(super) fn take_opened(&mut self) {
        match self.reading.opening.taken() {
            Some(Ok(opened)) => self.opened(opened),
            Some(Err(why)) => self.not_read(&why),
            None => {}
        }
        match self.reading.looking.taken() {
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
                self.session.said = PartFinding::of(&part)
                    .first()
                    .map_or_else(|| format!("{} facets read", part.mesh.facets.len()), Sentence::sentence);
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
        let job = document.job();
        let shown = document.file().map_or_else(|| PathBuf::from(&job.part.file), Path::to_path_buf);
        let mut derived = Derived::new(self.derived.pipeline.executor().clone());
        derived.pipeline.open(source, built.map(|part| (&job.part, part)));
        self.derived = derived;
        self.document = document;
        (self.reading.stamp, self.reading.unwanted) = (Some(stamp), None);
        self.session.fit_pending = true;
        self.remember(&shown);
        if let Some(leftover) = leftover
            && let Err(why) = leftover.take_over(&mut self.journal)
        {
            self.session.error = Some(why.sentence());
        }
        self.keep_journal();
    }

    /// Goes on with a part's file that has changed, or with another: the job is changed by that, and nothing saved.
    pub(super) fn use_part(&mut self, looked: LookedAt, opening: Option<(Box<Document>, Option<Leftover>)>) {
        if opening.is_none() && *looked.job != *self.document.job() {
            // Something was done meanwhile: what was found is not of the job as it is.
            self.look(self.document.job().clone(), looked.file, self.derived.part.clone());
            return;
        }
        let LookedAt { file, source, stamp, carried, .. } = looked;
        if let Some((document, leftover)) = opening {
            self.session.forget_part();
            self.show(*document, source, None, stamp, leftover);
        } else {
            self.derived.pipeline.open(source, None);
            (self.reading.stamp, self.reading.unwanted) = (Some(stamp), None);
            self.session.fit_pending = true;
        }
        let mut job = carried.map_or_else(|| self.document.job().clone(), |c| c.job);
        job.part.file = files::relative_to(&file, self.document.file());
        self.edit(Edit::ChangedPart(Box::new(job)));
    }

    /// Looks at another file in the place of the part that a question is about.
    pub(super) fn look_at_file(&mut self, file: PathBuf) {
        self.session.said = format!("reading {}…", file.display());
        match &self.question {
            Some(Question::PartChanged { opening: Some((document, _)), .. } | Question::PartGone { document, .. }) => {
                self.look(document.job().clone(), file, None);
            }
            _ => self.look(self.document.job().clone(), file, self.derived.part.clone()),
        }
    }

    /// Looks whether the part's file has changed while its document was open.
    pub(super) fn look_for_changes(&mut self) {
        if self.reading.looking.is_running() || self.reading.opening.is_running() || self.question.is_some() {
            return;
        }
        let (Some(known), Ok(file)) = (self.reading.stamp, files::part_file(self.document.job(), self.document.file()))
        else {
            return;
        };
        let now = stamp_of(&file);
        if now == known {
            return;
        }
        self.reading.stamp = Some(now);
        // What the surfaces look like is known from the part that is shown.
        let (job, shown) = (self.document.job().clone(), self.derived.part.clone());
        self.look(job, file, shown);
    }

    fn look(&mut self, mut job: Job, file: PathBuf, shown: Option<Arc<Part>>) {
        let executor = self.derived.pipeline.executor().clone();
        let loaded = self.derived.part_of.clone();
        self.reading.looking.clear();
        self.reading.looking.start(Hasher::default().finish(), Activity::Reading, &*executor, move |progress| {
            if let Some(part) = shown {
                job.part.landmarks = crate::document::Remembered::of(&job, &part, &loaded);
            }
            let stamp = stamp_of(&file);
            let source = Arc::new(Source::read(&file).map_err(|e| refused(e.into()))?);
            looked_at(&job, file, source, stamp, progress)
        });
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
                let is_new = self.reading.unwanted.as_deref() != Some(&looked.source.sha256);
                if looked.carried.is_some() && is_new {
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

fn refused(e: JobError) -> Refused {
    Failure::Refused(Arc::new(e))
}

/// The job of a job file, or one for a part.
fn job_of(path: &Path) -> Result<(Job, Option<JobFile>), Refused> {
    if files::is_job(path) {
        return save::open(path).map(|(job, file)| (job, Some(file))).map_err(refused);
    }
    let mut job = Job::default();
    job.part.file = path.display().to_string();
    Ok((job, None))
}

/// Reads the part of a job.
fn part_there(job: &Job, job_file: Option<&Path>, progress: &Progress) -> Result<PartThere, Refused> {
    let file = match files::part_file(job, job_file) {
        Ok(file) => file,
        // A part that was to be opened itself is an error; one that a job names can be looked for.
        Err(JobError::PartGone { file }) if job_file.is_some() => return Ok(PartThere::Gone(file.into())),
        Err(e) => return Err(refused(e)),
    };
    let stamp = stamp_of(&file);
    let source = Arc::new(Source::read(&file).map_err(|e| refused(e.into()))?);
    if job.part.is_of_another_file(&source.sha256) {
        return looked_at(job, file, source, stamp, progress).map(PartThere::Changed);
    }
    let built = files::build_part(&source, &job.part, &file, progress).map_err(|e| refused(e.into()))?;
    let part = built.ok_or(Failure::Cancelled)?;
    Ok(PartThere::Same(source, Box::new(part), stamp))
}

/// What becomes of a job on a file.
fn looked_at(
    job: &Job,
    file: PathBuf,
    source: Arc<Source>,
    stamp: Stamp,
    progress: &Progress,
) -> Result<LookedAt, Refused> {
    if !job.part.is_of_another_file(&source.sha256) {
        return Ok(LookedAt { file, source, stamp, job: Box::new(job.clone()), carried: None });
    }
    let carried = CarriedOver::to_file(job, &source, &file, progress).map_err(|e| refused(e.into()))?;
    let carried = Some(Box::new(carried.ok_or(Failure::Cancelled)?));
    Ok(LookedAt { file, source, stamp, job: Box::new(job.clone()), carried })
}
