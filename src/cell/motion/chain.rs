//! The cheapest chain of states over all targets, by dynamic programming.
//!
//! Within a lit piece a move keeps its branch, turns no joint by more than 30°, the spin by no more
//! than 30°, and no joint faster than it can go at the programmed speed of the spot. The cost is joint
//! travel, nearness to limits and nearness to singularities. Where no chain exists, the fewest targets
//! possible are left out. All spins are looked at; nothing is sampled or refined, so the chain is the
//! optimum of these rules.

use super::rules::{LEFT_OUT, OUT, Rules, TargetStates};
use super::states::{Arm, ArmState, NoState};
use crate::cell::Contact;
use nalgebra::Isometry3;
use rayon::prelude::*;

/// Targets whose states are made at once.
const CHUNK: usize = 256;

/// A target of the chain: where the focus has to be, and how fast it is come to.
pub(super) struct ChainTarget {
    pub pass: usize,
    pub point: usize,
    pub part_from_focus: Isometry3<f64>,
    /// Time of the lit move that ends here, s; `None`: none does.
    pub lit_s: Option<f64>,
}

/// The states of a target, or why it has none.
pub(super) type SolvedTarget = Result<Vec<ArmState>, NoPoseReason>;

/// Why a target has no state.
pub(super) enum NoPoseReason {
    /// The arm cannot stand there.
    NoState(NoState),
    /// All its states touch something; the contact of the first.
    Contact(Contact),
    /// No way leads there in any branch.
    NoWay,
}

/// A chain over all stops: the state of each, or why there is none (`None`: it has states, but the
/// cheapest chain leaves it out).
pub(super) fn chain(
    arm: &Arm<'_>,
    targets: &[ChainTarget],
    go_on: &(dyn Fn() -> bool + Sync),
    solve: impl Fn(&ChainTarget) -> SolvedTarget + Sync,
) -> Option<Vec<Result<ArmState, Option<NoPoseReason>>>> {
    let rules = Rules::new(arm);
    let mut trace: Vec<Trace> = Vec::with_capacity(targets.len());
    let mut before = TargetStates::start();
    for chunk in targets.chunks(CHUNK) {
        if !go_on() {
            return None;
        }
        let made: Vec<(TargetStates, Option<NoPoseReason>)> = chunk
            .par_iter()
            .map(|target| match solve(target) {
                Ok(states) => (TargetStates::new(states, &rules), None),
                Err(reason) => (TargetStates::new(Vec::new(), &rules), Some(reason)),
            })
            .collect();
        for (target, (mut current, reason)) in chunk.iter().zip(made) {
            let from = match target.lit_s {
                Some(seconds) => rules.after_lit_move(&before, &mut current, seconds),
                None => rules.after_connecting_move(&before, &mut current),
            };
            let (left_out_from, cheapest) = before.cheapest();
            current.left_out = cheapest + LEFT_OUT;
            let keys = current.states.iter().map(|s| [s.spin, s.branch, s.turn]).collect();
            trace.push(Trace { from, left_out_from, keys, reason });
            before = current;
        }
    }
    let mut at = before.cheapest().0;
    let mut picked = vec![OUT; targets.len()];
    for (pick, t) in picked.iter_mut().zip(&trace).rev() {
        *pick = at;
        at = if at == OUT { t.left_out_from } else { t.from[at as usize] };
    }
    let state = |(target, t, pick): (&ChainTarget, Trace, u32)| {
        let key = t.keys.get(pick as usize);
        key.and_then(|[spin, branch, turn]| arm.state(&target.part_from_focus, *spin, *branch, *turn)).ok_or(t.reason)
    };
    Some(targets.iter().zip(trace).zip(picked).map(|((target, t), pick)| state((target, t, pick))).collect())
}

/// What is kept of a target for tracing the chain back: predecessors, and what each state can be made again from.
struct Trace {
    from: Vec<u32>,
    left_out_from: u32,
    keys: Vec<[u8; 3]>,
    reason: Option<NoPoseReason>,
}
