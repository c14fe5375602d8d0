//! A file of an export, whole in memory.

use crate::part::digest_of;
use crate::planning::report::FileDigest;

/// What a file of a plan is called, and its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputFile {
    /// Name within the folder.
    pub name: String,
    /// Contents.
    pub bytes: Vec<u8>,
}

impl OutputFile {
    /// Its name and what its bytes come to.
    pub(super) fn digest(&self) -> FileDigest {
        FileDigest { name: self.name.clone(), sha256: digest_of(&self.bytes) }
    }
}
