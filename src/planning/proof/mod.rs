//! What proves the lit moves of a job, in its plan and in its program. The sweep itself is `program::sweep`'s.

pub mod as_written;
pub mod verify;

use super::plan::surface_plan::configurations;
use crate::beam::ToolConfiguration;
use crate::cell::Setup;
use crate::document::model::Job;
use crate::part::{GrownPart, Part};
use crate::program::lit::StraightFlange;
use crate::program::sweep::Prover;
use crate::progress::Progress;
use std::sync::Arc;

/// What proves the lit moves of a job.
pub fn prover<'a>(part: &'a Part, setup: &'a Setup, job: &Job) -> Prover<'a> {
    let deviation_mm = job.cell.deviation_mm;
    let mut all: Vec<ToolConfiguration<'_>> = configurations(job, &setup.tool);
    let mut sag_mm = job.path.chord_error_mm;
    for recipe in &job.recipes {
        let own = recipe.applied(job);
        sag_mm = sag_mm.max(own.path.chord_error_mm);
        for configuration in configurations(&own, &setup.tool) {
            if !all.iter().any(|s| s.settings == configuration.settings) {
                all.push(configuration);
            }
        }
    }
    Prover::new(part, &all, setup.mounted(), deviation_mm, sag_mm)
}

/// What finds straight lit moves, with something to spare for the digits of the program.
pub(super) fn straight<'a>(
    part: &'a Part,
    grown: &'a [Arc<GrownPart>],
    setup: &'a Setup,
    job: &Job,
    progress: &'a Progress,
) -> StraightFlange<'a> {
    let prover = prover(part, setup, job).on_layers(grown).under(progress);
    let least_move_s = setup.cell.timing.least_move_s;
    StraightFlange { prover: prover.with_spare(), deviation_mm: job.cell.deviation_mm, least_move_s }
}
