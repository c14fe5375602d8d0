//! The folder that an export goes into: what stands there, and the single changes that an export is made of. Which
//! changes, and in what order, is `commit`'s.

use super::error::ExportError;
use crate::document::files::JobError;
use crate::file::FileError;
use crate::part::digest_of;
use std::fs::{self, File, TryLockError};
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};

/// What an export intends to do, while it is doing it.
pub(super) const INTENT: &str = ".clearbeam-export.json";
/// New files have this before their names until they are put in place.
const STAGED: &str = ".clearbeam-export-";

/// A folder that one export has for itself.
pub(super) struct ExportFolder {
    path: PathBuf,
    /// Holds the lock; not every system opens folders.
    handle: Option<File>,
}

/// What stands under a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum FolderEntry {
    /// Nothing.
    Nothing,
    /// A file with this SHA-256.
    File(String),
    /// A folder, which no file can replace.
    Folder,
}

fn staged(name: &str) -> String {
    format!("{STAGED}{name}")
}

impl ExportFolder {
    /// Takes hold of a folder that is there.
    ///
    /// # Errors
    /// [`ExportError::Busy`] while another export has it.
    pub(super) fn open(path: &Path) -> Result<ExportFolder, ExportError> {
        let handle = File::open(path).ok();
        // A file system that knows no locks has none to respect.
        if let Some(Err(TryLockError::WouldBlock)) = handle.as_ref().map(File::try_lock) {
            return Err(ExportError::Busy { dir: path.to_path_buf() });
        }
        Ok(ExportFolder { path: path.to_path_buf(), handle })
    }

    /// A folder that is only looked into.
    pub(super) fn unlocked(path: &Path) -> ExportFolder {
        ExportFolder { path: path.to_path_buf(), handle: None }
    }

    /// Its path.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// What stands under a name.
    ///
    /// # Errors
    /// It is there and cannot be read.
    pub(super) fn entry(&self, name: &str) -> Result<FolderEntry, JobError> {
        match fs::symlink_metadata(self.path.join(name)) {
            Err(e) if e.kind() == ErrorKind::NotFound => return Ok(FolderEntry::Nothing),
            Ok(m) if m.is_dir() => return Ok(FolderEntry::Folder),
            _ => {}
        }
        // A link that leads nowhere stands there, and is no file that was written.
        Ok(FolderEntry::File(self.read(name)?.map_or(String::new(), |bytes| digest_of(&bytes))))
    }

    /// What is staged for a name.
    ///
    /// # Errors
    /// It is there and cannot be read.
    pub(super) fn staged_entry(&self, name: &str) -> Result<FolderEntry, JobError> {
        self.entry(&staged(name))
    }

    /// Bytes of a file; `None`: it is not there.
    ///
    /// # Errors
    /// It is there and cannot be read.
    pub(super) fn read(&self, name: &str) -> Result<Option<Vec<u8>>, JobError> {
        let file = self.path.join(name);
        match fs::read(&file) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(e) if e.kind() == ErrorKind::NotFound => Ok(None),
            Err(source) => Err(FileError::Read { file: file.display().to_string(), source }.into()),
        }
    }

    /// Names that something is staged for, in order.
    ///
    /// # Errors
    /// The folder cannot be read.
    pub(super) fn all_staged(&self) -> Result<Vec<String>, JobError> {
        let failed = |source| FileError::Read { file: self.path.display().to_string(), source };
        let mut out = Vec::new();
        for entry in fs::read_dir(&self.path).map_err(failed)? {
            let name = entry.map_err(failed)?.file_name();
            out.extend(name.to_str().and_then(|n| n.strip_prefix(STAGED)).map(str::to_owned));
        }
        out.sort();
        Ok(out)
    }

    /// Writes a file under its staged name, through to the disk.
    ///
    /// # Errors
    /// It cannot be written.
    pub(super) fn stage(&self, name: &str, bytes: &[u8]) -> Result<(), JobError> {
        let attempt = || -> std::io::Result<()> {
            let mut file = File::create(self.path.join(staged(name)))?;
            file.write_all(bytes)?;
            file.sync_all()
        };
        attempt().map_err(|e| JobError::write(&self.path.join(name), e))
    }

    /// Puts what is staged for a name in its place, over what stands there.
    ///
    /// # Errors
    /// It cannot be written.
    pub(super) fn place(&self, name: &str) -> Result<(), JobError> {
        let to = self.path.join(name);
        fs::rename(self.path.join(staged(name)), &to).map_err(|e| JobError::write(&to, e))
    }

    /// Removes a file, if it is there.
    ///
    /// # Errors
    /// It cannot be removed.
    pub(super) fn remove(&self, name: &str) -> Result<(), JobError> {
        let file = self.path.join(name);
        match fs::remove_file(&file) {
            Err(source) if source.kind() != ErrorKind::NotFound => Err(JobError::Remove { file, source }),
            _ => Ok(()),
        }
    }

    /// Removes what is staged for a name, if there is anything.
    ///
    /// # Errors
    /// It cannot be removed.
    pub(super) fn unstage(&self, name: &str) -> Result<(), JobError> {
        self.remove(&staged(name))
    }

    /// What was renamed and removed so far is on the disk before what follows, where the system can promise it.
    pub(super) fn sync(&self) {
        if let Some(handle) = &self.handle {
            let _ = handle.sync_all();
        }
    }
}
