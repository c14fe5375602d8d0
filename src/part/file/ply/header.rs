//! The header of a PLY file: its encoding, and its elements with their properties. It names them all, so a file can be
//! read without knowing what they mean.

use super::super::PlyFault;

/// How the rows behind the header are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Words.
    Ascii,
    /// Bytes, the lowest first.
    Little,
    /// Bytes, the highest first.
    Big,
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scalar {
    /// Signed, one byte.
    I8,
    /// Unsigned, one byte.
    U8,
    /// Signed, two bytes.
    I16,
    /// Unsigned, two bytes.
    U16,
    /// Signed, four bytes.
    I32,
    /// Unsigned, four bytes.
    U32,
    /// Floating point, four bytes.
    F32,
    /// Floating point, eight bytes.
    F64,
}

impl Scalar {
    /// The type of a word of the header.
    fn of(word: &str) -> Option<Scalar> {
        Some(match word {
            "char" | "int8" => Scalar::I8,
            "uchar" | "uint8" => Scalar::U8,
            "short" | "int16" => Scalar::I16,
            "ushort" | "uint16" => Scalar::U16,
            "int" | "int32" => Scalar::I32,
            "uint" | "uint32" => Scalar::U32,
            "float" | "float32" => Scalar::F32,
            "double" | "float64" => Scalar::F64,
            _ => return None,
        })
    }

    /// Bytes of a number.
    pub fn size(self) -> usize {
        match self {
            Scalar::I8 | Scalar::U8 => 1,
            Scalar::I16 | Scalar::U16 => 2,
            Scalar::I32 | Scalar::U32 | Scalar::F32 => 4,
            Scalar::F64 => 8,
        }
    }
}

/// What each row of an element has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Property {
    /// Its name.
    pub name: String,
    /// The type of its number, or of those of its list.
    pub scalar: Scalar,
    /// The type of a list's count; `None`: it is one number.
    pub list: Option<Scalar>,
}

/// Rows of one kind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Element {
    /// Its name.
    pub name: String,
    /// How many rows there are, as the header says.
    pub count: u64,
    /// What each has, in order.
    pub properties: Vec<Property>,
}

/// The header.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Header {
    /// How the rows are written.
    pub encoding: Encoding,
    /// The elements, in the order of their rows.
    pub elements: Vec<Element>,
    /// Where the rows begin in the file.
    pub body: usize,
}

impl Header {
    /// Reads the header of a file.
    ///
    /// # Errors
    /// [`PlyFault::HeaderLine`], [`PlyFault::NoHeaderEnd`].
    pub fn of(bytes: &[u8]) -> Result<Header, PlyFault> {
        let mut lines = Lines { bytes, at: if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 }, number: 0 };
        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        if lines.next().ok_or(PlyFault::NoHeaderEnd)? != "ply" {
            return Err(PlyFault::HeaderLine { line: 1 });
        }
        loop {
            let line = lines.next().ok_or(PlyFault::NoHeaderEnd)?;
            let fault = PlyFault::HeaderLine { line: lines.number };
            let words: Vec<&str> = line.split_ascii_whitespace().collect();
            match words[..] {
                [] | ["comment" | "obj_info", ..] => {}
                ["format", word, _] => encoding = Some(encoding_of(word).ok_or(fault)?),
                ["element", name, count] => {
                    let count = count.parse().map_err(|_| fault.clone())?;
                    if elements.iter().any(|e| e.name == name) {
                        return Err(fault);
                    }
                    elements.push(Element { name: name.into(), count, properties: Vec::new() });
                }
                ["property", ref rest @ ..] => {
                    let property = property_of(rest).ok_or_else(|| fault.clone())?;
                    elements.last_mut().ok_or(fault)?.properties.push(property);
                }
                ["end_header"] => {
                    let encoding = encoding.ok_or(fault)?;
                    return Ok(Header { encoding, elements, body: lines.at });
                }
                _ => return Err(fault),
            }
        }
    }

    /// Looks whether a file of so many bytes has room for what the header promises.
    ///
    /// # Errors
    /// [`PlyFault::CutOff`] with the first element that has none.
    pub fn check_size(&self, bytes: usize) -> Result<(), PlyFault> {
        let mut room = (bytes - self.body) as u64;
        for e in &self.elements {
            let least = |p: &Property| match (self.encoding, p.list) {
                // A digit and what divides it from the next; the last one may end the file.
                (Encoding::Ascii, _) => 2,
                (_, None) => p.scalar.size() as u64,
                (_, Some(count)) => count.size() as u64,
            };
            let row: u64 = e.properties.iter().map(least).sum();
            let needed = row.saturating_mul(e.count);
            if needed > room.saturating_add(1) || (row == 0 && e.count > 0) {
                return Err(PlyFault::CutOff { element: e.name.clone(), promised: e.count });
            }
            room = room.saturating_sub(needed);
        }
        Ok(())
    }
}

fn encoding_of(word: &str) -> Option<Encoding> {
    match word {
        "ascii" => Some(Encoding::Ascii),
        "binary_little_endian" => Some(Encoding::Little),
        "binary_big_endian" => Some(Encoding::Big),
        _ => None,
    }
}

fn property_of(words: &[&str]) -> Option<Property> {
    let (scalar, list, name) = match words {
        ["list", count, item, name] => (Scalar::of(item)?, Some(Scalar::of(count)?), name),
        [scalar, name] => (Scalar::of(scalar)?, None, name),
        _ => return None,
    };
    Some(Property { name: (*name).into(), scalar, list })
}

/// Lines of the header. Where the first one ends with a carriage return alone, all do: a line feed behind the last
/// one belongs to the rows.
struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    number: usize,
}

impl Lines<'_> {
    fn ends_with_cr(&self) -> bool {
        let first = self.bytes.iter().position(|b| matches!(b, b'\n' | b'\r'));
        first.is_some_and(|end| self.bytes[end] == b'\r' && self.bytes.get(end + 1) != Some(&b'\n'))
    }
}

/// No line of a header is longer: behind a mark alone there may be gigabytes of anything.
const LONGEST: usize = 1 << 16;

impl Iterator for Lines<'_> {
    type Item = String;

    fn next(&mut self) -> Option<String> {
        let end = if self.ends_with_cr() { b'\r' } else { b'\n' };
        let rest = &self.bytes[self.at..];
        let len = rest.iter().take(LONGEST).position(|b| *b == end)?;
        self.at += len + 1;
        self.number += 1;
        Some(String::from_utf8_lossy(rest[..len].trim_ascii()).into_owned())
    }
}
