//! A part's file as a scan: the corners of its facets become the points, each once, as scanners' programs write their
//! meshes as STL. All of it is read at once; what is told of single points is told of facets here.

use super::gather::{ColourScale, Gather, Has};
use super::role::Role;
use super::{Found, ScanFileError, ScanFinding};
use crate::part::Source;
use crate::part::weld::{Weld, Welded};
use crate::progress::Progress;

/// Reads the corners of a part's file.
///
/// # Errors
/// It is no usable part.
pub(super) fn read(bytes: &[u8], progress: &Progress) -> Result<Found, ScanFileError> {
    let source = Source::from_bytes(bytes)?;
    progress.check()?;
    let raw = &source.raw;
    let (facets, dropped) = (raw.facets.len() as u64, raw.invalid.len() as u64);
    let mut findings = vec![ScanFinding::CornersTaken { facets, dropped }];
    findings.extend(raw.passed_over.map(|p| ScanFinding::BytesPassedOver { count: p.count as u64, at: p.at as u64 }));
    let points = Welded::new(&raw.facets, Weld::Exact).points;
    progress.check()?;
    let mut gather = Gather::new(Has::default(), ColourScale::Bytes, true);
    gather.reserve(points.len() as u64)?;
    for place in &points {
        let point = gather.push();
        for (axis, value) in place.iter().enumerate() {
            gather.set(point, Role::Place(axis), f64::from(*value));
        }
    }
    Ok(Found { gather, findings, invalid: 0, stated_unit: raw.stated_unit })
}
