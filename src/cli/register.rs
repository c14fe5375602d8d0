//! `clearbeam register`: where a scan lies on its part, and where that puts the part in the robot's base.

use super::{CommandFailure, CommandOutcome, print, print_json, scans};
use crate::document::{Job, segmented};
use crate::planning::scanned::{MarkerResidual, PlacedScan, RegistrationReport};
use crate::progress::Progress;
use crate::scan::marker_file::{self, SeenMarker};
use crate::scan::registration::{RegistrationOptions, Start, SurfaceNormals, register};
use crate::text::{registration_lines, say};
use nalgebra::Isometry3;
use std::path::{Path, PathBuf};

/// Options of `register`.
#[derive(clap::Args, Debug)]
pub struct RegisterArguments {
    #[arg(value_name = "SCAN", required = true, help = say!(cli_register_scans))]
    scans: Vec<PathBuf>,
    #[arg(long, value_name = "PART", required_unless_present = "nominal_scan", help = say!(cli_register_part))]
    part: Option<PathBuf>,
    #[arg(long, value_name = "SCAN", conflicts_with = "part", help = say!(cli_register_nominal))]
    nominal_scan: Option<PathBuf>,
    #[arg(long, value_name = "FILE", help = say!(cli_register_markers))]
    markers: Option<PathBuf>,
    #[arg(long, value_name = "FILE", help = say!(cli_register_transform))]
    transform: Option<PathBuf>,
    #[arg(long, help = say!(cli_json))]
    json: bool,
}

/// Lays the scan on the part and says how it lies.
pub fn run(a: &RegisterArguments) -> Result<CommandOutcome, CommandFailure> {
    let start = match &a.transform {
        Some(file) => Start::From(scans::transform(file)?),
        None => Start::Anywhere,
    };
    let markers = a.markers.as_deref().map(marker_file::read).transpose().map_err(CommandFailure::failed)?;
    let named = markers.as_deref().zip(a.markers.as_deref());
    let cloud = scans::read_all(&a.scans, named)?;
    // clap sees to it that there is one of them.
    let nominal = a.part.as_deref().or(a.nominal_scan.as_deref()).unwrap_or(Path::new(""));
    let part = scans::part(nominal)?;
    scans::check_units(&cloud, &part)?;
    let surfaces = segmented(&part, &Job::default());
    let normals = SurfaceNormals::new(&part.mesh, &surfaces.of_facet);
    let options = RegistrationOptions { start, ..RegistrationOptions::default() };
    let found = register(&part, &normals, &cloud, &options, &Progress::default()).map_err(CommandFailure::failed)?;
    let mut report = RegistrationReport::new(&found);
    if let Some((markers, file)) = named {
        report.base_from_scan = placed(markers, a, file, &found.model_from_scan)?;
    }
    if a.json {
        print_json(&report)?;
    } else {
        print(&format!("{}\n", registration_lines(&report).join("\n")));
    }
    Ok(if report.is_in_doubt() { CommandOutcome::Found } else { CommandOutcome::Done })
}

/// Where markers that the robot touched put the scan.
fn placed(
    markers: &[SeenMarker],
    a: &RegisterArguments,
    file: &Path,
    model_from_scan: &Isometry3<f64>,
) -> Result<Option<PlacedScan>, CommandFailure> {
    let Some(scan) = a.scans.first() else { return Ok(None) };
    let (names, pairs): (Vec<_>, Vec<_>) = marker_file::touched(markers, scan, a.scans.len() == 1).into_iter().unzip();
    // Markers may be there for the scans alone.
    if pairs.is_empty() {
        return Ok(None);
    }
    let fit = scans::by_markers(&pairs, file, scan)?;
    let residuals = names.into_iter().zip(fit.residuals_mm);
    let residuals = residuals.map(|(marker, residual_mm)| MarkerResidual { marker, residual_mm }).collect();
    Ok(Some(PlacedScan::new(&fit.common_from_scan, model_from_scan, residuals)))
}
