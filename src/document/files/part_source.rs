//! A part's file as jobs take it: facets as CAD systems write them, or the scan of a sound part, through whose points
//! facets are laid here (P3: the nominal model may be a scan), or the depth image of a weld.

use super::depth_part::depth_source;
use super::error::JobError;
use super::scanned_part_error::ScannedPartError;
use crate::part::raw_part::{Meshed, RawPart};
use crate::part::{LoadError, Source};
use crate::progress::Progress;
use crate::scan::file::{self, RawScan, ScanFileError, ScanKind};
use crate::scan::meshing::{Oriented, mesh_of};
use std::path::Path;

/// Reads a part's file. `camera`: the one that took it, where the part is a depth image. `None`: the work was cancelled.
///
/// # Errors
/// It is neither a part nor a scan that tells a surface.
pub fn read_source(file: &Path, camera: Option<&Path>, progress: &Progress) -> Result<Option<Source>, JobError> {
    if let Some(camera) = camera {
        return depth_source(file, camera, progress);
    }
    match Source::read_under(progress, file) {
        Err(why @ LoadError::Unusable { .. }) => match scanned(file, progress) {
            Ok(None) => Err(why.into()),
            Ok(made) => Ok(made),
            Err(e) if e.is_cancelled() => Ok(None),
            Err(source) => Err(JobError::ScannedPart { file: file.display().to_string(), source }),
        },
        read => Ok(read?),
    }
}

/// Reads a scan and lays facets through its points; `None`: it is no scan, but a part that cannot be used.
fn scanned(file: &Path, progress: &Progress) -> Result<Option<Source>, ScannedPartError> {
    let RawScan { cloud, stated_unit, sha256, .. } = match file::read(file, progress) {
        Ok(RawScan { kind: ScanKind::Mesh, .. }) => return Ok(None),
        Ok(scan) => scan,
        // What is nothing that is known is told as a part's file.
        Err(ScanFileError::Part(_) | ScanFileError::Unknown | ScanFileError::Other(_)) => return Ok(None),
        Err(e) => return Err(e.into()),
    };
    let made = mesh_of(&cloud, progress)?;
    let meshed = Meshed {
        points: made.used_points,
        dropped: made.dropped_points,
        cell: made.cell_mm,
        rms: made.rms_mm,
        is_side_guessed: made.oriented != Oriented::OwnNormals,
    };
    let raw = RawPart { facets: made.facets_f32(), solids: 1, stated_unit, meshed: Some(meshed), ..RawPart::default() };
    Ok(Some(Source { raw, sha256 }))
}
