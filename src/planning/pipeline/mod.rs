//! The one pipeline from a part's file and a job to a plan. Window, command line, `render` and `verify` ask it.
//!
//! A stage becomes stale when its key does (see `key`); it is started once what it is made of is current. A
//! plan carries the part, the surfaces and the set-up that it was made of, so that nobody has to put together
//! what belongs together. `syncing` takes and starts work, `current` tells what there is.

mod current;
mod line_stage;
mod scan_stages;
mod syncing;
mod weld_stages;

use super::error::{PartError, PlanError, PlanningError};
use super::executor::Executor;
use super::failure::Failure;
use super::key::{Keys, part_key};
use super::planned::PlannedJob;
use super::pool::AtOnce;
use super::stage::Stage;
use super::surface_plan::PlanCache;
use crate::beam::Tool;
use crate::cell::{Cell, Robot, Setup};
use crate::document::Job;
use crate::document::files::JobError;
use crate::document::model::JobPart;
use crate::document::stamps::Stamps;
use crate::part::{Digest, Part, Source, Surfaces};
use line_stage::LineStage;
use scan_stages::ScanStages;
use std::convert::Infallible;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use weld_stages::WeldStages;

/// What changed while the pipeline was brought up to date.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Changes {
    /// The surfaces are others.
    pub surfaces: bool,
    /// The set-up is another, or the reason why there is none.
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
    /// Time and size of those files when they were read.
    stamps: Stamps,
    /// Keys of tool, cell, scan and weld that those were taken for.
    stamped: Option<(Digest, Digest, [Option<Digest>; 2])>,
    /// Surface plans and lines that other plans of this part can use again.
    pub cache: Arc<PlanCache>,
    part: Stage<Part, PartError>,
    surfaces: Stage<Surfaces, Infallible>,
    scan: ScanStages,
    weld: WeldStages,
    /// Key of the part and surfaces that were told last.
    told: Option<Digest>,
    tool: Stage<Tool, Arc<JobError>>,
    cell: Stage<Cell, Arc<JobError>>,
    /// By the key of the cell, which is made of the robot's name as well.
    robot: Stage<Option<Robot>, Arc<JobError>>,
    setup: Stage<Setup, Arc<JobError>>,
    lines: LineStage,
    /// Whether lines are wanted ahead of the plan.
    with_lines: bool,
    plan: Stage<PlannedJob, PlanError>,
}

impl Pipeline {
    /// A pipeline without a part. `with_lines`: toolpaths are made, to be shown, before the plan.
    pub fn new(executor: Arc<dyn Executor>, with_lines: bool) -> Pipeline {
        Pipeline {
            executor,
            source: None,
            wanted: None,
            reading: 0,
            stamps: Stamps::default(),
            stamped: None,
            cache: Arc::default(),
            part: Stage::default(),
            surfaces: Stage::default(),
            scan: ScanStages::default(),
            weld: WeldStages::default(),
            told: None,
            tool: Stage::default(),
            cell: Stage::default(),
            robot: Stage::default(),
            setup: Stage::default(),
            lines: LineStage::default(),
            with_lines,
            plan: Stage::default(),
        }
    }

    /// Takes another file, and the part of a job that was built from it if there is one; all else goes.
    pub fn open(&mut self, source: Arc<Source>, built: Option<(&JobPart, Part)>) {
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
        self.scan.try_again();
        self.weld.try_again();
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
        self.scan.cancel();
        self.weld.cancel();
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
