//! The cheapest chain of states over all targets, by dynamic programming.
//!
//! Within a lit piece a move keeps its branch, turns no joint by more than 30°, the spin by no more
//! than 30°, and no joint faster than it can go at the programmed speed of the spot. The cost is joint
//! travel, nearness to limits and nearness to singularities. Where no chain exists, the fewest targets
//! possible are left out. All spins are looked at; nothing is sampled or refined, so the chain is the
//! optimum of these rules; of a repeated search to a millionth of a degree.

use super::rules::{LEFT_OUT, OUT, Rules, TargetStates};
use super::states::{Arm, ArmState, NoState};
use crate::cell::Contact;
use nalgebra::Isometry3;
use rayon::prelude::*;

/// Targets whose states are made at once, and taken over from another search at once.
const CHUNK: usize = 64;

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
#[derive(Clone)]
pub(super) enum NoPoseReason {
    /// The arm cannot stand there.
    NoState(NoState),
    /// All its states touch something; the contact of the first.
    Contact(Contact),
    /// No way leads there in any branch.
    NoWay,
}

/// What the states of a target depend on, among searches over the same passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TargetKey {
    pub pass: usize,
    pub point: usize,
    pub lit_s: Option<f64>,
    /// The branches that are open, a bit each.
    pub open: u8,
    /// Whether its states are looked at for contacts.
    pub is_checked: bool,
}

/// A chain that was searched. Where the next one has the same targets and comes to them at costs that differ by the same
/// amount in every state, as it soon does behind a difference, it goes on as this one did.
#[derive(Default)]
pub(super) struct ChainMemory {
    keys: Vec<TargetKey>,
    trace: Vec<Trace>,
    /// The states before each chunk, and behind the last.
    states: Vec<TargetStates>,
}

impl ChainMemory {
    /// By how much more a chunk of targets is come to than here, if it is the same chunk and goes on as it did.
    fn goes_on(&self, chunk: usize, keys: &[TargetKey], before: &TargetStates) -> Option<f64> {
        // The states before are those of the target before.
        let last = |keys: &[TargetKey]| (chunk * CHUNK).checked_sub(1).and_then(|i| keys.get(i).copied());
        let is_known =
            last(&self.keys) == last(keys) && self.keys.chunks(CHUNK).nth(chunk) == keys.chunks(CHUNK).nth(chunk);
        self.states.get(chunk).filter(|_| is_known)?.costs_less_by(before)
    }
}

/// A chain over all targets, each with its key: the state of each, or why there is none (`None`: it has states, but the
/// cheapest chain leaves it out).
pub(super) fn chain(
    arm: &Arm<'_>,
    (targets, keys): (&[ChainTarget], &[TargetKey]),
    go_on: &(dyn Fn() -> bool + Sync),
    solve: impl Fn(&ChainTarget) -> SolvedTarget + Sync,
    memory: &mut ChainMemory,
) -> Option<Vec<Result<ArmState, Option<NoPoseReason>>>> {
    let rules = Rules::new(arm);
    let mut old = std::mem::take(memory);
    let mut before = TargetStates::start();
    for (number, chunk) in targets.chunks(CHUNK).enumerate() {
        if !go_on() {
            return None;
        }
        let more = old.goes_on(number, keys, &before);
        memory.states.push(before.clone());
        if let Some(more) = more {
            let first = number * CHUNK;
            memory.trace.extend(old.trace[first..first + chunk.len()].iter_mut().map(std::mem::take));
            before = old.states[number + 1].dearer_by(more);
            continue;
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
            memory.trace.push(Trace { from, left_out_from, keys, reason });
            before = current;
        }
    }
    let mut at = before.cheapest().0;
    memory.keys = keys.to_vec();
    memory.states.push(before);
    let mut picked = vec![OUT; targets.len()];
    for (pick, t) in picked.iter_mut().zip(&memory.trace).rev() {
        *pick = at;
        at = if at == OUT { t.left_out_from } else { t.from[at as usize] };
    }
    let state = |(target, t, pick): (&ChainTarget, &Trace, u32)| {
        let key = t.keys.get(pick as usize);
        key.and_then(|[spin, branch, turn]| arm.state(&target.part_from_focus, *spin, *branch, *turn))
            .ok_or_else(|| t.reason.clone())
    };
    let found = targets.iter().zip(&memory.trace).zip(picked);
    Some(found.map(|((target, t), pick)| state((target, t, pick))).collect())
}

/// What is kept of a target for tracing the chain back: predecessors, and what each state can be made again from.
#[derive(Default)]
struct Trace {
    from: Vec<u32>,
    left_out_from: u32,
    keys: Vec<[u8; 3]>,
    reason: Option<NoPoseReason>,
}
