//! Reads a part's file: STL in both forms, OBJ, PLY or 3MF, told by what is in it and not by its name. What is none of
//! them is named (`kind`), and what a reader drops, joins or passes over stands in the [`RawPart`].
//!
//! Coordinates of all of them are single precision, as those of STL are.

#[cfg(test)]
mod changed_bytes;
mod encoding;
mod error;
mod fault;
mod kind;
mod number;
mod obj;
pub mod ply;
mod polygon;
mod stl;
mod threemf;

pub use encoding::Utf16Form;
pub use error::PartFileError;
pub use fault::{ObjFault, PlyFault, ThreeMfFault};
pub use kind::FileKind;

use super::raw_part::RawPart;
use crate::progress::Progress;
use encoding::Utf16;

/// Endings of the names of files that can be parts, for dialogs.
pub const ENDINGS: [&str; 4] = ["stl", "obj", "ply", "3mf"];

/// Whether a file has the name of one that can be a part.
pub fn is_named_as_part(file: &std::path::Path) -> bool {
    file.extension().is_some_and(|e| ENDINGS.iter().any(|known| e.eq_ignore_ascii_case(known)))
}

/// What a file is by its beginning; `None`: it has no mark.
pub fn kind_of(beginning: &[u8]) -> Option<FileKind> {
    kind::of(beginning)
}

/// Parses the bytes of a part's file.
///
/// # Errors
/// They are no part: why, or what they are.
pub fn read(bytes: &[u8]) -> Result<RawPart, PartFileError> {
    read_under(&Progress::default(), bytes)
}

/// Parses the bytes of a part's file as long as nobody wants that to end.
///
/// # Errors
/// They are no part: why, or what they are; [`PartFileError::Cancelled`] when `progress` says so.
pub fn read_under(progress: &Progress, bytes: &[u8]) -> Result<RawPart, PartFileError> {
    if bytes.is_empty() {
        return Err(PartFileError::Empty);
    }
    let part = match Utf16::of(bytes) {
        Some(text) => text.in_file(read_as_it_is(&text.ascii, true, progress)),
        None => read_as_it_is(bytes, false, progress),
    }?;
    if part.facets.is_empty() {
        let first = part.invalid.first().map(|i| i.fault);
        return Err(PartFileError::NoFacet { dropped: part.invalid.len(), first });
    }
    Ok(part)
}

/// Parses bytes whose text is of single bytes. `is_text`: they can be nothing else.
fn read_as_it_is(bytes: &[u8], is_text: bool, progress: &Progress) -> Result<RawPart, PartFileError> {
    // A binary STL may begin with any words, those of another kind of file among them: what its counts fit is one.
    if !is_text && stl::is_binary(bytes) {
        return stl::read(bytes, progress);
    }
    match kind::of(bytes) {
        Some(FileKind::Ply) => ply::read(bytes, progress),
        Some(FileKind::Zip) => threemf::read(bytes, progress)?.ok_or(PartFileError::Other(FileKind::Zip)),
        Some(FileKind::Obj) => obj::read(bytes, progress),
        Some(other) => Err(PartFileError::Other(other)),
        None => stl::read(bytes, progress),
    }
}
