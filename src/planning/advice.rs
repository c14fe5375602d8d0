//! What would help where the robot refuses targets of a plan: changes that were tried, a slower spot,
//! and a better set-up.

use super::PlanError;
use super::driving::drive;
use super::plan::Plan;
use super::surface_plan::PlanCache;
use crate::beam::ProcessSettings;
use crate::cell::motion::advice::{self, BetterSetup, SAMPLE, SetupChange, SuggestedChange, sampled};
use crate::cell::motion::{Arm, Refusal, RefusalCause, SearchHooks, choose};
use crate::cell::{Frame, Mount, Setup, Spin};
use crate::document::Edit;
use crate::document::model::{Job, JobCell};
use crate::part::{Part, Surfaces};
use crate::pose::{Pass, TargetState};
use crate::progress::{Activity, Cancelled, Progress};
use nalgebra::{Isometry3, Point3};

/// Passes that are driven again, slower.
const PASSES: usize = 6;
/// Passes that proposed set-ups are tried on.
const TRIED_PASSES: usize = 24;
/// Key of the speed of the spot.
const SPEED: &str = "beam.speed_mm_s";
/// Shares of the speed that are tried.
const SLOWER: [f64; 5] = [0.75, 0.5, 0.3, 0.2, 0.1];

fn refusals(plan: &Plan) -> &[Refusal] {
    &plan.refusals
}

/// A path frame of every target that the robot does, and of every one that it refuses for where it is.
fn frames(plan: &Plan) -> [Vec<Isometry3<f64>>; 2] {
    let done = plan
        .passes
        .iter()
        .flat_map(|p| p.targets.iter().map(|t| (t, p.settings.defocus_mm)))
        .filter(|(t, _)| t.state != TargetState::Blocked)
        .map(|(t, defocus_mm)| t.frame(defocus_mm))
        .collect();
    let placed =
        |r: &&Refusal| matches!(r.cause, RefusalCause::Reach | RefusalCause::Limit | RefusalCause::Singularity);
    let frame = |r: &Refusal| plan.passes[r.pass].targets[r.point].frame(plan.passes[r.pass].settings.defocus_mm);
    let refused = refusals(plan).iter().filter(placed).map(frame).collect();
    [done, refused]
}

/// Something that would help, or how far that was looked into.
#[derive(Clone, Debug, PartialEq)]
pub enum Suggestion {
    /// A change of the set-up.
    SetupChange(SuggestedChange),
    /// A slower spot, with which no joint is too fast.
    Slower {
        /// Its speed on the part.
        speed_mm_s: f64,
    },
    /// The changes were tried on some of the refused targets only.
    Sampled {
        /// How many refused targets were tried.
        tried: usize,
        /// How many refused targets there are.
        of: usize,
    },
}

impl Suggestion {
    /// The edit that does it. `None`: it is no change, or surfaces have speeds of their own.
    pub fn edit(&self, job: &Job, setup: &Setup) -> Option<Edit> {
        match self {
            Suggestion::SetupChange(SuggestedChange { change: SetupChange::FreeSpin, .. }) => {
                Some(Edit::Spin(Spin::Free))
            }
            Suggestion::SetupChange(SuggestedChange { change, .. }) => {
                let (now, then) = (&setup.cell, change.applied(setup).cell);
                let mut cell = job.cell.clone();
                let changed = |now: &Frame, then: Frame| (*now != then).then_some(then);
                let own = [
                    (&mut cell.flange_from_part, changed(&now.flange_from_part, then.flange_from_part)),
                    (&mut cell.base_from_laser, changed(&now.base_from_laser, then.base_from_laser)),
                    (&mut cell.base_from_part, changed(&now.base_from_part, then.base_from_part)),
                ];
                for (frame, changed) in own {
                    *frame = changed.or(frame.take());
                }
                Some(Edit::Frames(Box::new(cell)))
            }
            Suggestion::Slower { speed_mm_s } => {
                let has_own = job.recipes.iter().any(|recipe| recipe.values.contains_key(SPEED));
                (!has_own).then_some(Edit::Set(SPEED, *speed_mm_s))
            }
            Suggestion::Sampled { .. } => None,
        }
    }
}

/// What would help, the best first; nothing where nothing was refused, or nothing helps.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn suggestions(
    part: &Part,
    plan: &Plan,
    job: &Job,
    setup: &Setup,
    progress: &Progress,
) -> Result<Vec<Suggestion>, Cancelled> {
    let [done, refused] = frames(plan);
    let samples = [&done, &refused].map(|all| sampled(all, SAMPLE));
    let found = advice::changes(setup, part, job.cell.spin, &samples[0], &samples[1], progress)?;
    let on_some = Suggestion::Sampled { tried: SAMPLE, of: refused.len() };
    let is_sampled = refused.len() > SAMPLE && !found.is_empty();
    let mut out: Vec<Suggestion> = found.into_iter().map(Suggestion::SetupChange).collect();
    out.extend(slower(plan, job, setup, progress)?.map(|speed_mm_s| Suggestion::Slower { speed_mm_s }));
    out.extend(is_sampled.then_some(on_some));
    Ok(out)
}

/// The highest of some lower speeds of the spot, mm/s, at which passes that are too fast can be driven.
fn slower(plan: &Plan, job: &Job, setup: &Setup, progress: &Progress) -> Result<Option<f64>, Cancelled> {
    let mut numbers: Vec<usize> =
        refusals(plan).iter().filter(|r| r.cause == RefusalCause::Speed).map(|r| r.pass).collect();
    numbers.dedup();
    let again: Vec<Pass> = sampled(&numbers, PASSES)
        .into_iter()
        .map(|n| {
            let mut pass = plan.passes[n].clone();
            for r in refusals(plan).iter().filter(|r| r.pass == n) {
                // The target as the beam left it, before the robot refused it.
                pass.targets[r.point].state = TargetState::Free;
                pass.targets[r.point].laser = r.point > 0;
                if let Some(next) = pass.targets.get_mut(r.point + 1) {
                    next.laser = next.state != TargetState::Blocked;
                }
            }
            pass
        })
        .collect();
    let Some(arm) = Arm::new(setup, job.cell.spin).filter(|_| !again.is_empty()) else { return Ok(None) };
    let go_on = || progress.goes_on();
    let watch = SearchHooks { go_on: &go_on, ..SearchHooks::default() };
    progress.begin(Activity::TryingSpeeds, SLOWER.len());
    for share in SLOWER {
        let slower: Vec<Pass> = again
            .iter()
            .map(|p| Pass {
                settings: ProcessSettings { speed_mm_s: share * p.settings.speed_mm_s, ..p.settings },
                ..p.clone()
            })
            .collect();
        let choice = choose(&arm, &slower, &watch).ok_or(Cancelled)?;
        if !choice.refusals.iter().any(|r| r.cause == RefusalCause::Speed) {
            let speed_mm_s = slower.iter().map(|p| p.settings.speed_mm_s).fold(f64::INFINITY, f64::min);
            return Ok(Some(speed_mm_s));
        }
        progress.step()?;
    }
    Ok(None)
}

/// The mounting with which most of the work can be done, and how many targets are refused with it: what
/// was found on single targets is planned before it is offered, first on some passes beside what there is, the best on all.
/// `None`: nothing is better.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn better_setup(
    part: &Part,
    surfaces: &Surfaces,
    plan: &Plan,
    job: &Job,
    setup: &Setup,
    cache: &PlanCache,
    progress: &Progress,
) -> Result<Option<(BetterSetup, usize)>, Cancelled> {
    if refusals(plan).is_empty() {
        return Ok(None);
    }
    let [mut done, refused] = frames(plan);
    done.extend(refused);
    // The passes as they were before the robot refused anything.
    let passes: Vec<&Pass> = plan.surfaces.iter().flat_map(|s| &s.passes).collect();
    let passes: Vec<Pass> = sampled(&passes, TRIED_PASSES).into_iter().cloned().collect();
    let changed = |better: &BetterSetup| {
        let job = Job { cell: applied(&job.cell, setup.mount, better), ..job.clone() };
        let mut setup = setup.clone();
        job.cell.put_frames(&mut setup.cell);
        (job, setup)
    };
    let found = advice::better_setups(setup, part, &sampled(&done, 3 * SAMPLE), progress)?;
    progress.begin(Activity::PlanningSamples, found.len() + 1);
    let refused_of = |job: &Job, setup: &Setup| {
        let mut trial = Plan { passes: passes.clone(), grown: plan.grown.clone(), ..Plan::default() };
        let driven = match &setup.robot {
            Some(robot) if setup.check().is_ok() => drive(&mut trial, part, setup, robot, job, &progress.within()),
            _ => return Ok(None),
        };
        match driven {
            Err(PlanError::Cancelled) => Err(Cancelled),
            // What cannot be planned is no better.
            Err(_) => Ok(None),
            Ok(()) => progress.step().map(|()| Some(trial.refusals.len())),
        }
    };
    let mut least = refused_of(job, setup)?.unwrap_or(usize::MAX);
    let mut best = None;
    for better in found {
        let (job, setup) = changed(&better);
        if let Some(left) = refused_of(&job, &setup)?.filter(|left| *left < least) {
            (least, best) = (left, Some(better));
        }
    }
    // What gains nothing on the sample is not worth to be planned whole, which takes as long as the plan itself.
    let Some(better) = best else { return Ok(None) };
    let (job, setup) = changed(&better);
    match super::plan(part, surfaces, &job, &setup, cache, progress) {
        Ok(whole) => {
            let left = whole.refusals.len();
            Ok((left < refusals(plan).len()).then_some((better, left)))
        }
        Err(PlanError::Cancelled) => Err(Cancelled),
        Err(_) => Ok(None),
    }
}

/// The job's cell with the frames of a better set-up.
pub fn applied(cell: &JobCell, mount: Mount, better: &BetterSetup) -> JobCell {
    let mut cell = cell.clone();
    match mount {
        Mount::PartInHand => {
            cell.flange_from_part = Some(better.part.clone());
            cell.base_from_laser = Some(better.base_from_laser.clone());
        }
        Mount::ToolInHand => cell.base_from_part = Some(better.part.clone()),
    }
    cell
}

/// Where the spot is at each target of the sample, in the part, and whether it is possible there.
pub fn spots(better: &BetterSetup, defocus_mm: f64) -> Vec<(Point3<f64>, bool)> {
    let spot = |f: &Isometry3<f64>| f * Point3::new(0.0, 0.0, -defocus_mm);
    better.sample.iter().map(spot).zip(better.possible.iter().copied()).collect()
}

/// The frames of a better set-up as lines of a job's `[cell]` table.
pub fn as_toml(mount: Mount, better: &BetterSetup) -> Vec<String> {
    let line = |name: &str, frame| format!("{name} = {{ {} }}", advice::as_toml(frame));
    match mount {
        Mount::PartInHand => {
            vec![line("flange_from_part", &better.part), line("base_from_laser", &better.base_from_laser)]
        }
        Mount::ToolInHand => vec![line("base_from_part", &better.part)],
    }
}
