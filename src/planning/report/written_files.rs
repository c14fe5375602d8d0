//! What an export says of itself in `report.json`: whose it is, and every file that was written with it. The next
//! export into the same folder reads it.

use serde::{Deserialize, Serialize};

/// Keys `job`, `part` and `files` of the report.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct WrittenFiles {
    /// Name of the job.
    pub job: String,
    /// File name of its part.
    pub part: String,
    /// All files but the report itself, in the order in which they were made: of the programs the one to start
    /// comes first.
    pub files: Vec<FileDigest>,
}

/// A file of an export.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct FileDigest {
    /// Name within the folder.
    pub name: String,
    /// SHA-256 of its bytes, hexadecimal.
    pub sha256: String,
}
