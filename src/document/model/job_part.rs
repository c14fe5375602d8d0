//! The `[part]` table of a job: the part's file, and how it stands.

use crate::document::remembered::Remembered;
use crate::part::{Placement, Source, Units, Weld};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The part of a job: its file, and how it stands.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct JobPart {
    /// Path, relative to the job file.
    pub file: String,
    /// SHA-256 of its bytes when the job was saved; empty: any.
    pub sha256: String,
    /// Unit of its coordinates.
    pub units: Units,
    /// Which of its corners become one vertex.
    pub weld: Weld,
    /// Shells whose other side is to be worked on.
    pub flipped_shells: Vec<u32>,
    /// Where the part stands.
    pub placement: Placement,
    /// What its surfaces looked like when the job was saved.
    #[serde(skip_serializing_if = "Remembered::is_empty")]
    pub landmarks: Remembered,
}

impl JobPart {
    /// Takes what was read of its file: from now on the job is of this part, and of no other under its name. A job
    /// that was just made, so it is in no file and was of no part yet, takes the unit that the file states.
    pub fn begin_with(&mut self, source: &Source, job_file: Option<&Path>) {
        if job_file.is_none() && self.sha256.is_empty() {
            self.units = source.raw.stated_unit.map_or(self.units, |s| s.taken());
        }
        self.sha256.clone_from(&source.sha256);
    }

    /// Whether the job was made for other bytes than those of this SHA-256.
    pub fn is_of_another_file(&self, sha256: &str) -> bool {
        !self.sha256.is_empty() && self.sha256 != sha256
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::raw_part::RawPart;
    use crate::part::units::StatedUnit;

    #[test]
    fn a_job_that_was_just_made_takes_the_unit_of_the_file() {
        let raw = RawPart { stated_unit: Some(StatedUnit::Inch), ..RawPart::default() };
        let source = Source { raw, sha256: "ab".into() };
        let units = |mut part: JobPart, job_file: Option<&Path>| {
            part.begin_with(&source, job_file);
            assert_eq!(part.sha256, "ab");
            part.units
        };
        assert_eq!(units(JobPart::default(), None), Units::Inch);
        assert_eq!(units(JobPart::default(), Some(Path::new("job.toml"))), Units::Mm);
        let of_a_part = JobPart { sha256: "ab".into(), units: Units::M, ..JobPart::default() };
        assert_eq!(units(of_a_part, None), Units::M);
    }
}
