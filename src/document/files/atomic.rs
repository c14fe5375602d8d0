//! Files that are written whole or not at all.

use super::error::JobError;
use std::io::Write as _;
use std::path::Path;

/// Writes a file whole or not at all.
///
/// # Errors
/// The folder or the file cannot be written.
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
    attempt().map_err(|e| JobError::write(path, e))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unwritable_folder_is_named() {
        let path = Path::new("/proc/none/x");
        let refused = write_atomic(path, b"x").expect_err("refused");
        assert!(matches!(&refused, JobError::Write { file, .. } if file == path), "{refused:?}");
    }
}
