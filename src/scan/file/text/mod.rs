//! Clouds as text: XYZ, TXT, CSV, PTS. What the columns are, and what divides them, is told by the beginning
//! ([`layout`]); then all rows are read alike. A line with one whole number, as PTS files have at their beginning, is
//! a count of points.

mod layout;
mod row;

pub(super) use row::{Row, is_comment};

use super::gather::{ColourScale, Gather, Has};
use super::role::Role;
use super::stream::{Lines, Stream};
use super::{Found, ScanFileError, ScanFinding};
use layout::Layout;

/// Lines that something is wrong with.
#[derive(Clone, Copy, Default)]
struct Tally {
    count: u64,
    first: u64,
}

impl Tally {
    fn add(&mut self, line: u64) {
        if self.count == 0 {
            self.first = line;
        }
        self.count += 1;
    }

    fn finding(self, of: fn(u64, u64) -> ScanFinding) -> Option<ScanFinding> {
        (self.count > 0).then(|| of(self.count, self.first))
    }
}

/// What is counted while rows are read.
#[derive(Default)]
struct Reading {
    line: u64,
    rows: u64,
    promised: Option<u64>,
    short: Tally,
    long: Tally,
    no_rows: Tally,
}

/// Reads a text as a cloud. `name` tells what columns without names are, where its ending says so.
///
/// # Errors
/// It has no rows of three numbers, or names columns and x, y and z are none of them.
pub(super) fn read(name: &str, stream: &mut Stream<'_>) -> Result<Found, ScanFileError> {
    let first = stream.lines()?;
    let layout = Layout::of(&stream.bytes()[..first], name)?;
    let has = Has::of(&layout.roles);
    let mut gather = Gather::new(has, layout.scale, false);
    // Room for as many rows as there would be if all were as long as those read so far, but no more than there can be.
    let bytes_per_row = first as u64 / layout.lines_seen.max(1);
    gather.reserve(stream.remaining() / bytes_per_row.max(2 * layout.width as u64) + 1)?;
    let mut reading = Reading::default();
    loop {
        let whole = stream.lines()?;
        if whole == 0 {
            break;
        }
        for line in Lines(&stream.bytes()[..whole]) {
            reading.line += 1;
            reading.take(line, &layout, &mut gather)?;
        }
        stream.take(whole);
    }
    let findings = reading.findings(&layout);
    Ok(Found { gather, findings, invalid: 0, stated_unit: None })
}

impl Reading {
    #[inline]
    fn take(&mut self, line: &[u8], layout: &Layout, gather: &mut Gather) -> Result<(), ScanFileError> {
        if self.line == layout.names_line || is_comment(line) {
            return Ok(());
        }
        let row = Row::of(line, layout.comma);
        if row.width == 0 {
            return Ok(());
        }
        if let (Some(count), true) = (row.count(), layout.width > 1) {
            self.promised = Some(self.promised.unwrap_or(0).saturating_add(count));
            return Ok(());
        }
        if layout.places.iter().any(|&column| !row.is_number(column)) {
            // A row that ends early is told apart from a line of words.
            let is_short = row.width < layout.width && row.words == 0;
            if is_short {
                self.short.add(self.line)
            } else {
                self.no_rows.add(self.line)
            }
            return Ok(());
        }
        if row.width < layout.width {
            self.short.add(self.line);
            return Ok(());
        }
        if row.width > layout.width {
            self.long.add(self.line);
        }
        self.rows += 1;
        if gather.offsets.len() == gather.offsets.capacity() {
            gather.reserve(1 + gather.offsets.len() as u64 / 4)?;
        }
        let point = gather.push();
        for &(column, role) in &layout.columns {
            if row.is_number(column) {
                gather.set(point, role, row.values[column]);
            }
        }
        Ok(())
    }

    fn findings(&self, layout: &Layout) -> Vec<ScanFinding> {
        let mut out = Vec::new();
        let promised = self.promised.filter(|p| *p != self.rows);
        out.extend(promised.map(|promised| ScanFinding::CountDiffers { promised, read: self.rows }));
        out.extend(self.short.finding(|count, line| ScanFinding::ShortRows { count, line }));
        out.extend(self.long.finding(|count, line| ScanFinding::LongRows { count, line }));
        out.extend(self.no_rows.finding(|count, line| ScanFinding::LinesPassedOver { count, line }));
        out.extend(layout.assumed.map(|columns| ScanFinding::ColumnsAssumed { columns }));
        out.extend(layout.has_decimal_commas.then_some(ScanFinding::DecimalCommas));
        let names = &layout.roles.unread;
        out.extend((!names.is_empty()).then(|| ScanFinding::ColumnsNotRead { names: names.clone() }));
        out
    }
}

/// How colours of a text are meant: whole numbers as they are, fractions until one above 1 is found.
fn scale(has_fractions: bool) -> ColourScale {
    if has_fractions { ColourScale::Fractions } else { ColourScale::Bytes }
}

/// The columns of x, y and z.
fn places(roles: &[Option<Role>]) -> [usize; 3] {
    std::array::from_fn(|axis| roles.iter().position(|r| *r == Some(Role::Place(axis))).unwrap_or(usize::MAX))
}
