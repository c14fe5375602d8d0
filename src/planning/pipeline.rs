//! The one pipeline from a part's file and a job to a plan. Window, command line, `render` and `verify` ask it.
//!
//! A stage becomes stale when its key does (see `key`); it is started once what it is made of is current. A
//! plan carries the part, the surfaces and the set-up that it was made of, so that nobody has to put together
//! what belongs together.

use super::key::{Keys, part_key};
use super::lay::Laid;
use super::plan::{PlanError, plan};
use super::planned::{PartError, PlannedJob, PlanningError};
use super::pool::AtOnce;
use super::preview;
use super::report::Report;
use super::stage::{Executor, Failure, Stage};
use super::surface_plan::Cache;
use crate::beam::Tool;
use crate::cell::{Cell, Setup};
use crate::document::files::{self, JobError};
use crate::document::model::PartFile;
use crate::document::stamps::Stamps;
use crate::document::{Job, segmented};
use crate::part::{Digest, Part, Source, Surfaces};
use crate::progress::{Activity, Progress};
use std::convert::Infallible;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What changed while the pipeline was brought up to date.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Changes {
    /// Other surfaces are.
    pub surfaces: bool,
    /// Another set-up is, or the reason why there is none.
    pub setup: bool,
}

/// What is wanted: a job in its file.
struct Wanted {
    job: Job,
    file: Option<PathBuf>,
    keys: Keys,
}

/// The stages.
pub struct Pipeline {
    executor: Arc<dyn Executor>,
    source: Option<Arc<Source>>,
    wanted: Option<Wanted>,
    /// Counts how often the files beside the part were read.
    reading: u64,
    /// How they were then.
    stamps: Stamps,
    /// Surface plans and lines that other plans of this part can use again.
    pub cache: Arc<Cache>,
    part: Stage<Part, PartError>,
    surfaces: Stage<Surfaces, Infallible>,
    tool: Stage<Tool, Arc<JobError>>,
    cell: Stage<Cell, Arc<JobError>>,
    setup: Stage<Setup, Arc<JobError>>,
    lines: Stage<Vec<Arc<Laid>>, PlanError>,
    /// Whether lines are wanted ahead of the plan.
    with_lines: bool,
    plan: Stage<PlannedJob, PlanError>,
}

impl Pipeline {
    /// A pipeline without a part. `with_lines`: lines are laid, to be shown, before the plan is made.
    pub fn new(executor: Arc<dyn Executor>, with_lines: bool) -> Pipeline {
        Pipeline {
            executor,
            source: None,
            wanted: None,
            reading: 0,
            stamps: Stamps::default(),
            cache: Arc::default(),
            part: Stage::default(),
            surfaces: Stage::default(),
            tool: Stage::default(),
            cell: Stage::default(),
            setup: Stage::default(),
            lines: Stage::default(),
            with_lines,
            plan: Stage::default(),
        }
    }

    /// Takes another file, and the part of a job that was built from it if there is one; all else goes.
    pub fn open(&mut self, source: Arc<Source>, built: Option<(&PartFile, Part)>) {
        self.cancel();
        let reading = self.reading + 1;
        let fresh = Pipeline::new(self.executor.clone(), self.with_lines);
        *self = Pipeline { reading, ..fresh };
        if let Some((of, part)) = built {
            self.part.fill(part_key(&source, of), || Ok(part));
        }
        self.source = Some(source);
    }

    /// Who does the work.
    pub fn executor(&self) -> &Arc<dyn Executor> {
        &self.executor
    }

    /// Reads cell, robot, head and clamps again when they are wanted next, and tries again what failed.
    pub fn try_again(&mut self) {
        self.reading += 1;
        self.wanted = None;
        self.part.try_again();
        self.lines.try_again();
        self.plan.try_again();
    }

    /// Looks whether cell, robot, head or clamps are other files by now: what was made of them is out of date then.
    pub fn look_again(&mut self) {
        if self.stamps.have_changed() {
            self.reading += 1;
            self.wanted = None;
        }
    }

    /// Ends the work that is going on; the plan is as good as failed then.
    pub fn cancel(&mut self) {
        self.part.cancel();
        if let Some(keys) = self.wanted.as_ref().map(|w| w.keys)
            && (self.lines.is_running() || self.plan.is_running())
        {
            self.lines.cancel();
            self.plan.fail(keys.plan, Failure::Cancelled);
        }
    }

    /// Takes over other names for what it is synced to: a job that was saved elsewhere is made of what it was made of.
    pub fn renamed(&mut self, from: (&Job, Option<&Path>), to: (&Job, Option<&Path>)) {
        if self.is_synced(from.0, from.1)
            && let Some(wanted) = &mut self.wanted
        {
            (wanted.job, wanted.file) = (to.0.clone(), to.1.map(Path::to_path_buf));
        }
    }

    /// Whether it was synced to this job last, and what it calls current is current.
    pub fn is_synced(&self, job: &Job, job_file: Option<&Path>) -> bool {
        self.wanted.as_ref().is_some_and(|w| w.job == *job && w.file.as_deref() == job_file)
    }

    /// Takes what has arrived for a job in its file, and starts what is out of date.
    pub fn sync(&mut self, job: &Job, job_file: Option<&Path>) -> Changes {
        let mut changes = Changes::default();
        let Some(source) = self.source.clone() else { return changes };
        let keys = self.want(&source, job, job_file);
        self.sync_part(&source, job, &keys, &mut changes);
        self.sync_setup(job, job_file, &keys, &mut changes);
        self.sync_plan(job, &keys);
        changes
    }

    /// The keys of what is wanted: those of the last time, while nothing has changed.
    fn want(&mut self, source: &Source, job: &Job, job_file: Option<&Path>) -> Keys {
        if let Some(known) = self.wanted.as_ref().filter(|_| self.is_synced(job, job_file)) {
            return known.keys;
        }
        let keys = Keys::new(source, job, job_file, self.reading);
        self.wanted = Some(Wanted { job: job.clone(), file: job_file.map(Path::to_path_buf), keys });
        keys
    }

    fn sync_part(&mut self, source: &Arc<Source>, job: &Job, keys: &Keys, changes: &mut Changes) {
        self.part.poll();
        if self.part.lacks(keys.part) {
            let (source, of) = (source.clone(), job.part.clone());
            self.part.start(keys.part, Activity::BuildingPart, &*self.executor, move |progress| {
                if of.is_of_another_file(&source.sha256) {
                    return Err(Failure::Refused(PartError::Changed));
                }
                let made = source.part(of.units, &of.placement, &of.flipped_shells, progress);
                made.map_err(|e| Failure::Refused(e.into()))?.ok_or(Failure::Cancelled)
            });
        }
        let Some(part) = self.part.of(keys.part) else { return };
        if self.surfaces.lacks(keys.surfaces) {
            self.surfaces.fill(keys.surfaces, || Ok(segmented(part, job)));
            changes.surfaces = true;
        }
    }

    /// Files are small and read at once; each is read again only where its own key changes, as frames are
    /// dragged.
    fn sync_setup(&mut self, job: &Job, job_file: Option<&Path>, keys: &Keys, changes: &mut Changes) {
        if !self.setup.lacks(keys.setup) {
            return;
        }
        let refused = |e: JobError| Failure::Refused(Arc::new(e));
        let is_read = self.tool.lacks(keys.tool) || self.cell.lacks(keys.cell);
        if self.tool.lacks(keys.tool) {
            self.tool.fill(keys.tool, || files::load_tool(job, job_file).map_err(refused));
        }
        if self.cell.lacks(keys.cell) {
            self.cell.fill(keys.cell, || files::load_cell(job, job_file).map_err(refused));
        }
        if is_read {
            self.stamps = Stamps::of(job, job_file, self.cell.of(keys.cell).map(|cell| &**cell));
        }
        let (tool, cell) = (current(&self.tool, keys.tool), current(&self.cell, keys.cell));
        self.setup.fill(keys.setup, || {
            let robot = files::load_robot(job, job_file).map_err(refused)?;
            files::set_up(job, robot, (*cell?).clone(), (*tool?).clone()).map_err(refused)
        });
        changes.setup = true;
    }

    fn sync_plan(&mut self, job: &Job, keys: &Keys) {
        self.lines.poll();
        self.plan.poll();
        let (Some(part), Some(surfaces)) = (self.part.of(keys.part), self.surfaces.of(keys.surfaces)) else { return };
        if job.chosen(surfaces).is_empty() {
            self.lines.clear();
            self.plan.clear();
            return;
        }
        let Some(setup) = self.setup.of(keys.setup) else { return };
        let (part, surfaces, setup) = (part.clone(), surfaces.clone(), setup.clone());
        if self.with_lines && self.lines.lacks(keys.plan) {
            let (part, surfaces, job, cache) = (part.clone(), surfaces.clone(), job.clone(), self.cache.clone());
            self.plan.only(keys.plan);
            self.lines.start(keys.plan, Activity::LayingLines, &*self.executor, move |progress| {
                Ok(preview(&part, &surfaces, &job, &cache, progress)?)
            });
        }
        let is_laid = !self.with_lines || !self.lines.is_running();
        if is_laid && self.plan.lacks(keys.plan) {
            let (key, job, cache) = (keys.plan, job.clone(), self.cache.clone());
            self.plan.start(key, Activity::Planning, &*self.executor, move |progress| {
                let plan = plan(&part, &surfaces, &job, &setup, &cache, progress)?;
                let report = Report::new(&plan, &surfaces);
                Ok(PlannedJob { key, job, part, surfaces, setup, plan, report })
            });
        }
    }
}

fn current<V, E: Clone>(stage: &Stage<V, E>, key: Digest) -> Result<Arc<V>, Failure<E>> {
    match (stage.of(key), stage.failure(key)) {
        (Some(value), _) => Ok(value.clone()),
        (None, Some(why)) => Err(why.clone()),
        (None, None) => Err(Failure::Cancelled),
    }
}

/// For those who wait for the plan.
impl Pipeline {
    /// Plans a job in its file on a part, with this thread alone.
    ///
    /// # Errors
    /// Why there is no plan.
    pub fn planned(
        source: Arc<Source>,
        job: &Job,
        job_file: Option<&Path>,
    ) -> Result<(Pipeline, Arc<PlannedJob>), PlanningError> {
        let mut pipeline = Pipeline::new(Arc::new(AtOnce), false);
        pipeline.open(source, None);
        pipeline.sync(job, job_file);
        match (pipeline.plan().cloned(), pipeline.error()) {
            (Some(planned), _) => Ok((pipeline, planned)),
            (None, Some(why)) => Err(why),
            // Nothing was refused, and nothing planned: nothing was chosen.
            (None, None) => Err(PlanningError::Plan(Failure::Refused(PlanError::Nothing))),
        }
    }
}

/// What there is of it. What is named *newest* may be out of date, the rest is current.
impl Pipeline {
    fn keys(&self) -> Option<&Keys> {
        self.wanted.as_ref().map(|w| &w.keys)
    }

    /// The newest plan.
    pub fn newest_plan(&self) -> Option<&Arc<PlannedJob>> {
        self.plan.newest().map(|(_, planned)| planned)
    }

    /// Part and surfaces of the job that was synced last; `None` while they are being made.
    pub fn surfaces(&self) -> Option<(&Arc<Part>, &Arc<Surfaces>)> {
        let keys = self.keys()?;
        Some((self.part.of(keys.part)?, self.surfaces.of(keys.surfaces)?))
    }

    /// Key of its surfaces.
    pub fn surfaces_key(&self) -> Option<Digest> {
        self.keys().map(|keys| keys.surfaces)
    }

    /// The cell of the job that was synced last, with its file's frames, or why there is none.
    pub fn cell(&self) -> Option<Result<&Arc<Cell>, &Failure<Arc<JobError>>>> {
        outcome(&self.cell, self.keys()?.cell)
    }

    /// Robot, cell and head of the job that was synced last, or why there are none.
    pub fn setup(&self) -> Option<Result<&Arc<Setup>, &Failure<Arc<JobError>>>> {
        outcome(&self.setup, self.keys()?.setup)
    }

    /// Key of that.
    pub fn setup_key(&self) -> Option<Digest> {
        self.keys().map(|keys| keys.setup)
    }

    /// Lines of the job that was synced last, while its plan is not there.
    pub fn lines(&self) -> Option<(Digest, &Arc<Vec<Arc<Laid>>>)> {
        let key = self.keys()?.plan;
        self.lines.of(key).filter(|_| self.plan.of(key).is_none()).map(|lines| (key, lines))
    }

    /// The plan of the job that was synced last: what may be called proven, and exported.
    pub fn plan(&self) -> Option<&Arc<PlannedJob>> {
        self.plan.of(self.keys()?.plan)
    }

    /// Key of the dose of that plan.
    pub fn dose_key(&self) -> Option<Digest> {
        self.keys().map(|keys| keys.dose)
    }

    /// Why there is no plan of it.
    pub fn error(&self) -> Option<PlanningError> {
        let keys = self.keys()?;
        if let Some(why) = self.part.failure(keys.part) {
            return Some(why.clone().into());
        }
        if let Some(Err(why)) = self.setup() {
            return Some(why.clone().into());
        }
        self.plan.failure(keys.plan).map(|why| why.clone().into())
    }

    /// Whether nothing is being computed.
    pub fn is_at_rest(&self) -> bool {
        !self.part.is_running() && !self.lines.is_running() && !self.plan.is_running()
    }

    /// How far the work is that is going on.
    pub fn progress(&self) -> Option<&Progress> {
        self.part.progress().or(self.lines.progress()).or(self.plan.progress())
    }
}

fn outcome<V, E>(stage: &Stage<V, E>, key: Digest) -> Option<Result<&Arc<V>, &Failure<E>>> {
    stage.of(key).map(Ok).or_else(|| stage.failure(key).map(Err))
}
