//! PCD as a cloud: rows of text, rows of bytes, or columns of bytes compressed as one.
//!
//! Format: <https://pointclouds.org/documentation/tutorials/pcd_file_format.html>, versions 0.6 and 0.7. The viewpoint
//! tells where the scanner stood and moves no point, as in the Point Cloud Library; it is told where it is none.

mod header;
mod lzf;
mod packed;
mod rows;

pub(super) use header::is_pcd;

use super::gather::Gather;
use super::role::Roles;
use super::stream::Stream;
use super::table::{Field, Table, gather_for};
use super::{Found, ScanFileError, ScanFinding};
use header::{Data, Header};

/// Reads a PCD file as a cloud.
///
/// # Errors
/// It cannot be read, or has no x, y and z.
pub(super) fn read(stream: &mut Stream<'_>) -> Result<Found, ScanFileError> {
    let header = Header::of(stream.bytes())?;
    stream.take(header.body);
    // A field of several numbers is nothing that a point has one of.
    let name = |f: &'_ header::PcdField| if f.count == 1 { f.name.clone() } else { format!("[{}", f.name) };
    let names: Vec<String> = header.fields.iter().map(name).collect();
    let mut roles = Roles::named(names.iter().map(String::as_str))?;
    for unread in &mut roles.unread {
        *unread = unread.trim_start_matches('[').to_owned();
    }
    roles.unread.retain(|n| n != "_");
    let mut gather = gather_for(&roles, header.fields.iter().map(|f| f.number));
    let mut findings = Vec::new();
    if !roles.unread.is_empty() {
        findings.push(ScanFinding::ColumnsNotRead { names: roles.unread.clone() });
    }
    if header.has_viewpoint {
        findings.push(ScanFinding::ViewpointNotApplied);
    }
    match header.data {
        Data::Ascii => rows::read(&header, &roles, stream, &mut gather, &mut findings)?,
        Data::Binary => binary(&header, &roles, stream, &mut gather)?,
        Data::Compressed => packed::read(&header, &roles, stream, &mut gather)?,
    }
    if let Some((count, at)) = stream.left()? {
        findings.push(ScanFinding::BytesPassedOver { count, at });
    }
    Ok(Found { gather, findings, invalid: 0, stated_unit: None })
}

fn binary(header: &Header, roles: &Roles, stream: &mut Stream<'_>, gather: &mut Gather) -> Result<(), ScanFileError> {
    let stride = header.stride();
    let present = stream.remaining() / stride as u64;
    if header.points > present {
        return Err(ScanFileError::CutOff { promised: header.points, present });
    }
    let mut at = 0;
    let mut fields = Vec::new();
    for (field, role) in header.fields.iter().zip(&roles.of) {
        fields.extend(role.map(|role| Field { at, number: field.number, role }));
        at += field.size();
    }
    let present = Table { fields, stride, is_big: false }.read(header.points, stream, gather)?;
    if present < header.points {
        return Err(ScanFileError::CutOff { promised: header.points, present });
    }
    Ok(())
}
