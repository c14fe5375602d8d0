//! The binary form of STL: a header of 80 bytes, a count, and 50 bytes a facet, the last two of which count bytes that
//! follow it. Few programs let any follow, and many keep a colour there instead, so how a file is laid out is decided
//! by what makes it come out to its end.

use super::super::PartFileError;
use super::words;
use crate::part::raw_part::{CountDiffers, RawFacet, RawPart};
use crate::progress::{Cancelled, Progress};
use std::ops::Range;

const HEADER: usize = 84;
const RECORD: usize = 50;

/// Solids one behind the other.
pub(super) struct Solids {
    /// Where each begins, and its facets.
    list: Vec<(usize, usize)>,
    /// Whether the last two bytes of a facet count bytes that follow.
    payload: bool,
    /// Where the last one ends.
    pub end: usize,
}

fn u16_at(bytes: &[u8], at: usize) -> Option<usize> {
    Some(usize::from(u16::from_le_bytes(bytes.get(at..at + 2)?.try_into().ok()?)))
}

fn count_at(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(at + 80..at + HEADER)?.try_into().ok()?))
}

/// Where the record ends that begins at `at`.
fn end_of_record(bytes: &[u8], at: usize, payload: bool) -> Option<usize> {
    let more = if payload { u16_at(bytes, at + RECORD - 2)? } else { 0 };
    Some(at + RECORD + more).filter(|end| *end <= bytes.len())
}

/// Where the solid ends that begins at `at`, and its facets; `None`: it has none, or not all of them are there.
fn end_of_solid(bytes: &[u8], at: usize, payload: bool) -> Option<(usize, usize)> {
    let count = count_at(bytes, at)? as usize;
    let plain = count.checked_mul(RECORD)?.checked_add(at + HEADER)?;
    if count == 0 || plain > bytes.len() {
        return None;
    }
    if !payload {
        return Some((plain, count));
    }
    let end = (0..count).try_fold(at + HEADER, |record, _| end_of_record(bytes, record, true))?;
    Some((end, count))
}

/// Solids from `at` on, as far as the next one in text form, to the end of the file, or so near to it that no facet
/// has room behind them.
pub(super) fn solids(bytes: &[u8], at: usize) -> Option<Solids> {
    let [plain, payload] = [false, true].map(|payload| chain(bytes, at, payload));
    let is_whole = |s: &Solids| s.end == bytes.len() || words::begins(&bytes[s.end..]);
    match (plain, payload) {
        (Some(plain), Some(payload)) if !is_whole(&plain) && is_whole(&payload) => Some(payload),
        (plain, payload) => plain.or(payload),
    }
}

fn chain(bytes: &[u8], mut at: usize, payload: bool) -> Option<Solids> {
    let mut list = Vec::new();
    loop {
        let rest = bytes.len().checked_sub(at)?;
        if !list.is_empty() && (rest < RECORD || words::begins(&bytes[at..])) {
            return Some(Solids { list, payload, end: at });
        }
        let (end, count) = end_of_solid(bytes, at, payload)?;
        list.push((at, count));
        at = end;
    }
}

/// Reads solids.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub(super) fn read_solids(
    bytes: &[u8],
    found: &Solids,
    part: &mut RawPart,
    progress: &Progress,
) -> Result<(), Cancelled> {
    for (begin, count) in &found.list {
        part.solids += 1;
        let mut at = begin + HEADER;
        for record in 0..*count {
            progress.check_at(record)?;
            push_record(bytes, at, part);
            let Some(end) = end_of_record(bytes, at, found.payload) else { break };
            at = end;
        }
    }
    Ok(())
}

fn push_record(bytes: &[u8], at: usize, part: &mut RawPart) {
    let Some(record) = bytes.get(at..at + RECORD) else { return };
    let numbers = numbers(record);
    let facet: RawFacet = std::array::from_fn(|v| std::array::from_fn(|c| numbers[3 + 3 * v + c]));
    part.push_checked(facet, at);
}

/// Normal and corners of a record.
fn numbers(record: &[u8]) -> [f32; 12] {
    let number = |k: usize| std::array::from_fn(|i| record[4 * k + i]);
    std::array::from_fn(|k| f32::from_le_bytes(number(k)))
}

/// Reads a file of one solid that does not come out to its end: behind the facets that its header promises stands
/// something else, and if that is facets they belong to the part.
///
/// # Errors
/// Fewer facets than promised, or bytes behind them of which only some are facets; [`PartFileError::Cancelled`] when
/// `progress` says so.
pub(super) fn read_uneven(bytes: &[u8], part: &mut RawPart, progress: &Progress) -> Result<(), PartFileError> {
    let promised = count_at(bytes, 0).ok_or(PartFileError::Unknown)?;
    let needed = HEADER as u64 + RECORD as u64 * u64::from(promised);
    let present = bytes.len() as u64;
    if needed > present && is_text(bytes) {
        return Err(PartFileError::Unknown);
    }
    if needed > present || has_payload(bytes, promised as usize) {
        return Err(PartFileError::CutOff { promised: u64::from(promised), needed, present });
    }
    let (promised, end) = (promised as usize, needed as usize);
    let records = bytes[end..].chunks_exact(RECORD);
    let whole = records.len();
    let reach = most(bytes, HEADER..end);
    let more = records.take_while(|r| is_facet(r, reach)).count();
    if more > 0 && more < whole {
        return Err(PartFileError::CountDoubtful { promised, more });
    }
    let read = promised + more;
    part.solids = 1;
    for k in 0..read {
        progress.check_at(k)?;
        push_record(bytes, HEADER + RECORD * k, part);
    }
    if more > 0 {
        part.count_differs = Some(CountDiffers { promised, read });
    }
    let end = HEADER + RECORD * read;
    if end < bytes.len() {
        part.pass_over(bytes.len() - end, end);
    }
    Ok(())
}

/// Whether bytes are words: they have no counts.
fn is_text(bytes: &[u8]) -> bool {
    bytes.iter().take(4096).all(|b| *b >= b' ' || b.is_ascii_whitespace())
}

/// So many facets in a row that are followed by as many bytes as each of them says tell a file of attribute bytes.
const TOLD_BY: usize = 3;

/// Whether attribute bytes follow the facets of a file that ends before all of them were there.
fn has_payload(bytes: &[u8], promised: usize) -> bool {
    let Some(first) = u16_at(bytes, HEADER + RECORD - 2).filter(|n| *n > 0) else { return false };
    let at = |k: usize| HEADER + (RECORD + first) * k;
    promised >= TOLD_BY && (1..TOLD_BY).all(|k| u16_at(bytes, at(k) + RECORD - 2) == Some(first))
}

/// The farthest coordinate of records, file units.
fn most(bytes: &[u8], records: Range<usize>) -> f32 {
    let corners = |r: &[u8]| numbers(r)[3..].iter().fold(0.0f32, |m, x| if x.is_finite() { m.max(x.abs()) } else { m });
    bytes[records].chunks_exact(RECORD).map(corners).fold(0.0, f32::max)
}

/// Whether 50 bytes are a facet of a part that reaches so far: bytes of anything else, read as numbers, are mostly far
/// larger than any part (letters are 1e20 and more), or all of them far smaller than it (digits and blanks are 1e-4 and
/// less). `reach` 0: nothing is known of the part.
fn is_facet(record: &[u8], reach: f32) -> bool {
    // Behind known facets a part may go on ten times as far; without any, planets end before 1e10 mm.
    let (most, least) = if reach > 0.0 { (10.0 * reach, 1e-3 * reach) } else { (1e10, 1e-3) };
    // Noise about zero is smaller than a single digit of any part, but not so small that it could not be added to it.
    let is_up_to = |x: f32, most: f32| x == 0.0 || (1e-30..=most).contains(&x.abs());
    let numbers = numbers(record);
    let (normal, corners) = numbers.split_at(3);
    // Some programs write normals as long as the facet is large, or none that is a number.
    normal.iter().all(|x| x.is_nan() || is_up_to(*x, 1e15))
        && corners.iter().all(|x| is_up_to(*x, most))
        && corners.iter().any(|x| x.abs() >= least)
}
