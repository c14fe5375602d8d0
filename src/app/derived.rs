//! All that is computed from the document: part, surfaces, shapes, pictures, plan. Each keeps the
//! inputs it was made from; [`App::sync`] starts what is out of date.

use super::App;
use super::clearance::Clearances;
use super::motion::Motion;
use super::remedy::Remedy;
use super::worker::Outcome;
use crate::beam::{Obstacle, Optics, Tool};
use crate::cell::{Cell, Setup};
use crate::document::Chosen;
use crate::document::Job;
use crate::document::files;
use crate::document::model::BeamParameters;
use crate::document::model::CellFile;
use crate::document::model::PartFile;
use crate::document::model::SurfaceParameters;
use crate::document::segmented;
use crate::part::{Part, Shape, Surfaces, stl::RawPart};
use crate::picture::{CellPicture, PartPicture, ToolPicture, paths};
use crate::planning;
use crate::planning::Cache;
use crate::planning::Plan;
use crate::planning::lay::Laid;
use crate::planning::report::Report;
use crate::planning::surface_plan::body;
use crate::view::LineItem;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Head and clamps as a job names them.
type ToolFiles = (String, Vec<Obstacle>);

/// Computed state.
#[derive(Default)]
pub struct Derived {
    /// Facets as read from the file.
    pub raw: Option<Arc<RawPart>>,
    /// The part, and what it was built from.
    pub part: Option<Arc<Part>>,
    pub(super) part_of: PartFile,
    rebuilding: Option<PartFile>,
    /// Its feature surfaces.
    pub surfaces: Arc<Surfaces>,
    surfaces_of: Option<(SurfaceParameters, Arc<Part>)>,
    /// Their shapes, as far as known.
    pub shapes: BTreeMap<u32, Shape>,
    /// Head, beam and clamps, and what they were made from.
    pub tool_picture: Option<((BeamParameters, Optics, u64), ToolPicture)>,
    /// Grows with each tool that is read.
    pub tool_count: u64,
    /// What lands.
    pub doses: super::dose::Doses,
    /// Buffers of the part.
    pub picture: Option<PartPicture>,
    /// The cell with the frames of its file, and the names of cell and robot in the job.
    pub cell_file: Option<((String, String), Result<Cell, String>)>,
    /// Head and clamps, and their names in the job.
    pub tool: Option<(ToolFiles, Result<Tool, String>)>,
    /// Cell and robot, and what in the job they were read from.
    pub setup: Option<(CellFile, Result<Setup, String>)>,
    /// Arm, head and floor, where the setup has a robot.
    pub cell: Option<CellPicture>,
    /// The lines of the job whose plan is being made.
    pub laid: Option<(Job, LineItem)>,
    /// The last plan with its report.
    pub plan: Option<(Arc<Plan>, Arc<Report>)>,
    /// The job that it was made for.
    pub plan_of: Option<Job>,
    /// The plan in motion, once that is made.
    pub motion: Option<Arc<Motion>>,
    pub(super) clearances: Clearances,
    /// What would help with what is refused of it.
    pub(super) remedy: Remedy,
    /// Why there is none for the job as it is.
    pub plan_error: Option<(Job, String)>,
    planning: Option<Job>,
    pub(super) cache: Arc<Cache>,
    /// Counts plans, so that pictures of older ones are not taken for new.
    pub plan_count: u64,
}

impl Derived {
    /// Whether all that is shown belongs to this job.
    pub fn is_current(&self, job: &Job) -> bool {
        self.part.is_none() || self.rebuilding.is_none() && (self.is_planned(job) || is_empty(job))
    }

    /// The lines of this job, where its plan is not there yet.
    pub(super) fn laid(&self, job: &Job) -> Option<&LineItem> {
        self.laid.as_ref().filter(|(of, _)| of == job && !self.is_planned(job)).map(|(_, lines)| lines)
    }

    fn is_planned(&self, job: &Job) -> bool {
        self.plan_of.as_ref() == Some(job) || self.plan_error.as_ref().is_some_and(|(of, _)| of == job)
    }

    /// Numbers of all surfaces.
    pub fn numbers(&self) -> Vec<u32> {
        self.surfaces.list.iter().map(|s| s.number).collect()
    }

    /// Name of a surface in lists and at the cursor.
    pub fn label(&self, job: &Job, surface: u32) -> String {
        match job.surfaces.names.get(&surface.to_string()) {
            Some(name) => name.clone(),
            None => self.shapes.get(&surface).map_or_else(|| "…".into(), Shape::label),
        }
    }
}

fn is_empty(job: &Job) -> bool {
    job.clean.surfaces == Chosen::These(Vec::new())
}

impl App {
    /// Brings what is out of date on its way.
    pub(super) fn sync(&mut self) {
        let job = self.document.job().clone();
        let d = &mut self.derived;
        let Some(raw) = d.raw.clone() else { return };
        if d.part_of != job.part && d.rebuilding.as_ref() != Some(&job.part) {
            d.rebuilding = Some(job.part.clone());
            let (of, sha) = (job.part.clone(), d.part.as_ref().map(|p| p.sha256.clone()).unwrap_or_default());
            self.worker.spawn(move || {
                let part = Part::from_raw(&raw, sha, of.units, &of.placement, &of.flipped_shells);
                Outcome::Rebuilt(part.map(Arc::new).map_err(|e| e.to_string()))
            });
            return;
        }
        let Some(part) = self.derived.part.clone() else { return };
        self.sync_surfaces(&part, &job);
        self.sync_borders(&part);
        self.sync_cell(&job);
        self.sync_tool(&job);
        self.sync_plan(part, job);
        self.sync_dose();
        self.sync_spacing();
        self.sync_advice();
        self.sync_clearance();
    }

    fn sync_surfaces(&mut self, part: &Arc<Part>, job: &Job) {
        let d = &mut self.derived;
        let same = |(of, p): &(SurfaceParameters, Arc<Part>)| {
            Arc::ptr_eq(p, part)
                && SurfaceParameters { names: BTreeMap::new(), ..of.clone() }
                    == SurfaceParameters { names: BTreeMap::new(), ..job.surfaces.clone() }
        };
        if d.surfaces_of.as_ref().is_some_and(same) {
            return;
        }
        d.surfaces = Arc::new(segmented(part, job));
        d.surfaces_of = Some((job.surfaces.clone(), part.clone()));
        d.picture = Some(PartPicture::new(part, &d.surfaces));
        let there = |n: &u32| d.surfaces.get(*n).is_some();
        self.session.selected.retain(there);
        self.session.hidden.retain(there);
        let (part, surfaces) = (part.clone(), d.surfaces.clone());
        self.worker.spawn(move || {
            use rayon::prelude::*;
            let shapes = surfaces.list.par_iter().map(|s| (s.number, Shape::of(&part.mesh, s))).collect();
            Outcome::Shaped(surfaces, shapes)
        });
    }

    fn sync_cell(&mut self, job: &Job) {
        let d = &mut self.derived;
        let tool_named = (job.beam.head.clone(), job.clamps.clone());
        let same_tool = d.tool.as_ref().is_some_and(|(of, _)| *of == tool_named);
        if same_tool && d.setup.as_ref().is_some_and(|(of, _)| *of == job.cell) {
            return;
        }
        let file = self.document.file();
        let named = (job.cell.file.clone(), job.cell.robot.clone());
        // Frames are dragged: the file with its obstacles is not read again for each step.
        if d.cell_file.as_ref().is_none_or(|(of, _)| *of != named) {
            d.cell_file = Some((named, files::load_cell(job, file).map_err(|e| e.to_string())));
        }
        if !same_tool {
            d.tool_count += 1;
            d.tool = Some((tool_named, files::load_tool(job, file).map_err(|e| e.to_string())));
        }
        let tool = d.tool.as_ref().map_or(Err(String::new()), |(_, tool)| tool.clone());
        let cell = d.cell_file.as_ref().map_or(Err(String::new()), |(_, cell)| cell.clone());
        let robot = files::load_robot(job, file).map_err(|e| e.to_string());
        let setup = robot.and_then(|robot| files::set_up(job, robot, cell?, tool?).map_err(|e| e.to_string()));
        let stands = |c: &CellFile| (c.file.clone(), c.robot.clone(), c.mount);
        let same = d.setup.as_ref().is_some_and(|(of, _)| stands(of) == stands(&job.cell));
        d.cell = setup.as_ref().ok().and_then(CellPicture::new);
        d.setup = Some((job.cell.clone(), setup));
        if !same {
            self.session.other_camera = None;
            self.session.fit_pending |= self.session.show.cell;
        }
    }

    fn sync_tool(&mut self, job: &Job) {
        let d = &mut self.derived;
        let of = (job.beam.clone(), job.optics, d.tool_count);
        if d.tool_picture.as_ref().is_some_and(|(known, _)| *known == of) {
            return;
        }
        let Some((_, Ok(setup))) = &d.setup else { return };
        d.tool_picture = Some((of, ToolPicture::new(&setup.tool, body(job, setup).as_ref())));
    }

    fn sync_plan(&mut self, part: Arc<Part>, job: Job) {
        let d = &mut self.derived;
        if is_empty(&job) {
            d.plan = None;
            d.motion = None;
            d.plan_of = None;
            d.plan_error = None;
            return;
        }
        if d.is_planned(&job) || d.planning.as_ref() == Some(&job) {
            return;
        }
        let setup = match &d.setup {
            Some((_, Ok(setup))) => setup.clone(),
            Some((_, Err(why))) => {
                d.plan_error = Some((job, why.clone()));
                return;
            }
            None => return,
        };
        d.planning = Some(job.clone());
        let (surfaces, cache) = (d.surfaces.clone(), d.cache.clone());
        let shown = d.plan.as_ref().map(|(plan, _)| plan.clone());
        self.worker.plan(move |progress, meanwhile| {
            // A plan takes a while: where its lines lie is shown at once, unless they are those that are shown.
            let is_shown = |laid: &[Arc<Laid>]| {
                let of_plan = shown.iter().flat_map(|plan| &plan.surfaces).filter(|s| s.laid.layer == 0);
                of_plan.map(|s| Arc::as_ptr(&s.laid)).eq(laid.iter().map(Arc::as_ptr))
            };
            let laid = planning::preview(&part, &surfaces, &job, &cache, progress);
            if let Some(laid) = laid.ok().filter(|laid| !is_shown(laid)) {
                meanwhile(Outcome::Laid(Box::new(job.clone()), paths::laid(&laid)));
            }
            let plan = planning::plan(&part, &surfaces, &job, &setup, &cache, progress);
            let result = plan.map(|plan| {
                let report = Report::new(&plan, &surfaces);
                (Arc::new(plan), Arc::new(report))
            });
            Outcome::Planned(Box::new(job), result)
        });
    }

    /// Takes over what threads have brought.
    pub(super) fn take_results(&mut self) {
        while let Some(outcome) = self.worker.take() {
            match outcome {
                Outcome::Opened(result) => self.opened(result),
                Outcome::Rebuilt(result) => self.rebuilt(result),
                Outcome::Shaped(of, shapes) => {
                    if Arc::ptr_eq(&of, &self.derived.surfaces) {
                        self.derived.shapes = shapes;
                    }
                }
                Outcome::Dosed(of, view) => self.dosed(of, view),
                Outcome::Laid(job, lines) => self.derived.laid = Some((*job, lines)),
                Outcome::Planned(job, result) => self.planned(*job, result),
                Outcome::Moving(of, motion) => self.moving(of, motion),
                Outcome::Cleared(of, curve) => self.cleared(of, curve),
                Outcome::Advised(of, told) => self.advised(of, told),
                Outcome::Proposed(of, proposal) => self.proposed(of, proposal),
                Outcome::Exported(result) => self.exported(result),
                Outcome::Picked(purpose, path) => self.picked(purpose, path),
            }
        }
    }

    fn rebuilt(&mut self, result: Result<Arc<Part>, String>) {
        let Some(of) = self.derived.rebuilding.take() else { return };
        self.derived.part_of = of;
        match result {
            Ok(part) => {
                self.derived.part = Some(part);
                self.session.fit_pending = true;
            }
            Err(why) => self.session.error = Some(why),
        }
    }

    fn planned(&mut self, job: Job, result: Result<(Arc<Plan>, Arc<Report>), planning::PlanError>) {
        let d = &mut self.derived;
        if d.planning.as_ref() == Some(&job) {
            d.planning = None;
        }
        if job != *self.document.job() {
            return; // made for a job that is no more
        }
        d.laid = None;
        match result {
            Ok(plan) => {
                d.plan = Some(plan);
                d.plan_of = Some(job);
                d.plan_error = None;
                d.plan_count += 1;
                d.motion = None;
                self.start_motion();
            }
            Err(planning::PlanError::Cancelled) => {
                d.plan_error = Some((job, "planning was cancelled; Ctrl+R plans again".into()))
            }
            Err(e) => d.plan_error = Some((job, e.to_string())),
        }
    }

    /// Works out the motion of the plan.
    fn start_motion(&mut self) {
        let d = &self.derived;
        let (Some((plan, report)), Some((_, Ok(setup))), Some(job)) = (&d.plan, &d.setup, &d.plan_of) else { return };
        let (plan, setup, job, report) = (plan.clone(), setup.clone(), job.clone(), report.clone());
        let (part_name, key) = (self.part_file_name(), d.plan_count);
        self.worker
            .spawn(move || Outcome::Moving(key, Arc::new(Motion::new(&job, &part_name, &setup, &plan, &report, key))));
    }

    fn moving(&mut self, of: u64, motion: Arc<Motion>) {
        if of == self.derived.plan_count && self.derived.plan.is_some() {
            self.derived.motion = Some(motion);
            self.session.plot_span = None;
            self.session.text_line = None;
            self.go_to_target(self.session.at);
        }
    }

    /// Plans again what was cancelled.
    pub(super) fn plan_again(&mut self) {
        self.derived.plan_error = None;
        self.derived.plan_of = None;
    }

    /// Takes a part that was opened.
    pub(super) fn take_part(&mut self, raw: Arc<RawPart>, part: Arc<Part>, of: PartFile) {
        self.end_searches();
        self.derived = Derived {
            raw: Some(raw),
            part: Some(part),
            part_of: of,
            plan_count: self.derived.plan_count,
            ..Derived::default()
        };
        self.session.fit_pending = true;
    }
}
