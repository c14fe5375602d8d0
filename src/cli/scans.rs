//! Scans that are named on the command line: read, in millimetres, with what was found in their files.

use super::CommandFailure;
use crate::part::{Part, Placement, Units, Weld};
use crate::planning::scanned::by_overlap;
use crate::progress::Progress;
use crate::scan::file::{self, RawScan, unit_doubt};
use crate::scan::marker_file::{self, SeenMarker};
use crate::scan::{Cloud, merging, transform_file};
use crate::text::{Sentence as _, say, unit_doubt_sentence};
use nalgebra::Isometry3;
use std::path::{Path, PathBuf};

/// Reads a scan, in the unit that its file states, else millimetres; what was found in it goes to stderr.
pub fn read(path: &Path) -> Result<Cloud, CommandFailure> {
    let name = path.display().to_string();
    let failed = |e: file::ScanFileError| CommandFailure::Failed(say!(in_file, file = &*name, what = e.sentence()));
    let RawScan { cloud, stated_unit, findings, .. } = file::read(path, &Progress::default()).map_err(failed)?;
    for finding in &findings {
        eprintln!("{}", say!(in_file, file = &*name, what = finding.sentence()));
    }
    Ok(cloud.scaled(stated_unit.map_or(1.0, |unit| unit.taken().mm() * unit.in_taken())))
}

/// Reads scans, and brings them into the frame of the first: by the markers that they share, or by their overlap.
pub fn read_all(paths: &[PathBuf], markers: Option<(&[SeenMarker], &Path)>) -> Result<Cloud, CommandFailure> {
    let clouds = paths.iter().map(|p| read(p)).collect::<Result<Vec<_>, _>>()?;
    let (Some(first), true) = (paths.first(), paths.len() > 1) else {
        return Ok(clouds.into_iter().next().unwrap_or_default());
    };
    let Some((markers, file)) = markers else {
        let names: Vec<String> = paths.iter().map(|p| p.display().to_string()).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let (whole, brought) = by_overlap(&names, &clouds, &Progress::default()).map_err(CommandFailure::failed)?;
        brought.iter().for_each(|one| eprintln!("{}", one.sentence()));
        return Ok(whole);
    };
    let mut placed = Vec::with_capacity(clouds.len());
    for (path, cloud) in paths.iter().zip(&clouds) {
        let shared = marker_file::shared(markers, path, first);
        let is_first = path == first;
        let motion = if is_first { Isometry3::identity() } else { by_markers(&shared, file, path)?.common_from_scan };
        placed.push((cloud, motion));
    }
    // Nobody can have cancelled it.
    Ok(merging::merged(&placed, &Progress::default()).unwrap_or_default())
}

/// The motion that the markers of a scan tell; `file` holds them.
pub fn by_markers(shared: &[merging::Marker], file: &Path, scan: &Path) -> Result<merging::MarkerFit, CommandFailure> {
    merging::by_markers(shared).map_err(|e| {
        let (file, scan) = (file.display().to_string(), scan.display().to_string());
        CommandFailure::Failed(say!(cli_markers_of, file, scan, what = e.sentence()))
    })
}

/// Reads the part that scans are laid on, in the unit that its file states.
pub fn part(path: &Path) -> Result<Part, CommandFailure> {
    let source = super::source_of(path, None)?;
    let made = source.part(source.units(), Weld::default(), &Placement::default(), &[], &Progress::default());
    let named = |e: crate::part::file::PartFileError| {
        CommandFailure::Failed(say!(in_file, file = path.display().to_string(), what = e.sentence()))
    };
    // Nobody can have cancelled it.
    Ok(made.map_err(named)?.unwrap_or_default())
}

/// A scan that would fit its part in another unit is asked about, never scaled.
pub fn check_units(cloud: &Cloud, part: &Part) -> Result<(), CommandFailure> {
    let sizes = [cloud.diagonal(), part.mesh.diagonal()];
    match unit_doubt(sizes, [Units::Mm; 2]) {
        Some(doubt) => Err(CommandFailure::Failed(unit_doubt_sentence(&doubt, sizes))),
        None => Ok(()),
    }
}

/// The motion of a file.
pub fn transform(path: &Path) -> Result<Isometry3<f64>, CommandFailure> {
    transform_file::read(path).map_err(CommandFailure::failed)
}
