//! `clearbeam plan`: from a part or a job to a folder with its program; `row` does it to several.

mod row;

use super::changed::part_of;
use super::word_options::full_path;
use super::{CommandFailure, CommandOutcome, PlanOptions, print, print_json, tell_of_file};
use crate::cell::Setup;
use crate::document::files::package;
use crate::document::model::ScanFile;
use crate::document::{Chosen, Edit, Job, ScanEdit, files};
use crate::part::Source;
use crate::planning::cures::Cure;
use crate::planning::export::{self, ExportError, ExportInput, ExportOptions, Exported, FileConflict, Page};
use crate::planning::report::PlanFinding;
use crate::planning::{self, FromPassError, Pipeline, PlanError, PlannedJob, PlanningError, advice};
use crate::program::{DRY_RUN_PERCENT, Variant};
use crate::progress::Progress;
use crate::scan;
use crate::scan::file::ScanFileError;
use crate::text::{
    NamedSentence as _, Naming, Sentence as _, clock, exact, program_comment, report_lines, report_page, say,
};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Options of `plan`.
#[derive(clap::Args, Debug)]
pub struct PlanArguments {
    #[arg(required = true, value_name = "INPUT", help = say!(cli_plan_input))]
    inputs: Vec<PathBuf>,
    #[arg(long, value_name = "DIR", help = say!(cli_plan_out))]
    out: PathBuf,
    #[command(flatten)]
    options: PlanOptions,
    #[arg(long, value_name = "SCAN", help = say!(cli_plan_scan))]
    scan: Vec<PathBuf>,
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..), help = say!(cli_plan_jobs))]
    jobs: u16,
    #[arg(long, help = say!(cli_plan_dose))]
    dose: bool,
    #[arg(long, help = say!(cli_plan_report))]
    report: bool,
    #[arg(long, help = say!(cli_plan_dry_run, percent = exact(DRY_RUN_PERCENT)))]
    dry_run: bool,
    #[arg(long, value_name = "N", help = say!(cli_plan_from_pass))]
    from_pass: Option<usize>,
    #[arg(long, help = say!(cli_plan_overwrite))]
    overwrite: bool,
    #[arg(long, help = say!(cli_plan_json))]
    json: bool,
}

/// One plan of those that a command makes.
struct PlanRun<'a> {
    /// Part or job.
    input: &'a Path,
    /// The scan that takes the place of the job's.
    scan: Option<&'a Path>,
    /// Its folder.
    out: PathBuf,
}

/// A plan whose files are written.
pub(in crate::cli) struct WrittenPlan {
    pipeline: Pipeline,
    /// The plan.
    pub planned: Arc<PlannedJob>,
    job: Job,
    /// What was written.
    pub exported: Exported,
}

/// Plans and writes: one job into its folder, or a row of them.
pub fn run(a: &PlanArguments) -> Result<CommandOutcome, CommandFailure> {
    let [input] = &a.inputs[..] else { return row::run(a) };
    if a.scan.len() > 1 {
        return row::run(a);
    }
    let one = PlanRun { input, scan: a.scan.first().map(PathBuf::as_path), out: a.out.clone() };
    let made = write(a, &one)?;
    let report = &made.exported.report;
    if a.json {
        print_json(report)?;
    } else {
        print(&told(&made));
    }
    Ok(if report.is_complete() { CommandOutcome::Done } else { CommandOutcome::Found })
}

/// Plans one job and writes its files.
fn write(a: &PlanArguments, of: &PlanRun<'_>) -> Result<WrittenPlan, CommandFailure> {
    // A package is unpacked into the plan's folder: nothing is left anywhere else.
    let input = package::unpacked(of.input, &of.out).map_err(CommandFailure::failed)?;
    let (job, job_file) = opened(&input)?;
    let job_file = job_file.as_deref();
    // Under the job's own numbers, before options give others.
    let (mut job, source, findings) = part_of(job, job_file)?;
    a.options.apply(&mut job, &source)?;
    take_files(a, of.scan, &mut job)?;
    let options = ExportOptions { dose: a.dose, variant: a.variant(), page: a.report };
    let target = PlanTarget { input: of.input, out: &of.out, options, overwrite: a.overwrite };
    plan_and_write(&target, (job, job_file), source, &findings)
}

/// Where a plan goes.
pub(in crate::cli) struct PlanTarget<'a> {
    /// What it is told of as.
    pub input: &'a Path,
    /// Its folder.
    pub out: &'a Path,
    /// What is written.
    pub options: ExportOptions,
    /// Whether what stands in the way is replaced.
    pub overwrite: bool,
}

/// Plans a job on the part that was read from `source`, and writes its files.
pub(in crate::cli) fn plan_and_write(
    target: &PlanTarget<'_>,
    (job, job_file): (Job, Option<&Path>),
    source: Source,
    findings: &[PlanFinding],
) -> Result<WrittenPlan, CommandFailure> {
    let PlanTarget { input: named, out, options, overwrite } = *target;
    // Known before the work is done, as far as names are.
    let setup = files::load_setup(&job, job_file).map_err(CommandFailure::failed)?;
    export::conflicts(out, &job, job_file, &setup, &options)
        .and_then(|met| export::allowed(out, met, overwrite))
        .map_err(not_exported)?;
    // Nobody cancels it: a key that ends the program ends all.
    let (pipeline, planned) = Pipeline::planned(Arc::new(source), &job, job_file).map_err(refused)?;
    let PlannedJob { part, surfaces, setup, plan, .. } = &*planned;
    tell_of_file(named, planned.report.findings.iter().filter_map(PlanFinding::in_file));
    tell_of_cell(&job, setup);
    let wording = program_comment;
    let exported = {
        let page = options.page.then(|| report_page(&planned, &job));
        let page = page.as_ref().map(|page| page as Page<'_>);
        let input = ExportInput { job: &job, part, surfaces, setup, plan, findings, wording, options, page };
        export::write(out, &input, job_file, overwrite, &Progress::default()).map_err(not_exported)?
    };
    Ok(WrittenPlan { pipeline, planned, job, exported })
}

/// What there is to say of a plan that was written.
pub(in crate::cli) fn told(made: &WrittenPlan) -> String {
    let WrittenPlan { pipeline, planned, job, exported } = made;
    let mut text = report_lines(&exported.report, job);
    if let Some(t) = &exported.times {
        let [work, travel, waiting] = [t.work_s, t.travel_s, t.waiting_s].map(clock);
        text.push_str(&format!("{}\n", say!(cli_times, work, travel, waiting)));
    }
    text.push_str(&cured(planned));
    text.push_str(&advised(planned, job, pipeline));
    for path in &exported.removed {
        text.push_str(&format!("{}\n", say!(cli_removed, file = path.display().to_string())));
    }
    for path in &exported.written {
        text.push_str(&format!("{}\n", say!(cli_wrote, file = path.display().to_string())));
    }
    text
}

impl PlanArguments {
    fn variant(&self) -> Variant {
        Variant { dry_run: self.dry_run, from_pass: self.from_pass }
    }
}

/// Scan and head that are named on the command line, by their full paths.
fn take_files(a: &PlanArguments, scan: Option<&Path>, job: &mut Job) -> Result<(), CommandFailure> {
    if let Some(scan) = scan {
        // Another scan of the same part: where the last one lay says nothing of it.
        let failed = |e: ScanFileError| {
            CommandFailure::Failed(say!(in_file, file = scan.display().to_string(), what = e.sentence()))
        };
        let sha256 = scan::file::sha256(scan, &Progress::default()).map_err(failed)?;
        let files = vec![ScanFile { file: full_path(scan)?, sha256 }];
        Edit::Scan(Box::new(ScanEdit::Files(files, job.scan.units))).apply(job, &[]);
    }
    if let Some(head) = a.options.head() {
        job.beam.head = full_path(head)?;
    }
    Ok(())
}

/// Says on stderr how well the cell's frames fit what was measured, and whether the dialect is not the robot's own.
fn tell_of_cell(job: &Job, setup: &Setup) {
    for note in setup.cell.calibrations() {
        eprintln!("{}: {}", setup.cell.name, note.sentence());
    }
    let own = setup.robot.as_ref().map(|r| r.dialect.as_str()).filter(|d| *d != "csv" && *d != job.cell.dialect);
    if let Some(own) = own {
        eprintln!("{}", say!(cli_speaks_own_dialect, robot = setup.robot_name(), own));
    }
}

/// What gives lines to surfaces that have none, one line each.
fn cured(planned: &PlannedJob) -> String {
    let naming = Naming::of(&planned.job);
    let told = |cure: &Cure| format!("{}\n", say!(cli_to_help, advice = cure.sentence_with(&naming)));
    planned.cures.iter().map(told).collect()
}

/// What would help where something is left out, one line each.
fn advised(of: &PlannedJob, job: &Job, pipeline: &Pipeline) -> String {
    let PlannedJob { part, surfaces, setup, plan, .. } = of;
    let progress = Progress::default();
    let mut text = String::new();
    for advice in advice::suggestions(part, plan, job, setup, &progress).unwrap_or_default() {
        text.push_str(&format!("{}\n", say!(cli_to_help, advice = advice.sentence())));
    }
    let better = advice::better_setup(part, surfaces, plan, job, setup, &pipeline.cache, &progress);
    if let Ok(Some((better, left))) = better {
        text.push_str(&format!("{}\n", say!(cli_better_setup, left, before = plan.refusals.len())));
        for line in advice::as_toml(setup.mount, &better) {
            text.push_str(&format!("  {line}\n"));
        }
    }
    text
}

/// Errors that come from the options count as wrong usage.
fn refused(e: PlanningError) -> CommandFailure {
    match &e {
        PlanningError::Plan(planning::Failure::Refused(
            PlanError::Parameter(_)
            | PlanError::Unwritable(_)
            | PlanError::NoSurface { .. }
            | PlanError::SpacingTooLarge { .. }
            | PlanError::SpacingTooSmall { .. },
        )) => CommandFailure::Usage(e.sentence()),
        _ => CommandFailure::failed(e),
    }
}

/// Why nothing was exported, and what helps.
fn not_exported(e: ExportError) -> CommandFailure {
    let why = e.sentence();
    CommandFailure::Failed(match e {
        ExportError::Conflicts { conflicts, .. } if conflicts.iter().all(FileConflict::can_be_overwritten) => {
            say!(cli_help_overwrite, why)
        }
        ExportError::Conflicts { .. } => say!(cli_help_other_folder, why),
        // Only the plan tells which passes there are.
        ExportError::FromPass(FromPassError::NoPass { .. }) => return CommandFailure::Usage(why),
        _ => why,
    })
}

/// A job from a job file, or the job that cleans all of a part.
pub(in crate::cli) fn opened(input: &Path) -> Result<(Job, Option<PathBuf>), CommandFailure> {
    if files::is_job(input) {
        let job = files::read(input).map_err(CommandFailure::failed)?;
        return Ok((job, Some(input.to_path_buf())));
    }
    let mut job = Job::default();
    job.part.file = input.display().to_string();
    job.settings.choose(Chosen::All);
    Ok((job, None))
}
