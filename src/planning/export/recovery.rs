//! What a crash left in a folder. An export whose intent stands is ended, where all of it is still there; where it
//! is not, no program is left rather than a mixed one.

use super::conflict::{ConflictReason, FileConflict, MayReplace};
use super::error::ExportError;
use super::folder::{ExportFolder, FolderEntry, INTENT};
use super::intent::{CommitStep, ExportIntent};
use super::output_file::{JOB, REPORT, is_program};
use super::ownership::allowed;
use crate::document::files::JobError;
use crate::planning::report::FileDigest;

/// What there is to do after a crash.
#[derive(Debug, Default)]
pub(super) struct Pending {
    /// The intent that was left.
    intent: Option<ExportIntent>,
    /// What ends it, or takes it back.
    pub(super) steps: Vec<CommitStep>,
    /// What the user changed since: not to be touched unasked.
    pub(super) conflicts: Vec<FileConflict>,
}

/// Brings a folder back to an export that is whole, or to none. `reads_job`: the job that stands there is the one that
/// is exported next; it may have been changed, and stays as it is.
///
/// # Errors
/// [`ExportError::Conflicts`] with what was changed since the crash, unless it may be overwritten; what cannot be
/// read or written.
pub(super) fn recover(folder: &ExportFolder, may: MayReplace) -> Result<(), ExportError> {
    let pending = Pending::in_folder(folder, may.reads_job)?;
    allowed(folder.path(), pending.conflicts.clone(), may.overwrite)?;
    pending.steps.iter().try_for_each(|step| pending.apply(folder, step))?;
    Ok(())
}

impl Pending {
    /// Looks into a folder. `reads_job`: as in [`MayReplace`].
    ///
    /// # Errors
    /// A file is there and cannot be read.
    pub(super) fn in_folder(folder: &ExportFolder, reads_job: bool) -> Result<Pending, JobError> {
        let Some(intent) = ExportIntent::read(folder)? else {
            let mut steps: Vec<CommitStep> = folder.all_staged()?.into_iter().map(CommitStep::Unstage).collect();
            if folder.entry(INTENT)? != FolderEntry::Nothing {
                steps.push(CommitStep::Forget);
            }
            return Ok(Pending { steps, ..Pending::default() });
        };
        let mut conflicts = changed_since(folder, &intent)?;
        let known = conflicts.len();
        conflicts.retain(|c| !(reads_job && c.name == JOB && c.can_be_overwritten()));
        let keeps_job = conflicts.len() < known;
        let mut leftovers = folder.all_staged()?;
        let mut steps: Vec<CommitStep> = match state(folder, &intent, keeps_job)? {
            Left::All { staged } => {
                leftovers.retain(|name| !staged.contains(name));
                let is_staged = |name: &String| staged.contains(name);
                let places = |name: &String| intent.place.iter().any(|f| f.name == *name);
                let remains = |step: &CommitStep| match step {
                    // What the new export has already put there stays.
                    CommitStep::Remove(name) => is_staged(name) || !places(name),
                    CommitStep::Place(name) => is_staged(name),
                    _ => true,
                };
                intent.steps().into_iter().filter(remains).collect()
            }
            Left::Untouched => vec![CommitStep::Forget],
            // The intent stays: it tells the next export which files are of this one.
            Left::Parts => programs(&intent).into_iter().map(CommitStep::Remove).collect(),
        };
        let before_last = steps.len() - usize::from(steps.last() == Some(&CommitStep::Forget));
        steps.splice(before_last..before_last, leftovers.into_iter().map(CommitStep::Unstage));
        Ok(Pending { intent: Some(intent), steps, conflicts })
    }

    /// Takes a step.
    ///
    /// # Errors
    /// The system does not let it be taken.
    pub(super) fn apply(&self, folder: &ExportFolder, step: &CommitStep) -> Result<(), JobError> {
        match (&self.intent, step) {
            (Some(intent), _) => intent.apply(folder, &[], step),
            (None, CommitStep::Unstage(name)) => folder.unstage(name),
            (None, _) => folder.remove(INTENT),
        }
    }
}

/// How much of an intended export is left.
enum Left {
    /// Each file is staged or in its place.
    All {
        /// Those that are not in their place.
        staged: Vec<String>,
    },
    /// Not all of it, but the folder is as it was before.
    Untouched,
    /// Not all of it, and the folder is not as it was before.
    Parts,
}

/// `keeps_job`: the job was changed, and is not put in place any more.
fn state(folder: &ExportFolder, intent: &ExportIntent, keeps_job: bool) -> Result<Left, JobError> {
    let (mut staged, mut is_all, mut is_untouched) = (Vec::new(), true, true);
    let others = |f: &&FileDigest| !(keeps_job && f.name == JOB);
    for f in intent.place.iter().filter(others) {
        let new = FolderEntry::File(f.sha256.clone());
        if folder.staged_entry(&f.name)? == new {
            staged.push(f.name.clone());
        } else {
            is_all &= folder.entry(&f.name)? == new;
        }
        let was_there = intent.was.iter().any(|w| w.name == f.name);
        is_untouched &= was_there || folder.entry(&f.name)? == FolderEntry::Nothing;
    }
    for f in intent.was.iter().filter(others) {
        is_untouched &= folder.entry(&f.name)? == FolderEntry::File(f.sha256.clone());
    }
    Ok(match (is_all, is_untouched) {
        (true, _) => Left::All { staged },
        (false, true) => Left::Untouched,
        (false, false) => Left::Parts,
    })
}

/// Files that are neither as they were nor as they were to be. The report is the list itself, and made anew.
fn changed_since(folder: &ExportFolder, intent: &ExportIntent) -> Result<Vec<FileConflict>, JobError> {
    let mut out: Vec<FileConflict> = Vec::new();
    for name in intent.names().filter(|n| *n != REPORT) {
        let mut known = intent.place.iter().chain(&intent.was).filter(|f| f.name == name);
        let reason = match folder.entry(name)? {
            FolderEntry::Nothing => continue,
            FolderEntry::Folder => ConflictReason::Folder,
            FolderEntry::File(sha256) if known.any(|f| f.sha256 == sha256) => continue,
            FolderEntry::File(_) => ConflictReason::ChangedByHand,
        };
        let conflict = FileConflict { name: name.to_owned(), reason };
        if !out.contains(&conflict) {
            out.push(conflict);
        }
    }
    Ok(out)
}

/// All programs of an intent, old and new, those to be started first.
fn programs(intent: &ExportIntent) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    let all = intent.remove.iter().chain(&intent.main).map(String::as_str).chain(intent.names());
    for name in all.filter(|n| is_program(n)) {
        if !out.iter().any(|n| n == name) {
            out.push(name.to_owned());
        }
    }
    out
}
