//! What a folder holds, as a dialog lists it.

use std::path::{Path, PathBuf};

/// A row of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Entry {
    /// Its name within the folder.
    pub name: String,
    /// Whether it is a folder.
    pub is_folder: bool,
    /// Size of a file, bytes.
    pub bytes: u64,
}

/// Everything in a folder that is not hidden: folders first, both by name without regard to case.
///
/// # Errors
/// The system's words where it cannot be read.
pub(super) fn entries(folder: &Path) -> Result<Vec<Entry>, String> {
    let mut out = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(|e| e.to_string())? {
        // One that is gone by now is left out.
        let Ok(entry) = entry else { continue };
        let name = entry.file_name().to_string_lossy().into_owned();
        // Links are followed.
        let Ok(data) = std::fs::metadata(entry.path()) else { continue };
        if !name.starts_with('.') {
            out.push(Entry { name, is_folder: data.is_dir(), bytes: data.len() });
        }
    }
    out.sort_by_key(|e| (!e.is_folder, e.name.to_lowercase(), e.name.clone()));
    Ok(out)
}

/// The user's own folder.
pub(super) fn home() -> Option<PathBuf> {
    let name = if cfg!(windows) { "USERPROFILE" } else { "HOME" };
    std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_dir())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_come_first_and_hidden_files_not_at_all() {
        let dir = tempfile::tempdir().expect("a folder");
        for name in ["b.stl", "A.stl", ".hidden"] {
            std::fs::write(dir.path().join(name), "x").expect("writes");
        }
        for name in ["z", "Y"] {
            std::fs::create_dir(dir.path().join(name)).expect("made");
        }
        let found = entries(dir.path()).expect("read");
        let names: Vec<_> = found.iter().map(|e| (e.name.as_str(), e.is_folder)).collect();
        assert_eq!(names, [("Y", true), ("z", true), ("A.stl", false), ("b.stl", false)]);
        assert_eq!(found[3].bytes, 1);
        assert!(entries(&dir.path().join("gone")).is_err());
    }
}
