//! Files that people write, TOML above all: read whole, or refused with the file's name and the line.
//!
//! What the figures in them may be is for the room to check that knows what they mean; that they are figures, and
//! not infinite, is checked here for all.

mod encoding;
mod key_lines;
mod toml_text;

pub use encoding::NoText;
pub use key_lines::{Step, line_of, way_of};
pub use toml_text::{TomlError, TomlFault, one_line, read as read_toml};

use serde::de::DeserializeOwned;
use std::path::Path;
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
    #[error("{file}: {source}")]
    NoText {
        /// The file.
        file: String,
        /// What they are, as far as can be told.
        source: NoText,
    },
    /// It is no TOML, or has a key or a value that does not belong there, or lacks one.
    #[error("{file}: {source}")]
    Toml {
        /// The file.
        file: String,
        /// Where and what.
        source: Box<TomlError>,
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
    encoding::decode(bytes).map_err(|source| FileError::NoText { file: file.to_owned(), source })
}

/// The text of bytes that may have no file.
///
/// # Errors
/// They are no UTF-8.
pub fn decode(bytes: &[u8]) -> Result<&str, NoText> {
    encoding::decode(bytes)
}

/// What the text of a TOML file says; `file` is what its file is called.
///
/// # Errors
/// [`FileError::Toml`].
pub fn toml<T: DeserializeOwned>(text: &str, file: &str) -> Result<T, FileError> {
    read_toml(text).map_err(|e| FileError::Toml { file: file.to_owned(), source: Box::new(e) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_refused_by_its_name() {
        let gone = bytes(Path::new("/none/cell.toml")).expect_err("there is none");
        assert!(matches!(&gone, FileError::Read { file, .. } if file == "/none/cell.toml"), "{gone}");
        let binary = text(b"name = \"\xff\"", "cell.toml").expect_err("no text");
        assert!(matches!(binary, FileError::NoText { source: NoText::Byte { line: 1, byte: 0xff }, .. }), "{binary}");
        let torn = toml::<::toml::Table>("name = ", "cell.toml").expect_err("no TOML");
        assert!(matches!(torn, FileError::Toml { file, .. } if file == "cell.toml"));
    }
}
