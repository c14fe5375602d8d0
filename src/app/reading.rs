//! Reads documents and their parts on a thread, and tells whether a part's file is the one that the job was made for.
//!
//! What the window does with that is in `opening`.

use crate::document::files::{self, JobError, package};
use crate::document::journal::Leftover;
use crate::document::model::JobPart;
use crate::document::stamps::{Stamp, stamp_of};
use crate::document::{CarriedOver, Document, Job, JobFile, Remembered, save};
use crate::part::{Hasher, Part, Source};
use crate::planning::{Executor, Failure, Stage};
use crate::progress::{Activity, Progress};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Why a file cannot be opened.
pub(super) type Refused = Failure<Arc<JobError>>;

/// What is read on a thread, and what is known of the part's file since it was.
#[derive(Default)]
pub(super) struct Reading {
    /// The document that is being opened.
    opening: Stage<Opened, Arc<JobError>>,
    /// The part's file, looked at again while its document is open.
    looking: Stage<LookedAt, Arc<JobError>>,
    /// Stamp of the part's file when it was read last.
    stamp: Option<Stamp>,
    /// A changed file that the operator does not want, by its SHA-256.
    unwanted: Option<String>,
}

impl Reading {
    /// Begins to read a part or a job.
    pub fn open(&mut self, path: PathBuf, executor: &dyn Executor) {
        self.start(executor, move |progress| {
            let beside = path.parent().unwrap_or(Path::new(""));
            let (mut job, file) = job_of(&package::unpacked(&path, beside).map_err(refused)?)?;
            let part = part_there(&mut job, file.as_ref().map(|f| f.path.as_path()), progress)?;
            Ok(Opened { part, document: Document::new(job, file), leftover: None })
        });
    }

    /// Begins to read the part of a job that is in no file yet.
    pub fn open_job(&mut self, mut job: Job, executor: &dyn Executor) {
        self.start(executor, move |progress| {
            let part = part_there(&mut job, None, progress)?;
            Ok(Opened { part, document: Document::new(job, None), leftover: None })
        });
    }

    /// Begins to read the part of what a killed program left behind.
    pub fn restore(&mut self, leftover: Leftover, executor: &dyn Executor) {
        self.start(executor, move |progress| {
            let document = leftover.restored();
            let part = part_there(&mut document.job().clone(), document.file(), progress)?;
            Ok(Opened { part, document, leftover: Some(leftover) })
        });
    }

    fn start(
        &mut self,
        executor: &dyn Executor,
        work: impl FnOnce(&Progress) -> Result<Opened, Refused> + Send + 'static,
    ) {
        self.opening.clear();
        self.opening.start(Hasher::default().finish(), Activity::Reading, executor, work);
    }

    /// Begins to look what becomes of a job on a file. What its surfaces look like is known from the part that is
    /// shown, with the way it was built.
    pub fn look(
        &mut self,
        (mut job, job_file): (Job, Option<&Path>),
        file: PathBuf,
        shown: Option<(Arc<Part>, JobPart)>,
        executor: &dyn Executor,
    ) {
        let camera = job.depth_camera(job_file);
        self.looking.clear();
        self.looking.start(Hasher::default().finish(), Activity::Reading, executor, move |progress| {
            if let Some((part, built)) = shown {
                job.part.landmarks = Remembered::of(&job, &part, &built);
            }
            let stamp = stamp_of(&file);
            let source = read(&file, camera.as_deref(), progress)?;
            looked_at(&job, file, source, stamp, progress)
        });
    }

    /// The document that was opened, or why it could not be.
    pub fn opened(&mut self) -> Option<Result<Opened, Refused>> {
        self.opening.take_result()
    }

    /// What was found at the file that was looked at, or why it could not be read.
    pub fn looked_at(&mut self) -> Option<Result<LookedAt, Refused>> {
        self.looking.take_result()
    }

    /// Whether a file is being looked at.
    pub fn is_looking(&self) -> bool {
        self.looking.is_running()
    }

    /// How far the document that is being opened is.
    pub fn progress(&self) -> Option<&Progress> {
        self.opening.progress()
    }

    /// Asks the opening to end.
    pub fn cancel(&mut self) {
        self.opening.cancel();
    }

    /// Whether nothing is being read.
    pub fn is_at_rest(&self) -> bool {
        !self.opening.is_running() && !self.looking.is_running()
    }

    /// Notes that a part's file was taken as it is: later changes are noticed.
    pub fn took(&mut self, stamp: Stamp) {
        (self.stamp, self.unwanted) = (Some(stamp), None);
    }

    /// Whether the part's file has changed since it was read last, or since that was asked last.
    pub fn has_changed(&mut self, file: &Path) -> bool {
        let Some(known) = self.stamp else { return false };
        let now = stamp_of(file);
        self.stamp = Some(now);
        now != known
    }

    /// Notes that a changed file was refused: while the document is open it is not asked about again.
    pub fn refuse(&mut self, looked: &LookedAt) {
        self.unwanted = Some(looked.source.sha256.clone());
    }

    /// Whether a file differs from the job's, and was not refused.
    pub fn is_news(&self, looked: &LookedAt) -> bool {
        looked.carried.is_some() && self.unwanted.as_deref() != Some(&looked.source.sha256)
    }
}

/// A document with its part.
pub(super) struct Opened {
    /// The document.
    pub document: Document,
    /// Its part.
    pub part: PartThere,
    /// The journal entry that it was restored from; it is taken over once the document is shown.
    pub leftover: Option<Leftover>,
}

/// What is found where the part of a job should be.
pub(super) enum PartThere {
    /// The file that the job was made for.
    Same(Arc<Source>, Box<Part>, Stamp),
    /// Another file.
    Changed(LookedAt),
    /// No file.
    Gone(PathBuf),
}

/// A part's file that has changed since the job was made, or another file in its place.
pub(super) struct LookedAt {
    /// The file.
    pub file: PathBuf,
    /// Its bytes.
    pub source: Arc<Source>,
    /// Its stamp when they were read.
    pub stamp: Stamp,
    /// The job that was asked about.
    pub job: Box<Job>,
    /// What becomes of the job there; `None`: the bytes are those of the job's part, and only the name differs.
    pub carried: Option<Box<CarriedOver>>,
}

fn refused(e: JobError) -> Refused {
    Failure::Refused(Arc::new(e))
}

fn read(file: &Path, camera: Option<&Path>, progress: &Progress) -> Result<Arc<Source>, Refused> {
    let read = files::read_source(file, camera, progress).map_err(refused)?;
    read.map(Arc::new).ok_or(Failure::Cancelled)
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

/// Reads the part of a job, which is of it from now on.
fn part_there(job: &mut Job, job_file: Option<&Path>, progress: &Progress) -> Result<PartThere, Refused> {
    let file = match files::part_file(job, job_file) {
        Ok(file) => file,
        // A part that was to be opened itself is an error; one that a job names can be looked for.
        Err(JobError::PartGone { file }) if job_file.is_some() => return Ok(PartThere::Gone(file.into())),
        Err(e) => return Err(refused(e)),
    };
    let stamp = stamp_of(&file);
    let source = read(&file, job.depth_camera(job_file).as_deref(), progress)?;
    if job.part.is_of_another_file(&source.sha256) {
        return looked_at(job, file, source, stamp, progress).map(PartThere::Changed);
    }
    job.part.begin_with(&source, job_file);
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
