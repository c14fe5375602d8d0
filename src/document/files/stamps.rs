//! Whether files have changed since they were read, told by their time and size: the part's, and those of scan, cell,
//! robot with its bodies, head and obstacles that a job names.

use super::paths::resolved;
use crate::cell::{Cell, Robot};
use crate::document::model::Job;
use std::fs::metadata;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Time and size of a file: where neither changes it is taken for unchanged. `None`: it is not there.
pub type Stamp = Option<(SystemTime, u64)>;

/// The stamp of a file as it is now.
pub fn stamp_of(file: &Path) -> Stamp {
    let data = metadata(file).ok()?;
    Some((data.modified().ok()?, data.len()))
}

/// Files with the stamps that they had when they were read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stamps(Vec<(PathBuf, Stamp)>);

impl Stamps {
    /// Stamps of all files that a job in `job_file` names, but for the part's; `cell` and `robot` are those that it names,
    /// if they can be read.
    pub fn of(job: &Job, job_file: Option<&Path>, cell: Option<&Cell>, robot: Option<&Robot>) -> Stamps {
        let robot_file = Some(&job.cell.robot).filter(|r| !Robot::is_shipped(r));
        let named = [Some(&job.cell.file), Some(&job.beam.head), robot_file];
        let named = named.into_iter().flatten().chain(job.clamps.iter().map(|c| &c.file));
        let named = named.chain(job.scan.files.iter().map(|s| &s.file)).chain(job.weld.files().map(|f| &f.file));
        let named = named.chain([&job.weld.hand_eye, &job.weld.tool]);
        let mut files: Vec<PathBuf> = named.filter(|f| !f.is_empty()).map(|f| resolved(job_file, f)).collect();
        let cell_file = resolved(job_file, &job.cell.file);
        let obstacles = cell.into_iter().flat_map(|c| &c.bodies.obstacles);
        files.extend(obstacles.map(|o| resolved(Some(&cell_file), &o.file)));
        let robot_file = resolved(job_file, &job.cell.robot);
        let bodies = robot.into_iter().flat_map(|r| r.links.meshes.bodies());
        files.extend(bodies.map(|(_, _, body)| resolved(Some(&robot_file), &body.file)));
        Stamps(files.into_iter().map(|file| (file.clone(), stamp_of(&file))).collect())
    }

    /// Whether a file is another one by now.
    pub fn have_changed(&self) -> bool {
        self.0.iter().any(|(file, stamp)| stamp_of(file) != *stamp)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_head_that_is_written_anew_or_gone_is_noticed() {
        let folder = tempfile::tempdir().expect("a folder");
        let (file, head) = (folder.path().join("job.toml"), folder.path().join("head.toml"));
        let mut job = Job::default();
        job.beam.head = "head.toml".into();
        let missing = Stamps::of(&job, Some(&file), None, None);
        assert!(!missing.have_changed());
        std::fs::write(&head, "a").expect("writes");
        assert!(missing.have_changed());
        let there = Stamps::of(&job, Some(&file), None, None);
        assert!(!there.have_changed());
        std::fs::write(&head, "longer").expect("writes");
        assert!(there.have_changed());
        assert!(!Stamps::of(&Job::default(), Some(&file), None, None).have_changed(), "a shipped cell is no file");
    }

    /// The files stand beside the robot's, not beside the job's.
    #[test]
    fn a_body_of_the_robot_that_is_gone_is_noticed() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut job = Job::default();
        job.cell.robot = "arms/my.toml".into();
        let robot = crate::cell::robot::meshed("mz04", [0.0; 6]);
        let body = folder.path().join("arms/3.stl");
        std::fs::create_dir(folder.path().join("arms")).expect("a folder");
        std::fs::write(&body, "solid").expect("writes");
        let there = Stamps::of(&job, Some(&folder.path().join("job.toml")), None, Some(&robot));
        assert!(!there.have_changed());
        std::fs::remove_file(&body).expect("goes");
        assert!(there.have_changed());
    }
}
