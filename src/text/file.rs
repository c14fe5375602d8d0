//! Why a file cannot be read.

use super::{Sentence, say};
use crate::file::FileError;

impl Sentence for FileError {
    fn sentence(&self) -> String {
        match self {
            FileError::Read { file, source } => say!(file_not_read, file, reason = source.to_string()),
            FileError::NoText { file, source } => say!(file_no_text, file, reason = source.to_string()),
            FileError::Toml { file, source } => say!(in_file, file, what = one_line(source)),
        }
    }
}

/// What the reader of TOML says of a fault, with its place, on one line.
pub(super) fn one_line(e: &impl std::fmt::Display) -> String {
    e.to_string().trim_end().replace('\n', " ")
}
