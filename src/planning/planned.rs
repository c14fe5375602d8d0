//! A plan with all that it was made of.

use super::cures::Cure;
use super::plan::Plan;
use super::report::{Notice, Report};
use crate::cell::Setup;
use crate::document::Job;
use crate::part::{Digest, Part, Surfaces};
use std::sync::Arc;

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
    /// What people are to know of it, the worst first, and of the part's file.
    pub notices: Vec<Notice>,
    /// What gives lines to surfaces that have none.
    pub cures: Vec<Cure>,
}

impl PlannedJob {
    /// Tells its pictures from those of other plans.
    pub fn picture_key(&self) -> u64 {
        self.key.0 as u64
    }
}
