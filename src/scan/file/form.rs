//! Which form a scan's file has, by what is in it; its name decides only where that says nothing.

use super::stream::Stream;
use super::{PcdFault, ScanFileError, pcd, ptx};
use crate::part::file::{FileKind, kind_of};
use serde::Serialize;

/// Forms that scans are read in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ScanKind {
    /// PLY.
    Ply,
    /// PCD.
    Pcd,
    /// Rows of text: XYZ, TXT, CSV, PTS.
    Text,
    /// PTX.
    Ptx,
    /// E57.
    E57,
    /// A part's file: STL, OBJ or 3MF.
    Mesh,
}

/// Endings of the names of files that can be scans, for dialogs.
pub const ENDINGS: [&str; 15] =
    ["ply", "pcd", "xyz", "xyzn", "xyzrgb", "txt", "csv", "asc", "pts", "ptx", "e57", "stl", "obj", "3mf", "dat"];

/// What people take for a scan and is none that is read.
const OTHERS: [(&[u8], FileKind); 1] = [(b"LASF", FileKind::OtherModel("LAS / LAZ"))];

/// So much of the beginning tells text from bytes.
const LOOKED_AT: usize = 4096;

/// The form of a file that has this name and begins so.
///
/// # Errors
/// It is something else, or a PCD file by its name and has no header.
pub(super) fn of(name: &str, stream: &Stream<'_>) -> Result<ScanKind, ScanFileError> {
    let begin = stream.bytes();
    let is_named = |ending: &str| name.rsplit('.').next().is_some_and(|e| e.eq_ignore_ascii_case(ending));
    if begin.starts_with(b"ASTM-E57") {
        return Ok(ScanKind::E57);
    }
    if let Some((_, kind)) = OTHERS.iter().find(|(mark, _)| begin.starts_with(mark)) {
        return Err(ScanFileError::Other(*kind));
    }
    if is_named("stl") {
        return Ok(ScanKind::Mesh);
    }
    match kind_of(begin) {
        Some(FileKind::Ply) => return Ok(ScanKind::Ply),
        Some(FileKind::Obj | FileKind::Zip) => return Ok(ScanKind::Mesh),
        Some(kind) => return Err(ScanFileError::Other(kind)),
        None if pcd::is_pcd(begin) => return Ok(ScanKind::Pcd),
        None if is_named("pcd") => return Err(PcdFault::NoHeader.into()),
        None if is_named("e57") || is_named("ply") => return Err(ScanFileError::Unknown),
        None => {}
    }
    let looked_at = &begin[..begin.len().min(LOOKED_AT)];
    if !stream.is_utf16() && looked_at.contains(&0) {
        return Ok(ScanKind::Mesh);
    }
    if looked_at.trim_ascii_start().get(..5).is_some_and(|w| w.eq_ignore_ascii_case(b"solid")) {
        return Ok(ScanKind::Mesh);
    }
    Ok(if ptx::is_ptx(begin) { ScanKind::Ptx } else { ScanKind::Text })
}
