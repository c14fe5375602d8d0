//! Unpacks a package into a folder, whole or not at all.

use super::super::atomic::write_atomic;
use super::super::error::JobError;
use super::{ABOUT, AboutPackage, ENDING, JOB, PackageError, SCHEMA};
use crate::file::bytes;
use std::io::{Cursor, Read as _};
use std::path::{Path, PathBuf};
use zip::ZipArchive;

/// So much may be unpacked, MiB: a job with a dozen of the largest scans.
const MOST_MIB: u64 = 8192;

/// Whether a file is a package, by its ending and its first bytes: a job may be kept under that ending as it is.
pub fn is_package(file: &Path) -> bool {
    let begins = || {
        let mut first = [0; 4];
        std::fs::File::open(file).and_then(|mut f| f.read_exact(&mut first)).is_ok_and(|()| first == *b"PK\x03\x04")
    };
    file.extension().is_some_and(|e| e.eq_ignore_ascii_case(ENDING)) && begins()
}

/// The job in a package, which is unpacked into `NAME_files` within a folder; any other file as it is.
///
/// # Errors
/// As [`unpack`].
pub fn unpacked(file: &Path, within: &Path) -> Result<PathBuf, JobError> {
    if is_package(file) { unpack(file, &unpacked_in(within, file)) } else { Ok(file.to_path_buf()) }
}

/// The folder that a package is unpacked into, within another one: `NAME_files`.
pub fn unpacked_in(folder: &Path, package: &Path) -> PathBuf {
    folder.join(format!("{}_files", stem(package)))
}

fn stem(package: &Path) -> String {
    package.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// Unpacks a package into a folder, and gives its job's file, which is called as the package is. A folder that holds
/// just that already is left as it is.
///
/// # Errors
/// The package cannot be read, the folder holds something else, or cannot be written.
pub fn unpack(package: &Path, folder: &Path) -> Result<PathBuf, JobError> {
    let refused = |what| JobError::Package { file: package.display().to_string(), what };
    let job_name = format!("{}.toml", stem(package));
    let mut entries = entries(&bytes(package)?).map_err(refused)?;
    for (name, _) in &mut entries {
        if name == JOB {
            name.clone_from(&job_name);
        }
    }
    if folder.exists() {
        let differs =
            |(name, bytes): &&(String, Vec<u8>)| std::fs::read(folder.join(name)).ok().as_ref() != Some(bytes);
        if let Some((name, _)) = entries.iter().find(differs) {
            return Err(refused(PackageError::Occupied { folder: folder.to_path_buf(), file: name.clone() }));
        }
    } else {
        written(&entries, folder)?;
    }
    Ok(folder.join(job_name))
}

/// Writes all files into a new folder, which appears when it is whole.
fn written(entries: &[(String, Vec<u8>)], folder: &Path) -> Result<(), JobError> {
    let failed = |e| JobError::write(folder, e);
    let parent = folder.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    std::fs::create_dir_all(parent).map_err(failed)?;
    let new = tempfile::Builder::new().prefix(".clearbeam-").tempdir_in(parent).map_err(failed)?;
    for (name, bytes) in entries {
        let file = new.path().join(name);
        let within = file.parent().unwrap_or(new.path());
        std::fs::create_dir_all(within).map_err(|e| JobError::write(within, e))?;
        write_atomic(&file, bytes)?;
    }
    #[cfg(unix)]
    {
        // Temporary folders are private; what an operator unpacks is not.
        use std::os::unix::fs::PermissionsExt as _;
        std::fs::set_permissions(new.path(), std::fs::Permissions::from_mode(0o755)).map_err(failed)?;
    }
    std::fs::rename(new.path(), folder).map_err(failed)
}

/// All files of a package by their names, but for what it says of itself.
fn entries(package: &[u8]) -> Result<Vec<(String, Vec<u8>)>, PackageError> {
    let mut archive = ZipArchive::new(Cursor::new(package)).map_err(|_| PackageError::Archive)?;
    let mut left = MOST_MIB << 20;
    let (mut out, mut about) = (Vec::new(), None);
    for i in 0..archive.len() {
        let entry = archive.by_index(i).map_err(|_| PackageError::Archive)?;
        if entry.is_dir() {
            continue;
        }
        let name = entry.name().map_err(|_| PackageError::Archive)?.into_owned();
        if !is_within(&name) {
            return Err(PackageError::Name { name });
        }
        let mut bytes = Vec::new();
        entry.take(left + 1).read_to_end(&mut bytes).map_err(|_| PackageError::Archive)?;
        left = left.checked_sub(bytes.len() as u64).ok_or(PackageError::TooLarge { most_mib: MOST_MIB })?;
        if name == ABOUT {
            about = std::str::from_utf8(&bytes).ok().and_then(|text| toml::from_str::<AboutPackage>(text).ok());
        } else {
            out.push((name, bytes));
        }
    }
    match about {
        Some(AboutPackage { schema }) if schema > SCHEMA => Err(PackageError::Later { schema }),
        Some(_) if out.iter().any(|(name, _)| name == JOB) => Ok(out),
        _ => Err(PackageError::NoJob),
    }
}

/// Whether a name stays within the folder that it is looked for in, on every system.
pub(super) fn is_within(name: &str) -> bool {
    let is_plain = |piece: &str| !piece.is_empty() && piece != "." && piece != "..";
    name.split('/').all(is_plain) && !name.contains(['\\', ':', '\0'])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stay_within_the_folder() {
        assert!(["job.toml", "files/1/a b.stl", "files/1/x/ä..stl"].into_iter().all(is_within));
        let outside = ["", "/a", "a/", "../a", "a/../b", "a//b", "./a", "c:\\a", "a\\b", "a\0"];
        assert!(!outside.into_iter().any(is_within));
    }
}
