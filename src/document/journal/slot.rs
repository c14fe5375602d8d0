//! A place in the journal's folder: `NUMBER.lock`, held as long as its owner lives, and `NUMBER.toml`,
//! the state. Knows nothing of what a state says.
//!
//! Locks belong to open files, not to process numbers, which are given again. Lock files stay: to
//! remove one would let two owners lock two files of one name. Slots are used again, so there are no
//! more of them than there have ever been windows and states at once.

use super::error::JournalError;
use std::ffi::OsStr;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// A slot that is owned here.
#[derive(Debug)]
pub(super) struct JournalSlot {
    folder: PathBuf,
    number: u32,
    /// Unlocked when it is closed.
    _lock: File,
}

impl JournalSlot {
    /// Takes the first slot that nobody owns and that has no state, in a folder, which is made.
    pub(super) fn take_free(folder: &Path) -> Result<JournalSlot, JournalError> {
        std::fs::create_dir_all(folder)
            .map_err(|source| JournalError::Folder { folder: folder.to_path_buf(), source })?;
        let mut number = 0;
        loop {
            number += 1;
            let state = state_file(folder, number);
            // Looked at before, so that a leftover is not locked while another window looks for it; and
            // again under the lock, where nobody else can make one.
            if !state.exists()
                && let Some(slot) = JournalSlot::take(folder, number)?
                && !state.exists()
            {
                return Ok(slot);
            }
        }
    }

    /// Takes a slot by its number; `None` where somebody owns it already.
    pub(super) fn take(folder: &Path, number: u32) -> Result<Option<JournalSlot>, JournalError> {
        let unusable = |source| JournalError::Folder { folder: folder.to_path_buf(), source };
        let file = folder.join(format!("{number}.lock"));
        let lock = OpenOptions::new().create(true).truncate(false).write(true).open(file).map_err(unusable)?;
        match lock.try_lock() {
            Ok(()) => Ok(Some(JournalSlot { folder: folder.to_path_buf(), number, _lock: lock })),
            Err(TryLockError::WouldBlock) => Ok(None),
            Err(TryLockError::Error(source)) => Err(unusable(source)),
        }
    }

    /// Numbers of the slots that have a state, least first.
    pub(super) fn with_state(folder: &Path) -> Result<Vec<u32>, JournalError> {
        let unusable = |source| JournalError::Folder { folder: folder.to_path_buf(), source };
        let entries = match std::fs::read_dir(folder) {
            Err(e) if e.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
            entries => entries.map_err(unusable)?,
        };
        let files = entries.map(|e| e.map(|e| PathBuf::from(e.file_name()))).collect::<Result<Vec<_>, _>>();
        let number =
            |f: &PathBuf| (f.extension()? == OsStr::new("toml")).then(|| f.file_stem()?.to_str()?.parse().ok());
        let mut numbers: Vec<u32> = files.map_err(unusable)?.iter().filter_map(number).flatten().collect();
        numbers.sort_unstable();
        Ok(numbers)
    }

    /// Where its state is.
    pub(super) fn state_file(&self) -> PathBuf {
        state_file(&self.folder, self.number)
    }

    /// Bytes of its state; `None` where there is none.
    pub(super) fn read(&self) -> std::io::Result<Option<Vec<u8>>> {
        match std::fs::read(self.state_file()) {
            Err(e) if e.kind() == ErrorKind::NotFound => Ok(None),
            read => read.map(Some),
        }
    }

    /// Replaces its state: whoever looks sees the old one or the new one.
    pub(super) fn write(&self, text: &str) -> Result<(), JournalError> {
        let (file, new) = (self.state_file(), self.folder.join(format!("{}.new", self.number)));
        let attempt = || {
            // The folder may have been swept away while the window was open.
            if !self.folder.is_dir() {
                std::fs::create_dir_all(&self.folder)?;
            }
            std::fs::write(&new, text)?;
            std::fs::rename(&new, &file)
        };
        attempt().map_err(|source| JournalError::Write { file: file.clone(), source })
    }

    /// Removes its state.
    pub(super) fn clear(&self) -> Result<(), JournalError> {
        match std::fs::remove_file(self.state_file()) {
            Err(source) if source.kind() != ErrorKind::NotFound => {
                Err(JournalError::Write { file: self.state_file(), source })
            }
            _ => Ok(()),
        }
    }
}

fn state_file(folder: &Path, number: u32) -> PathBuf {
    folder.join(format!("{number}.toml"))
}
