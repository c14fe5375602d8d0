//! What a repeated search for a chain keeps from the one before: the chain, the arm's solutions at targets, and which of
//! them touch. Targets do not move, whatever was refused or closed meanwhile.

use super::chain::ChainMemory;
use super::states::{ArmSolutions, ArmState};
use crate::pose::Pass;
use std::collections::BTreeMap;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU8, AtomicUsize, Ordering};

/// Solutions are kept up to so many: a third of a gigabyte. The others are worked out again.
const MOST_SOLUTIONS: usize = 5_000_000;

/// What is known of the targets of some passes.
#[derive(Default)]
pub struct TargetStateCache {
    /// By pass and point; empty until a second search begins.
    solutions: Vec<Vec<OnceLock<ArmSolutions>>>,
    kept: AtomicUsize,
    /// The chain that was found last.
    pub(super) chain: ChainMemory,
    /// By pass in which a chosen state touched: what is known of each of its targets.
    checks: BTreeMap<usize, Vec<ContactChecks>>,
}

/// What is known of one target's states, by branch and spin: not looked at, free, or touching. All readings of a turn
/// are one pose.
pub(super) struct ContactChecks(Vec<AtomicU8>);

impl TargetStateCache {
    /// Keeps the solutions at the targets of these passes from now on.
    pub(super) fn keep(&mut self, passes: &[Pass]) {
        if self.solutions.is_empty() {
            self.solutions = passes.iter().map(|p| p.targets.iter().map(|_| OnceLock::new()).collect()).collect();
        }
    }

    /// What is read from the solutions at a target by pass and point, which are worked out if they are not known.
    pub(super) fn read<R>(
        &self,
        (pass, point): (usize, usize),
        solve: impl FnOnce() -> ArmSolutions,
        read: impl FnOnce(&ArmSolutions) -> R,
    ) -> R {
        let place = self.solutions.get(pass).and_then(|p| p.get(point));
        if let Some(known) = place.and_then(OnceLock::get) {
            return read(known);
        }
        let solved = solve();
        let out = read(&solved);
        let more = solved.room();
        if let Some(place) = place.filter(|_| self.kept.fetch_add(more, Ordering::Relaxed) + more <= MOST_SOLUTIONS) {
            // Nobody else asks for the same target meanwhile.
            let _ = place.set(solved);
        }
        out
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
