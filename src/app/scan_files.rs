//! Files of a scan that the operator gives: from the dialog, or dropped onto the window. What is in them is read by the
//! pipeline.

use super::App;
use super::shown::Tab;
use crate::document::Edit;
use crate::document::files;
use crate::document::model::ScanFile;
use crate::document::scan_edit::ScanEdit;
use crate::part::Hasher;
use crate::part::file::ENDINGS as PART_ENDINGS;
use crate::planning::{Executor, Failure, Stage};
use crate::progress::{Activity, Progress};
use crate::scan::file::{self, ENDINGS, ScanFileError};
use crate::text::{Sentence as _, say};
use std::fs::File;
use std::io::Read as _;
use std::path::{Path, PathBuf};

/// The header of a PLY file ends before this; those of scanners have a few hundred bytes.
const HEADER_BYTES: u64 = 1 << 16;

/// Files that are on their way into the job: each is hashed on a thread first, so that the job knows it again.
#[derive(Default)]
pub(super) struct ScanAdding {
    waiting: Vec<PathBuf>,
    hashing: Stage<Vec<(PathBuf, String)>, (PathBuf, ScanFileError)>,
}

impl ScanAdding {
    fn start(&mut self, executor: &dyn Executor) {
        if self.waiting.is_empty() || self.hashing.is_running() {
            return;
        }
        let files = std::mem::take(&mut self.waiting);
        let hashed = |file: PathBuf, progress: &Progress| match file::sha256(&file, progress) {
            Ok(sha256) => Ok((file, sha256)),
            Err(ScanFileError::Cancelled) => Err(Failure::Cancelled),
            Err(why) => Err(Failure::Refused((file, why))),
        };
        self.hashing.start(Hasher::default().finish(), Activity::ReadingScan, executor, move |progress| {
            files.into_iter().map(|file| hashed(file, progress)).collect()
        });
    }

    /// How far it is.
    pub fn progress(&self) -> Option<&Progress> {
        self.hashing.progress()
    }

    /// Asks it to end: nothing is added.
    pub fn cancel(&mut self) {
        self.waiting.clear();
        self.hashing.cancel();
    }

    /// Whether no file is on its way.
    pub fn is_at_rest(&self) -> bool {
        self.waiting.is_empty() && !self.hashing.is_running()
    }
}

impl App {
    /// Begins to add files to the job's scan.
    pub(super) fn add_scans(&mut self, files: impl IntoIterator<Item = PathBuf>) {
        self.adding.waiting.extend(files);
        let executor = self.derived.pipeline.executor().clone();
        self.adding.start(&*executor);
    }

    /// Takes files whose bytes are known by now into the job, each unless it is there.
    pub(super) fn take_scans(&mut self) {
        match self.adding.hashing.take_result() {
            Some(Ok(hashed)) => {
                let scan = &self.document.job().scan;
                let (mut all, units) = (scan.files.clone(), scan.units);
                for (path, sha256) in hashed {
                    let file = files::relative_to(&path, self.document.file());
                    if all.iter().all(|f| f.file != file) {
                        all.push(ScanFile { file, sha256 });
                    }
                }
                if all.len() > scan.files.len() {
                    self.edit(Edit::Scan(Box::new(ScanEdit::Files(all, units))));
                    self.session.tab = Some(Tab::Scan);
                }
            }
            Some(Err(Failure::Refused((path, why)))) => {
                self.session.error = Some(say!(in_file, file = path.display().to_string(), what = why.sentence()));
            }
            Some(Err(Failure::Panicked(why))) => self.session.error = Some(say!(window_fault, error = why)),
            Some(Err(Failure::Cancelled)) | None => {}
        }
        self.add_scans([]);
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
