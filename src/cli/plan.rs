//! `clearbeam plan`.

use super::changed::part_of;
use super::{Failure, Outcome, PlanOptions, print};
use crate::cell::Robot;
use crate::document::{Chosen, Job, files};
use crate::planning::export::{self, ExportError, ExportInput, FileConflict};
use crate::planning::{self, Pipeline, PlanError, PlannedJob, PlanningError, advice};
use crate::progress::Progress;
use crate::text::{Sentence as _, clock, program_comment, report_lines};
use anyhow::anyhow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Options of `plan`.
#[derive(clap::Args, Debug)]
pub struct Arguments {
    /// Part or job
    input: PathBuf,
    /// Folder for the files of the plan
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    #[command(flatten)]
    options: PlanOptions,
    /// Replace files of the folder that were changed by hand, are another job's, or no export's
    #[arg(long)]
    overwrite: bool,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
}

/// Plans and writes.
pub fn run(a: &Arguments) -> Result<Outcome, Failure> {
    let (job, job_file) = opened(&a.input)?;
    let job_file = job_file.as_deref();
    // Under the job's own numbers, before options give others.
    let (mut job, source, findings) = part_of(job, job_file)?;
    a.options.apply(&mut job, &source)?;
    if let Some(cell) = a.options.cell() {
        let file = std::path::absolute(cell).map_err(anyhow::Error::from)?;
        job.cell.file = file.display().to_string();
    }
    if let Some(head) = a.options.head() {
        let file = std::path::absolute(head).map_err(anyhow::Error::from)?;
        job.beam.head = file.display().to_string();
    }
    if let Some(robot) = a.options.robot() {
        job.cell.robot = if Robot::is_shipped(robot) {
            robot.clone()
        } else {
            std::path::absolute(robot).map_err(anyhow::Error::from)?.display().to_string()
        };
    }
    // Known before the work is done, as far as names are.
    let setup = files::load_setup(&job, job_file).map_err(anyhow::Error::from)?;
    export::conflicts(&a.out, &job, job_file, &setup)
        .and_then(|met| export::allowed(&a.out, met, a.overwrite))
        .map_err(not_exported)?;
    // Nobody cancels it: a key that ends the program ends all.
    let (pipeline, planned) = Pipeline::planned(Arc::new(source), &job, job_file).map_err(refused)?;
    let PlannedJob { part, surfaces, setup, plan, .. } = &*planned;
    for s in part.findings.sentences(&part.mesh, &part.orientation) {
        eprintln!("{}: {s}", a.input.display());
    }
    for note in setup.cell.calibrations() {
        eprintln!("{}: {note}", setup.cell.name);
    }
    let own = setup.robot.as_ref().map(|r| r.dialect.as_str()).filter(|d| *d != "csv" && *d != job.cell.dialect);
    if let Some(own) = own {
        eprintln!("the {} speaks {own}: give --dialect {own}", setup.robot_name());
    }
    let progress = Progress::default();
    let input = ExportInput { job: &job, part, surfaces, setup, plan, findings: &findings, wording: program_comment };
    let exported = export::write(&a.out, &input, job_file, a.overwrite, &progress).map_err(not_exported)?;
    let report = &exported.report;
    if a.json {
        let json = serde_json::to_string_pretty(report).map_err(anyhow::Error::from)?;
        print(&format!("{json}\n"));
    } else {
        let mut text = report_lines(report, &job);
        if let Some(timeline) = &plan.timeline {
            let t = timeline.breakdown();
            let [work, travel, waiting] = [t.work_s, t.travel_s, t.waiting_s].map(clock);
            text.push_str(&format!("{work} of work, {travel} of travel, {waiting} of waiting\n"));
        }
        for sentence in advice::advice(part, plan, &job, setup, &progress).unwrap_or_default() {
            text.push_str(&format!("to help: {sentence}\n"));
        }
        let better = advice::better_setup(part, surfaces, plan, &job, setup, &pipeline.cache, &progress);
        if let Ok(Some((better, left))) = better {
            let before = plan.refusals.len();
            text.push_str(&format!(
                "a better set-up: {left} targets refused instead of {before}, with this in the job's [cell]\n"
            ));
            for line in advice::as_toml(setup.mount, &better) {
                text.push_str(&format!("  {line}\n"));
            }
        }
        for path in &exported.removed {
            text.push_str(&format!("removed {}\n", path.display()));
        }
        for path in &exported.written {
            text.push_str(&format!("wrote {}\n", path.display()));
        }
        print(&text);
    }
    Ok(if report.is_complete() { Outcome::Done } else { Outcome::Found })
}

/// What the options ask for and cannot be is wrong usage.
fn refused(e: PlanningError) -> Failure {
    match &e {
        PlanningError::Plan(planning::Failure::Refused(
            PlanError::Parameter(_)
            | PlanError::NoSurface { .. }
            | PlanError::SpacingTooLarge { .. }
            | PlanError::SpacingTooSmall { .. },
        )) => Failure::Usage(e.sentence()),
        _ => Failure::Failed(anyhow!(e.sentence())),
    }
}

/// Why nothing was exported, and what helps.
fn not_exported(e: ExportError) -> Failure {
    let help = match &e {
        ExportError::Conflicts { conflicts, .. } if conflicts.iter().all(FileConflict::can_be_overwritten) => {
            "; give --overwrite to replace them, or choose another folder"
        }
        ExportError::Conflicts { .. } => "; choose another folder",
        _ => "",
    };
    Failure::Failed(anyhow!("{}{help}", e.sentence()))
}

/// A job from a job file, or the job that cleans all of a part.
pub(super) fn opened(input: &Path) -> Result<(Job, Option<PathBuf>), Failure> {
    if files::is_job(input) {
        let job = files::read(input).map_err(anyhow::Error::from)?;
        return Ok((job, Some(input.to_path_buf())));
    }
    let mut job = Job::default();
    job.part.file = input.display().to_string();
    job.settings.choose(Chosen::All);
    Ok((job, None))
}
