//! Compressed PCD: all numbers of the first field, then all of the next, unpacked and used up as they come.

use super::header::Header;
use super::lzf::{LONGEST_STEP, Unpacker};
use crate::scan::file::gather::Gather;
use crate::scan::file::number::Number;
use crate::scan::file::role::{Role, Roles};
use crate::scan::file::stream::{CHUNK, Stream};
use crate::scan::file::table::{Field, Table};
use crate::scan::file::{PcdFault, ScanFileError};

/// A copy of 264 bytes takes 3: no byte can become more.
const MOST_TIMES: u64 = 88;

/// Reads the points.
///
/// # Errors
/// They are not there, not of the promised size, or cannot be unpacked.
pub(super) fn read(
    header: &Header,
    roles: &Roles,
    stream: &mut Stream<'_>,
    gather: &mut Gather,
) -> Result<(), ScanFileError> {
    let stride = header.stride() as u64;
    let cut_off = |present| ScanFileError::CutOff { promised: header.points, present };
    if !stream.need(8)? {
        return Err(cut_off(0));
    }
    let [packed, unpacked] = [0, 4].map(|at| Number::U32.read(&stream.bytes()[at..], false) as u64);
    stream.take(8);
    let expected = header.points.saturating_mul(stride);
    if unpacked != expected {
        return Err(PcdFault::Size { header: expected, packed: unpacked }.into());
    }
    if packed > stream.remaining() {
        let share = stream.remaining() as f64 / packed as f64;
        return Err(cut_off((header.points as f64 * share) as u64));
    }
    if unpacked > packed.saturating_mul(MOST_TIMES) {
        return Err(PcdFault::Packed { byte: stream.place(0) }.into());
    }
    gather.reserve(header.points)?;
    let mut columns = Columns::new(header, roles);
    let mut unpacker = Unpacker::default();
    let mut left = packed;
    while left > 0 {
        stream.need((CHUNK as u64).min(left) as usize)?;
        let here = left.min(stream.bytes().len() as u64) as usize;
        let input = &stream.bytes()[..here];
        let is_last = here as u64 == left;
        let took = unpacker.unpack(input, is_last).filter(|t| *t > 0);
        let Some(took) = took else {
            // Where the file ends before its length says, the input is short, and not wrong.
            let is_short = stream.has_ended() && here <= LONGEST_STEP && !is_last;
            let fault = PcdFault::Packed { byte: stream.place(0) };
            return Err(if is_short { cut_off(columns.points_read()) } else { fault.into() });
        };
        stream.take(took);
        left -= took as u64;
        if unpacker.total > unpacked {
            return Err(PcdFault::Packed { byte: stream.place(0) }.into());
        }
        let used = columns.put(unpacker.bytes(), gather);
        unpacker.take(used);
    }
    if unpacker.total < unpacked {
        return Err(PcdFault::Packed { byte: stream.place(0) }.into());
    }
    Ok(())
}

/// Fields one behind the other, each with all its numbers.
struct Columns {
    /// Size of a point's share of a field, and what it is.
    fields: Vec<(usize, Option<Field>)>,
    points: usize,
    /// The field and the point that come next.
    next: (usize, usize),
    table: Table,
}

impl Columns {
    fn new(header: &Header, roles: &Roles) -> Columns {
        let field = |role: Option<Role>, number| role.map(|role| Field { at: 0, number, role });
        let fields = header.fields.iter().zip(&roles.of).map(|(f, role)| (f.size(), field(*role, f.number))).collect();
        let table = Table { fields: Vec::new(), stride: 0, is_big: false };
        Columns { fields, points: header.points as usize, next: (0, 0), table }
    }

    /// Takes whole numbers from the beginning; returns how many bytes they are.
    fn put(&mut self, bytes: &[u8], gather: &mut Gather) -> usize {
        let mut at = 0;
        while let Some((size, field)) = self.fields.get(self.next.0) {
            let whole = ((bytes.len() - at) / size).min(self.points - self.next.1);
            for (k, number) in bytes[at..at + whole * size].chunks_exact(*size).enumerate() {
                let Some(field) = field else { break };
                let point = self.next.1 + k;
                while gather.offsets.len() <= point {
                    gather.push();
                }
                self.table.put(gather, point, field, number);
            }
            at += whole * size;
            self.next.1 += whole;
            if self.next.1 < self.points {
                break;
            }
            self.next = (self.next.0 + 1, 0);
        }
        at
    }

    fn points_read(&self) -> u64 {
        if self.next.0 + 1 == self.fields.len() { self.next.1 as u64 } else { 0 }
    }
}
