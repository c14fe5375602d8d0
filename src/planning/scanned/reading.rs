//! The files of a job's scan as one cloud in millimetres, in the frame that they share.

use super::ScanError;
use crate::document::files::resolved;
use crate::document::model::{JobScan, ScanTogether};
use crate::part::Units;
use crate::part::units::StatedUnit;
use crate::progress::Progress;
use crate::scan::file::{self, RawScan, ScanFinding};
use crate::scan::merging::OverlapStart;
use crate::scan::{Cloud, merging};
use nalgebra::Isometry3;
use serde::Serialize;
use std::path::Path;
use std::sync::Arc;

/// A scan as it was read.
#[derive(Clone, Debug, Default)]
pub struct ReadScan {
    /// All points, mm, in the frame of the scan.
    pub cloud: Cloud,
    /// What was found in the files, by their names in the job.
    pub findings: Vec<(String, ScanFinding)>,
    /// How well each file but the first fits those before it, where they were brought together by their overlap.
    pub together: Vec<BroughtTogether>,
}

/// How well a scan fits those that it was brought to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BroughtTogether {
    /// Its file.
    pub file: String,
    /// Root of the mean square of the distances where they overlap, mm.
    pub rms_mm: f64,
    /// Share of its points there.
    pub overlap: f64,
}

/// Reads the files of a scan that a job in `job_file` names, in the frame of the first.
///
/// # Errors
/// A file is no scan, another one than the job was saved with, or none that overlaps those before it.
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
    match scan.together {
        _ if clouds.len() < 2 => read.cloud = clouds.pop().unwrap_or_default(),
        ScanTogether::Shared => {
            let placed: Vec<_> = clouds.iter().map(|c| (c, Isometry3::identity())).collect();
            read.cloud = merging::merged(&placed, progress)?;
        }
        ScanTogether::Overlap => {
            let names: Vec<&str> = scan.files.iter().map(|f| f.file.as_str()).collect();
            (read.cloud, read.together) = by_overlap(&names, &clouds, progress)?;
        }
    }
    Ok(read)
}

/// Brings clouds into the frame of the first, each by the area that it shares with all before it.
///
/// # Errors
/// One shares too little, or fits as well elsewhere; it is named.
pub fn by_overlap(
    names: &[&str],
    clouds: &[Cloud],
    progress: &Progress,
) -> Result<(Cloud, Vec<BroughtTogether>), ScanError> {
    let mut whole = clouds.first().cloned().unwrap_or_default();
    let mut brought = Vec::new();
    for (name, cloud) in names.iter().zip(clouds).skip(1) {
        let file = || (*name).to_string();
        let found = merging::by_overlap(&whole, cloud, &OverlapStart::Anywhere, progress);
        let fit = found.map_err(|source| ScanError::Overlap { file: file(), source })?;
        let placed = [(&whole, Isometry3::identity()), (cloud, fit.common_from_scan)];
        whole = merging::merged(&placed, progress)?;
        brought.push(BroughtTogether { file: file(), rms_mm: fit.rms_mm, overlap: fit.overlap_share });
    }
    Ok((whole, brought))
}

/// The points of a file in mm. A file that states its unit is taken in that, another one as the job says.
fn in_mm(raw: RawScan, units: Units) -> Cloud {
    let stated = raw.stated_unit.map(|unit: StatedUnit| unit.taken().mm() * unit.in_taken());
    raw.cloud.scaled(stated.unwrap_or_else(|| units.mm()))
}
