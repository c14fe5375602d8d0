//! The part of a job: where its file is, whether it is still the one that the job was made for, and the part built
//! from it.

use super::error::JobError;
use super::part_source::read_source;
use super::paths::resolved;
use crate::document::model::{Job, JobPart};
use crate::part::{LoadError, Part, Source};
use crate::progress::Progress;
use std::path::{Path, PathBuf};

/// Where the part of a job is: where the job says, or in the folder of the job under the name that it has there.
///
/// # Errors
/// It is at neither place.
pub fn part_file(job: &Job, job_file: Option<&Path>) -> Result<PathBuf, JobError> {
    let named = resolved(job_file, &job.part.file);
    let near = named.file_name().zip(job_file.and_then(Path::parent)).map(|(name, folder)| folder.join(name));
    let name = || named.display().to_string();
    let found = [Some(&named), near.as_ref()].into_iter().flatten().find(|f| f.is_file());
    match found {
        Some(file) => Ok(file.clone()),
        None if named.is_dir() => Err(LoadError::Folder { file: name() }.into()),
        None => Err(JobError::PartGone { file: name() }),
    }
}

/// Reads the part's file of a job and checks that it is still the one the job was made for.
///
/// # Errors
/// Gone, changed, or no usable part.
pub fn read_part(job: &Job, job_file: Option<&Path>) -> Result<Source, JobError> {
    read_unchanged(job, job_file, &part_file(job, job_file)?)
}

fn read_unchanged(job: &Job, job_file: Option<&Path>, file: &Path) -> Result<Source, JobError> {
    let camera = job.depth_camera(job_file);
    // Nobody can have cancelled it.
    let source = read_source(file, camera.as_deref(), &Progress::default())?.unwrap_or_default();
    if job.part.is_of_another_file(&source.sha256) {
        return Err(JobError::PartChanged { file: file.display().to_string() });
    }
    Ok(source)
}

/// The part of a job as it stands.
///
/// # Errors
/// Gone, changed, or no usable part.
pub fn load_part(job: &Job, job_file: Option<&Path>) -> Result<Part, JobError> {
    let file = part_file(job, job_file)?;
    let built = build_part(&read_unchanged(job, job_file, &file)?, &job.part, &file, &Progress::default())?;
    // Nobody can have cancelled it.
    Ok(built.unwrap_or_default())
}

/// Welds, places and orients a part as a job says, from what was read of `file`. `None`: the work was cancelled.
///
/// # Errors
/// No facet has any area.
pub fn build_part(
    source: &Source,
    part: &JobPart,
    file: &Path,
    progress: &Progress,
) -> Result<Option<Part>, LoadError> {
    let built = source.part(part.units, part.weld, &part.placement, &part.flipped_shells, progress);
    built.map_err(|source| LoadError::Unusable { file: file.display().to_string(), source })
}
