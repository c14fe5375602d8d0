//! The files that a job is planned from, told by their bytes: part, scans, images of a weld, cell, robot, head, grinding tool,
//! clamps, and the obstacles of the cell. Whoever plans again later sees by them whether it is the same.

use super::part_file::part_file;
use super::paths::resolved;
use super::setup::{cell_key, load_cell};
use crate::cell::{Cell, Robot};
use crate::document::model::Job;
use crate::file::bytes;
use crate::part::digest_of;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What a file is to a job.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum InputKind {
    /// The workpiece.
    Part,
    /// A scan of it.
    Scan,
    /// An image of a weld.
    Image,
    /// The camera that took it.
    Camera,
    /// Where that stood.
    HandEye,
    /// The robot cell.
    Cell,
    /// The robot.
    Robot,
    /// The head behind the beam.
    Head,
    /// The tool that grinds.
    Grinder,
    /// A clamp on the part.
    Clamp,
    /// A body that stands in the cell.
    Obstacle,
}

/// A file that a job is planned from.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct InputDigest {
    /// What it is.
    pub kind: InputKind,
    /// Its name without folders; of a shipped cell or robot its key.
    pub name: String,
    /// SHA-256 of its bytes, hexadecimal.
    pub sha256: String,
}

/// The files of a job in `job_file` as they are now, of a kind in the job's order. What cannot be read is left out.
pub fn inputs(job: &Job, job_file: Option<&Path>) -> Vec<InputDigest> {
    let named = |file: &str| Some(resolved(job_file, file)).filter(|_| !file.is_empty());
    let shipped =
        |kind, key: &str, text: &str| InputDigest { kind, name: key.into(), sha256: digest_of(text.as_bytes()) };
    let cell = match named(&job.cell.file) {
        Some(file) => of_file(InputKind::Cell, &file),
        None => Cell::shipped_text(cell_key(job)).map(|text| shipped(InputKind::Cell, cell_key(job), text)),
    };
    let robot = match Robot::shipped_text(&job.cell.robot) {
        Some(text) => Some(shipped(InputKind::Robot, &job.cell.robot, text)),
        None => named(&job.cell.robot).and_then(|file| of_file(InputKind::Robot, &file)),
    };
    let part = part_file(job, job_file).ok().and_then(|file| of_file(InputKind::Part, &file));
    let scans = job.scan.files.iter().filter_map(|s| of_file(InputKind::Scan, &named(&s.file)?));
    let weld = &job.weld;
    let images = weld.files().filter(|f| **f != weld.images.camera);
    let images = images.filter_map(|f| of_file(InputKind::Image, &named(&f.file)?));
    let one = |kind, file: &str| named(file).and_then(|file| of_file(kind, &file));
    let camera = one(InputKind::Camera, &weld.images.camera.file);
    let seen = images.chain(camera).chain(one(InputKind::HandEye, &weld.hand_eye));
    let grinder = one(InputKind::Grinder, &weld.tool);
    let head = named(&job.beam.head).and_then(|file| of_file(InputKind::Head, &file));
    let clamps = job.clamps.iter().filter_map(|c| of_file(InputKind::Clamp, &named(&c.file)?));
    let obstacles = load_cell(job, job_file).map(|cell| cell.bodies.obstacles).unwrap_or_default();
    let cell_file = named(&job.cell.file);
    let obstacles =
        obstacles.iter().filter_map(|o| of_file(InputKind::Obstacle, &resolved(cell_file.as_deref(), &o.file)));
    let set_up = [cell, robot, head, grinder].into_iter().flatten();
    part.into_iter().chain(scans).chain(seen).chain(set_up).chain(clamps).chain(obstacles).collect()
}

fn of_file(kind: InputKind, file: &Path) -> Option<InputDigest> {
    let name = file.file_name()?.to_string_lossy().into_owned();
    Some(InputDigest { kind, name, sha256: digest_of(&bytes(file).ok()?) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::model::ScanFile;

    #[test]
    fn every_file_of_a_job_is_told_by_its_bytes() {
        let folder = tempfile::tempdir().expect("a folder");
        let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("writes");
        let job_file = folder.path().join("job.toml");
        let mut job = Job::default();
        (job.part.file, job.beam.head) = ("a.stl".into(), "head.toml".into());
        write("a.stl", "part");
        write("head.toml", "head");
        let kinds = |job: &Job| inputs(job, Some(&job_file)).iter().map(|i| i.kind).collect::<Vec<_>>();
        assert_eq!(kinds(&job), [InputKind::Part, InputKind::Cell, InputKind::Head]);
        let before = inputs(&job, Some(&job_file));
        assert_eq!((before[0].name.as_str(), before[0].sha256.as_str()), ("a.stl", digest_of(b"part").as_str()));
        assert_eq!((before[1].name.as_str(), before[1].sha256.len()), ("mz04", 64), "the shipped cell");
        write("head.toml", "another");
        let after = inputs(&job, Some(&job_file));
        assert_eq!(before[..2], after[..2]);
        assert_ne!(before[2], after[2]);
        write("worn.ply", "points");
        job.scan.files = vec![ScanFile { file: "worn.ply".into(), ..ScanFile::default() }];
        let scanned = inputs(&job, Some(&job_file));
        assert_eq!((scanned[1].kind, scanned[1].name.as_str()), (InputKind::Scan, "worn.ply"));
        job.scan.files.clear();
        job.cell.robot = "gp7".into();
        assert_eq!(inputs(&job, Some(&job_file))[1].name, "gp7");
        assert_eq!(kinds(&job)[2], InputKind::Robot);
    }
}
