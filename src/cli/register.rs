//! `clearbeam register`: where a scan lies on its part, and where that puts the part in the robot's base.

use super::{CommandFailure, CommandOutcome, print, print_json, scans};
use crate::document::{Job, segmented};
use crate::fit::PlacedPair;
use crate::planning::report::{MarkerResidual, PlacedScan, RegistrationReport};
use crate::progress::Progress;
use crate::scan::marker_file::{self, Marker};
use crate::scan::registration::{RegistrationOptions, Start, SurfaceNormals, register};
use crate::text::{registration_lines, say};
use nalgebra::{Isometry3, Point3};
use std::path::{Path, PathBuf};

/// Options of `register`.
#[derive(clap::Args, Debug)]
pub struct RegisterArguments {
    #[arg(help = say!(cli_register_scans))]
    scan: PathBuf,
    #[arg(long, value_name = "PART", help = say!(cli_register_part))]
    part: PathBuf,
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
    let cloud = scans::read(&a.scan)?;
    let part = scans::part(&a.part)?;
    scans::check_units(&cloud, &part)?;
    let surfaces = segmented(&part, &Job::default());
    let normals = SurfaceNormals::new(&part.mesh, &surfaces.of_facet);
    let options = RegistrationOptions { start, ..RegistrationOptions::default() };
    let found =
        register(&part, &normals, &cloud, &options, &Progress::default()).map_err(CommandFailure::failed)?;
    let mut report = RegistrationReport::new(&found);
    if let (Some(markers), Some(file)) = (&markers, &a.markers) {
        report.base_from_scan = Some(placed(markers, &a.scan, file, &found.model_from_scan)?);
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
    markers: &[Marker],
    scan: &Path,
    file: &Path,
    model_from_scan: &Isometry3<f64>,
) -> Result<PlacedScan, CommandFailure> {
    let touched = |m: &Marker| m.base_mm.map(|base| (m.name.clone(), m.scan_mm, base));
    let touched: Vec<_> = marker_file::of_scan(markers, scan, true).filter_map(touched).collect();
    let pairs: Vec<PlacedPair> = touched
        .iter()
        .map(|(_, scan, base)| PlacedPair { from: Point3::from(*scan), onto: Point3::from(*base), weight: 1.0 })
        .collect();
    let fit = crate::scan::merging::by_markers(&pairs).map_err(|_| {
        let (file, scan) = (file.display().to_string(), scan.display().to_string());
        CommandFailure::Failed(say!(markers_few, file, found = pairs.len(), scan, key = say!(markers_key_base)))
    })?;
    let residuals = touched.into_iter().zip(fit.residuals_mm);
    let residuals = residuals.map(|((marker, ..), residual_mm)| MarkerResidual { marker, residual_mm }).collect();
    Ok(PlacedScan::new(&fit.motion, model_from_scan, residuals))
}
