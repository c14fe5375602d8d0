//! The files of a job's scan as one cloud in millimetres, in the frame that they share.

use super::ScanError;
use crate::document::files::resolved;
use crate::document::model::JobScan;
use crate::part::Units;
use crate::part::units::StatedUnit;
use crate::progress::Progress;
use crate::scan::file::{self, RawScan, ScanFinding};
use crate::scan::{Cloud, merging};
use nalgebra::Isometry3;
use std::path::Path;
use std::sync::Arc;

/// A scan as it was read.
#[derive(Clone, Debug, Default)]
pub struct ReadScan {
    /// All points, mm, in the frame of the scan.
    pub cloud: Cloud,
    /// What was found in the files, by their names in the job.
    pub findings: Vec<(String, ScanFinding)>,
}

/// Reads the files of a scan that a job in `job_file` names. They share a frame, as scanners export them.
///
/// # Errors
/// A file is no scan, or another one than the job was saved with.
pub fn read_scan(scan: &JobScan, job_file: Option<&Path>, progress: &Progress) -> Result<ReadScan, ScanError> {
    let mut read = ReadScan::default();
    let mut clouds = Vec::with_capacity(scan.files.len());
    for named in &scan.files {
        let file = || named.file.clone();
        let raw = file::read(&resolved(job_file, &named.file), progress)
            .map_err(|source| ScanError::File { file: file(), source: Arc::new(source) })?;
        if !named.sha256.is_empty() && named.sha256 != raw.sha256 {
            return Err(ScanError::Changed { file: file(), sha256: raw.sha256 });
        }
        read.findings.extend(raw.findings.iter().map(|f| (file(), f.clone())));
        clouds.push(in_mm(raw, scan.units));
    }
    if clouds.len() > 1 {
        let placed: Vec<_> = clouds.iter().map(|c| (c, Isometry3::identity())).collect();
        read.cloud = merging::merged(&placed, progress)?;
    } else {
        read.cloud = clouds.pop().unwrap_or_default();
    }
    Ok(read)
}

/// The points of a file in mm. A file that states its unit is taken in that, another one as the job says.
fn in_mm(raw: RawScan, units: Units) -> Cloud {
    let stated = raw.stated_unit.map(|unit: StatedUnit| unit.taken().mm() * unit.in_taken());
    raw.cloud.scaled(stated.unwrap_or_else(|| units.mm()))
}
