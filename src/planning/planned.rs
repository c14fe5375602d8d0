//! A plan with all that it was made of, and why there is none.

use super::plan::{Plan, PlanError};
use super::report::Report;
use super::stage::Failure;
use crate::cell::Setup;
use crate::document::{Job, JobError};
use crate::part::stl::StlError;
use crate::part::{Digest, Part, Surfaces};
use std::sync::Arc;
use thiserror::Error;

/// A plan with all that it was made of.
#[derive(Debug)]
pub struct PlannedJob {
    /// The key that it was made for.
    pub key: Digest,
    /// The job, as it was then; what it was named may have changed since.
    pub job: Job,
    /// The part.
    pub part: Arc<Part>,
    /// Its feature surfaces.
    pub surfaces: Arc<Surfaces>,
    /// Robot, cell and head.
    pub setup: Arc<Setup>,
    /// The plan itself.
    pub plan: Plan,
    /// What it comes to.
    pub report: Report,
}

impl PlannedJob {
    /// Tells its pictures from those of other plans.
    pub fn picture_key(&self) -> u64 {
        self.key.0 as u64
    }
}

/// Why there is no part.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PartError {
    /// No facet of the file has any area.
    #[error(transparent)]
    Stl(#[from] StlError),
    /// The job speaks of surfaces of another file.
    #[error("the part's file is not the one that the job was made for")]
    Changed,
}

impl From<PlanError> for Failure<PlanError> {
    fn from(e: PlanError) -> Failure<PlanError> {
        match e {
            PlanError::Cancelled => Failure::Cancelled,
            other => Failure::Refused(other),
        }
    }
}

/// Why there is no plan.
#[derive(Clone, Debug, Error)]
pub enum PlanningError {
    /// The part cannot be built.
    #[error(transparent)]
    Part(#[from] Failure<PartError>),
    /// Cell, robot or head cannot be used.
    #[error(transparent)]
    Setup(#[from] Failure<Arc<JobError>>),
    /// The job cannot be planned.
    #[error(transparent)]
    Plan(#[from] Failure<PlanError>),
}

impl PlanningError {
    /// Whether the user ended it.
    pub fn is_cancelled(&self) -> bool {
        matches!(
            self,
            PlanningError::Part(Failure::Cancelled)
                | PlanningError::Setup(Failure::Cancelled)
                | PlanningError::Plan(Failure::Cancelled)
        )
    }
}
