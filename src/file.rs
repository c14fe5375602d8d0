//! Files that people write, TOML above all: read whole, or refused with the file's name.
//!
//! What the figures in them may be is for the room to check that knows what they mean.

use serde::de::DeserializeOwned;
use std::path::Path;
use std::str::Utf8Error;
use thiserror::Error;

/// Why a file cannot be read.
#[derive(Debug, Error)]
pub enum FileError {
    /// It cannot be read.
    #[error("{file}: not read")]
    Read {
        /// The file.
        file: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// Its bytes are no text.
    #[error("{file}: not UTF-8")]
    NoText {
        /// The file.
        file: String,
        /// The first byte that is none.
        source: Utf8Error,
    },
    /// It is no TOML, or has a key or a value that does not belong there, or lacks one.
    #[error("{file}: not parsed")]
    Toml {
        /// The file.
        file: String,
        /// Where and what.
        source: Box<::toml::de::Error>,
    },
}

/// The bytes of a file.
///
/// # Errors
/// [`FileError::Read`].
pub fn bytes(path: &Path) -> Result<Vec<u8>, FileError> {
    std::fs::read(path).map_err(|source| FileError::Read { file: path.display().to_string(), source })
}

/// The text of a file's bytes; `file` is what the file is called.
///
/// # Errors
/// [`FileError::NoText`].
pub fn text<'b>(bytes: &'b [u8], file: &str) -> Result<&'b str, FileError> {
    std::str::from_utf8(bytes).map_err(|source| FileError::NoText { file: file.to_owned(), source })
}

/// What the text of a TOML file says; `file` is what its file is called.
///
/// # Errors
/// [`FileError::Toml`].
pub fn toml<T: DeserializeOwned>(text: &str, file: &str) -> Result<T, FileError> {
    ::toml::from_str(text).map_err(|e| FileError::Toml { file: file.to_owned(), source: Box::new(e) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_refused_by_its_name() {
        let gone = bytes(Path::new("/none/cell.toml")).expect_err("there is none");
        assert!(matches!(&gone, FileError::Read { file, .. } if file == "/none/cell.toml"), "{gone}");
        let binary = text(b"name = \"\xff\"", "cell.toml").expect_err("no text");
        assert!(matches!(binary, FileError::NoText { source, .. } if source.valid_up_to() == 8));
        let torn = toml::<::toml::Table>("name = ", "cell.toml").expect_err("no TOML");
        assert!(matches!(torn, FileError::Toml { file, .. } if file == "cell.toml"));
    }
}
