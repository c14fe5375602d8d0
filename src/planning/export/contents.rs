//! What an export writes: job, program, tables, dose and report, whole in memory. The same job gives the same bytes.
//! The folder is not looked at here.

use super::conflict::ExportOf;
use super::error::ExportError;
use super::output_file::{DOSE, JOB, OutputFile, PAGE, REPORT, WELD_BEAD, WELD_MASK, is_plain};
use super::program::{self, program, read_back, variant_program};
use super::tables::{joints_csv, path_csv};
use super::weld_files::{bead_ply, mask_png};
use crate::cell::Setup;
use crate::document::files::{self, InputDigest, JobError};
use crate::document::{Job, Remembered};
use crate::part::{Part, Surfaces, digest_of};
use crate::planning::PlanError;
use crate::planning::dose::{self, DoseReport, dose};
use crate::planning::from_pass;
use crate::planning::plan::Plan;
use crate::planning::report::{DryRunReport, FileDigest, PlanFinding, Report, StandingProgram, WrittenFiles, in_file};
use crate::program::{Breakdown, DRY_RUN_PERCENT, ProgramFile, Timeline, Variant, Wording};
use crate::progress::{Activity, Progress};
use std::path::Path;

/// A finished plan with all that it was made from.
#[derive(Clone, Copy)]
pub struct ExportInput<'a> {
    /// The job.
    pub job: &'a Job,
    /// Its part.
    pub part: &'a Part,
    /// The part's surfaces under the job.
    pub surfaces: &'a Surfaces,
    /// Cell and robot.
    pub setup: &'a Setup,
    /// The plan.
    pub plan: &'a Plan,
    /// What was found before there was a plan; the report has it first.
    pub findings: &'a [PlanFinding],
    /// The words of the program's comments.
    pub wording: Wording,
    /// What is written.
    pub options: ExportOptions,
    /// Makes the report's page for people, where it is written as well.
    pub page: Option<Page<'a>>,
}

/// Makes a page of the report, and of what takes how much of the program's time.
pub type Page<'a> = &'a (dyn Fn(&Report, Option<&Breakdown>) -> String + Sync);

/// What of an export is up to whoever asks for it.
#[derive(Clone, Copy, Debug, Default)]
pub struct ExportOptions {
    /// The dose is computed and written even where the job has no threshold for it.
    pub dose: bool,
    /// Which program of the plan is written.
    pub variant: Variant,
    /// The report is written as a page for people as well.
    pub page: bool,
}

impl ExportOptions {
    /// Whether an export of a job has the dose.
    fn has_dose(&self, job: &Job) -> bool {
        self.dose || job.dose.has_threshold()
    }
}

/// The files of a plan, the report last, and what they report; the program is read back and compared with the plan. The
/// job names its part and cell relative to the folder they will stand in, which has no other programs of the plan.
///
/// # Errors
/// The program cannot be written or would not do what was planned; [`ExportError::Cancelled`] when `progress` says
/// so.
pub fn files(
    input: &ExportInput<'_>,
    of: &ExportOf,
    progress: &Progress,
) -> Result<(Vec<OutputFile>, Report), ExportError> {
    MadeFiles::new(input, of, Vec::new(), progress)?.finished(of, input.page, Vec::new())
}

/// All files of an export but the report, which lists what stands beside them.
pub(super) struct MadeFiles {
    /// The files.
    files: Vec<OutputFile>,
    /// The report, but for what is written.
    report: Report,
    /// The program that is written.
    pub(super) program: StandingProgram,
    /// SHA-256 of the whole program of the plan.
    pub(super) plan_sha256: String,
    /// What takes how much of the program's time; not known without a robot.
    pub(super) times: Option<Breakdown>,
}

impl MadeFiles {
    /// Makes them. `inputs`: what is to be reported of the files that the plan was made from.
    ///
    /// # Errors
    /// As [`files()`].
    pub(super) fn new(
        input: &ExportInput<'_>,
        of: &ExportOf,
        inputs: Vec<InputDigest>,
        progress: &Progress,
    ) -> Result<MadeFiles, ExportError> {
        let ExportInput { job, part, surfaces, setup, plan: whole, findings, wording, options, .. } = *input;
        let mut job = job.clone();
        // With the patches of a scan the part has other facets than its file: what the job remembered stays.
        if surfaces.worked.is_none() {
            job.part.landmarks = Remembered::of(&job, part, &job.part);
        }
        let job = &job;
        let variant = options.variant;
        let left = variant.from_pass.map(|n| from_pass(part, whole, setup, job, n, progress)).transpose()?;
        let plan = left.as_ref().unwrap_or(whole);
        let in_file = in_file(part, surfaces, job, progress)?;
        let report_of = |plan| Report::new(plan, surfaces).with_inputs(&in_file, job, setup);
        let mut report = report_of(plan);
        report.findings.splice(0..0, findings.iter().cloned());
        let dose = options.has_dose(job).then(|| DoseFile::new(input, job, progress)).transpose()?;
        let (dose_ply, dose_report) = dose.map_or((None, None), |d| (Some(d.ply), Some(d.report)));
        (report.dose, report.inputs) = (dose_report, inputs);
        progress.check()?;
        progress.begin(Activity::WritingProgram, 2);
        let of_part = &of.part;
        let written = variant_program(variant, (job, of_part, setup), plan, &report, wording)?;
        let all = match variant {
            Variant::WHOLE => None,
            _ => Some(program(job, of_part, setup, whole, &report_of(whole), wording)?),
        };
        let plan_sha256 = sha256_of(all.as_ref().unwrap_or(&written));
        progress.step()?;
        read_back(part, job, setup, (plan, variant), &written, progress)?;
        progress.step()?;
        let file = |name: &str, bytes: Vec<u8>| OutputFile { name: name.into(), bytes };
        let mut out = vec![file(JOB, files::to_toml(job)?.into_bytes())];
        let program = StandingProgram { variant, names: written.iter().map(|f| f.name.clone()).collect() };
        out.extend(written.into_iter().map(|f| OutputFile { name: f.name, bytes: f.text.into_bytes() }));
        out.push(file("path.csv", path_csv(plan).into_bytes()));
        if let Some(choice) = &plan.choice {
            out.push(file("joints.csv", joints_csv(plan, choice).into_bytes()));
        }
        out.extend(dose_ply.map(|ply| file(DOSE, ply)));
        if let Some(weld) = &plan.weld {
            out.push(file(WELD_MASK, mask_png(&weld.measured)));
            out.push(file(WELD_BEAD, bead_ply(weld)));
        }
        check_names(&out)?;
        let times = plan.timeline.as_ref().map(Timeline::breakdown);
        Ok(MadeFiles { files: out, report, program, plan_sha256, times })
    }

    /// Names of the files.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.files.iter().map(|f| f.name.as_str())
    }

    /// All files, the report last. `beside`: other programs that stand in the folder, with their files.
    ///
    /// # Errors
    /// The report cannot be written.
    pub(super) fn finished(
        self,
        of: &ExportOf,
        page: Option<Page<'_>>,
        beside: Vec<(StandingProgram, Vec<FileDigest>)>,
    ) -> Result<(Vec<OutputFile>, Report), ExportError> {
        let MadeFiles { files: mut out, mut report, program, plan_sha256, times } = self;
        let variant = program.variant;
        let (others, kept): (Vec<StandingProgram>, Vec<Vec<FileDigest>>) = beside.into_iter().unzip();
        let own = Some(program).filter(|p| !p.names.is_empty());
        report.written = Some(WrittenFiles {
            job: of.job.clone(),
            part: of.part.clone(),
            from_pass: variant.from_pass,
            dry_run: variant.dry_run.then_some(DryRunReport { speed_percent: DRY_RUN_PERCENT }),
            plan_sha256,
            programs: own.into_iter().chain(others).collect(),
            files: out.iter().map(OutputFile::digest).chain(kept.into_iter().flatten()).collect(),
        });
        if let Some(page) = page {
            let page = OutputFile { name: PAGE.into(), bytes: page(&report, times.as_ref()).into_bytes() };
            if let Some(written) = &mut report.written {
                written.files.insert(out.len(), page.digest());
            }
            out.push(page);
        }
        out.push(OutputFile { name: REPORT.into(), bytes: json(&report)? });
        Ok((out, report))
    }
}

/// The dose, as it is written and reported. It is that of the whole job: what was worked before a stop counts as well.
struct DoseFile {
    ply: Vec<u8>,
    report: DoseReport,
}

impl DoseFile {
    fn new(input: &ExportInput<'_>, job: &Job, progress: &Progress) -> Result<DoseFile, ExportError> {
        let ExportInput { part, surfaces, setup, plan, .. } = *input;
        let map = dose(part, surfaces, plan, job, setup, progress).map_err(|e| match e {
            PlanError::Cancelled => ExportError::Cancelled,
            other => ExportError::Dose(other),
        })?;
        let patches = dose::not_cleanable((part, surfaces), plan, job, &map, progress)?;
        let ply = dose::ply(&map, surfaces, progress)?;
        Ok(DoseFile { ply, report: DoseReport::new(&map, &patches, surfaces) })
    }
}

/// SHA-256 of all files of a program.
fn sha256_of(program: &[ProgramFile]) -> String {
    digest_of(
        &program.iter().flat_map(|f| [f.name.as_bytes(), &[0], f.text.as_bytes(), &[0]].concat()).collect::<Vec<u8>>(),
    )
}

/// Names that an export of this job has for sure, before anything is planned: tables, and the program's.
pub(super) fn names_ahead(job: &Job, setup: &Setup, options: &ExportOptions) -> Vec<String> {
    let joints = setup.robot.is_some().then_some("joints.csv");
    let dose = options.has_dose(job).then_some(DOSE);
    let page = options.page.then_some(PAGE);
    let weld = [WELD_MASK, WELD_BEAD].into_iter().filter(|_| job.weld.is_there());
    let tables =
        [JOB, REPORT, "path.csv"].into_iter().chain(dose).chain(joints).chain(page).chain(weld).map(str::to_owned);
    tables.chain(program::names_ahead(job, setup, options.variant)).collect()
}

fn json(report: &Report) -> Result<Vec<u8>, JobError> {
    let mut json = serde_json::to_vec_pretty(report).map_err(|e| JobError::write(Path::new(REPORT), e.into()))?;
    json.push(b'\n');
    Ok(json)
}

/// Programs are named by the cell file: such a name must neither leave the folder nor be taken. Some systems take
/// large and small letters for the same.
fn check_names(files: &[OutputFile]) -> Result<(), ExportError> {
    for (i, f) in files.iter().enumerate() {
        let others = files[..i].iter().map(|f| f.name.as_str()).chain([REPORT]);
        if !is_plain(&f.name) || others.into_iter().any(|n| n.eq_ignore_ascii_case(&f.name)) {
            return Err(ExportError::Name { name: f.name.clone() });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stay_within_the_folder_and_are_taken_once() {
        let files = |names: &[&str]| -> Vec<OutputFile> {
            names.iter().map(|n| OutputFile { name: (*n).into(), bytes: Vec::new() }).collect()
        };
        assert!(check_names(&files(&["job.toml", "A.001", "A.002"])).is_ok());
        for bad in ["../A.001", "a/b", "", "..", ".hidden", "c:\\x", "PATH.csv", "Report.JSON"] {
            let why = check_names(&files(&["path.csv", bad])).expect_err("refused");
            assert!(matches!(&why, ExportError::Name { name } if name == bad), "{why}");
        }
    }
}
