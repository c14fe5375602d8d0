//! Whose the files of a folder are: the earlier export of the same job may be replaced, and nothing else without
//! being asked for.

use super::conflict::{ConflictReason, ExportOf, FileConflict};
use super::error::ExportError;
use super::folder::{ExportFolder, FolderEntry};
use super::intent::ExportIntent;
use super::output_file::{JOB, REPORT, is_plain};
use crate::document::files::JobError;
use crate::document::model::Job;
use crate::planning::report::FileDigest;
use serde::Deserialize;
use serde::de::IgnoredAny;
use std::path::Path;

/// Passes if nothing is in the way, or all of it may be replaced.
///
/// # Errors
/// [`ExportError::Conflicts`] with those that stay in the way.
pub fn allowed(dir: &Path, mut conflicts: Vec<FileConflict>, overwrite: bool) -> Result<(), ExportError> {
    conflicts.retain(|c| !(overwrite && c.can_be_overwritten()));
    if conflicts.is_empty() { Ok(()) } else { Err(ExportError::Conflicts { dir: dir.to_path_buf(), conflicts }) }
}

/// What an earlier export left in a folder.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Earlier {
    /// No export that is known.
    Nothing,
    /// One that did not list its files.
    WithoutList,
    /// What it is of, and its files. One that was begun and given up lists a name twice: as it stood, and as it
    /// would have.
    Export(ExportOf, Vec<FileDigest>),
}

/// As much of `report.json` as tells whose it is.
#[derive(Deserialize)]
struct ReportHead {
    job: Option<String>,
    part: Option<String>,
    files: Option<Vec<FileDigest>>,
    passes: Option<IgnoredAny>,
    surfaces: Option<IgnoredAny>,
}

impl Earlier {
    /// Looks into a folder.
    ///
    /// # Errors
    /// A file is there and cannot be read.
    pub(super) fn in_folder(folder: &ExportFolder) -> Result<Earlier, JobError> {
        let text = folder.read(REPORT)?.unwrap_or_default();
        let reported = serde_json::from_slice(&text).map_or(Earlier::Nothing, Earlier::of_report);
        let Some(intent) = ExportIntent::read(folder)? else { return Ok(reported) };
        let mut files = intent.place;
        if let Earlier::Export(_, listed) = reported {
            files.extend(listed);
        }
        Ok(Earlier::Export(intent.of, files))
    }

    fn of_report(head: ReportHead) -> Earlier {
        match head {
            ReportHead { job: Some(job), part: Some(part), files: Some(files), .. }
                if files.iter().all(|f| is_plain(&f.name)) =>
            {
                Earlier::Export(ExportOf { job, part }, files)
            }
            ReportHead { files: None, passes: Some(_), surfaces: Some(_), .. } => Earlier::WithoutList,
            _ => Earlier::Nothing,
        }
    }

    /// Names of what it wrote, each once, in its order.
    fn names(&self) -> Vec<&str> {
        let mut out = Vec::new();
        if let Earlier::Export(_, files) = self {
            for f in files {
                if !out.contains(&f.name.as_str()) {
                    out.push(f.name.as_str());
                }
            }
        }
        out
    }

    /// Why a file with these bytes is not to be touched; `None`: it may be.
    fn objection(&self, of: &ExportOf, name: &str, sha256: &str) -> Option<ConflictReason> {
        match self {
            Earlier::Nothing => Some(ConflictReason::NoExports),
            Earlier::WithoutList => Some(ConflictReason::EarlierVersion),
            Earlier::Export(theirs, files) => {
                let mut listed = files.iter().filter(|f| f.name == name).peekable();
                if name != REPORT && listed.peek().is_none() {
                    Some(ConflictReason::NoExports)
                } else if theirs != of {
                    Some(ConflictReason::OtherJob(theirs.clone()))
                } else if name == REPORT || listed.any(|f| f.sha256 == sha256) {
                    None
                } else {
                    Some(ConflictReason::ChangedByHand)
                }
            }
        }
    }
}

/// What an export meets in its folder.
#[derive(Debug, Default)]
pub(super) struct FolderComparison {
    /// What it may not touch unasked.
    pub(super) conflicts: Vec<FileConflict>,
    /// All files that it would replace or remove, as they stand; what the earlier export wrote in its order.
    pub(super) standing: Vec<FileDigest>,
}

/// Compares what stands in a folder with what an export would write, and what it leaves alone. `reads_job`: the job that
/// stands there is the one that is exported.
///
/// # Errors
/// A file is there and cannot be read.
pub(super) fn compare_folder(
    folder: &ExportFolder,
    of: &ExportOf,
    (names, stays): (&[&str], &[&str]),
    reads_job: bool,
) -> Result<FolderComparison, JobError> {
    let earlier = Earlier::in_folder(folder)?;
    let theirs = earlier.names();
    let fresh = names.iter().copied().filter(|n| !theirs.contains(n));
    let mut met = FolderComparison::default();
    for name in theirs.iter().copied().chain(fresh).filter(|n| !stays.contains(n)) {
        let reason = match folder.entry(name)? {
            FolderEntry::Nothing => continue,
            FolderEntry::Folder => Some(ConflictReason::Folder),
            FolderEntry::File(sha256) => {
                let reason = earlier.objection(of, name, &sha256).filter(|_| !(reads_job && name == JOB));
                met.standing.push(FileDigest { name: name.to_owned(), sha256 });
                reason
            }
        };
        met.conflicts.extend(reason.map(|reason| FileConflict { name: name.to_owned(), reason }));
    }
    Ok(met)
}

impl ExportOf {
    /// What an export of a job is of. A job that was itself exported goes by the name that its report tells, so that
    /// planning it again is the same job.
    pub fn new(job: &Job, job_file: Option<&Path>) -> ExportOf {
        let part = Path::new(&job.part.file);
        let text = |name: Option<&std::ffi::OsStr>| name.map_or(String::new(), |n| n.to_string_lossy().into_owned());
        let part_name = text(part.file_name());
        let exported = job_file.filter(|f| f.file_name().is_some_and(|n| n == JOB)).and_then(Path::parent);
        let beside = exported.and_then(|dir| Earlier::in_folder(&ExportFolder::unlocked(dir)).ok());
        match beside {
            Some(Earlier::Export(of, _)) if of.part == part_name => of,
            _ => ExportOf { job: text(job_file.unwrap_or(part).file_stem()), part: part_name },
        }
    }
}

/// Whether the job of a folder is the file that a job was read from.
pub(super) fn reads_job_of(dir: &Path, job_file: Option<&Path>) -> bool {
    let whole = |p: &Path| p.canonicalize().ok();
    job_file.and_then(whole).is_some_and(|f| whole(&dir.join(JOB)) == Some(f))
}
