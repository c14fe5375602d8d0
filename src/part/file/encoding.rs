//! Text in UTF-16, as some systems save it, taken as single bytes. Formats of parts are ASCII but for names, which
//! nobody needs: each unit that is not ASCII becomes a question mark, so places in the file stay known.

use super::PartFileError;
use crate::part::raw_part::RawPart;

/// How a text is UTF-16.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Utf16Form {
    /// Bytes before the first unit.
    pub begin: usize,
    /// The high byte comes first.
    pub is_big: bool,
}

impl Utf16Form {
    /// The form, if the bytes are such a text: by their mark, or where every other byte of the beginning is zero and
    /// no other.
    pub fn of(bytes: &[u8]) -> Option<Utf16Form> {
        let (begin, is_big) = match bytes {
            [0xff, 0xfe, ..] => (2, false),
            [0xfe, 0xff, ..] => (2, true),
            _ => (0, is_unmarked(bytes)?),
        };
        Some(Utf16Form { begin, is_big })
    }

    /// Its units as single bytes; half a unit at the end is none.
    pub fn ascii(self, units: &[u8]) -> impl Iterator<Item = u8> + '_ {
        units.chunks_exact(2).map(move |pair| match (pair[usize::from(!self.is_big)], pair[usize::from(self.is_big)]) {
            (0, low) if low.is_ascii() => low,
            _ => b'?',
        })
    }
}

/// A text that was UTF-16.
pub(super) struct Utf16 {
    /// Its units as single bytes.
    pub ascii: Vec<u8>,
    /// Bytes before the first unit.
    begin: usize,
}

impl Utf16 {
    /// The text, if the bytes are one.
    pub fn of(bytes: &[u8]) -> Option<Utf16> {
        let form = Utf16Form::of(bytes)?;
        Some(Utf16 { ascii: form.ascii(&bytes[form.begin..]).collect(), begin: form.begin })
    }

    /// What was read of the text, with its places as they are in the file.
    pub fn in_file(&self, read: Result<RawPart, PartFileError>) -> Result<RawPart, PartFileError> {
        let place = |at: usize| self.begin + 2 * at;
        let told = |e| match e {
            PartFileError::TextCutOff { facets, byte } => PartFileError::TextCutOff { facets, byte: place(byte) },
            PartFileError::DecimalComma { byte } => PartFileError::DecimalComma { byte: place(byte) },
            other => other,
        };
        let mut part = read.map_err(told)?;
        for dropped in &mut part.invalid {
            dropped.byte = place(dropped.byte);
        }
        if let Some(over) = &mut part.passed_over {
            (over.count, over.at) = (2 * over.count, place(over.at));
        }
        Ok(part)
    }
}

/// So many characters tell UTF-16 without a mark.
const TOLD_BY: usize = 16;

/// Whether bytes without a mark are UTF-16 with the high byte first; `None`: they are no UTF-16.
fn is_unmarked(bytes: &[u8]) -> Option<bool> {
    let begin = bytes.get(..2 * TOLD_BY)?;
    let is_character = |b: u8| b.is_ascii_graphic() || b.is_ascii_whitespace();
    let all = |high: usize| begin.chunks_exact(2).all(|pair| pair[high] == 0 && is_character(pair[1 - high]));
    if all(0) { Some(true) } else { all(1).then_some(false) }
}
