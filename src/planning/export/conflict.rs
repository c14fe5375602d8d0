//! What an export is of, and files that stand in its way, as data.

use serde::{Deserialize, Serialize};

/// What an export is of. Two exports are of the same job if both names agree.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ExportOf {
    /// Name of the job: its file without ending, or the part's where the job has no file.
    pub job: String,
    /// File name of the part.
    pub part: String,
}

/// Why a file may not be replaced or removed without being asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ConflictReason {
    /// An earlier export of this job wrote it, and it is not as it was written.
    ChangedByHand,
    /// The export of another job wrote it.
    OtherJob(ExportOf),
    /// No export wrote it.
    NoExports,
    /// An earlier version wrote the export, which did not list its files.
    EarlierVersion,
    /// It is a folder; that is never replaced.
    Folder,
}

/// A file that stands in the way of an export.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileConflict {
    /// Name within the folder.
    pub name: String,
    /// Why it stays.
    pub reason: ConflictReason,
}

impl FileConflict {
    /// Whether it is replaced if the user says so.
    pub fn can_be_overwritten(&self) -> bool {
        self.reason != ConflictReason::Folder
    }
}

/// What an export may replace although it is not as an earlier export of the same job left it.
#[derive(Clone, Copy, Debug)]
pub(super) struct MayReplace {
    /// The folder's job: it is the file that the exported job was read from.
    pub(super) reads_job: bool,
    /// All files: the user said so.
    pub(super) overwrite: bool,
}
