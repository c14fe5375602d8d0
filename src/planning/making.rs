//! A plan is made: lines and poses layer by layer, the moves between, and the proof of the lit ones as they are
//! written. What a surface's plan is made of is taken from the cache where its inputs have not changed.

use super::driving::{drive, settle};
use super::error::PlanError;
use super::plan::Plan;
use super::plan::build_up::{LayerInput, grown_parts, layer_count, plan_layer};
use super::plan::cell_report::CellReport;
use super::plan::prepared::prepare;
use super::plan::surface_plan::{PlanCache, PlanCacheContents};
use super::proof::as_written::{Refuted, UnprovenProgram, proven_as_written};
use super::proof::{prover, straight};
use crate::cell::Setup;
use crate::cell::motion::{Refusal, RefusalCause, RefusalReason};
use crate::document::model::Job;
use crate::part::{Part, Surfaces};
use crate::program::{DialectError, Timeline, dialects, pacing, steps};
use crate::progress::{Activity, Progress};

/// So often targets are refused whose moves hit something only as they are written.
const MOST_WRITTEN: usize = 6;

fn refusal_as_written(r: &Refuted) -> Refusal {
    let ((pass, point), hit) = (r.target, r.blocker);
    Refusal { pass, point, cause: RefusalCause::of_blocker(&hit), why: RefusalReason::HitAsWritten { hit } }
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
    cache: &PlanCache,
    progress: &Progress,
) -> Result<Plan, PlanError> {
    let (list, own) = prepare(part, surfaces, job)?;
    dialects::check(&job.cell.dialect, setup)?;
    let grown = grown_parts(part, surfaces, &own, progress)?;
    let mut used = PlanCacheContents::default();
    let (mut surface_plans, mut passes) = (Vec::new(), Vec::new());
    for number in 0..layer_count(surfaces, &own) {
        let before = number.checked_sub(1).and_then(|n| grown.get(n as usize));
        let (part, surfaces) = before.map_or((part, surfaces), |g| (&g.part, &g.surfaces));
        let of = LayerInput { part, surfaces, list: &list, jobs: &own, layer: number };
        let made = plan_layer(&of, setup, cache, &mut used, progress)?;
        passes.extend(made.iter().flat_map(|s| {
            let times = own.get(&s.toolpath.surface).map_or(1, |j| j.layers.passes as usize);
            (0..times).flat_map(|_| s.passes.iter().cloned())
        }));
        surface_plans.extend(made);
    }
    cache.keep(used);
    let cell = setup.robot.is_some().then(|| CellReport::new(setup, &job.cell.robot));
    let mut plan = Plan { surfaces: surface_plans, passes, grown, cell, ..Plan::default() };
    for round in 0.. {
        connect(&mut plan, part, setup, job, progress)?;
        let (proof, refuted) = match proven_as_written(part, &plan, setup, job, progress) {
            Ok(proven) => proven,
            Err(UnprovenProgram::Cancelled) => return Err(PlanError::Cancelled),
            // A plan that no program can be made of is none.
            Err(UnprovenProgram::Unwritable(e)) => return Err(e.into()),
            // Export says that its own text cannot be read; the moves themselves can still be proven.
            Err(UnprovenProgram::Empty | UnprovenProgram::Unreadable(_)) => {
                let lit = plan.steps.lit_moves(&setup.mounted());
                let prover = prover(part, setup, job).on_layers(&plan.grown).under(progress);
                (prover.prove(lit)?, Vec::new())
            }
        };
        plan.proof = Some(proof);
        if refuted.is_empty() || round == MOST_WRITTEN {
            break;
        }
        let refusals: Vec<Refusal> = refuted.iter().map(refusal_as_written).collect();
        plan.refuse(&refusals);
    }
    Ok(plan)
}

/// Makes the steps between and over the passes, in pieces that the controller takes; what was refused before stays so.
fn connect(plan: &mut Plan, part: &Part, setup: &Setup, job: &Job, progress: &Progress) -> Result<(), PlanError> {
    let dialect = dialects::known(&job.cell.dialect).map_err(DialectError::from)?;
    loop {
        connect_pieces(plan, part, setup, job, progress)?;
        let more = pacing::cuts(&plan.steps, setup, dialect);
        // There are more of them each time, so it ends.
        if more.is_subset(&plan.cuts) {
            break;
        }
        plan.cuts.extend(more);
    }
    pacing::pace(&mut plan.steps, &plan.passes, setup, dialect);
    plan.timeline = Timeline::new(&plan.steps, setup);
    Ok(())
}

fn connect_pieces(
    plan: &mut Plan,
    part: &Part,
    setup: &Setup,
    job: &Job,
    progress: &Progress,
) -> Result<(), PlanError> {
    let before = std::mem::take(&mut plan.refusals);
    match &setup.robot {
        Some(robot) => drive(plan, part, setup, robot, job, progress)?,
        None => {
            progress.begin(Activity::ConnectingMoves, 1);
            let (grown, cuts) = (plan.grown.clone(), plan.cuts.clone());
            let straight = straight(part, &grown, setup, job, progress);
            let air_mm_s = job.beam.air_speed_mm_s;
            settle(plan, progress, |plan| steps(&straight, setup, &plan.passes, &cuts, air_mm_s))?;
        }
    }
    plan.refusals.extend(before);
    plan.refusals.sort_by_key(|r| (r.pass, r.point));
    Ok(())
}
