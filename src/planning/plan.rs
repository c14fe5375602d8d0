//! From a job to a plan: planes, lines, poses, program, report. Surfaces whose inputs have not
//! changed are taken from the cache.

use super::report::CellReport;
use super::surface_plan::{Cache, Kept, SurfacePlan, rules, stances};
use super::{layer, written};
use crate::beam::Stance;
use crate::cell::collision::Collision;
use crate::cell::motion::{Arm, Cause, Choice, Memory, Refusal, Watch, Why, choose_again};
use crate::cell::{Joints, Robot, Setup};
use crate::document::model::Job;
use crate::document::parameter;
use crate::part::{Grown, Part, SurfaceId, Surfaces};
use crate::pose::{Pass, State};
use crate::program::drive::{Drive, Known};
use crate::program::lit::Straight;
use crate::program::steps::{Steps, steps};
use crate::program::sweep::{Proof, Prover};
use crate::program::{Timeline, dialects};
use crate::progress::{Activity, Cancelled, Progress};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use thiserror::Error;

/// A plan.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// By surface, in the order of work, layer after layer.
    pub surfaces: Vec<Arc<SurfacePlan>>,
    /// All passes in program order.
    pub passes: Vec<Pass>,
    /// The part as it has grown behind each layer; none where nothing is laid.
    pub grown: Vec<Arc<Grown>>,
    /// The program, step by step.
    pub steps: Steps,
    /// Joints and spin of every target that the robot does, and what it does not; without a robot
    /// nothing is known.
    pub choice: Option<Choice>,
    /// What was refused after the beam had been found free, and why, in program order.
    pub refusals: Vec<Refusal>,
    /// The program over time; without a robot nothing is known of moves by joints.
    pub timeline: Option<Timeline>,
    /// What is proven of its moves with the laser on.
    pub proof: Option<Proof>,
    /// The frames it was made for.
    pub cell: Option<CellReport>,
}

/// Why there is no plan.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PlanError {
    /// A number is out of range.
    #[error("{0}")]
    Parameter(String),
    /// A surface that is not there.
    #[error("surface {surface} does not exist: the part has surfaces {known}; look at `clearbeam inspect`")]
    NoSurface {
        /// The number asked for.
        surface: u32,
        /// Those there are.
        known: String,
    },
    /// Nothing chosen.
    #[error("no surface is chosen; move at least one to the list to clean")]
    Nothing,
    /// Spacing against size.
    #[error("spacing = {spacing_mm} mm is larger than the part ({size_mm:.3} mm); give less, or the right --units")]
    SpacingTooLarge {
        /// Asked for.
        spacing_mm: f64,
        /// Diagonal of the part.
        size_mm: f64,
    },
    /// Spacing against size, the other way.
    #[error(
        "spacing = {spacing_mm} mm would need about {points:.0} points on this part; give more, or the right --units"
    )]
    SpacingTooSmall {
        /// Asked for.
        spacing_mm: f64,
        /// Points of the dense lines, about.
        points: f64,
    },
    /// A coordinate is out of all reason.
    #[error("the part is {size_mm:e} mm large; a facet far away, or the wrong --units? look at `clearbeam inspect`")]
    PartTooLarge {
        /// Diagonal of the part.
        size_mm: f64,
    },
    /// A build-up that closes a hollow.
    #[error(
        "surface {surface} is too hollow for {layers} layers and more: its facets fold over; give fewer layers, or less bead.height_mm"
    )]
    Folds {
        /// The surface.
        surface: u32,
        /// Layers that it has no room for.
        layers: u32,
    },
    /// The user ended it.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for PlanError {
    fn from(_: Cancelled) -> Self {
        PlanError::Cancelled
    }
}

/// Numbers of the surfaces to clean, checked.
fn chosen(surfaces: &Surfaces, job: &Job) -> Result<Vec<u32>, PlanError> {
    let list = job.chosen(surfaces);
    if list.is_empty() {
        return Err(PlanError::Nothing);
    }
    if let Some(&surface) = list.iter().find(|n| surfaces.get(**n).is_none()) {
        let last = surfaces.list.last().map_or(0, |s| s.number);
        return Err(PlanError::NoSurface { surface, known: format!("1 to {last}") });
    }
    Ok(list)
}

/// The surfaces to clean and the job of each, checked.
pub(super) fn prepared<'a>(
    part: &Part,
    surfaces: &Surfaces,
    job: &'a Job,
) -> Result<(Vec<u32>, layer::Own<'a>), PlanError> {
    parameter::check_all(job).map_err(PlanError::Parameter)?;
    let list = chosen(surfaces, job)?;
    let size_mm = part.mesh.diagonal();
    let own: layer::Own<'_> = list.iter().map(|&n| (n, job.of_surface(SurfaceId(n)))).collect();
    if let Some(spacing_mm) = own.values().map(|j| j.layers.spacing_mm).find(|mm| *mm > size_mm) {
        return Err(PlanError::SpacingTooLarge { spacing_mm, size_mm });
    }
    bound_size(surfaces, &own, size_mm)?;
    Ok((list, own))
}

/// Computes the plan of a job.
///
/// # Errors
/// What in the job cannot be planned on; [`PlanError::Cancelled`] when `progress` says so.
pub fn plan(
    part: &Part,
    surfaces: &Surfaces,
    job: &Job,
    setup: &Setup,
    cache: &Cache,
    progress: &Progress,
) -> Result<Plan, PlanError> {
    let (list, own) = prepared(part, surfaces, job)?;
    dialects::check(&job.cell.dialect, setup).map_err(PlanError::Parameter)?;
    let grown = layer::parts(part, surfaces, &own)?;
    let mut kept = Kept::default();
    let (mut surface_plans, mut passes) = (Vec::new(), Vec::new());
    for number in 0..layer::count(&own) {
        let before = number.checked_sub(1).and_then(|n| grown.get(n as usize));
        let on = before.map_or((part, surfaces), |g| (&g.part, &g.surfaces));
        let with = (&setup.tool, cache);
        let made = layer::planned(on, &list, &own, with, number, &mut kept, progress)?;
        passes.extend(made.iter().flat_map(|s| {
            let times = own.get(&s.laid.surface).map_or(1, |j| j.layers.passes as usize);
            (0..times).flat_map(|_| s.passes.iter().cloned())
        }));
        surface_plans.extend(made);
    }
    cache.keep(kept);
    let cell = setup.robot.is_some().then(|| CellReport::new(setup, &job.cell.robot));
    let mut plan = Plan { surfaces: surface_plans, passes, grown, cell, ..Plan::default() };
    for round in 0.. {
        connect(&mut plan, part, setup, job, progress)?;
        let lit = || plan.steps.lit_moves(&setup.mounted());
        // What cannot be written is said when it is; the moves themselves can still be proven.
        let (proof, refuted) = written::proven_as_written(part, &plan, setup, job)
            .unwrap_or_else(|_| (prover(part, setup, job).on_layers(&plan.grown).prove(&lit()), Vec::new()));
        plan.proof = Some(proof);
        if refuted.is_empty() || round == MOST_WRITTEN {
            break;
        }
        let refusals: Vec<Refusal> = refuted.iter().map(as_written).collect();
        plan.refuse(&refusals);
    }
    Ok(plan)
}

/// So often targets are refused whose moves hit something only as they are written.
const MOST_WRITTEN: usize = 6;

fn as_written(r: &written::Refuted) -> Refusal {
    let ((pass, point), hit) = (r.target, r.blocker);
    Refusal { pass, point, cause: Cause::of_blocker(&hit), why: Why::HitAsWritten { hit } }
}

/// Makes the steps between and over the passes; what was refused before stays so.
fn connect(plan: &mut Plan, part: &Part, setup: &Setup, job: &Job, progress: &Progress) -> Result<(), PlanError> {
    let before = std::mem::take(&mut plan.refusals);
    match &setup.robot {
        Some(robot) => drive(plan, part, setup, robot, job, progress)?,
        None => {
            progress.begin(Activity::ConnectingMoves, 1);
            let grown = plan.grown.clone();
            let straight = straight(part, &grown, setup, job);
            let air_mm_s = job.beam.air_speed_mm_s;
            settle(plan, progress, |plan| steps(&straight, setup, &plan.passes, air_mm_s))?;
        }
    }
    plan.refusals.extend(before);
    plan.refusals.sort_by_key(|r| (r.pass, r.point));
    Ok(())
}

/// What proves the lit moves of a job.
pub fn prover<'a>(part: &'a Part, setup: &'a Setup, job: &Job) -> Prover<'a> {
    let deviation_mm = job.cell.deviation_mm;
    let mut all: Vec<Stance<'_>> = stances(job, &setup.tool);
    let mut sag_mm = job.path.chord_error_mm;
    for recipe in &job.recipes {
        let own = recipe.applied(job);
        sag_mm = sag_mm.max(own.path.chord_error_mm);
        for stance in stances(&own, &setup.tool) {
            if !all.iter().any(|s| s.work == stance.work) {
                all.push(stance);
            }
        }
    }
    Prover::new(part, &all, setup.mounted(), deviation_mm, sag_mm)
}

fn straight<'a>(part: &'a Part, grown: &'a [Arc<Grown>], setup: &'a Setup, job: &Job) -> Straight<'a> {
    let prover = prover(part, setup, job).on_layers(grown);
    Straight { prover: prover.with_spare(), deviation_mm: job.cell.deviation_mm }
}

/// Spin, branch and joints of every target, and the program's steps with them. What the robot cannot
/// do is blocked, with its reason.
pub(super) fn drive(
    plan: &mut Plan,
    part: &Part,
    setup: &Setup,
    robot: &Robot,
    job: &Job,
    progress: &Progress,
) -> Result<(), PlanError> {
    let Some(arm) = Arm::new(setup, job.cell.spin) else { return Ok(()) };
    progress.begin(Activity::ChoosingSpins, 2);
    let grown = plan.grown.clone();
    // Arm and head keep clear of all that will be there, from the first layer on.
    let whole = grown.last().map_or(part, |g| &g.part);
    let collision = Collision::new(setup, whole);
    let touches = |joints: &Joints| collision.as_ref()?.first(joints);
    let go_on = || progress.goes_on();
    let beam_free = plan.passes.clone();
    let mut memory = Memory::default();
    let mut closed: BTreeSet<(usize, u8)> = BTreeSet::new();
    // What driving refused stays refused, whatever branch is chosen then.
    let mut refused: Vec<Refusal> = Vec::new();
    let mut best: Option<Plan> = None;
    let drive = Drive {
        part: whole,
        setup,
        mounted: setup.mounted(),
        robot,
        air_mm_s: job.beam.air_speed_mm_s,
        straight: straight(part, &grown, setup, job),
        collision: collision.as_ref(),
        go_on: &go_on,
        known: Known::default(),
    };
    for round in 0.. {
        plan.passes.clone_from(&beam_free);
        (plan.choice, plan.refusals) = (None, Vec::new());
        plan.refuse(&refused);
        let is_open = |pass: usize, branch: u8| !closed.contains(&(pass, branch));
        let watch = Watch { touches: &touches, go_on: &go_on, is_open: &is_open };
        let choice = choose_again(&arm, &plan.passes, &watch, &mut memory);
        let choice = choice.ok_or(PlanError::Cancelled)?;
        plan.refuse(&choice.refusals);
        plan.choice = Some(choice);
        let mut shut = Vec::new();
        settle(plan, progress, |plan| {
            let Some(choice) = &plan.choice else { return Ok(Steps::default()) };
            drive.steps(&plan.passes, choice).map_err(|undriven| {
                if undriven.closed.is_empty() {
                    refused.extend_from_slice(&undriven.refused);
                }
                shut.extend(undriven.closed);
                undriven.refused
            })
        })?;
        if best.as_ref().is_none_or(|b| plan.refusals.len() < b.refusals.len()) {
            best = Some(plan.clone());
        }
        if shut.is_empty() || round == MOST_ROUNDS {
            break;
        }
        closed.extend(shut);
    }
    // Closing a branch for a whole pass may lose pieces of it that could be reached.
    if let Some(best) = best {
        *plan = best;
    }
    plan.timeline = Timeline::new(&plan.steps, setup);
    Ok(())
}

/// So often other branches are tried for passes that no way leads to; the eight branches of an arm, and
/// a few for passes that are shut out only then.
const MOST_ROUNDS: usize = 12;

/// Makes the steps, again and again without what cannot be driven: there is less each time.
fn settle(
    plan: &mut Plan,
    progress: &Progress,
    mut make: impl FnMut(&Plan) -> Result<Steps, Vec<Refusal>>,
) -> Result<(), PlanError> {
    loop {
        match make(plan) {
            Ok(steps) => {
                plan.steps = steps;
                plan.refusals.sort_by_key(|r| (r.pass, r.point));
                progress.step()?;
                return Ok(());
            }
            Err(refused) => plan.refuse(&refused),
        }
        progress.step()?;
    }
}

impl Plan {
    /// What of lines and program is not as it was wanted, by surface: a layer's after those below it.
    pub fn remarks(&self) -> impl Iterator<Item = (u32, &str)> {
        let laid = self.surfaces.iter().flat_map(|s| s.laid.remarks.iter().map(|r| (s.laid.surface, r.as_str())));
        laid.chain(self.steps.remarks.iter().map(|(surface, r)| (*surface, r.as_str())))
    }

    /// Blocks what was refused.
    fn refuse(&mut self, refused: &[Refusal]) {
        for r in refused {
            block(&mut self.passes[r.pass], r.point);
            if let Some(choice) = &mut self.choice {
                choice.rows[r.pass][r.point] = None;
            }
        }
        self.refusals.extend_from_slice(refused);
    }
}

/// The laser is off at a target, and on the way to the next.
fn block(pass: &mut Pass, point: usize) {
    if let Some(t) = pass.targets.get_mut(point) {
        t.state = State::Blocked;
        t.laser = false;
    }
    if let Some(next) = pass.targets.get_mut(point + 1) {
        next.laser = false;
    }
}

/// Refuses what no machine's memory would hold, before anything is allocated.
fn bound_size(surfaces: &Surfaces, own: &BTreeMap<u32, Cow<'_, Job>>, size_mm: f64) -> Result<(), PlanError> {
    // A hundred metres: no robot reaches that, and one flipped bit of a coordinate gives more.
    if size_mm > 1e5 || size_mm.is_nan() {
        return Err(PlanError::PartTooLarge { size_mm });
    }
    // Every plane is cut through every surface at least once.
    let points_of = |(&n, job): (&u32, &Cow<'_, Job>)| {
        let (spacing_mm, gap_mm) = (job.layers.spacing_mm, rules(job).max_gap_mm);
        (surfaces.get(n).map_or(0.0, |s| s.area_mm2) / (spacing_mm * gap_mm) + size_mm / spacing_mm)
            * f64::from(job.layer_count())
    };
    let points: f64 = own.iter().map(points_of).sum();
    let spacing_mm = own.values().map(|j| j.layers.spacing_mm).fold(f64::INFINITY, f64::min);
    if points > MOST_POINTS {
        return Err(PlanError::SpacingTooSmall { spacing_mm, points });
    }
    Ok(())
}

/// Points of dense lines: a square metre at P1's spacing has 8 million, and takes a minute or two.
const MOST_POINTS: f64 = 5e8;
