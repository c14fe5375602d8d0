//! Paths as a job names them: relative to the folder of its file, with '/' on every system.

use super::error::JobError;
use crate::cell::Robot;
use crate::document::model::Job;
use std::path::{Component, Path, PathBuf};

/// A path that a job in `job_file` names, as seen from the current folder.
pub fn resolved(job_file: Option<&Path>, named: &str) -> PathBuf {
    match job_file.and_then(Path::parent) {
        Some(folder) => folder.join(named),
        None => PathBuf::from(named),
    }
}

/// A path as a job in `job_file` names it; whole where the job has no file yet.
pub fn relative_to(path: &Path, job_file: Option<&Path>) -> String {
    job_file.and_then(|f| relative(path, f).ok()).unwrap_or_else(|| path.display().to_string())
}

/// The job with its paths seen from another job file.
///
/// # Errors
/// The folder cannot be found.
pub fn rebased(job: &Job, from: Option<&Path>, to: &Path) -> Result<Job, JobError> {
    with_paths(job, |path| relative(&resolved(from, path), to))
}

/// The job with whole paths, for one that has no file to name them from.
///
/// # Errors
/// The current folder cannot be found.
pub(in crate::document) fn with_whole_paths(job: &Job) -> Result<Job, JobError> {
    with_paths(job, |path| Ok(absolute(Path::new(path))?.display().to_string()))
}

/// A path from the root, without `.` and `..`.
///
/// # Errors
/// The current folder cannot be found.
pub(in crate::document) fn absolute(path: &Path) -> Result<PathBuf, JobError> {
    std::path::absolute(path).map(|p| without_dots(&p)).map_err(|e| JobError::write(path, e))
}

/// The job with every path that it names changed.
pub(super) fn with_paths(job: &Job, mut change: impl FnMut(&str) -> Result<String, JobError>) -> Result<Job, JobError> {
    let mut job = job.clone();
    let has_robot_file = !job.cell.robot.is_empty() && !Robot::is_shipped(&job.cell.robot);
    let robot = has_robot_file.then_some(&mut job.cell.robot);
    let clamps = job.clamps.iter_mut().map(|c| &mut c.file);
    let files = [&mut job.part.file, &mut job.cell.file, &mut job.beam.head];
    let scans = job.scan.files.iter_mut().map(|s| &mut s.file);
    let weld = job.weld.paths_mut();
    for path in files.into_iter().chain(robot).chain(clamps).chain(scans).chain(weld) {
        if !path.is_empty() {
            *path = change(path)?;
        }
    }
    Ok(job)
}

/// Path of `file` as seen from the folder of `job_file`, with '/' on every system.
fn relative(file: &Path, job_file: &Path) -> Result<String, JobError> {
    let (file, job_file) = (absolute(file)?, absolute(job_file)?);
    let folder: Vec<Component<'_>> = job_file.parent().map(|p| p.components().collect()).unwrap_or_default();
    let target: Vec<Component<'_>> = file.components().collect();
    let common = folder.iter().zip(&target).take_while(|(a, b)| a == b).count();
    if common == 0 {
        return Ok(file.display().to_string()); // another drive
    }
    let up = std::iter::repeat_n("..".to_owned(), folder.len() - common);
    let down = target[common..].iter().map(|c| c.as_os_str().to_string_lossy().into_owned());
    Ok(up.chain(down).collect::<Vec<_>>().join("/"))
}

/// Takes `.` and `..` out of an absolute path.
fn without_dots(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for c in path.components() {
        match c {
            Component::ParentDir => {
                out.pop();
            }
            Component::CurDir => {}
            other => out.push(other),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_follow_the_job() {
        let job = Job {
            part: crate::document::model::JobPart { file: "../parts/a.stl".into(), ..Default::default() },
            ..Job::default()
        };
        let moved = rebased(&job, Some(Path::new("/x/jobs/a.toml")), Path::new("/x/out/b/job.toml")).expect("rebases");
        assert_eq!(moved.part.file, "../../parts/a.stl");
    }
}
