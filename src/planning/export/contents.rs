//! What an export writes: job, program, tables, dose and report, whole in memory. The same job gives the same bytes.
//! The folder is not looked at here.

use super::conflict::ExportOf;
use super::error::ExportError;
use super::output_file::{JOB, OutputFile, REPORT, is_plain};
use super::program::{self, program, read_back};
use super::tables::{joints_csv, path_csv};
use crate::cell::Setup;
use crate::document::files::{self, InputDigest, JobError};
use crate::document::{Job, Remembered};
use crate::part::{Part, Surfaces};
use crate::planning::PlanError;
use crate::planning::dose::{self, DoseReport, dose};
use crate::planning::plan::Plan;
use crate::planning::report::{PlanFinding, Report, WrittenFiles};
use crate::program::Wording;
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
}

/// The files of a plan, the report last, and what they report; the program is read back and compared with the plan,
/// and the dose is computed. The job names its part and cell relative to the folder they will stand in.
///
/// # Errors
/// The program cannot be written or would not do what was planned; [`ExportError::Cancelled`] when `progress` says
/// so.
pub fn files(
    input: &ExportInput<'_>,
    of: &ExportOf,
    progress: &Progress,
) -> Result<(Vec<OutputFile>, Report), ExportError> {
    files_made_from(input, of, Vec::new(), progress)
}

/// The same, with what is to be reported of the files that the plan was made from.
///
/// # Errors
/// As [`files`].
pub(super) fn files_made_from(
    input: &ExportInput<'_>,
    of: &ExportOf,
    inputs: Vec<InputDigest>,
    progress: &Progress,
) -> Result<(Vec<OutputFile>, Report), ExportError> {
    let ExportInput { job, part, surfaces, setup, plan, findings, wording } = *input;
    let mut job = job.clone();
    job.part.landmarks = Remembered::of(&job, part, &job.part);
    let job = &job;
    let mut report = Report::new(plan, surfaces);
    report.findings.splice(0..0, findings.iter().cloned());
    let map = dose(part, surfaces, plan, job, setup, progress).map_err(|e| match e {
        PlanError::Cancelled => ExportError::Cancelled,
        other => ExportError::Dose(other),
    })?;
    let patches = dose::not_cleanable(part, surfaces, plan, job, &map);
    report.dose = Some(DoseReport::new(&map, &patches, surfaces));
    progress.check()?;
    progress.begin(Activity::WritingProgram, 2);
    let written = program(job, &of.part, setup, plan, &report, wording)?;
    progress.step()?;
    read_back(part, job, setup, plan, &written)?;
    progress.step()?;
    let file = |name: &str, bytes: Vec<u8>| OutputFile { name: name.into(), bytes };
    let mut out = vec![file(JOB, files::to_toml(job)?.into_bytes())];
    out.extend(written.into_iter().map(|f| OutputFile { name: f.name, bytes: f.text.into_bytes() }));
    out.push(file("path.csv", path_csv(plan).into_bytes()));
    if let Some(choice) = &plan.choice {
        out.push(file("joints.csv", joints_csv(plan, choice).into_bytes()));
    }
    out.push(file("dose.ply", dose::ply(&map, surfaces)));
    check_names(&out)?;
    let list = out.iter().map(OutputFile::digest).collect();
    report.inputs = inputs;
    report.written = Some(WrittenFiles { job: of.job.clone(), part: of.part.clone(), files: list });
    out.push(file(REPORT, json(&report)?));
    Ok((out, report))
}

/// Names that an export of this job has for sure, before anything is planned.
pub(super) fn names_ahead(job: &Job, setup: &Setup) -> Vec<String> {
    let joints = setup.robot.is_some().then_some("joints.csv");
    let tables = [JOB, REPORT, "path.csv", "dose.ply"].into_iter().chain(joints).map(str::to_owned);
    tables.chain(program::names_ahead(job, setup)).collect()
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
