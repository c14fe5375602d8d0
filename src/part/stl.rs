//! Reads STL files as CAD systems really write them.
//!
//! Binary is told from text by the length, not by the first word: SolidWorks starts binary headers
//! with `solid `. Facets with a NaN or infinite corner are dropped and counted; a file that is cut
//! off is refused. Writing is left to `stl_io`.

use super::stl_text;
use serde::Serialize;
use thiserror::Error;

/// Corners of one facet as stored, file units.
pub type RawFacet = [[f32; 3]; 3];

/// What a file held, before welding.
#[derive(Debug, Default, PartialEq)]
pub struct RawPart {
    /// Usable facets in file order.
    pub facets: Vec<RawFacet>,
    /// Facets that were dropped: number in the file, byte offset, why.
    pub invalid: Vec<InvalidFacet>,
    /// Text or binary.
    pub form: Form,
    /// Solids in a text file (1 in a binary one).
    pub solids: usize,
    /// Bytes behind the last facet of a binary file.
    pub tail_bytes: usize,
}

/// A dropped facet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct InvalidFacet {
    /// Number in the file, from 0.
    pub facet: usize,
    /// Where it stands in the file.
    pub byte: usize,
    /// What is wrong with it.
    pub fault: FacetFault,
}

/// Why a facet cannot be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum FacetFault {
    /// A coordinate is no number (NaN).
    Nan,
    /// A coordinate is infinite.
    Infinite,
    /// A coordinate's text cannot be read as a number.
    Unreadable,
    /// The next facet begins, or the solid ends, before its `endfacet`.
    NoEnd,
    /// It has fewer or more than three vertices.
    NotThreeVertices,
    /// Its vertices lie in one point or on one line.
    NoArea,
}

/// Form of an STL file.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// 84 bytes, then 50 a facet.
    #[default]
    Binary,
    /// `solid … facet normal … vertex …`.
    Text,
}

/// Why a file cannot be used at all.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum StlError {
    /// Nothing in it.
    #[error("empty file")]
    Empty,
    /// The header promises more facets than there are bytes.
    #[error("binary cut off: {promised} facets promised, {needed} bytes needed, {present} present")]
    CutOff {
        /// Facets by the header.
        promised: u64,
        /// Bytes those would need.
        needed: u64,
        /// Bytes there are.
        present: u64,
    },
    /// A text without its `endsolid`.
    #[error("text cut off after {facets} facets, byte {byte}")]
    TextCutOff {
        /// Whole facets read before.
        facets: usize,
        /// Length of the file.
        byte: usize,
    },
    /// Neither form.
    #[error("not an STL file")]
    NotStl,
    /// Read, but nothing usable in it.
    #[error("no usable facet: {dropped} dropped, first: {first:?}")]
    NoFacet {
        /// Facets dropped.
        dropped: usize,
        /// What is wrong with the first; `None`: the file holds none.
        first: Option<FacetFault>,
    },
}

const HEADER: usize = 84;
const RECORD: usize = 50;

/// Parses the bytes of an STL file.
pub fn read(bytes: &[u8]) -> Result<RawPart, StlError> {
    if bytes.is_empty() {
        return Err(StlError::Empty);
    }
    let promised = bytes.get(80..HEADER).map(|c| u64::from(u32::from_le_bytes([c[0], c[1], c[2], c[3]])));
    let needed = promised.map(|n| HEADER as u64 + RECORD as u64 * n);
    let present = bytes.len() as u64;
    // A text's bytes 80–84, read as a count, promise more than 150 million facets: never fits.
    let part = match (promised, needed) {
        (Some(n), Some(needed)) if needed <= present => read_binary(bytes, n as usize),
        _ if stl_text::looks_like_text(bytes) => stl_text::read(bytes)?,
        (Some(promised), Some(needed)) => return Err(StlError::CutOff { promised, needed, present }),
        _ => return Err(StlError::NotStl),
    };
    if part.facets.is_empty() {
        let first = part.invalid.first().map(|i| i.fault);
        return Err(StlError::NoFacet { dropped: part.invalid.len(), first });
    }
    Ok(part)
}

fn read_binary(bytes: &[u8], count: usize) -> RawPart {
    let end = HEADER + RECORD * count;
    let mut part = RawPart { solids: 1, tail_bytes: bytes.len() - end, ..Default::default() };
    part.facets.reserve_exact(count);
    for (i, record) in bytes[HEADER..end].chunks_exact(RECORD).enumerate() {
        let number = |k: usize| {
            let at = 12 + 4 * k;
            f32::from_le_bytes([record[at], record[at + 1], record[at + 2], record[at + 3]])
        };
        let facet: RawFacet = std::array::from_fn(|v| std::array::from_fn(|c| number(3 * v + c)));
        push_checked(&mut part, facet, i, HEADER + RECORD * i);
    }
    part
}

/// Keeps a facet of finite numbers; lists the others. The stored normal is not looked at.
pub(super) fn push_checked(part: &mut RawPart, facet: RawFacet, number: usize, byte: usize) {
    if facet.as_flattened().iter().all(|x| x.is_finite()) {
        part.facets.push(facet);
        return;
    }
    let nan = facet.as_flattened().iter().any(|x| x.is_nan());
    let fault = if nan { FacetFault::Nan } else { FacetFault::Infinite };
    part.invalid.push(InvalidFacet { facet: number, byte, fault });
}

#[cfg(test)]
mod tests {
    use super::*;

    fn binary(header: &[u8], count: u32, facets: &[RawFacet]) -> Vec<u8> {
        let mut b = vec![0u8; 80];
        b[..header.len()].copy_from_slice(header);
        b.extend(count.to_le_bytes());
        for f in facets {
            b.extend([0u8; 12]);
            b.extend(f.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
            b.extend([0u8; 2]);
        }
        b
    }

    const F: RawFacet = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    #[test]
    fn binary_whose_header_says_solid() {
        let part = read(&binary(b"solid made by a CAD system", 2, &[F, F])).expect("reads");
        assert_eq!((part.form, part.facets), (Form::Binary, vec![F, F]));
    }

    #[test]
    fn a_tail_behind_the_last_facet_is_tolerated() {
        let mut b = binary(b"x", 1, &[F]);
        b.extend([7u8; 33]);
        let part = read(&b).expect("reads");
        assert_eq!((part.facets.len(), part.tail_bytes), (1, 33));
    }

    #[test]
    fn four_billion_promised_facets_are_refused_at_once() {
        let b = binary(b"x", u32::MAX, &[F]);
        assert!(matches!(read(&b), Err(StlError::CutOff { promised: 4_294_967_295, present: 134, .. })));
    }

    #[test]
    fn nan_is_dropped_and_said_and_all_nan_refused() {
        let mut bad = F;
        bad[1][2] = f32::NAN;
        let part = read(&binary(b"x", 2, &[bad, F])).expect("reads");
        assert_eq!(part.facets, vec![F]);
        assert_eq!(part.invalid, vec![InvalidFacet { facet: 0, byte: 84, fault: FacetFault::Nan }]);
        assert!(matches!(read(&binary(b"x", 1, &[bad])), Err(StlError::NoFacet { dropped: 1, .. })));
    }

    #[test]
    fn what_is_no_stl() {
        assert_eq!(read(b""), Err(StlError::Empty));
        assert_eq!(read(b"\xff\xd8\xff\xe0 JFIF"), Err(StlError::NotStl));
        assert!(matches!(read(&binary(b"x", 0, &[])), Err(StlError::NoFacet { .. })));
    }
}
