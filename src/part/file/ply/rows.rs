//! The rows behind a PLY header: numbers of any type in any encoding, one after the other. Nothing is allocated that a
//! count promises and the file does not hold.

use super::super::number::has_decimal_comma;
use super::super::{PartFileError, PlyFault};
use super::header::{Element, Encoding, Header, Property, Scalar};

/// Why a row cannot be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowFault {
    /// The file ends.
    Ends,
    /// It is no number, or a list has less than no items.
    Value,
    /// A number is written with a comma.
    DecimalComma {
        /// Where it stands.
        byte: usize,
    },
}

impl RowFault {
    /// The fault with its place.
    pub fn told(self, element: &Element, row: u64) -> PartFileError {
        let name = || element.name.clone();
        match self {
            RowFault::Ends => PlyFault::CutOff { element: name(), promised: element.count }.into(),
            RowFault::Value => PlyFault::Value { element: name(), row }.into(),
            RowFault::DecimalComma { byte } => PartFileError::DecimalComma { byte },
        }
    }
}

/// Goes through the rows of a file.
pub struct Rows<'a> {
    bytes: &'a [u8],
    at: usize,
    encoding: Encoding,
}

impl<'a> Rows<'a> {
    /// Begins behind the header.
    pub fn new(bytes: &'a [u8], header: &Header) -> Rows<'a> {
        Rows { bytes, at: header.body, encoding: header.encoding }
    }

    /// Goes through rows that stand alone, a part of those behind a header.
    pub fn over(bytes: &'a [u8], encoding: Encoding) -> Rows<'a> {
        Rows { bytes, at: 0, encoding }
    }

    /// Where the next number begins in the file, or in the rows that stand alone.
    pub fn at(&self) -> usize {
        self.at
    }

    /// Where bytes begin that no row has, and how many there are; white space alone is none.
    pub fn left(&self) -> Option<(usize, usize)> {
        let rest = &self.bytes[self.at..];
        let first = rest.iter().position(|b| !b.is_ascii_whitespace())?;
        Some((self.at + first, rest.len() - first))
    }

    /// Passes over what these properties have in a row.
    ///
    /// # Errors
    /// It is not there.
    pub fn skip(&mut self, properties: &[Property]) -> Result<(), RowFault> {
        for p in properties {
            let items = p.list.map_or(Ok(1), |count| self.count(count))?;
            match self.encoding {
                Encoding::Ascii => (0..items).try_for_each(|_| self.word().map(|_| ()))?,
                _ => {
                    self.take(items.checked_mul(p.scalar.size()).ok_or(RowFault::Ends)?)?;
                }
            }
        }
        Ok(())
    }

    /// The numbers of a row, one for each property; lists are skipped and stand as NaN.
    ///
    /// # Errors
    /// One is not there, or no number.
    pub fn values(&mut self, properties: &[Property], into: &mut Vec<f64>) -> Result<(), RowFault> {
        into.clear();
        for p in properties {
            if p.list.is_some() {
                self.skip(std::slice::from_ref(p))?;
                into.push(f64::NAN);
            } else {
                into.push(self.number(p.scalar)?);
            }
        }
        Ok(())
    }

    /// Adds the numbers of a list.
    ///
    /// # Errors
    /// One is not there, or no number.
    pub fn list(&mut self, property: &Property, into: &mut Vec<f64>) -> Result<(), RowFault> {
        let items = property.list.map_or(Ok(1), |count| self.count(count))?;
        (0..items).try_for_each(|_| self.number(property.scalar).map(|n| into.push(n)))
    }

    fn count(&mut self, scalar: Scalar) -> Result<usize, RowFault> {
        let n = self.number(scalar)?;
        if n >= 0.0 && n.fract() == 0.0 { Ok(n as usize) } else { Err(RowFault::Value) }
    }

    fn number(&mut self, scalar: Scalar) -> Result<f64, RowFault> {
        if self.encoding == Encoding::Ascii {
            let (byte, word) = self.word()?;
            if has_decimal_comma(word) {
                return Err(RowFault::DecimalComma { byte });
            }
            return std::str::from_utf8(word).ok().and_then(|w| w.parse().ok()).ok_or(RowFault::Value);
        }
        let mut b = [0; 8];
        let taken = self.take(scalar.size())?;
        b[..taken.len()].copy_from_slice(taken);
        if self.encoding == Encoding::Big {
            b[..scalar.size()].reverse();
        }
        let [b0, b1, b2, b3, ..] = b;
        Ok(match scalar {
            Scalar::I8 => f64::from(i8::from_le_bytes([b0])),
            Scalar::U8 => f64::from(b0),
            Scalar::I16 => f64::from(i16::from_le_bytes([b0, b1])),
            Scalar::U16 => f64::from(u16::from_le_bytes([b0, b1])),
            Scalar::I32 => f64::from(i32::from_le_bytes([b0, b1, b2, b3])),
            Scalar::U32 => f64::from(u32::from_le_bytes([b0, b1, b2, b3])),
            Scalar::F32 => f64::from(f32::from_le_bytes([b0, b1, b2, b3])),
            Scalar::F64 => f64::from_le_bytes(b),
        })
    }

    fn take(&mut self, count: usize) -> Result<&'a [u8], RowFault> {
        let end = self.at.checked_add(count).ok_or(RowFault::Ends)?;
        let taken = self.bytes.get(self.at..end).ok_or(RowFault::Ends)?;
        self.at = end;
        Ok(taken)
    }

    fn word(&mut self) -> Result<(usize, &'a [u8]), RowFault> {
        let rest = &self.bytes[self.at..];
        let begin = rest.iter().position(|b| !b.is_ascii_whitespace()).ok_or(RowFault::Ends)?;
        let len = rest[begin..].iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len() - begin);
        let byte = self.at + begin;
        self.at = byte + len;
        Ok((byte, &rest[begin..begin + len]))
    }
}
