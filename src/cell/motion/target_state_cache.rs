//! What a repeated search for a chain keeps from the one before: the states of targets, and which of them touch. Targets
//! do not move, whatever was refused or closed meanwhile.

use super::states::{ArmState, NoState};
use crate::pose::Pass;
use std::collections::BTreeMap;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU8, AtomicUsize, Ordering};

/// So many states are kept: a quarter of a gigabyte. The others are made again.
const MOST_STATES: usize = 4_000_000;

/// The states of a target, or why there is none.
type SolvedStates = Result<Vec<ArmState>, NoState>;

/// What is known of the targets of some passes.
#[derive(Default)]
pub struct TargetStateCache {
    /// By pass and point; empty until a second search begins.
    states: Vec<Vec<OnceLock<SolvedStates>>>,
    kept: AtomicUsize,
    /// By pass in which a chosen state touched: what is known of each of its targets.
    checks: BTreeMap<usize, Vec<ContactChecks>>,
}

/// What is known of one target's states, by branch and spin: not looked at, free, or touching. All readings of a turn
/// are one pose.
pub(super) struct ContactChecks(Vec<AtomicU8>);

impl TargetStateCache {
    /// Keeps the states of these passes from now on.
    pub(super) fn keep(&mut self, passes: &[Pass]) {
        if self.states.is_empty() {
            self.states = passes.iter().map(|p| p.targets.iter().map(|_| OnceLock::new()).collect()).collect();
        }
    }

    /// The states of a target by pass and point, made if they are not known.
    pub(super) fn states(&self, (pass, point): (usize, usize), make: impl FnOnce() -> SolvedStates) -> SolvedStates {
        let Some(place) = self.states.get(pass).and_then(|p| p.get(point)) else { return make() };
        if let Some(known) = place.get() {
            return known.clone();
        }
        let made = make();
        let more = made.as_ref().map_or(0, Vec::len);
        if self.kept.fetch_add(more, Ordering::Relaxed) + more <= MOST_STATES {
            // Nobody else asks for the same target meanwhile.
            let _ = place.set(made.clone());
        }
        made
    }

    /// Which states of a target touch, where its pass is looked at in full.
    pub(super) fn checks(&self, (pass, point): (usize, usize)) -> Option<&ContactChecks> {
        self.checks.get(&pass)?.get(point)
    }

    /// Looks at these passes in full from now on.
    pub(super) fn check_all_of(&mut self, numbers: &[usize], passes: &[Pass], spins: usize) {
        let unknown = || ContactChecks(std::iter::repeat_with(AtomicU8::default).take(8 * spins).collect());
        for &number in numbers {
            let checks = || passes[number].targets.iter().map(|_| unknown()).collect();
            self.checks.entry(number).or_insert_with(checks);
        }
    }
}

impl ContactChecks {
    /// Whether a state is free; it is looked at once.
    pub(super) fn is_free(&self, state: &ArmState, spins: usize, look: impl FnOnce() -> bool) -> bool {
        let known = &self.0[usize::from(state.branch) * spins + usize::from(state.spin)];
        if known.load(Ordering::Relaxed) == 0 {
            known.store(if look() { 1 } else { 2 }, Ordering::Relaxed);
        }
        known.load(Ordering::Relaxed) == 1
    }
}
