//! Files of a scan that the operator gives: from the dialog, or dropped onto the window. What is in them is read by the
//! pipeline.

use super::App;
use crate::document::Edit;
use crate::document::files;
use crate::document::model::ScanFile;
use crate::document::scan_edit::ScanEdit;
use crate::part::file::ENDINGS as PART_ENDINGS;
use crate::scan::file::ENDINGS;
use std::fs::File;
use std::io::Read as _;
use std::path::Path;

/// The header of a PLY file ends before this; those of scanners have a few hundred bytes.
const HEADER_BYTES: u64 = 1 << 16;

impl App {
    /// Adds a file to the job's scan, unless it is there.
    pub(super) fn add_scan(&mut self, path: &Path) {
        let file = files::relative_to(path, self.document.file());
        let scan = &self.document.job().scan;
        if scan.files.iter().all(|f| f.file != file) {
            let mut all = scan.files.clone();
            all.push(ScanFile { file, ..ScanFile::default() });
            self.edit(Edit::Scan(Box::new(ScanEdit::Files(all, scan.units))));
        }
    }
}

/// Whether a file is a scan and cannot be a part: by the ending of its name, and a PLY by having no facets.
pub(super) fn is_scan_alone(path: &Path) -> bool {
    let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    match ending.as_str() {
        "ply" => is_ply_without_facets(path),
        ending => ENDINGS.contains(&ending) && !PART_ENDINGS.contains(&ending),
    }
}

fn is_ply_without_facets(path: &Path) -> bool {
    let mut begin = Vec::new();
    let read = File::open(path).and_then(|file| file.take(HEADER_BYTES).read_to_end(&mut begin));
    let text = String::from_utf8_lossy(&begin);
    let Some((header, _)) = text.split_once("end_header") else { return false };
    let has_facets = |line: &str| {
        let words: Vec<&str> = line.split_whitespace().collect();
        matches!(words.as_slice(), ["element", "face" | "tristrips", count] if *count != "0")
    };
    read.is_ok() && !header.lines().any(has_facets)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ply_is_a_scan_when_it_has_no_facets() {
        let folder = tempfile::tempdir().expect("a folder");
        let is_scan = |name: &str, text: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, text).expect("writes");
            is_scan_alone(&path)
        };
        let ply = |faces: &str| format!("ply\nformat ascii 1.0\nelement vertex 1\n{faces}end_header\n0 0 0\n");
        assert!(is_scan("a.ply", &ply("")) && is_scan("a.PLY", &ply("element face 0\n")));
        assert!(!is_scan("b.ply", &ply("element face 12\n")));
        assert!(!is_scan("c.ply", "ply\nelement vertex 3\n"), "it has no end of its header");
        for (name, scan) in [("a.e57", true), ("a.XYZ", true), ("a.stl", false), ("a.toml", false), ("a", false)] {
            assert_eq!(is_scan(name, ""), scan, "{name}");
        }
        assert!(!is_scan_alone(&folder.path().join("gone.ply")));
    }
}
