//! What an export says of itself in `report.json`: whose it is, which programs of its plan stand in the folder, and every
//! file that was written with it. The next export into the same folder reads it.

use crate::program::Variant;
use serde::{Deserialize, Serialize};

/// Keys `job`, `part`, `from_pass`, `dry_run`, `plan_sha256`, `programs` and `files` of the report.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WrittenFiles {
    /// Name of the job.
    pub job: String,
    /// File name of its part.
    pub part: String,
    /// The pass that the export begins with, where it is not the first: report and tables leave out what is before it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from_pass: Option<usize>,
    /// Whether the program that was written is a dry run; report and tables are those of the program itself.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dry_run: Option<DryRunReport>,
    /// SHA-256 of the whole program of the plan: programs of the same plan stand beside each other, others go.
    pub plan_sha256: String,
    /// The programs that stand in the folder, the one that was written first.
    pub programs: Vec<StandingProgram>,
    /// All files but the report itself, in the order in which they were made, then those of the other programs: of
    /// each program the one to start comes first.
    pub files: Vec<FileDigest>,
}

/// Key `dry_run` of the report.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct DryRunReport {
    /// Its speed, per cent of the program's.
    pub speed_percent: f64,
}

/// A program in a folder.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct StandingProgram {
    /// Which of the plan's.
    #[serde(flatten)]
    pub variant: Variant,
    /// Its files, the one to start first.
    pub names: Vec<String>,
}

/// A file of an export.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct FileDigest {
    /// Name within the folder.
    pub name: String,
    /// SHA-256 of its bytes, hexadecimal.
    pub sha256: String,
}
