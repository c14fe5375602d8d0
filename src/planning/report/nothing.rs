//! Plans that never light, and why.

use super::problem::{NotDone, Problem, word};
use crate::cell::motion::RefusalCause;
use crate::planning::plan::Plan;
use crate::program::Step;
use serde::Serialize;

/// Why there is nothing to do.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "reason", rename_all = "snake_case")]
pub enum NothingReason {
    /// No line lies on the chosen surfaces, or none that is long enough for a move.
    NoLines,
    /// Every line is blocked.
    AllBlocked {
        /// By what, in the order in which it was met.
        by: Vec<BlockedBy>,
    },
}

/// Blocked targets with the same cause.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BlockedBy {
    /// The cause, named as in `problems`.
    #[serde(serialize_with = "word")]
    pub cause: RefusalCause,
    /// The surface in the way.
    pub by_surface: Option<u32>,
    /// How many.
    pub targets: usize,
}

/// Whether a plan has no move with the laser on.
pub fn is_dark(plan: &Plan) -> bool {
    !plan.steps.list.iter().any(|s| matches!(s, Step::Laser(true)))
}

/// Why a plan has nothing to do; `None`: it has.
pub(super) fn nothing_planned(plan: &Plan, problems: &[Problem]) -> Option<NothingReason> {
    if !is_dark(plan) {
        return None;
    }
    let mut by: Vec<BlockedBy> = Vec::new();
    for p in problems {
        let NotDone::Blocked(cause) = p.cause else { continue };
        match by.iter_mut().find(|b| (b.cause, b.by_surface) == (cause, p.by_surface)) {
            Some(b) => b.targets += 1,
            None => by.push(BlockedBy { cause, by_surface: p.by_surface, targets: 1 }),
        }
    }
    Some(if by.is_empty() { NothingReason::NoLines } else { NothingReason::AllBlocked { by } })
}
