//! E57 (ASTM E2807) as a cloud: metres by its standard, each scan put where its pose says. The `e57` crate takes files
//! apart; here its points become a cloud, and what it refuses gets a cause.

mod checksum;
mod near;
mod record;

use super::gather::{ColourScale, Gather};
use super::role::Role;
use super::{E57Fault, Found, ScanFileError, ScanFinding, Source};
use crate::part::units::StatedUnit;
use crate::progress::{Activity, Progress};
use ::e57::{E57Reader, PointCloud};
use near::Near;
use record::{Columns, Pose};

/// Points between two looks at the progress: some ten milliseconds.
const BLOCK: u64 = 1 << 16;

/// Reads an E57 file as a cloud.
///
/// # Errors
/// It cannot be read, a checksum does not fit, or its points have no coordinates.
pub(super) fn read(source: &mut dyn Source, len: u64, progress: &Progress) -> Result<Found, ScanFileError> {
    match scans(source, len, progress) {
        // What is damaged may look like anything; checksums tell.
        Err(ScanFileError::E57(fault)) => {
            let stated = checksum::stated_length(source)?;
            if stated != len {
                return Err(E57Fault::Length { stated, present: len }.into());
            }
            let page = checksum::first_wrong_page(source, progress)?;
            Err(page.map_or(fault, |page| E57Fault::Checksum { page }).into())
        }
        other => other,
    }
}

fn scans(source: &mut dyn Source, len: u64, progress: &Progress) -> Result<Found, ScanFileError> {
    let mut reader = E57Reader::new(Near::new(source)?).map_err(|e| fault(&e, E57Fault::Description))?;
    let clouds = reader.pointclouds();
    let columns = clouds.iter().map(Columns::of).collect::<Result<Vec<_>, _>>()?;
    let mut records = 0u64;
    for (cloud, columns) in clouds.iter().zip(&columns) {
        // Before anything is made room for.
        let present = len.saturating_mul(8) / columns.bits;
        if cloud.records > present {
            return Err(ScanFileError::CutOff { promised: cloud.records, present });
        }
        records = records.saturating_add(cloud.records);
    }
    progress.begin(Activity::Reading, (records / BLOCK) as usize + 1);
    let has = columns.iter().map(|c| c.has).reduce(|a, b| a.or(b)).unwrap_or_default();
    let from_origin =
        columns.iter().zip(&clouds).all(|(columns, cloud)| columns.are_single && cloud.transform.is_none());
    let mut gather = Gather::new(has, ColourScale::Bytes, from_origin);
    gather.reserve(records)?;
    let mut invalid = 0;
    for (scan, (cloud, columns)) in clouds.iter().zip(&columns).enumerate() {
        invalid += points(&mut reader, scan, cloud, columns, &mut gather, progress)?;
    }
    let mut findings = Vec::new();
    let count = clouds.iter().filter(|c| c.records > 0).count() as u64;
    findings.extend((count > 1).then_some(ScanFinding::CloudsJoined { count }));
    let mut names: Vec<String> = columns.into_iter().flat_map(|c| c.unread).collect();
    names.sort();
    names.dedup();
    findings.extend((!names.is_empty()).then_some(ScanFinding::ColumnsNotRead { names }));
    let images = reader.images().len() as u64;
    findings.extend((images > 0).then(|| ScanFinding::NotRead { element: "images2D".into(), count: images }));
    Ok(Found { gather, findings, invalid, stated_unit: Some(StatedUnit::Meter) })
}

fn fault(error: &::e57::Error, else_: E57Fault) -> ScanFileError {
    match error {
        ::e57::Error::NotImplemented { .. } => E57Fault::NotHandled.into(),
        _ => else_.into(),
    }
}

/// Reads the points of one scan; returns how many are marked as not measured.
fn points(
    reader: &mut E57Reader<Near<'_>>,
    scan: usize,
    cloud: &PointCloud,
    columns: &Columns,
    gather: &mut Gather,
    progress: &Progress,
) -> Result<u64, ScanFileError> {
    let pose = Pose::of(cloud.transform.as_ref()).ok_or(E57Fault::Pose { scan })?;
    let fault = |e: &::e57::Error| fault(e, E57Fault::Points { scan });
    let mut invalid = 0;
    let mut records = reader.pointcloud_raw(cloud).map_err(|e| fault(&e))?;
    for read in 0..cloud.records {
        if read % BLOCK == 0 {
            progress.step()?;
        }
        let record = records.next().ok_or(E57Fault::Points { scan })?.map_err(|e| fault(&e))?;
        let Some(place) = columns.place(&record) else {
            invalid += 1;
            continue;
        };
        let point = gather.push();
        let place = pose.placed(place);
        for axis in 0..3 {
            gather.set(point, Role::Place(axis), place[axis]);
        }
        if let Some(normal) = columns.normal(&record).map(|n| pose.turned(n)) {
            for axis in 0..3 {
                gather.set(point, Role::Normal(axis), normal[axis]);
            }
        }
        if let Some(colour) = columns.colour(&record) {
            for (channel, value) in colour.into_iter().enumerate() {
                gather.set(point, Role::Colour(channel), value);
            }
        }
        if let Some(intensity) = columns.intensity(&record) {
            gather.set(point, Role::Intensity, intensity);
        }
    }
    Ok(invalid)
}
