//! Why there is no part, no plan, no export.

use super::{Sentence, say};
use crate::planning::export::ExportError;
use crate::planning::{Failure, PartError, PlanError, PlanningError};

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
            PartError::Stl(e) => e.sentence(),
            PartError::Changed => say!(part_changed),
        }
    }
}

impl Sentence for PlanError {
    fn sentence(&self) -> String {
        match self {
            PlanError::Parameter(e) => e.sentence(),
            PlanError::Unwritable(e) => e.sentence(),
            other => other.to_string(),
        }
    }
}

impl Sentence for PlanningError {
    fn sentence(&self) -> String {
        match self {
            PlanningError::Part(e) => e.sentence(),
            PlanningError::Setup(e) => e.sentence(),
            PlanningError::Plan(e) => e.sentence(),
        }
    }
}

impl Sentence for ExportError {
    fn sentence(&self) -> String {
        match self {
            ExportError::Document(e) => e.sentence(),
            other => other.to_string(),
        }
    }
}
