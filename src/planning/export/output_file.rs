//! A file of an export, whole in memory, and what its files may be called.

use crate::part::digest_of;
use crate::planning::report::FileDigest;

/// The job as it was exported.
pub(super) const JOB: &str = "job.toml";
/// The report, which lists all other files.
pub(super) const REPORT: &str = "report.json";
/// The report as a page for people.
pub(super) const PAGE: &str = "report.html";
/// What lands.
pub(super) const DOSE: &str = "dose.ply";
/// The pixels of a weld's areas.
pub(super) const WELD_MASK: &str = "mask.png";
/// The points of its beads.
pub(super) const WELD_BEAD: &str = "bead.ply";
/// Every file of an export that is no program, those of other versions included: all else is taken for one.
const NOT_PROGRAMS: [&str; 9] = [JOB, REPORT, "path.csv", "joints.csv", "air.csv", DOSE, PAGE, WELD_MASK, WELD_BEAD];

/// Whether a file that an export wrote belongs to its program.
pub(super) fn is_program(name: &str) -> bool {
    !NOT_PROGRAMS.contains(&name)
}

/// Whether a name is that of a file of an export: within the folder, and none that it needs for itself.
pub(super) fn is_plain(name: &str) -> bool {
    !name.is_empty() && !name.starts_with('.') && !name.contains(['/', '\\', ':', '\0'])
}

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
