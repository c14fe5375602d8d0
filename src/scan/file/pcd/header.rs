//! The header of a PCD file: its fields, how many points it has, and how they are written.

use crate::scan::file::number::Number;
use crate::scan::file::{PcdFault, ScanFileError};

/// How the points are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Data {
    Ascii,
    Binary,
    Compressed,
}

/// A field of each point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct PcdField {
    pub name: String,
    pub number: Number,
    /// Numbers that a point has of it.
    pub count: usize,
}

impl PcdField {
    /// Bytes that a point has of it.
    pub fn size(&self) -> usize {
        self.number.size() * self.count
    }
}

/// The header.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Header {
    pub fields: Vec<PcdField>,
    pub points: u64,
    pub data: Data,
    /// Whether the scanner stood elsewhere than at the origin.
    pub has_viewpoint: bool,
    /// Where the points begin in the file.
    pub body: usize,
    /// Lines before them.
    pub lines: u64,
}

/// Words that lines of a header begin with.
const WORDS: [&str; 12] =
    ["VERSION", "FIELDS", "COLUMNS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA", "#"];

/// Whether a file begins as PCD files do: comments apart, with a word of their header.
pub(in super::super) fn is_pcd(begin: &[u8]) -> bool {
    let mut lines = begin.split(|b| *b == b'\n').map(<[u8]>::trim_ascii).filter(|l| !l.is_empty());
    let first = lines.find(|l| l[0] != b'#').unwrap_or_default();
    let word = first.split(u8::is_ascii_whitespace).next().unwrap_or_default();
    WORDS.iter().any(|w| w.as_bytes() == word)
}

/// A field has at most so many numbers, and a header so many fields: none that is true has more.
const MOST: usize = 1 << 16;

/// Values of the header's lines as they stand.
#[derive(Default)]
struct Raw<'a> {
    names: Vec<&'a str>,
    sizes: Vec<&'a str>,
    types: Vec<&'a str>,
    counts: Vec<&'a str>,
    width: Option<u64>,
    height: Option<u64>,
    points: Option<u64>,
    has_viewpoint: bool,
}

impl Header {
    /// Reads the header that the bytes begin with.
    ///
    /// # Errors
    /// There is none, a line cannot be read, or counts contradict each other.
    pub fn of(bytes: &[u8]) -> Result<Header, ScanFileError> {
        let (mut at, mut line) = (0, 0);
        let mut raw = Raw::default();
        while let Some(len) = bytes[at..].iter().position(|b| *b == b'\n') {
            line += 1;
            let fault = || PcdFault::Line { line };
            let text = std::str::from_utf8(&bytes[at..at + len]).map_err(|_| fault())?;
            at += len + 1;
            let mut words = text.split_ascii_whitespace();
            let Some(word) = words.next() else { continue };
            let number = |word: Option<&str>| word.and_then(|w| w.parse().ok()).ok_or_else(fault);
            match word {
                _ if word.starts_with('#') => {}
                "VERSION" => {}
                "FIELDS" | "COLUMNS" => raw.names = words.collect(),
                "SIZE" => raw.sizes = words.collect(),
                "TYPE" => raw.types = words.collect(),
                "COUNT" => raw.counts = words.collect(),
                "WIDTH" => raw.width = Some(number(words.next())?),
                "HEIGHT" => raw.height = Some(number(words.next())?),
                "POINTS" => raw.points = Some(number(words.next())?),
                "VIEWPOINT" => {
                    let at: Vec<f64> = words.map(|w| w.parse().map_err(|_| fault())).collect::<Result<_, _>>()?;
                    raw.has_viewpoint = at != [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
                }
                "DATA" => {
                    let data = match words.next() {
                        Some("ascii") => Data::Ascii,
                        Some("binary") => Data::Binary,
                        Some("binary_compressed") => Data::Compressed,
                        _ => return Err(fault().into()),
                    };
                    return raw.header(data, at, line);
                }
                _ => return Err(fault().into()),
            }
        }
        Err(PcdFault::NoData.into())
    }

    /// Bytes of a point.
    pub fn stride(&self) -> usize {
        self.fields.iter().map(PcdField::size).sum()
    }

    /// Numbers of a point.
    pub fn columns(&self) -> usize {
        self.fields.iter().map(|f| f.count).sum()
    }
}

impl Raw<'_> {
    fn header(self, data: Data, body: usize, lines: u64) -> Result<Header, ScanFileError> {
        if self.names.len() > MOST {
            return Err(PcdFault::Line { line: lines }.into());
        }
        let mut fields = Vec::new();
        for (i, name) in self.names.iter().enumerate() {
            let fault = || PcdFault::Type { field: (*name).to_owned() };
            let count = match self.counts.get(i) {
                Some(word) => word.parse().ok().filter(|c| (1..=MOST).contains(c)).ok_or_else(fault)?,
                None if self.counts.is_empty() => 1,
                None => return Err(fault().into()),
            };
            let number = number(self.types.get(i), self.sizes.get(i)).ok_or_else(fault)?;
            fields.push(PcdField { name: (*name).to_owned(), number, count });
        }
        let grid = self.width.map(|w| w.saturating_mul(self.height.unwrap_or(1)));
        let points = match (self.points, grid) {
            (Some(points), Some(grid)) if points != grid => return Err(PcdFault::Counts { points, grid }.into()),
            (points, grid) => points.or(grid).ok_or(PcdFault::Line { line: lines })?,
        };
        Ok(Header { fields, points, data, has_viewpoint: self.has_viewpoint, body, lines })
    }
}

fn number(kind: Option<&&str>, size: Option<&&str>) -> Option<Number> {
    Some(match (*kind?, *size?) {
        ("F", "4") => Number::F32,
        ("F", "8") => Number::F64,
        ("I", "1") => Number::I8,
        ("I", "2") => Number::I16,
        ("I", "4") => Number::I32,
        ("I", "8") => Number::I64,
        ("U", "1") => Number::U8,
        ("U", "2") => Number::U16,
        ("U", "4") => Number::U32,
        ("U", "8") => Number::U64,
        _ => return None,
    })
}
