//! The export of a finished plan into a folder. It appears whole or not at all, replaces the earlier export of the
//! same job, and touches nothing else unless told to; other programs of the same plan stay beside it.
//!
//! `contents` makes the files, `ownership` tells whose the files of the folder are, `commit` puts the new ones in
//! place step by step, and `recovery` ends what a crash has broken off.

mod beside;
mod commit;
#[cfg(test)]
mod commit_tests;
mod conflict;
mod contents;
mod error;
mod folder;
mod intent;
mod output_file;
mod ownership;
mod program;
mod recorded;
mod recovery;
mod tables;
mod weld_files;

pub use conflict::{ConflictReason, ExportOf, FileConflict};
pub use contents::{ExportInput, ExportOptions, Page, files};
pub use error::ExportError;
pub use output_file::OutputFile;
pub use ownership::allowed;
pub use program::program;
pub use recorded::recorded_inputs;
pub use tables::path_csv;

use super::report::Report;
use crate::cell::Setup;
use crate::document::files::{inputs, rebased};
use crate::document::model::Job;
use crate::program::Breakdown;
use crate::progress::Progress;
use conflict::MayReplace;
use contents::MadeFiles;
use folder::ExportFolder;
use std::path::{Path, PathBuf};

/// What an export came to.
#[derive(Clone, Debug)]
pub struct Exported {
    /// The files that were written: the job, the program with the file to start first, tables, the report.
    pub written: Vec<PathBuf>,
    /// Files of the earlier export that went.
    pub removed: Vec<PathBuf>,
    /// What the report says.
    pub report: Report,
    /// What takes how much of the program's time; not known without a robot.
    pub times: Option<Breakdown>,
}

/// What would stand in the way of exporting a job into a folder, as far as it can be told before anything is
/// planned: subprograms are not known by then. What a crash left there is brought to its end first.
///
/// The command line asks this before it plans, so that nobody waits for a plan that cannot be written. The window
/// exports plans that are finished, and learns of conflicts from [`write()`], which always compares all files.
///
/// # Errors
/// What cannot be read, or, after a crash, written.
pub fn conflicts(
    dir: &Path,
    job: &Job,
    job_file: Option<&Path>,
    setup: &Setup,
    options: &ExportOptions,
) -> Result<Vec<FileConflict>, ExportError> {
    if !dir.is_dir() {
        return Ok(Vec::new());
    }
    let folder = ExportFolder::open(dir)?;
    let reads_job = ownership::reads_job_of(dir, job_file);
    match recovery::recover(&folder, MayReplace { reads_job, overwrite: false }) {
        Err(ExportError::Conflicts { conflicts, .. }) => return Ok(conflicts),
        other => other?,
    }
    let names = contents::names_ahead(job, setup, options);
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let of = ExportOf::new(job, job_file);
    // Whether they are programs of the same plan is known when there is one.
    let stays = beside::programs_beside(&folder, &of, options.variant, None, &names)?;
    let stays: Vec<&str> = stays.iter().flat_map(|(p, _)| &p.names).map(String::as_str).collect();
    Ok(ownership::compare_folder(&folder, &of, (&names, &stays), reads_job)?.conflicts)
}

/// Names of files that an export writes for sure, and that stand in the folder already.
pub fn standing(dir: &Path, job: &Job, setup: &Setup, options: &ExportOptions) -> Vec<String> {
    let mut names = contents::names_ahead(job, setup, options);
    names.retain(|name| dir.join(name).exists());
    names
}

/// Writes a plan into a folder, made if it is not there. `job_file`: where the job was read from. `overwrite`: what
/// [`conflicts`] tells is replaced.
///
/// # Errors
/// What stands in the way, what cannot be written, and why; [`ExportError::Cancelled`] when `progress` says so.
pub fn write(
    dir: &Path,
    input: &ExportInput<'_>,
    job_file: Option<&Path>,
    overwrite: bool,
    progress: &Progress,
) -> Result<Exported, ExportError> {
    let of = ExportOf::new(input.job, job_file);
    let job = rebased(input.job, job_file, &dir.join(output_file::JOB))?;
    let inputs = inputs(input.job, job_file);
    let made = MadeFiles::new(&ExportInput { job: &job, ..*input }, &of, inputs, progress)?;
    let may = MayReplace { reads_job: ownership::reads_job_of(dir, job_file), overwrite };
    progress.check()?;
    let mut stays = Vec::new();
    if dir.is_dir() {
        let folder = ExportFolder::open(dir)?;
        recovery::recover(&folder, may)?;
        let (variant, names) = (input.options.variant, made.names().collect::<Vec<_>>());
        stays = beside::programs_beside(&folder, &of, variant, Some(&made.plan_sha256), &names)?;
    }
    let times = made.times;
    let (files, report) = made.finished(&of, input.page, stays)?;
    let removed = commit::put_in_place(dir, &files, &of, may, progress)?;
    let path = |name: &String| dir.join(name);
    Ok(Exported {
        written: files.iter().map(|f| path(&f.name)).collect(),
        removed: removed.iter().map(path).collect(),
        report,
        times,
    })
}
