//! Passes become steps with a robot: spins and branches are chosen, the way is driven, and what cannot be driven is
//! refused, until the rest can.

use super::error::PlanError;
use super::plan::Plan;
use super::proof::straight;
use crate::cell::collision::Collision;
use crate::cell::motion::{Arm, Refusal, SearchHooks, TargetStateCache, choose_again};
use crate::cell::{Joints, Robot, Setup};
use crate::document::model::Job;
use crate::part::{GrownPart, Part};
use crate::program::lit::StraightFlange;
use crate::program::{Cuts, Drive, DriveCache, Steps};
use crate::progress::{Activity, Progress};
use std::collections::BTreeSet;

/// So often other branches are tried for passes that no way leads to; the eight branches of an arm, and
/// a few for passes that are shut out only then.
const MOST_ROUNDS: usize = 12;

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
    let (grown, cuts) = (plan.grown.clone(), plan.cuts.clone());
    // Arm and head keep clear of all that will be there, from the first layer on, and of what is ground off, to the last pass.
    let whole = GrownPart::largest(part, &grown);
    let collision = Collision::new(setup, whole);
    let touches = |joints: &Joints| collision.as_ref()?.first_contact(joints);
    let go_on = || progress.goes_on();
    let beam_free = plan.passes.clone();
    let mut closed: BTreeSet<(usize, u8)> = BTreeSet::new();
    let mut known = EarlierRounds::default();
    let mut best: Option<Plan> = None;
    let straight = straight(part, &grown, setup, job, progress);
    let drive = driver((setup, robot), job, straight, collision.as_ref(), &cuts, progress);
    for round in 0.. {
        plan.passes.clone_from(&beam_free);
        let is_open = |pass: usize, branch: u8| !closed.contains(&(pass, branch));
        let watch = SearchHooks { touches: &touches, go_on: &go_on, is_open: &is_open };
        let shut = choose_and_drive(plan, &arm, &drive, &watch, &mut known, progress)?;
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
    Ok(())
}

/// What drives the passes of a job, nothing worked out yet.
pub(super) fn driver<'a>(
    (setup, robot): (&'a Setup, &'a Robot),
    job: &Job,
    straight: StraightFlange<'a>,
    collision: Option<&'a Collision<'a>>,
    cuts: &'a Cuts,
    progress: &'a Progress,
) -> Drive<'a> {
    let (mounted, air_mm_s, cache) = (setup.mounted(), job.beam.air_speed_mm_s, DriveCache::default());
    Drive { setup, mounted, robot, air_mm_s, straight, collision, progress, cuts, cache }
}

/// What was found out in the rounds before.
#[derive(Default)]
struct EarlierRounds {
    target_states: TargetStateCache,
    /// What driving refused stays refused, whatever branch is chosen then.
    refused: Vec<Refusal>,
}

/// Chooses spins and branches once and drives the way; gives the branches of passes that no way leads to.
fn choose_and_drive(
    plan: &mut Plan,
    arm: &Arm<'_>,
    drive: &Drive<'_>,
    watch: &SearchHooks<'_>,
    known: &mut EarlierRounds,
    progress: &Progress,
) -> Result<Vec<(usize, u8)>, PlanError> {
    (plan.choice, plan.refusals) = (None, Vec::new());
    plan.refuse(&known.refused);
    let choice = choose_again(arm, &plan.passes, watch, &mut known.target_states).ok_or(PlanError::Cancelled)?;
    plan.refuse(&choice.refusals);
    plan.choice = Some(choice);
    let mut shut = Vec::new();
    settle(plan, progress, |plan| {
        let Some(choice) = &plan.choice else { return Ok(Steps::default()) };
        drive.steps(&plan.passes, choice).map_err(|undriven| {
            if undriven.closed.is_empty() {
                known.refused.extend_from_slice(&undriven.refused);
            }
            shut.extend(undriven.closed);
            undriven.refused
        })
    })?;
    Ok(shut)
}

/// Makes the steps, again and again without what cannot be driven: there is less each time.
pub(super) fn settle(
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
