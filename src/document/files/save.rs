//! Opening and saving a job: whole or not at all, never in silence over what somebody else has saved, and with the
//! save before kept beside it. Every save of a document comes through [`save`].

use super::atomic::write_atomic;
use super::error::JobError;
use super::paths::{absolute, rebased};
use crate::document::job_file;
use crate::document::model::Job;
use crate::file;
use crate::part::digest_of;
use serde::{Deserialize, Serialize};
use std::ffi::OsString;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Where a job is kept, and what that file held when it was last read or written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct JobFile {
    /// The file.
    pub path: PathBuf,
    /// SHA-256 of its bytes at that time, hexadecimal.
    pub sha256: String,
}

/// How a document's file is now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileState {
    /// As it was when it was last read or written here.
    AsOpened,
    /// It holds something else, or cannot be read: another window, or another program.
    Changed,
    /// It is not there any more.
    Gone,
    /// The job has no file yet.
    New,
}

/// What a save does where its file has changed since it was last read or written here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IfChanged {
    /// It is refused, and the operator asked.
    Refuse,
    /// What stands there becomes the backup.
    Overwrite,
}

impl JobFile {
    /// How the file is now.
    pub fn state(&self) -> FileState {
        match std::fs::read(&self.path) {
            Ok(bytes) if digest_of(&bytes) == self.sha256 => FileState::AsOpened,
            Err(e) if e.kind() == ErrorKind::NotFound => FileState::Gone,
            Ok(_) | Err(_) => FileState::Changed,
        }
    }
}

/// Reads a job file, and remembers what it held.
///
/// # Errors
/// It cannot be read, or is no job (with line and column).
pub fn open(path: &Path) -> Result<(Job, JobFile), JobError> {
    let bytes = file::bytes(path)?;
    let no_job = |e| JobError::NoJob { file: path.display().to_string(), source: Box::new(e) };
    let job = job_file::from_bytes(&bytes).map_err(no_job)?;
    Ok((job, JobFile { path: path.to_path_buf(), sha256: digest_of(&bytes) }))
}

/// Reads a job file.
///
/// # Errors
/// It cannot be read, or is no job (with line and column).
pub fn read(file: &Path) -> Result<Job, JobError> {
    open(file).map(|(job, _)| job)
}

/// Whether a path names a job rather than a part.
pub fn is_job(path: &Path) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml") || e.eq_ignore_ascii_case("clearbeam"))
}

/// The job as text.
///
/// # Errors
/// Never, for jobs made here.
pub fn to_toml(job: &Job) -> Result<String, JobError> {
    toml::to_string(job).map_err(JobError::Unwritable)
}

/// Writes a job into a file; the job as its file has it, with paths seen from there. What stood there
/// before becomes the backup. Where that is the same to the byte, nothing is written.
///
/// The look at the file and the write are two steps: a save by another window that falls within the
/// milliseconds between them is not noticed.
///
/// # Errors
/// [`JobError::ChangedOnDisk`]; what else could not be written, and why.
pub fn save(job: &Job, from: Option<&JobFile>, to: &Path, if_changed: IfChanged) -> Result<(Job, JobFile), JobError> {
    let job = rebased(job, from.map(|f| f.path.as_path()), to)?;
    let text = to_toml(&job)?;
    if let Some(opened) = from.filter(|f| is_same_file(&f.path, to))
        && if_changed == IfChanged::Refuse
        && opened.state() == FileState::Changed
    {
        return Err(JobError::ChangedOnDisk { file: to.display().to_string() });
    }
    let before = std::fs::read(to).ok();
    if before.as_deref() != Some(text.as_bytes()) {
        if let Some(before) = before {
            write_atomic(&backup_of(to), &before)?;
        }
        write_atomic(to, text.as_bytes())?;
    }
    Ok((job, JobFile { path: to.to_path_buf(), sha256: digest_of(text.as_bytes()) }))
}

/// The file that holds the save before: `NAME.toml.bak` beside `NAME.toml`.
pub fn backup_of(file: &Path) -> PathBuf {
    let mut name: OsString = file.into();
    name.push(".bak");
    name.into()
}

/// Whether two paths lead to one file.
fn is_same_file(a: &Path, b: &Path) -> bool {
    let real = |p: &Path| std::fs::canonicalize(p).ok().or_else(|| absolute(p).ok());
    real(a) == real(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn worth(spacing_mm: f64) -> Job {
        let mut job = Job::default();
        job.layers.spacing_mm = spacing_mm;
        job
    }

    #[test]
    fn the_save_before_is_kept_and_an_empty_save_does_not_push_it_out() {
        let folder = tempfile::tempdir().expect("a folder");
        let to = folder.path().join("a.toml");
        let (_, first) = save(&worth(1.0), None, &to, IfChanged::Refuse).expect("saves");
        assert!(!backup_of(&to).exists(), "there was nothing before");
        let (_, second) = save(&worth(2.0), Some(&first), &to, IfChanged::Refuse).expect("saves");
        let (_, third) = save(&worth(2.0), Some(&second), &to, IfChanged::Refuse).expect("saves");
        assert_eq!(second, third);
        assert_eq!(read(&to).expect("reads"), worth(2.0));
        assert_eq!(read(&folder.path().join("a.toml.bak")).expect("reads"), worth(1.0));
    }

    #[test]
    fn the_last_save_does_not_win_in_silence() {
        let folder = tempfile::tempdir().expect("a folder");
        let to = folder.path().join("a.toml");
        save(&worth(1.0), None, &to, IfChanged::Refuse).expect("saves");
        let (_, one) = open(&to).expect("opens");
        let (_, other) = open(&to).expect("opens");
        save(&worth(2.0), Some(&one), &to, IfChanged::Refuse).expect("saves");
        assert_eq!((one.state(), other.state()), (FileState::Changed, FileState::Changed));
        let kept = std::fs::read(&to).expect("reads");
        let beside = folder.path().join("sub/../a.toml");
        std::fs::create_dir(folder.path().join("sub")).expect("makes");
        for same in [&to, &beside] {
            let refused = save(&worth(3.0), Some(&other), same, IfChanged::Refuse).expect_err("another has saved");
            assert!(matches!(refused, JobError::ChangedOnDisk { .. }), "{refused:?}");
        }
        assert_eq!(std::fs::read(&to).expect("reads"), kept);
        assert_eq!(read(&backup_of(&to)).expect("reads"), worth(1.0), "a refused save touches no backup");
        let (_, told) = save(&worth(3.0), Some(&other), &to, IfChanged::Overwrite).expect("saves");
        assert_eq!((told.state(), std::fs::read(backup_of(&to)).expect("reads")), (FileState::AsOpened, kept));
    }

    #[test]
    fn a_file_that_is_gone_is_written_again() {
        let folder = tempfile::tempdir().expect("a folder");
        let to = folder.path().join("a.toml");
        let (_, file) = save(&worth(1.0), None, &to, IfChanged::Refuse).expect("saves");
        std::fs::remove_file(&to).expect("removes");
        assert_eq!(file.state(), FileState::Gone);
        let (_, again) = save(&worth(1.0), Some(&file), &to, IfChanged::Refuse).expect("saves");
        assert_eq!((again.state(), again), (FileState::AsOpened, file));
    }
}
