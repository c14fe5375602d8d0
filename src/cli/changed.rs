//! A job whose part's file has changed: it is planned if all surfaces to clean are found again in their place, and
//! refused with the list of what was found if not.

use super::CommandFailure;
use crate::document::{CarriedOver, Job, files};
use crate::part::Source;
use crate::planning::report::PlanFinding;
use crate::progress::Progress;
use crate::text::{carried_lines, listed_clauses, say};
use std::path::Path;

/// The part's file of a job as it is now, the job carried over to it, and the lines to print about that.
///
/// # Errors
/// The part is gone, is no usable part, or has changed so that a surface to clean is not found in its place.
pub(super) fn part_of(job: Job, job_file: Option<&Path>) -> Result<(Job, Source, Vec<PlanFinding>), CommandFailure> {
    let file = files::part_file(&job, job_file).map_err(CommandFailure::failed)?;
    let source = super::source_of(&file, job.depth_camera(job_file).as_deref())?;
    if !job.part.is_of_another_file(&source.sha256) {
        let mut job = job;
        job.part.begin_with(&source, job_file);
        return Ok((job, source, Vec::new()));
    }
    let name = || file.display().to_string();
    let carried = CarriedOver::to_file(&job, &source, &file, &Progress::default()).map_err(CommandFailure::failed)?;
    let carried = carried.ok_or_else(|| CommandFailure::Failed(say!(text_cancelled)))?;
    let told = listed_clauses(carried_lines(&carried));
    if !carried.is_work_in_place() {
        return Err(CommandFailure::Failed(say!(cli_part_changed, file = name(), told)));
    }
    eprintln!("{}", say!(cli_part_carried_over, file = name(), told));
    let finding = PlanFinding::PartChanged {
        was: carried.was.clone(),
        is: carried.is.clone(),
        kept: carried.kept.iter().map(|(old, new)| [old.0, new.0]).collect(),
        lost: carried.lost.iter().map(|l| l.surface.0).collect(),
    };
    Ok((carried.job, source, vec![finding]))
}
