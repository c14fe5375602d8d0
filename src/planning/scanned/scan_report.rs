//! What a scan says of a planned part: key `scan` of `report.json`.

use super::{BroughtTogether, RegistrationReport, Scanned, WornPatch};
use crate::scan::deviation::Patch;
use crate::scan::file::ScanFinding;
use crate::scan::transform_file;
use serde::Serialize;

/// What a scan says of a part. Lengths mm.
#[derive(Clone, Debug, Serialize)]
pub struct ScanReport {
    /// Points that were read.
    pub points_read: usize,
    /// Points that are left after cleaning.
    pub points: usize,
    /// From the scan's frame to the part's, row by row.
    pub model_from_scan: [f64; 16],
    /// How it was found; null where the job gives it.
    pub registration: Option<RegistrationReport>,
    /// Whether it is known where the scanner stands in the robot's base, so that the part stands in the cell as it was
    /// scanned.
    pub is_placed: bool,
    /// How much wider than their margins everything keeps clear, since the part may lie so far off.
    pub slack_mm: f64,
    /// Area of the model without points, mm².
    pub unscanned_mm2: f64,
    /// How well files fit those before them, where they were brought together by their overlap.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub together: Vec<BroughtTogether>,
    /// What was found in the files.
    pub findings: Vec<ScanFileFinding>,
    /// What is worn or built up; the report has it beside this.
    #[serde(skip)]
    pub patches: Vec<WornPatch>,
}

/// What was found in a file of a scan.
#[derive(Clone, Debug, Serialize)]
pub struct ScanFileFinding {
    /// The file, as the job names it.
    pub file: String,
    /// What.
    #[serde(flatten)]
    pub finding: ScanFinding,
}

impl ScanReport {
    /// Of a scan that was compared; `None`: it has not come so far.
    pub fn new(of: &Scanned, is_placed: bool) -> Option<ScanReport> {
        let (laid, compared) = (of.laid.as_ref()?, of.compared.as_ref()?);
        let finding =
            |(file, finding): &(String, ScanFinding)| ScanFileFinding { file: file.clone(), finding: finding.clone() };
        let layers = of.worn.as_ref().map_or(&[][..], |worn| &worn.layers);
        let patch = |(at, patch): (usize, &Patch)| WornPatch::new(patch, layers.get(at).map_or(&[], Vec::as_slice));
        Some(ScanReport {
            points_read: of.read.cloud.len(),
            points: laid.cloud_in_part.len(),
            model_from_scan: transform_file::rows(&laid.model_from_scan),
            registration: laid.registration.as_ref().map(RegistrationReport::new),
            is_placed,
            slack_mm: laid.slack_mm(),
            unscanned_mm2: compared.unscanned_mm2,
            together: of.read.together.clone(),
            findings: of.read.findings.iter().map(finding).collect(),
            patches: compared.patches.patches.iter().enumerate().map(patch).collect(),
        })
    }
}
