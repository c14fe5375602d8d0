//! What is left of a plan after a stop: passes before the one to go on with count as done, and what comes behind stays as
//! it was, on the part as it has grown. Only the way in from home is new, and looked for as a plan's own is.

use super::driving::driver;
use super::plan::Plan;
use super::proof::as_written::proven_as_written;
use super::proof::straight;
use crate::cell::Setup;
use crate::cell::collision::Collision;
use crate::document::model::Job;
use crate::part::{GrownPart, Part};
use crate::program::{Go, Shortfall, Steps, Timeline, dialects, pacing, steps_from, way_from_home};
use crate::progress::Progress;
use thiserror::Error;

/// Why a plan cannot go on from a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum FromPassError {
    /// It has no such pass.
    #[error("pass {asked} of {passes}")]
    NoPass {
        /// The pass that was asked for.
        asked: usize,
        /// How many there are; the first is 0.
        passes: usize,
    },
    /// No way leads from home to its first target.
    #[error("no way from home to pass {pass}")]
    NoWay {
        /// The first pass that is left to work.
        pass: usize,
    },
}

/// What is left of a plan from a pass on; passes before it have no targets.
///
/// # Errors
/// There is no such pass, or no way to it.
pub fn from_pass(
    part: &Part,
    plan: &Plan,
    setup: &Setup,
    job: &Job,
    first: usize,
    progress: &Progress,
) -> Result<Plan, FromPassError> {
    let passes = plan.passes.len();
    if first >= passes {
        return Err(FromPassError::NoPass { asked: first, passes });
    }
    let steps = steps(part, plan, setup, job, first, progress)?;
    let mut left = plan.clone();
    for done in &mut left.passes[..first] {
        (done.targets, done.splits) = (Vec::new(), Vec::new());
        (done.line_points, done.dense_points, done.chord_error_mm) = (0, 0, 0.0);
    }
    left.refusals.retain(|r| r.pass >= first);
    left.timeline = Timeline::new(&steps, setup).filter(|_| plan.timeline.is_some());
    left.steps = steps;
    // What cannot be written or read back is told when it is.
    left.proof = proven_as_written(part, &left, setup, job, progress).ok().map(|(proof, _)| proof);
    Ok(left)
}

fn steps(
    part: &Part,
    plan: &Plan,
    setup: &Setup,
    job: &Job,
    first: usize,
    progress: &Progress,
) -> Result<Steps, FromPassError> {
    let straight = straight(part, &plan.grown, setup, job, progress);
    let left = match &setup.robot {
        None => {
            let air_mm_s = job.beam.air_speed_mm_s;
            let way_in = |entry: &Go| Some(way_from_home(&straight, setup, &plan.passes, entry, air_mm_s));
            steps_from(&plan.steps, &plan.passes, first, &way_in)
        }
        Some(robot) => {
            let collision = Collision::new(setup, GrownPart::largest(part, &plan.grown));
            let drive = driver((setup, robot), job, straight, collision.as_ref(), &plan.cuts, progress);
            let way_in = |entry: &Go| drive.way_from_home(&plan.passes, entry);
            steps_from(&plan.steps, &plan.passes, first, &way_in)
        }
    };
    let mut left = left.map_err(|e| FromPassError::NoWay { pass: e.pass })?;
    // The way in is new, and has to have times that the controller's words know. The moves behind it have them; what of
    // them is slower than it was to be is known of the whole plan.
    left.shortfalls.retain(|(_, s)| !matches!(s, Shortfall::ShortMoves { .. }));
    if let Some(dialect) = dialects::by_name(&job.cell.dialect) {
        pacing::pace(&mut left, &plan.passes, setup, dialect);
    }
    left.off_speed.clone_from(&plan.steps.off_speed);
    Ok(left)
}
