//! The program of a plan: its text with what its head says, and the reading back without which it is not handed
//! out.

use super::error::ExportError;
use crate::cell::Setup;
use crate::document::model::Job;
use crate::part::Part;
use crate::planning::plan::Plan;
use crate::planning::report::{Report, is_dark};
use crate::planning::verify;
use crate::program::dialect::WriteError;
use crate::program::{Program, ProgramFile, Step, Steps, dialects, lines};

/// The program's files as they would be written, the one to start first; none of a plan that never lights.
///
/// # Errors
/// [`ExportError::Unwritable`]: what the controller could not take.
pub fn program(
    job: &Job,
    part_name: &str,
    setup: &Setup,
    plan: &Plan,
    report: &Report,
) -> Result<Vec<ProgramFile>, ExportError> {
    if is_dark(plan) {
        return Ok(Vec::new());
    }
    let lines = lines(&plan.steps, setup);
    let program = Program { head: head(job, part_name, setup, (&plan.steps, report)), lines, setup };
    let dialect = dialects::known(&job.cell.dialect).map_err(WriteError::Rule)?;
    Ok(dialect.write(&program)?)
}

/// Names of the files that a program of this job has, however long it is; none where it cannot be written.
pub(super) fn names_ahead(job: &Job, setup: &Setup) -> Vec<String> {
    let nothing = Program { head: Vec::new(), lines: Vec::new(), setup };
    let files = dialects::known(&job.cell.dialect).ok().and_then(|d| d.write(&nothing).ok());
    files.unwrap_or_default().into_iter().map(|f| f.name).collect()
}

/// Reads the program's own text, and refuses to hand out one that would not do what was planned.
///
/// # Errors
/// It cannot be read, or it is not the plan.
pub(super) fn read_back(
    part: &Part,
    job: &Job,
    setup: &Setup,
    plan: &Plan,
    written: &[ProgramFile],
) -> Result<(), ExportError> {
    let found = verify::check_own(part, plan, setup, job, written)?.findings;
    let findings = found.len();
    match found.into_iter().next() {
        None => Ok(()),
        Some(first) => Err(ExportError::NotThePlan { first: Box::new(first), findings }),
    }
}

/// Comments at the head of a program.
fn head(job: &Job, part_name: &str, setup: &Setup, (steps, report): (&Steps, &Report)) -> Vec<String> {
    let list: Vec<String> = report.surfaces.iter().map(|s| s.surface.to_string()).collect();
    let shown =
        if list.len() > 20 { format!("{} and {} more", list[..20].join(" "), list.len() - 20) } else { list.join(" ") };
    let mut out =
        vec![format!("clearbeam {}, part {part_name}", env!("CARGO_PKG_VERSION")), format!("surfaces {shown}")];
    out.extend(worked_with(steps));
    out.extend([
        format!(
            "direction {}, spacing {} mm, {}",
            job.layers.direction,
            job.layers.spacing_mm,
            job.layers.order.word()
        ),
        format!("{} targets, {} corrected, {} blocked and left out", report.points, report.corrected, report.blocked),
    ]);
    match &setup.robot {
        None => out.push(format!("Flange poses, {}; reach and limits are NOT checked", setup.mount.word())),
        Some(robot) => {
            out.push(format!("{}, {}", robot.name, setup.mount.word()));
            if !robot.unverified.is_empty() {
                out.push(format!("Figures of the robot that nobody has checked: {}", robot.unverified.join(", ")));
            }
        }
    }
    out.push(format!("Not verified on a {} controller: run it with the laser off first", job.cell.dialect));
    out
}

/// What the lit pieces are worked with, each once, in the order of work.
fn worked_with(steps: &Steps) -> Vec<String> {
    // A head that is drawn back widens the spot by any number of digits.
    let short = |mm: f64| (mm * 1e4).round() / 1e4;
    let mut out: Vec<String> = Vec::new();
    for step in &steps.list {
        let Step::Work(w) = step else { continue };
        let pulses = if w.frequency_khz > 0.0 { format!(" at {} kHz", w.frequency_khz) } else { String::new() };
        let said = format!(
            "power {} W{pulses}, spot {} mm, defocus {} mm, speed {} mm/s",
            w.power_w,
            short(w.spot_mm),
            short(w.defocus_mm),
            w.speed_mm_s
        );
        if !out.contains(&said) {
            out.push(said);
        }
    }
    out
}
