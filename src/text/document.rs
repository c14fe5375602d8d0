//! Why a job cannot be read or saved, and what its surfaces start from or lose.

use super::{Sentence, exact, id, say};
use crate::document::files::ScannedPartError;
use crate::document::job_file::{JobFileError, WRITTEN};
use crate::document::{JobError, LostSettings, StartFrom};
use crate::file::one_line;
use crate::pose::ToolBody;
use crate::scan::meshing::MeshingError;
use std::path::Path;

impl Sentence for JobError {
    fn sentence(&self) -> String {
        match self {
            JobError::File(e) => e.sentence(),
            JobError::NoJob { file, source } => say!(in_file, file, what = source.sentence()),
            JobError::Package { file, what } => say!(in_file, file, what = what.sentence()),
            JobError::PartGone { file } => say!(job_part_gone, file),
            JobError::PartChanged { file } => say!(job_part_changed, file),
            JobError::Part(e) => e.sentence(),
            JobError::ScannedPart { file, source } => say!(in_file, file, what = source.sentence()),
            JobError::DepthImage(e) => e.sentence(),
            JobError::Camera(e) => e.sentence(),
            JobError::Grinder(e) => e.sentence(),
            JobError::Cell(e) => e.sentence(),
            JobError::Robot(e) => e.sentence(),
            JobError::Head(e) => e.sentence(),
            JobError::LaserBlocked { cell, obstacle, by: ToolBody::Beam } => say!(job_beam_blocked, cell, obstacle),
            JobError::LaserBlocked { cell, obstacle, by: ToolBody::Head | ToolBody::Abrasive | ToolBody::Gouge } => {
                say!(job_head_blocked, cell, obstacle)
            }
            JobError::ChangedOnDisk { file } => say!(job_changed_on_disk, file),
            JobError::Unwritable(source) => say!(job_not_serialized, reason = source.to_string()),
            JobError::Write { file, source } => {
                say!(job_not_written, file = path(file), reason = source.to_string())
            }
            JobError::Remove { file, source } => {
                say!(job_not_removed, file = path(file), reason = source.to_string())
            }
        }
    }
}

impl Sentence for ScannedPartError {
    fn sentence(&self) -> String {
        match self {
            ScannedPartError::File(e) => e.sentence(),
            ScannedPartError::Meshing(MeshingError::NoSurface { finite }) => say!(scan_no_surface, points = *finite),
            ScannedPartError::Meshing(MeshingError::TooWide) => say!(scan_too_wide),
            ScannedPartError::Meshing(MeshingError::Cancelled) => say!(text_cancelled),
        }
    }
}

impl Sentence for JobFileError {
    fn sentence(&self) -> String {
        match self {
            JobFileError::NoText(e) => e.sentence(),
            JobFileError::Toml(e) => e.sentence(),
            JobFileError::Table(source) => one_line(source.message()),
            JobFileError::Parameter(e) => e.sentence(),
            JobFileError::Recipe(e) => e.sentence(),
            JobFileError::Range { key, value, low, high } => {
                say!(figure_range, key = *key, value = exact(*value), low = exact(*low), high = exact(*high))
            }
            JobFileError::InLine { line, what } => say!(in_line, line = id(line), what = what.sentence()),
            JobFileError::Frame(e) => e.sentence(),
            JobFileError::Transform(fault) => say!(transform_of_scan, what = fault.sentence()),
            JobFileError::Later(version) => say!(job_file_later, version = id(version), known = id(WRITTEN)),
            JobFileError::NoVersion(version) => say!(job_file_no_version, version, known = id(WRITTEN)),
            JobFileError::Twice { key, surface } => say!(job_file_twice, key = *key, surface = id(surface)),
            JobFileError::NoNumber { key, text } => say!(job_file_no_number, key = *key, text),
        }
    }
}

impl Sentence for StartFrom {
    /// Borders count from 1.
    fn sentence(&self) -> String {
        match self {
            StartFrom::Whole => say!(start_whole),
            StartFrom::Border(b) => say!(start_border, number = id(b.saturating_add(1))),
        }
    }
}

impl Sentence for LostSettings {
    fn sentence(&self) -> String {
        let (pins, surface) = (self.pins, id(self.surface));
        match (pins, self.border) {
            (0, _) => say!(dropped_border, surface),
            (_, false) => say!(dropped_pins, pins, surface),
            (_, true) => say!(dropped_pins_and_border, pins, surface),
        }
    }
}

/// A path as people read it.
pub(super) fn path(path: &Path) -> String {
    path.display().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::job_file::parse;
    use crate::part::SurfaceId;

    fn refusal(text: &str) -> String {
        parse(text).expect_err(text).sentence()
    }

    #[test]
    fn what_is_wrong_with_a_job_is_told_with_a_remedy() {
        let said = refusal("version = 3\nnovelty = 1");
        assert!(said.contains("version = 3") && said.contains("later clearbeam"), "{said}");
        assert!(said.contains("open it with a newer"), "{said}");
        for none in ["0", "-1", "\"2\"", "2.0"] {
            let said = refusal(&format!("version = {none}"));
            assert!(said.contains(&format!("version = {none}: give 2")), "{said}");
        }
        let said = refusal("[clean]\nsurfaces = [1204, 1, 1204]");
        assert_eq!(said, "line 2: clean.surfaces: surface 1204 is listed twice; name it once");
        let said = refusal("[surfaces.names]\nfour = \"Rim\"");
        assert_eq!(said, "line 2: surfaces.names: \"four\" is not a surface number; give a number like 4");
        let said = refusal("[layers]\nspaceing_mm = 2");
        assert!(said.contains("line 2") && said.contains("spaceing_mm") && said.lines().count() == 1, "{said}");
        let write = JobError::write(Path::new("/none/x"), std::io::Error::other("read-only"));
        assert_eq!(write.sentence(), "/none/x: cannot be written: read-only; choose another folder");
    }

    #[test]
    fn what_a_surface_loses_is_told_by_number() {
        let lost = |pins, border| LostSettings { surface: SurfaceId(3), pins, border }.sentence();
        assert_eq!(lost(0, true), "the border of surface 3 was dropped");
        assert_eq!(lost(1, false), "1 pinned tilt of surface 3 was dropped");
        assert_eq!(lost(2, false), "2 pinned tilts of surface 3 were dropped");
        assert_eq!(lost(1, true), "1 pinned tilt and the border of surface 3 were dropped");
        assert_eq!(lost(2, true), "2 pinned tilts and the border of surface 3 were dropped");
        assert_eq!(
            (StartFrom::Border(0).sentence(), StartFrom::Whole.sentence()),
            ("border 1".into(), "whole outline".into())
        );
    }
}
