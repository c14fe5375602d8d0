//! Files that clouds come in: PLY, PCD, rows of text (XYZ, TXT, CSV, PTS), PTX, E57, and the corners of a part's file.
//!
//! A reader gathers points (`gather`) from a file on its way through a window (`stream`), and what becomes of them is
//! settled for all forms alike (`settle`). In memory are 31 bytes a point and a few MiB; only a part's file is read as
//! a whole. Coordinates stay in the unit of the file: `units` tells where that is in doubt.

mod decimal;
mod e57;
mod error;
mod finding;
mod form;
mod gather;
mod mesh;
mod number;
mod pcd;
mod ply;
mod ptx;
mod role;
mod settle;
mod stream;
mod table;
#[cfg(test)]
mod tests;
mod text;
mod units;

pub use error::{E57Fault, PcdFault, PtxFault, ScanFileError};
pub use finding::{Assumed, Attribute, ScanFinding};
pub use form::{ENDINGS, ScanKind};
pub use units::{UnitDoubt, UnitFit, unit_doubt};

use super::Cloud;
use crate::part::units::StatedUnit;
use crate::progress::Progress;
use gather::Gather;
use std::fs::File;
use std::io::{Cursor, Read, Seek};
use std::path::Path;
use stream::Stream;

/// A scan's file as it was read.
#[derive(Clone, Debug, PartialEq)]
pub struct RawScan {
    /// Its points, in the unit of the file; the middle of their box is the origin.
    pub cloud: Cloud,
    /// The form of the file.
    pub kind: ScanKind,
    /// The unit that the file states, or its form has.
    pub stated_unit: Option<StatedUnit>,
    /// What was dropped, left unread or assumed.
    pub findings: Vec<ScanFinding>,
    /// SHA-256 of the file's bytes, hexadecimal.
    pub sha256: String,
}

/// What a reader found in a file.
struct Found {
    gather: Gather,
    findings: Vec<ScanFinding>,
    /// Points that the file marks as not measured; they are not among the gathered.
    invalid: u64,
    stated_unit: Option<StatedUnit>,
}

/// What files are read from.
trait Source: Read + Seek {}

impl<T: Read + Seek> Source for T {}

/// Reads a scan's file.
///
/// # Errors
/// It cannot be read, is no scan, or the work was cancelled.
pub fn read(path: &Path, progress: &Progress) -> Result<RawScan, ScanFileError> {
    let (mut file, len) = opened(path)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    read_from(&name, &mut file, len, progress)
}

/// SHA-256 of a file's bytes, hexadecimal, as [`RawScan::sha256`] is: tells the scan that a job is made for.
///
/// # Errors
/// It cannot be read, or the work was cancelled.
pub fn sha256(path: &Path, progress: &Progress) -> Result<String, ScanFileError> {
    let (mut file, len) = opened(path)?;
    Stream::new(&mut file, len, progress)?.digest()
}

fn opened(path: &Path) -> Result<(File, u64), ScanFileError> {
    if path.is_dir() {
        return Err(ScanFileError::Folder);
    }
    let file = File::open(path)?;
    let len = file.metadata()?.len();
    Ok((file, len))
}

/// Takes the bytes of a scan's file. `name_hint`: its name, for what the bytes do not tell.
///
/// # Errors
/// They are no scan, or the work was cancelled.
pub fn from_bytes(name_hint: &str, bytes: &[u8], progress: &Progress) -> Result<RawScan, ScanFileError> {
    read_from(name_hint, &mut Cursor::new(bytes), bytes.len() as u64, progress)
}

fn read_from(name: &str, source: &mut dyn Source, len: u64, progress: &Progress) -> Result<RawScan, ScanFileError> {
    if len == 0 {
        return Err(ScanFileError::Empty);
    }
    let (kind, found, sha256) = {
        let mut stream = Stream::new(source, len, progress)?;
        let kind = form::of(name, &stream)?;
        let found = match kind {
            ScanKind::Ply => Some(ply::read(&mut stream)?),
            ScanKind::Pcd => Some(pcd::read(&mut stream)?),
            ScanKind::Text => Some(text::read(name, &mut stream)?),
            ScanKind::Ptx => Some(ptx::read(&mut stream)?),
            ScanKind::E57 | ScanKind::Mesh => None,
        };
        (kind, found, stream.digest()?)
    };
    let found = match (found, kind) {
        (Some(found), _) => found,
        (None, ScanKind::E57) => e57::read(source, len, progress)?,
        (None, _) => {
            source.rewind()?;
            let mut bytes = Vec::new();
            source.read_to_end(&mut bytes)?;
            mesh::read(&bytes, progress)?
        }
    };
    let (cloud, dropped) = found.gather.settle(found.invalid, progress)?;
    let findings = dropped.into_iter().chain(found.findings).collect();
    Ok(RawScan { cloud, kind, stated_unit: found.stated_unit, findings, sha256 })
}
