//! The program of a plan: its text with what its head says, and the reading back without which it is not handed
//! out.

use super::error::ExportError;
use crate::cell::Setup;
use crate::document::model::Job;
use crate::part::{Part, PartFinding};
use crate::planning::plan::Plan;
use crate::planning::report::{PlanFinding, Report, is_dark};
use crate::planning::verify::{self, VerifyError};
use crate::program::{
    Comment, DRY_RUN_PERCENT, DialectError, FileNote, Program, ProgramFile, Step, Steps, Variant, Wording, dialects,
};
use crate::progress::Progress;

/// The whole program's files as they would be written, the one to start first; none of a plan that never lights.
/// `wording`: the words of its comments.
///
/// # Errors
/// [`ExportError::Unwritable`]: what the controller could not take.
pub fn program(
    job: &Job,
    part_name: &str,
    setup: &Setup,
    plan: &Plan,
    report: &Report,
    wording: Wording,
) -> Result<Vec<ProgramFile>, ExportError> {
    variant_program(Variant::WHOLE, (job, part_name, setup), plan, report, wording)
}

/// The files of a variant of the program, the one to start first. `plan`: what the variant has of the plan.
///
/// # Errors
/// [`ExportError::Unwritable`]: what the controller could not take.
pub(super) fn variant_program(
    variant: Variant,
    of: (&Job, &str, &Setup),
    plan: &Plan,
    report: &Report,
    wording: Wording,
) -> Result<Vec<ProgramFile>, ExportError> {
    if is_dark(plan) {
        return Ok(Vec::new());
    }
    let (job, _, setup) = of;
    let dialect = dialects::known(&job.cell.dialect).map_err(DialectError::from)?;
    let (lines, head) = (dialect.lines(variant, &plan.steps, setup), head(variant, of, &plan.steps, report));
    let setup = &dialect.named(setup, variant);
    let program = Program { head, lines, setup, wording };
    Ok(dialect.write(&program).map_err(DialectError::from)?)
}

/// Names of the files that a program of this job has, however long it is; none where it cannot be written.
pub(super) fn names_ahead(job: &Job, setup: &Setup, variant: Variant) -> Vec<String> {
    dialects::by_name(&job.cell.dialect).map_or_else(Vec::new, |dialect| dialect.file_names(setup, variant))
}

/// Reads the program's own text, and refuses to hand out one that would not do what was planned.
///
/// # Errors
/// It cannot be read, or it is not the plan; [`ExportError::Cancelled`] when `progress` says so.
pub(super) fn read_back(
    part: &Part,
    job: &Job,
    setup: &Setup,
    of: (&Plan, Variant),
    written: &[ProgramFile],
    progress: &Progress,
) -> Result<(), ExportError> {
    let found = verify::check_own(part, of, setup, job, written, progress)
        .map_err(|e| if e == VerifyError::Cancelled { ExportError::Cancelled } else { e.into() })?
        .findings;
    let findings = found.len();
    match found.into_iter().next() {
        None => Ok(()),
        Some(first) => Err(ExportError::NotThePlan { first: Box::new(first), findings }),
    }
}

/// So many surfaces are named at the head.
const MOST_SURFACES: usize = 20;

/// Comments at the head of a program.
fn head(
    variant: Variant,
    (job, part_name, setup): (&Job, &str, &Setup),
    steps: &Steps,
    report: &Report,
) -> Vec<Comment> {
    let mut out: Vec<Comment> = Vec::new();
    if variant.dry_run {
        out.push(Comment::DryRun { percent: DRY_RUN_PERCENT });
    }
    out.push(Comment::Part(part_name.into()));
    out.extend(variant.from_pass.map(Comment::FromPass));
    let shown: Vec<u32> = report.surfaces.iter().take(MOST_SURFACES).map(|s| s.surface).collect();
    let more = report.surfaces.len() - shown.len();
    out.push(Comment::Surfaces { shown, more });
    if !variant.dry_run {
        out.extend(process_comments(steps));
    }
    let l = &job.layers;
    out.push(Comment::LineLayout { direction: l.direction, spacing_mm: l.spacing_mm, order: l.order });
    out.push(Comment::Targets { all: report.points, corrected: report.corrected, blocked: report.blocked });
    match &setup.robot {
        None => out.push(Comment::WithoutRobot(setup.mount)),
        Some(robot) => {
            out.push(Comment::Robot { name: robot.name.clone(), mount: setup.mount });
            if !robot.unverified.is_empty() {
                out.push(Comment::Unchecked(robot.unverified.clone()));
            }
        }
    }
    out.extend(report.findings.iter().filter_map(file_note).map(Comment::PartFile));
    if !variant.dry_run {
        let dry_run = names_ahead(job, setup, variant.dry()).into_iter().next().unwrap_or_default();
        out.push(Comment::NeverRun { dialect: job.cell.dialect.clone(), dry_run });
    }
    out
}

/// What whoever starts the program is to know of the part's file: that it may hold another part than the one that
/// stands in the cell. What is wrong with the mesh alone shows in the lines.
fn file_note(finding: &PlanFinding) -> Option<FileNote> {
    let PlanFinding::InFile(finding) = finding else { return None };
    Some(match *finding {
        PartFinding::UnitOverridden { stated, units } => FileNote::UnitOverridden { stated, units },
        PartFinding::FacetsDropped { count, .. } => FileNote::FacetsDropped(count),
        PartFinding::CountDiffers { promised, read } => FileNote::CountDiffers { promised, read },
        PartFinding::NotRead { count, .. } => FileNote::NotRead(count),
        PartFinding::BytesPassedOver { count, at } => FileNote::BytesPassedOver { count, at },
        PartFinding::SolidsJoined { count } => FileNote::SolidsJoined(count),
        PartFinding::ImplausibleSize { .. }
        | PartFinding::FarFromOrigin(_)
        | PartFinding::Shattered { .. }
        | PartFinding::OpenEdges { .. }
        | PartFinding::NonManifoldEdges { .. }
        | PartFinding::FlippedFacets { .. }
        | PartFinding::DuplicateFacets { .. }
        | PartFinding::TwoSidedFacets { .. }
        | PartFinding::JoinedCorners { .. }
        | PartFinding::DegenerateFacets { .. }
        | PartFinding::Meshed { .. }
        | PartFinding::UnitTaken { .. } => return None,
    })
}

/// What the lit pieces are worked with, each once, in the order of work.
fn process_comments(steps: &Steps) -> Vec<Comment> {
    let mut out: Vec<Comment> = Vec::new();
    for step in &steps.list {
        let Step::Process(settings) = step else { continue };
        let comment = Comment::of_settings(settings);
        if !out.contains(&comment) {
            out.push(comment);
        }
    }
    out
}
