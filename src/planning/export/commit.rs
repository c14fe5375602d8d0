//! Files into a folder, all of them or none, whatever stands there and whenever the process ends.

use super::beside::listed_beside;
use super::conflict::{ExportOf, MayReplace};
use super::error::ExportError;
use super::folder::ExportFolder;
use super::intent::ExportIntent;
use super::output_file::OutputFile;
use super::ownership::{allowed, compare_folder};
use super::recovery::recover;
use crate::document::files::JobError;
use crate::progress::{Activity, Progress};
use std::path::Path;

/// Puts files into a folder, which is made if it is not there; names of those of the earlier export that went.
///
/// # Errors
/// What stands in the way, cannot be written, or [`ExportError::Cancelled`]; the folder is as it was, unless it could
/// not be written half way: then the next export into it ends this one.
pub(super) fn put_in_place(
    dir: &Path,
    files: &[OutputFile],
    of: &ExportOf,
    may: MayReplace,
    progress: &Progress,
) -> Result<Vec<String>, ExportError> {
    progress.check()?;
    let is_new = !dir.exists();
    std::fs::create_dir_all(dir).map_err(|e| JobError::write(dir, e))?;
    let folder = ExportFolder::open(dir)?;
    recover(&folder, may)?;
    let intent = intended(&folder, files, of, may)?;
    let staging = intent.staging(files);
    progress.begin(Activity::WritingFiles, staging.len());
    let staged = staging.iter().try_for_each(|step| {
        progress.step()?;
        intent.apply(&folder, files, step).map_err(ExportError::from)
    });
    if let Err(e) = staged {
        roll_back(&folder, is_new);
        return Err(e);
    }
    intent.steps().iter().try_for_each(|step| intent.apply(&folder, files, step))?;
    let goes = |name: &String| files.iter().all(|f| f.name != *name);
    Ok(intent.remove.into_iter().filter(goes).collect())
}

/// The intent of putting files into a folder as it stands.
///
/// # Errors
/// What stands in the way.
pub(super) fn intended(
    folder: &ExportFolder,
    files: &[OutputFile],
    of: &ExportOf,
    may: MayReplace,
) -> Result<ExportIntent, ExportError> {
    let names: Vec<&str> = files.iter().map(|f| f.name.as_str()).collect();
    let stays = listed_beside(files);
    let stays: Vec<&str> = stays.iter().map(String::as_str).collect();
    let met = compare_folder(folder, of, (&names, &stays), may.reads_job)?;
    allowed(folder.path(), met.conflicts, may.overwrite)?;
    Ok(ExportIntent::new(of.clone(), files, met.standing))
}

/// Removes what was staged. What cannot be removed now is when the next export comes.
fn roll_back(folder: &ExportFolder, is_new: bool) {
    for name in folder.all_staged().unwrap_or_default() {
        let _ = folder.unstage(&name);
    }
    if is_new {
        let _ = std::fs::remove_dir(folder.path());
    }
}
