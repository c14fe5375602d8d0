//! Why there is no part and no plan.

use super::{Sentence, exact, fixed, id, say};
use crate::planning::{Failure, FromPassError, NotCompared, PartError, PlanError, PlanningError};

impl<E: Sentence> Sentence for Failure<E> {
    fn sentence(&self) -> String {
        match self {
            Failure::Cancelled => say!(text_cancelled),
            Failure::Panicked(words) => say!(stage_panicked, words),
            Failure::Refused(e) => e.sentence(),
        }
    }
}

impl Sentence for PartError {
    fn sentence(&self) -> String {
        match self {
            PartError::File(e) => e.sentence(),
            PartError::Changed => say!(part_changed),
        }
    }
}

impl Sentence for PlanError {
    fn sentence(&self) -> String {
        match self {
            PlanError::Parameter(e) => e.sentence(),
            PlanError::Unwritable(e) => e.sentence(),
            PlanError::NoSurface { surface, last } => say!(plan_no_surface, surface = id(surface), last = id(last)),
            PlanError::Nothing => say!(plan_nothing_chosen),
            PlanError::SpacingTooLarge { spacing_mm, size_mm } => {
                say!(plan_spacing_too_large, spacing = exact(*spacing_mm), size = fixed(*size_mm, 3))
            }
            PlanError::SpacingTooSmall { spacing_mm, points } => {
                // More than any count holds is said as the largest.
                say!(plan_spacing_too_small, spacing = exact(*spacing_mm), points = *points as u64)
            }
            PlanError::PartTooLarge { size_mm } => say!(plan_part_too_large, size = format!("{size_mm:e}")),
            PlanError::Folds { surface, layers } => say!(plan_folds, surface = id(surface), layers = *layers),
            PlanError::Cancelled => say!(text_cancelled),
        }
    }
}

impl Sentence for PlanningError {
    fn sentence(&self) -> String {
        match self {
            PlanningError::Part(e) => e.sentence(),
            PlanningError::Scan(e) => e.sentence(),
            PlanningError::Weld(e) => e.sentence(),
            PlanningError::Setup(e) => e.sentence(),
            PlanningError::Plan(e) => e.sentence(),
        }
    }
}

impl Sentence for FromPassError {
    fn sentence(&self) -> String {
        match *self {
            FromPassError::NoPass { asked, passes: 0 } => say!(from_pass_without_passes, asked = id(asked)),
            FromPassError::NoPass { asked, passes } => {
                say!(from_pass_no_pass, asked = id(asked), last = id(passes - 1))
            }
            FromPassError::NoWay { pass } => say!(from_pass_no_way, pass = id(pass)),
        }
    }
}

impl Sentence for NotCompared {
    fn sentence(&self) -> String {
        match self {
            NotCompared::Verify(e) => e.sentence(),
            NotCompared::FromPass(e) => e.sentence(),
        }
    }
}
