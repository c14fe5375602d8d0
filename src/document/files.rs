//! Job files: reading, atomic writing, and paths relative to where the job stands.

use super::job_file::{self, JobFileError};
use super::model::Job;
use crate::beam::{Body, Head, HeadError, Tool};
use crate::cell::robot::RobotFigureError;
use crate::cell::{Cell, CellError, Mount, Robot, RobotError, Setup};
use crate::file::{self, FileError};
use crate::part::{LoadError, Part, Source};
use crate::pose::{Beam, Blocker, Obstruction, ToolBody};
use crate::program::dialects;
use crate::progress::Progress;
use nalgebra::{Point3, Vector3};
use std::io::Write as _;
use std::path::{Component, Path, PathBuf};
use thiserror::Error;

/// Why a job cannot be opened or saved.
#[derive(Debug, Error)]
pub enum JobError {
    /// A file cannot be read, or is no TOML of a job.
    #[error(transparent)]
    File(#[from] FileError),
    /// It is no job.
    #[error("{file}: no job")]
    NoJob {
        /// The file.
        file: String,
        /// What is wrong with it.
        source: JobFileError,
    },
    /// The part is not where the job says.
    #[error("the part {file} is not there; put it back, or write its place into `part.file` of the job")]
    PartGone {
        /// Where it was looked for.
        file: String,
    },
    /// The part is another one now.
    #[error(
        "the part {file} has changed since the job was saved, so its surfaces may have other numbers; \
         open the job in the window, or plan it: both say what of it was found again"
    )]
    PartChanged {
        /// The file.
        file: String,
    },
    /// The part cannot be used.
    #[error(transparent)]
    Part(#[from] LoadError),
    /// The cell cannot be used.
    #[error(transparent)]
    Cell(#[from] CellError),
    /// The robot cannot be used.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// The head cannot be used.
    #[error(transparent)]
    Head(#[from] HeadError),
    /// The laser stands still, and an obstacle of the cell stands in its way.
    #[error("{cell}: {obstacle} blocks the laser")]
    LaserBlocked {
        /// Name of the cell.
        cell: String,
        /// The obstacle's file.
        obstacle: String,
        /// What of the tool it touches.
        by: ToolBody,
    },
    /// Somebody else has saved meanwhile.
    #[error(
        "{file}: has changed since it was opened here, by another window or program; save under another name, \
         open it again, or overwrite it: what stands there now becomes {file}.bak"
    )]
    ChangedOnDisk {
        /// The job file.
        file: String,
    },
    /// Something cannot be written.
    #[error("{what}")]
    Write {
        /// What, where, why.
        what: String,
    },
}

impl JobError {
    pub(crate) fn write(path: &Path, error: &std::io::Error) -> JobError {
        JobError::Write { what: format!("{}: cannot be written: {error}; choose another folder", path.display()) }
    }
}

/// Whether a path names a job rather than a part.
pub fn is_job(path: &Path) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml") || e.eq_ignore_ascii_case("clearbeam"))
}

/// Reads a job file.
///
/// # Errors
/// It cannot be read, or is no job (with line and column).
pub fn read(file: &Path) -> Result<Job, JobError> {
    super::save::open(file).map(|(job, _)| job)
}

/// The job that the bytes of a file hold.
///
/// # Errors
/// They are no job (with line and column); `name` is what the file is called.
pub(super) fn from_bytes(bytes: &[u8], name: &str) -> Result<Job, JobError> {
    let file = || name.to_owned();
    job_file::parse(file::text(bytes, name)?).map_err(|e| match e {
        JobFileError::Toml(e) => FileError::Toml { file: file(), source: Box::new(e) }.into(),
        source => JobError::NoJob { file: file(), source },
    })
}

/// The job as text.
///
/// # Errors
/// Never, for jobs made here.
pub fn to_toml(job: &Job) -> Result<String, JobError> {
    toml::to_string(job).map_err(|e| JobError::Write { what: format!("the job cannot be written: {e}") })
}

/// Reads the part's file of a job and checks that it is still the one the job was made for.
///
/// # Errors
/// Gone, changed, or no usable STL.
pub fn read_part(job: &Job, job_file: Option<&Path>) -> Result<Source, JobError> {
    let file = part_file(job, job_file)?;
    let source = Source::read(&file)?;
    if job.part.is_of_another_file(&source.sha256) {
        return Err(JobError::PartChanged { file: file.display().to_string() });
    }
    Ok(source)
}

/// The part of a job as it stands.
///
/// # Errors
/// Gone, changed, or no usable STL.
pub fn load_part(job: &Job, job_file: Option<&Path>) -> Result<Part, JobError> {
    let source = read_part(job, job_file)?;
    let p = &job.part;
    let built = source.part(p.units, &p.placement, &p.flipped_shells, &Progress::default());
    let named = |source| LoadError::Stl { file: p.file.clone(), source };
    // Nobody can have cancelled it.
    Ok(built.map_err(named)?.unwrap_or_default())
}

/// Where the part of a job is: where the job says, or beside the job under the same name.
///
/// # Errors
/// It is at neither place.
pub fn part_file(job: &Job, job_file: Option<&Path>) -> Result<PathBuf, JobError> {
    let named = beside(job_file, &job.part.file);
    let near = named.file_name().zip(job_file.and_then(Path::parent)).map(|(name, folder)| folder.join(name));
    [Some(named.clone()), near]
        .into_iter()
        .flatten()
        .find(|f| f.is_file())
        .ok_or(JobError::PartGone { file: named.display().to_string() })
}

/// A path as a job in `job_file` names it; whole where the job has no file yet.
pub fn relative_to(path: &Path, job_file: Option<&Path>) -> String {
    job_file.and_then(|f| relative(path, f).ok()).unwrap_or_else(|| path.display().to_string())
}

/// Cell, robot and mount of a job.
///
/// # Errors
/// A file cannot be read or has absurd figures.
pub fn load_setup(job: &Job, job_file: Option<&Path>) -> Result<Setup, JobError> {
    let robot = load_robot(job, job_file)?;
    set_up(job, robot, load_cell(job, job_file)?, load_tool(job, job_file)?)
}

/// The robot of a job; `None`: poses only.
///
/// # Errors
/// There is none of that name, or its file cannot be read or has absurd figures.
pub fn load_robot(job: &Job, job_file: Option<&Path>) -> Result<Option<Robot>, JobError> {
    Ok(match job.cell.robot.as_str() {
        "" => None,
        name => {
            let robot = Robot::load(name, job_file.and_then(Path::parent))?;
            if dialects::by_name(&robot.dialect).is_none() {
                let known = dialects::DIALECTS.iter().map(|d| d.name()).collect();
                let what = RobotFigureError::Dialect { dialect: robot.dialect, known };
                return Err(RobotError::Figure { file: name.into(), what: Box::new(what) }.into());
            }
            Some(robot)
        }
    })
}

/// Head and clamps of a job.
///
/// # Errors
/// A file cannot be read or has absurd figures.
pub fn load_tool(job: &Job, job_file: Option<&Path>) -> Result<Tool, JobError> {
    let named = Some(&job.beam.head).filter(|f| !f.is_empty());
    let head = named.map(|f| Head::load(&beside(job_file, f))).transpose()?;
    let mut clamps = job.clamps.clone();
    clamps.iter_mut().try_for_each(|c| c.load(job_file.and_then(Path::parent)))?;
    Ok(Tool { head, clamps })
}

/// The cell that a job names, with the frames of its file.
///
/// # Errors
/// The file cannot be read or has absurd figures.
pub fn load_cell(job: &Job, job_file: Option<&Path>) -> Result<Cell, JobError> {
    Ok(match (job.cell.file.as_str(), job.cell.robot.as_str()) {
        ("", "") => Cell::shipped("mz04")?,
        ("", robot) => Cell::shipped(robot)?,
        (file, _) => Cell::load(&beside(job_file, file))?,
    })
}

/// The robot in the cell, with the frames of the job in place of the cell's.
///
/// # Errors
/// The robot cannot stand there.
pub fn set_up(job: &Job, robot: Option<Robot>, mut cell: Cell, mut tool: Tool) -> Result<Setup, JobError> {
    job.cell.put_frames(&mut cell);
    let mount = job.cell.mount.unwrap_or(cell.mount);
    if mount == Mount::ToolInHand {
        // The part stands still in the cell, and what stands beside it is in the way of beam and head.
        let part_from_base = cell.base_from_part.isometry().inverse();
        tool.clamps.extend(cell.bodies.obstacles.iter().map(|o| o.seen_in(&part_from_base)));
    }
    let setup = Setup { cell, robot, mount, tool };
    setup.check()?;
    if mount == Mount::PartInHand {
        clear_of_obstacles(job, &setup)?;
    }
    Ok(setup)
}

/// A laser that stands still is blocked for good by what stands in its way.
fn clear_of_obstacles(job: &Job, setup: &Setup) -> Result<(), JobError> {
    let obstacles = &setup.cell.bodies.obstacles;
    let tool = Tool { head: setup.tool.head.clone(), clamps: obstacles.clone() };
    let (b, nothing) = (&job.beam, Part::default());
    let body = Body::new(&tool, &job.optics, b.spot_mm, b.defocus_mm, b.margin_mm);
    let laser = setup.cell.base_from_laser.isometry();
    let a = laser.rotation * Vector3::z();
    let spot = Point3::from(laser.translation.vector) - a * b.defocus_mm;
    let blocker = Beam::with(&nothing, body.as_ref()).blocker(&spot, &a);
    let Some(Blocker { tool_body, obstruction: Obstruction::Clamp(i), .. }) = blocker else { return Ok(()) };
    let obstacle = obstacles.get(i as usize).map_or_else(String::new, |o| o.file.clone());
    Err(JobError::LaserBlocked { cell: setup.cell.name.clone(), obstacle, by: tool_body })
}

/// A path of a job, seen from the current folder.
pub fn beside(job_file: Option<&Path>, path: &str) -> PathBuf {
    match job_file.and_then(Path::parent) {
        Some(folder) => folder.join(path),
        None => PathBuf::from(path),
    }
}

/// The job with its paths seen from another job file.
///
/// # Errors
/// The folder cannot be found.
pub fn rebased(job: &Job, from: Option<&Path>, to: &Path) -> Result<Job, JobError> {
    with_paths(job, |path| relative(&beside(from, path), to))
}

/// The job with whole paths, for one that has no file to name them from.
///
/// # Errors
/// The current folder cannot be found.
pub(super) fn with_whole_paths(job: &Job) -> Result<Job, JobError> {
    with_paths(job, |path| Ok(whole(Path::new(path))?.display().to_string()))
}

/// The job with every path that it names changed.
fn with_paths(job: &Job, change: impl Fn(&str) -> Result<String, JobError>) -> Result<Job, JobError> {
    let mut job = job.clone();
    let own_robot = !job.cell.robot.is_empty() && !Robot::is_shipped(&job.cell.robot);
    let robot = own_robot.then_some(&mut job.cell.robot);
    let clamps = job.clamps.iter_mut().map(|c| &mut c.file);
    let files = [&mut job.part.file, &mut job.cell.file, &mut job.beam.head];
    for path in files.into_iter().chain(robot).chain(clamps) {
        if !path.is_empty() {
            *path = change(path)?;
        }
    }
    Ok(job)
}

/// A path from the root, without `.` and `..`.
///
/// # Errors
/// The current folder cannot be found.
pub(super) fn whole(path: &Path) -> Result<PathBuf, JobError> {
    std::path::absolute(path).map(|p| tidy(&p)).map_err(|e| JobError::write(path, &e))
}

/// Path of `file` as seen from the folder of `job_file`, with '/' on every system.
fn relative(file: &Path, job_file: &Path) -> Result<String, JobError> {
    let (file, job_file) = (whole(file)?, whole(job_file)?);
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
fn tidy(path: &Path) -> PathBuf {
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

/// Writes a file whole or not at all.
///
/// # Errors
/// What could not be written, and why.
pub fn write_atomic(path: &Path, bytes: &[u8]) -> Result<(), JobError> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let attempt = || -> std::io::Result<()> {
        let mut file = tempfile::Builder::new().prefix(".clearbeam-").tempfile_in(folder)?;
        file.write_all(bytes)?;
        file.as_file().sync_all()?;
        #[cfg(unix)]
        {
            // Temporary files are private; what an operator exports is not.
            use std::os::unix::fs::PermissionsExt as _;
            file.as_file().set_permissions(std::fs::Permissions::from_mode(0o644))?;
        }
        file.persist(path).map_err(|e| e.error)?;
        Ok(())
    };
    attempt().map_err(|e| JobError::write(path, &e))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_follow_the_job() {
        let job = Job {
            part: crate::document::model::PartFile { file: "../parts/a.stl".into(), ..Default::default() },
            ..Job::default()
        };
        let moved = rebased(&job, Some(Path::new("/x/jobs/a.toml")), Path::new("/x/out/b/job.toml")).expect("rebases");
        assert_eq!(moved.part.file, "../../parts/a.stl");
    }

    #[test]
    fn an_unwritable_folder_is_named() {
        let said = write_atomic(Path::new("/proc/none/x"), b"x").expect_err("refused").to_string();
        assert!(said.contains("/proc/none/x") && said.contains("choose another folder"), "{said}");
    }
}
