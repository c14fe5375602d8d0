//! Scans that are named on the command line: read, in millimetres, with what was found in their files.

use super::CommandFailure;
use crate::part::{Part, Placement, Units, Weld};
use crate::progress::Progress;
use crate::scan::file::{self, RawScan, unit_doubt};
use crate::scan::{Cloud, transform_file};
use crate::text::{Sentence as _, say, unit_doubt_sentence};
use nalgebra::Isometry3;
use std::path::Path;

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

/// Reads the part that scans are laid on, in the unit that its file states.
pub fn part(path: &Path) -> Result<Part, CommandFailure> {
    let source = crate::part::Source::read(path).map_err(CommandFailure::failed)?;
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
