//! What the report of an export says of the files that its program was planned from.

use super::output_file::REPORT;
use crate::document::files::InputDigest;
use crate::planning::report::FileDigest;
use serde::Deserialize;
use std::path::Path;

/// As much of `report.json` as tells what a program was made from.
#[derive(Deserialize)]
struct ReportInputs {
    files: Vec<FileDigest>,
    inputs: Vec<InputDigest>,
}

/// The files that the program of this name was planned from, by the report in a folder; `None`: there is no report of
/// that program, or none that says it.
pub fn recorded_inputs(folder: &Path, program: &str) -> Option<Vec<InputDigest>> {
    let text = std::fs::read(folder.join(REPORT)).ok()?;
    let report: ReportInputs = serde_json::from_slice(&text).ok()?;
    report.files.iter().any(|f| f.name == program).then_some(report.inputs)
}
