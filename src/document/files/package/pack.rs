//! Packs a job: the same files give the same bytes.

use super::super::error::JobError;
use super::super::paths::{absolute, resolved, with_paths};
use super::super::setup::{load_cell, load_robot};
use super::unpack::is_within;
use super::{ABOUT, AboutPackage, FILES, JOB, PackageError, SCHEMA, THUMBNAIL};
use crate::cell::Robot;
use crate::document::model::Job;
use crate::file::bytes;
use std::io::{Cursor, Write as _};
use std::path::{Path, PathBuf};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// A job in `job_file` with all files that it names, as the bytes of a package; `thumbnail`: a PNG file of it.
///
/// # Errors
/// A file cannot be read, or names another one that does not lie beside it or below.
pub fn pack(job: &Job, job_file: Option<&Path>, thumbnail: Option<&[u8]>) -> Result<Vec<u8>, JobError> {
    let mut gathered = Gathered::default();
    let packed = with_paths(job, |named| gathered.take(&resolved(job_file, named)))?;
    for (of, named) in named_by_files(job, job_file)? {
        gathered.take_beside(&of, &named)?;
    }
    let about = toml::to_string(&AboutPackage { schema: SCHEMA }).map_err(JobError::Unwritable)?;
    let mut archive = Archive::default();
    archive.add(ABOUT, about.as_bytes())?;
    archive.add(JOB, super::super::to_toml(&packed)?.as_bytes())?;
    for (entry, file) in &gathered.entries {
        archive.add(entry, &bytes(file)?)?;
    }
    if let Some(png) = thumbnail {
        archive.add(THUMBNAIL, png)?;
    }
    archive.finished()
}

/// Obstacles that the cell's file names, and bodies of links that the robot's does, each with the file that names it.
fn named_by_files(job: &Job, job_file: Option<&Path>) -> Result<Vec<(PathBuf, String)>, JobError> {
    let mut out = Vec::new();
    if !job.cell.file.is_empty() {
        let cell = resolved(job_file, &job.cell.file);
        let obstacles = load_cell(job, job_file)?.bodies.obstacles;
        out.extend(obstacles.into_iter().map(|o| (cell.clone(), o.file)));
    }
    if !job.cell.robot.is_empty() && !Robot::is_shipped(&job.cell.robot) {
        let file = resolved(job_file, &job.cell.robot);
        let robot = load_robot(job, job_file)?;
        let meshes = robot.iter().flat_map(|r| r.links.meshes.bodies());
        out.extend(meshes.map(|(_, _, mesh)| (file.clone(), mesh.file.clone())));
    }
    Ok(out)
}

/// Files on their way into a package, by their entries.
#[derive(Default)]
struct Gathered {
    entries: Vec<(String, PathBuf)>,
}

impl Gathered {
    /// Takes a file into a folder of its own; what it is called in the package. One that is named twice is in it once.
    fn take(&mut self, file: &Path) -> Result<String, JobError> {
        let file = absolute(file)?;
        if let Some((entry, _)) = self.entries.iter().find(|(_, known)| *known == file) {
            return Ok(entry.clone());
        }
        let name = file.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let entry = format!("{FILES}/{}/{name}", self.entries.len() + 1);
        self.entries.push((entry.clone(), file));
        Ok(entry)
    }

    /// Takes a file that another one of the package names, to where that one looks for it.
    fn take_beside(&mut self, of: &Path, named: &str) -> Result<(), JobError> {
        let of = absolute(of)?;
        let named = named.replace('\\', "/");
        let folder = self.entries.iter().find(|(_, known)| *known == of).and_then(|(entry, _)| entry.rsplit_once('/'));
        let entry = folder.map(|(folder, _)| format!("{folder}/{named}")).filter(|_| is_within(&named));
        let Some(entry) = entry else {
            let what = PackageError::Outside { of: of.display().to_string(), file: named };
            return Err(JobError::Package { file: of.display().to_string(), what });
        };
        if self.entries.iter().all(|(known, _)| *known != entry) {
            self.entries.push((entry, resolved(Some(&of), &named)));
        }
        Ok(())
    }
}

/// The archive that is being written.
struct Archive(ZipWriter<Cursor<Vec<u8>>>);

impl Default for Archive {
    fn default() -> Archive {
        Archive(ZipWriter::new(Cursor::new(Vec::new())))
    }
}

impl Archive {
    fn add(&mut self, entry: &str, bytes: &[u8]) -> Result<(), JobError> {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            // No clock: the same files are the same package.
            .last_modified_time(DateTime::default())
            .unix_permissions(0o644)
            .large_file(bytes.len() as u64 >= u64::from(u32::MAX));
        let written = self.0.start_file(entry, options).map_err(|e| e.to_string());
        written.and_then(|()| self.0.write_all(bytes).map_err(|e| e.to_string())).map_err(unwritable)
    }

    fn finished(self) -> Result<Vec<u8>, JobError> {
        self.0.finish().map(Cursor::into_inner).map_err(|e| unwritable(e.to_string()))
    }
}

fn unwritable(reason: String) -> JobError {
    JobError::Package { file: JOB.into(), what: PackageError::Unwritable { reason } }
}
