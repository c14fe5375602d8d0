//! Programs that stay in a folder beside the one that is exported: the dry run beside the program, and what goes on after a
//! stop. They stay as long as they are of the same plan; then no program stands beside a job and a report that are not
//! its own.

use super::conflict::ExportOf;
use super::folder::{ExportFolder, FolderEntry};
use super::output_file::{OutputFile, REPORT, is_plain};
use crate::document::files::JobError;
use crate::planning::report::{FileDigest, StandingProgram};
use crate::program::Variant;
use serde::Deserialize;

/// As much of `report.json` as tells which programs stand there.
#[derive(Deserialize)]
struct StandingPrograms {
    #[serde(flatten)]
    of: ExportOf,
    plan_sha256: String,
    programs: Vec<StandingProgram>,
    files: Vec<FileDigest>,
}

/// The other programs of a plan that exports of the same job left in a folder, with their files as they were written.
/// `plan_sha256`: that of the plan; `None`: of any. `names`: what is written now; a program that has to give up a file goes
/// as a whole.
///
/// # Errors
/// A file is there and cannot be read.
pub(super) fn programs_beside(
    folder: &ExportFolder,
    of: &ExportOf,
    variant: Variant,
    plan_sha256: Option<&str>,
    names: &[&str],
) -> Result<Vec<(StandingProgram, Vec<FileDigest>)>, JobError> {
    let text = folder.read(REPORT)?.unwrap_or_default();
    let Ok(report) = serde_json::from_slice::<StandingPrograms>(&text) else { return Ok(Vec::new()) };
    if report.of != *of || plan_sha256.is_some_and(|sha256| sha256 != report.plan_sha256) {
        return Ok(Vec::new());
    }
    let mut out = Vec::new();
    for program in report.programs.into_iter().filter(|p| p.variant != variant) {
        let listed = |name: &String| report.files.iter().find(|f| f.name == *name).cloned();
        let files: Option<Vec<FileDigest>> = program.names.iter().map(listed).collect();
        let is_free = |name: &String| is_plain(name) && !names.iter().any(|n| n.eq_ignore_ascii_case(name));
        let mut is_whole = !program.names.is_empty() && program.names.iter().all(is_free);
        for name in &program.names {
            is_whole &= matches!(folder.entry(name)?, FolderEntry::File(_));
        }
        out.extend(files.filter(|_| is_whole).map(|files| (program, files)));
    }
    Ok(out)
}

/// Names that the report of an export lists, and that it does not write: they stay.
pub(super) fn listed_beside(files: &[OutputFile]) -> Vec<String> {
    #[derive(Deserialize)]
    struct Listed {
        files: Vec<FileDigest>,
    }
    let report = files.iter().find(|f| f.name == REPORT);
    let listed = report.and_then(|r| serde_json::from_slice::<Listed>(&r.bytes).ok()).map_or(Vec::new(), |l| l.files);
    listed.into_iter().map(|f| f.name).filter(|name| files.iter().all(|f| f.name != *name)).collect()
}
