//! What an export is about to do with a folder, kept there while it does it: whoever comes after a crash can end it.

use super::conflict::ExportOf;
use super::folder::{ExportFolder, INTENT};
use super::output_file::{OutputFile, REPORT, is_plain, is_program};
use crate::document::files::JobError;
use crate::planning::report::FileDigest;
use serde::{Deserialize, Serialize};

/// One change of the folder. A process may be killed between any two, and within none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum CommitStep {
    /// The new file of this number is written beside its place.
    Stage(usize),
    /// The intent is written: from here on the export will be done.
    Declare,
    /// A file goes.
    Remove(String),
    /// A staged file takes its place.
    Place(String),
    /// A staged file goes.
    Unstage(String),
    /// All of that is on the disk before what follows.
    Sync,
    /// The intent goes.
    Forget,
}

/// What an export is about to do.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct ExportIntent {
    /// What it is of.
    #[serde(flatten)]
    pub(super) of: ExportOf,
    /// The new program that is to be started; none where nothing is planned.
    pub(super) main: Option<String>,
    /// What is removed before anything is put in place, programs to be started first.
    pub(super) remove: Vec<String>,
    /// The new files in the order in which they are put in place.
    pub(super) place: Vec<FileDigest>,
    /// What stood under any of these names before.
    pub(super) was: Vec<FileDigest>,
}

impl ExportIntent {
    /// The intent of writing files where others stand: those of the earlier export in its order, then others.
    pub(super) fn new(of: ExportOf, files: &[OutputFile], standing: Vec<FileDigest>) -> ExportIntent {
        let main = files.iter().map(|f| &f.name).find(|n| is_program(n)).cloned();
        let stands = |name: &String| standing.iter().any(|f| f.name == *name);
        let writes = |name: &str| files.iter().any(|f| f.name == name);
        let old_main = standing.iter().map(|f| &f.name).find(|n| is_program(n));
        let mut remove: Vec<String> = Vec::new();
        let stale = standing.iter().map(|f| &f.name).filter(|n| !writes(n));
        for name in old_main.into_iter().chain(main.iter().filter(|n| stands(n))).chain(stale) {
            if !remove.contains(name) {
                remove.push(name.clone());
            }
        }
        let mut place: Vec<FileDigest> = files.iter().map(OutputFile::digest).collect();
        place.sort_by_key(|f| (f.name == REPORT, Some(&f.name) == main.as_ref()));
        ExportIntent { of, main, remove, place, was: standing }
    }

    /// The one in a folder; `None`: there is none that could be read.
    ///
    /// # Errors
    /// It is there and the system does not let it be read.
    pub(super) fn read(folder: &ExportFolder) -> Result<Option<ExportIntent>, JobError> {
        let text = folder.read(INTENT)?.unwrap_or_default();
        let read: Option<ExportIntent> = serde_json::from_slice(&text).ok();
        Ok(read.filter(|i| i.names().all(is_plain)))
    }

    /// All names that it touches; some twice.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        let digests = self.place.iter().chain(&self.was).map(|f| f.name.as_str());
        self.remove.iter().map(String::as_str).chain(digests)
    }

    /// What is done before the intent stands.
    pub(super) fn staging(&self, files: &[OutputFile]) -> Vec<CommitStep> {
        let staged = (0..files.len()).map(CommitStep::Stage);
        staged.chain([CommitStep::Sync, CommitStep::Declare, CommitStep::Sync]).collect()
    }

    /// What is done behind it. A program to be started is never there with subprograms that are not its own: the old
    /// one goes first, and the new one comes last.
    pub(super) fn steps(&self) -> Vec<CommitStep> {
        let is_last = |f: &&FileDigest| f.name == REPORT || Some(&f.name) == self.main.as_ref();
        let place = |f: &FileDigest| CommitStep::Place(f.name.clone());
        let mut out: Vec<CommitStep> = self.remove.iter().cloned().map(CommitStep::Remove).collect();
        out.push(CommitStep::Sync);
        out.extend(self.place.iter().filter(|f| !is_last(f)).map(place));
        out.push(CommitStep::Sync);
        out.extend(self.place.iter().filter(is_last).map(place));
        out.extend([CommitStep::Sync, CommitStep::Forget]);
        out
    }

    /// Takes a step.
    ///
    /// # Errors
    /// The system does not let it be taken.
    pub(super) fn apply(&self, folder: &ExportFolder, files: &[OutputFile], step: &CommitStep) -> Result<(), JobError> {
        match step {
            CommitStep::Stage(number) => match files.get(*number) {
                Some(f) => folder.stage(&f.name, &f.bytes),
                None => Ok(()),
            },
            CommitStep::Declare => {
                let json = serde_json::to_vec_pretty(self);
                let json = json.map_err(|e| JobError::write(&folder.path().join(INTENT), e.into()))?;
                folder.stage(INTENT, &json)?;
                folder.place(INTENT)
            }
            CommitStep::Remove(name) => folder.remove(name),
            CommitStep::Place(name) => folder.place(name),
            CommitStep::Unstage(name) => folder.unstage(name),
            CommitStep::Sync => {
                folder.sync();
                Ok(())
            }
            CommitStep::Forget => folder.remove(INTENT),
        }
    }
}
