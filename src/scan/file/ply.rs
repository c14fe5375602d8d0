//! PLY as a cloud: its vertices are the points, whatever stands before and behind them. Rows without lists are read by
//! their fixed width, all others word by word with the rows of [`crate::part::file::ply`].

use super::gather::{ColourScale, Gather};
use super::number::Number;
use super::role::Roles;
use super::stream::{CHUNK, Stream};
use super::table::{Field, Table, gather_for};
use super::{Found, ScanFileError, ScanFinding};
use crate::part::file::PlyFault;
use crate::part::file::ply::header::{Element, Encoding, Header};
use crate::part::file::ply::rows::{RowFault, Rows};

/// Reads a PLY file as a cloud.
///
/// # Errors
/// It cannot be read, or its vertices have no x, y and z.
pub(super) fn read(stream: &mut Stream<'_>) -> Result<Found, ScanFileError> {
    let header = Header::of(stream.bytes())?;
    header.check_size(stream.remaining().min(usize::MAX as u64) as usize)?;
    stream.take(header.body);
    let mut found = None;
    let mut findings = Vec::new();
    for element in &header.elements {
        if element.name == "vertex" {
            found = Some(vertices(stream, element, header.encoding, &mut findings)?);
        } else {
            let is_whole = match width(element).filter(|_| header.encoding != Encoding::Ascii) {
                Some(width) => stream.skip(element.count.saturating_mul(width as u64))?,
                None => by_rows(stream, element, header.encoding, |rows, _| rows.skip(&element.properties), |_| {})?,
            };
            if !is_whole {
                return Err(cut_off(element));
            }
            if element.count > 0 {
                let (element, count) = (element.name.clone(), element.count);
                findings.push(ScanFinding::NotRead { element, count });
            }
        }
    }
    let columns = || header.elements.iter().map(|e| e.name.clone()).collect();
    let gather = found.ok_or_else(|| ScanFileError::NoCoordinates { columns: columns() })?;
    if let Some((count, at)) = stream.left()? {
        findings.push(ScanFinding::BytesPassedOver { count, at });
    }
    Ok(Found { gather, findings, invalid: 0, stated_unit: None })
}

fn cut_off(element: &Element) -> ScanFileError {
    PlyFault::CutOff { element: element.name.clone(), promised: element.count }.into()
}

/// Bytes of a binary row, where each has the same.
fn width(element: &Element) -> Option<usize> {
    element.properties.iter().map(|p| p.list.is_none().then(|| p.scalar.size())).sum()
}

fn vertices(
    stream: &mut Stream<'_>,
    element: &Element,
    encoding: Encoding,
    findings: &mut Vec<ScanFinding>,
) -> Result<Gather, ScanFileError> {
    // A list has no role, whatever its name; brackets are in no name of a file.
    let name = |p: usize| if element.properties[p].list.is_some() { "[" } else { &element.properties[p].name };
    let mut roles = Roles::named((0..element.properties.len()).map(name)).map_err(|_| PlyFault::NoCoordinates)?;
    let unread = element.properties.iter().zip(&roles.of).filter(|(_, role)| role.is_none());
    roles.unread = unread.map(|(p, _)| p.name.clone()).collect();
    let numbers = element.properties.iter().map(|p| Number::from(p.scalar));
    let mut gather = gather_for(&roles, numbers.clone());
    if !roles.unread.is_empty() {
        findings.push(ScanFinding::ColumnsNotRead { names: roles.unread.clone() });
    }
    if let Some(stride) = width(element).filter(|_| encoding != Encoding::Ascii) {
        let mut at = 0;
        let mut fields = Vec::new();
        for (number, role) in numbers.zip(&roles.of) {
            fields.extend(role.map(|role| Field { at, number, role }));
            at += number.size();
        }
        let table = Table { fields, stride, is_big: encoding == Encoding::Big };
        let read = table.read(element.count, stream, &mut gather)?;
        return if read < element.count { Err(cut_off(element)) } else { Ok(gather) };
    }
    if encoding == Encoding::Ascii && gather.scale == ColourScale::Words {
        // Nobody writes sixteen bits as words; `short` is what some write for bytes.
        gather.scale = ColourScale::Bytes;
    }
    gather.reserve(element.count)?;
    let read = |rows: &mut Rows<'_>, values: &mut Vec<f64>| rows.values(&element.properties, values);
    let is_whole = by_rows(stream, element, encoding, read, |values| {
        let point = gather.push();
        for (value, role) in values.iter().zip(&roles.of) {
            if let Some(role) = role {
                gather.set(point, *role, *value);
            }
        }
    })?;
    if is_whole { Ok(gather) } else { Err(cut_off(element)) }
}

/// Goes through the rows of an element: `read` makes values of one, `keep` is given them once all of the row is in the
/// window. False where the file ends before.
fn by_rows(
    stream: &mut Stream<'_>,
    element: &Element,
    encoding: Encoding,
    read: impl Fn(&mut Rows<'_>, &mut Vec<f64>) -> Result<(), RowFault>,
    mut keep: impl FnMut(&[f64]),
) -> Result<bool, ScanFileError> {
    let (mut done, mut values) = (0, Vec::new());
    while done < element.count {
        let mut rows = Rows::over(stream.bytes(), encoding);
        let (len, has_ended) = (stream.bytes().len(), stream.has_ended());
        let mut taken = 0;
        let mut fault = RowFault::Ends;
        while done < element.count {
            match read(&mut rows, &mut values) {
                // The last word of the window may go on behind it.
                Ok(()) if rows.at() == len && !has_ended => break,
                Ok(()) => {
                    keep(&values);
                    (done, taken) = (done + 1, rows.at());
                }
                Err(e) => {
                    fault = e;
                    break;
                }
            }
        }
        if done == element.count {
            stream.take(taken);
            break;
        }
        match fault {
            RowFault::Ends if has_ended => return Ok(false),
            RowFault::Ends => stream.take(taken),
            RowFault::Value => {
                return Err(PlyFault::Value { element: element.name.clone(), row: done }.into());
            }
            RowFault::DecimalComma { byte } => return Err(ScanFileError::DecimalComma { byte: stream.place(byte) }),
        }
        // Twice as much where one row is longer than the window, so that it is not read anew too often.
        stream.need(if taken == 0 { 2 * len + CHUNK } else { len - taken + CHUNK })?;
    }
    Ok(true)
}
