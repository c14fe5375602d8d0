//! The rows of a PCD text: as many as the header says, each with all its numbers.

use super::header::Header;
use crate::scan::file::decimal::{Comma, cell};
use crate::scan::file::gather::Gather;
use crate::scan::file::number::Number;
use crate::scan::file::role::{Role, Roles};
use crate::scan::file::stream::{Lines, Stream};
use crate::scan::file::{PcdFault, ScanFileError, ScanFinding};

/// Reads the rows.
///
/// # Errors
/// They are fewer than promised, or one is no row of numbers.
pub(super) fn read(
    header: &Header,
    roles: &Roles,
    stream: &mut Stream<'_>,
    gather: &mut Gather,
    findings: &mut Vec<ScanFinding>,
) -> Result<(), ScanFileError> {
    let columns = header.columns();
    // A digit and what divides it from the next; the last one may end the file.
    let room = (stream.remaining() + 1) / (2 * columns.max(1)) as u64;
    if header.points > room {
        return Err(ScanFileError::CutOff { promised: header.points, present: room });
    }
    gather.reserve(header.points)?;
    let mut of: Vec<Option<(Role, Number)>> = Vec::with_capacity(columns);
    for (field, role) in header.fields.iter().zip(&roles.of) {
        of.extend((0..field.count).map(|_| role.map(|r| (r, field.number))));
    }
    let (mut read, mut line) = (0, header.lines);
    let mut long: Option<(u64, u64)> = None;
    while read < header.points {
        let whole = stream.lines()?;
        if whole == 0 {
            return Err(ScanFileError::CutOff { promised: header.points, present: read });
        }
        let mut lines = Lines(&stream.bytes()[..whole]);
        while read < header.points {
            let Some(text) = lines.next() else { break };
            line += 1;
            let text = text.trim_ascii();
            if text.is_empty() {
                continue;
            }
            let is_long = row(text, &of, gather).ok_or(PcdFault::Row { line })?;
            if is_long {
                long = Some(long.map_or((1, line), |(count, first)| (count + 1, first)));
            }
            read += 1;
        }
        let taken = whole - lines.0.len();
        stream.take(taken);
    }
    findings.extend(long.map(|(count, line)| ScanFinding::LongRows { count, line }));
    Ok(())
}

/// Adds a row; whether it has more than it needs. `None`: it has less, or a word that is no number.
fn row(text: &[u8], of: &[Option<(Role, Number)>], gather: &mut Gather) -> Option<bool> {
    let mut rest = text;
    let point = gather.push();
    for column in of {
        let (value, len) = cell(rest, Comma::Delimits);
        let value = value?;
        match column {
            Some((Role::Packed, _)) if value.is_nan() => {}
            // The bits of a float are the colour; a whole number is the colour itself.
            Some((Role::Packed, Number::F32 | Number::F64)) => gather.set_packed(point, (value as f32).to_bits()),
            Some((Role::Packed, _)) => gather.set_packed(point, value as i64 as u32),
            Some((role, _)) => gather.set(point, *role, value),
            None => {}
        }
        rest = rest[len..].trim_ascii_start();
    }
    Some(!rest.is_empty())
}
