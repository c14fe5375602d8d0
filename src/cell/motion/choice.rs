//! Spin and branch of every target, chosen together: the cheapest chain of states ([`super::chain`]) that touches
//! nothing, and what is left out of it.

use super::chain::{ChainTarget, NoPoseReason, TargetKey, chain};
use super::reason;
use super::refusal::{Refusal, RefusalCause, RefusalReason};
use super::states::{Arm, ArmState};
use super::target_state_cache::TargetStateCache;
use crate::cell::{Contact, Joints};
use crate::pose::{self, Pass};
use rayon::prelude::*;

/// What was chosen for a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChosenPose {
    /// Joints, degrees.
    pub joints_deg: Joints,
    /// Rotation about the beam axis from the path frame, degrees.
    pub spin_deg: f64,
    /// Branch of the inverse.
    pub branch: u8,
    /// Distance from a singular pose, 0 to 1.
    pub singularity: f64,
    /// Least distance of a joint from its limits, degrees.
    pub limit_margin_deg: f64,
}

/// What was chosen for all targets, by pass and point, and what was refused.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Choice {
    /// `None`: blocked before, or refused.
    pub rows: Vec<Vec<Option<ChosenPose>>>,
    /// In program order.
    pub refusals: Vec<Refusal>,
}

/// What the search asks of its caller: contacts, whether to go on, and which branches are open.
pub struct SearchHooks<'a> {
    /// What the arm and all it carries touch at some joints; a joint turned by a whole turn touches what it touched.
    pub touches: &'a (dyn Fn(&Joints) -> Option<Contact> + Sync),
    /// Whether to go on.
    pub go_on: &'a (dyn Fn() -> bool + Sync),
    /// Whether a pass may be done in a branch: no way may lead there.
    pub is_open: &'a (dyn Fn(usize, u8) -> bool + Sync),
}

impl Default for SearchHooks<'_> {
    /// Nothing is touched, every branch is open, and nobody stops the search.
    fn default() -> Self {
        SearchHooks { touches: &|_| None, go_on: &|| true, is_open: &|_, _| true }
    }
}

/// Chooses spin and branch for every target that is not blocked.
///
/// What is touched is asked for the chosen states first, and for all states of a pass where one of
/// them does. `None`: the search was stopped.
pub fn choose(arm: &Arm<'_>, passes: &[Pass], watch: &SearchHooks<'_>) -> Option<Choice> {
    choose_again(arm, passes, watch, &mut TargetStateCache::default())
}

/// Chooses spin and branch for every target that is not blocked, with what is known of targets that were looked at
/// before: they may be blocked by now, and branches closed, but they stand where they stood.
pub fn choose_again(
    arm: &Arm<'_>,
    passes: &[Pass],
    watch: &SearchHooks<'_>,
    cache: &mut TargetStateCache,
) -> Option<Choice> {
    let SearchHooks { touches, go_on, is_open } = watch;
    let targets = chain_targets(passes);
    loop {
        let mut memory = std::mem::take(&mut cache.chain);
        let known = &*cache;
        let key = |t: &ChainTarget| TargetKey {
            pass: t.pass,
            point: t.point,
            lit_s: t.lit_s,
            open: (0..8).map(|branch| u8::from(is_open(t.pass, branch)) << branch).sum(),
            is_checked: known.checks((t.pass, t.point)).is_some(),
        };
        let keys: Vec<TargetKey> = targets.iter().map(key).collect();
        let solve = |target: &ChainTarget| {
            let solve = || arm.solutions(&target.part_from_focus);
            let states = known.read((target.pass, target.point), solve, |solved| arm.readings(solved));
            let mut states = states.map_err(NoPoseReason::NoState)?;
            states.retain(|s| is_open(target.pass, s.branch));
            if states.is_empty() {
                return Err(NoPoseReason::NoWay);
            }
            let Some(checks) = known.checks((target.pass, target.point)) else { return Ok(states) };
            let first = states[0].joints_deg;
            states.retain(|s| checks.is_free(s, arm.spins(), || touches(&s.joints_deg).is_none()));
            match states.is_empty() {
                true => Err(touches(&first).map_or(NoPoseReason::NoWay, NoPoseReason::Contact)),
                false => Ok(states),
            }
        };
        let chain = chain(arm, (&targets, &keys), go_on, solve, &mut memory)?;
        let touching: Vec<usize> = targets
            .par_iter()
            .zip(&chain)
            .filter(|(target, state)| {
                go_on()
                    && known.checks((target.pass, target.point)).is_none()
                    && state.as_ref().is_ok_and(|s| touches(&s.joints_deg).is_some())
            })
            .map(|(target, _)| target.pass)
            .collect();
        if !go_on() {
            return None;
        }
        cache.chain = memory;
        if touching.is_empty() {
            let choice = choice(arm, passes, &targets, chain);
            cache.keep(passes);
            return Some(choice);
        }
        cache.check_all_of(&touching, passes, arm.spins());
        cache.keep(passes);
    }
}

fn chain_targets(passes: &[Pass]) -> Vec<ChainTarget> {
    let mut out = Vec::new();
    for (pass, p) in passes.iter().enumerate() {
        for (point, t) in p.targets.iter().enumerate().filter(|(_, t)| t.state != pose::TargetState::Blocked) {
            let lit_s = t.laser.then(|| (t.p - p.targets[point - 1].p).norm() / p.settings.speed_mm_s);
            out.push(ChainTarget { pass, point, part_from_focus: t.frame(p.settings.defocus_mm), lit_s });
        }
    }
    out
}

/// The chain by pass and point, with what was left out and why.
fn choice(
    arm: &Arm<'_>,
    passes: &[Pass],
    targets: &[ChainTarget],
    chain: Vec<Result<ArmState, Option<NoPoseReason>>>,
) -> Choice {
    let mut rows: Vec<Vec<Option<ChosenPose>>> = passes.iter().map(|p| vec![None; p.targets.len()]).collect();
    let mut refusals = Vec::new();
    let mut last: Option<(&ChainTarget, ArmState)> = None;
    for (target, node) in targets.iter().zip(chain) {
        match node {
            Ok(state) => {
                rows[target.pass][target.point] = Some(ChosenPose {
                    joints_deg: state.joints_deg,
                    spin_deg: arm.spin_deg(state.spin),
                    branch: state.branch,
                    singularity: state.singularity,
                    limit_margin_deg: arm.robot.limit_margin_deg(&state.joints_deg),
                });
                last = Some((target, state));
            }
            Err(refused) => {
                let neighbour = last.filter(|(s, _)| s.pass == target.pass).map(|(_, state)| state);
                let (cause, why) = match refused {
                    Some(NoPoseReason::NoState(reason)) => reason::of_no_state(arm, &reason),
                    Some(NoPoseReason::Contact(contact)) => RefusalReason::contact(contact),
                    Some(NoPoseReason::NoWay) => (RefusalCause::Robot, RefusalReason::NoWay),
                    None => reason::of_move(arm, &target.part_from_focus, neighbour.as_ref(), target.lit_s),
                };
                refusals.push(Refusal { pass: target.pass, point: target.point, cause, why });
            }
        }
    }
    Choice { rows, refusals }
}
