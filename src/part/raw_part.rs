//! The facets of an STL file before welding, what is wrong with those that were dropped, and why a file cannot be
//! used at all. Both readers fill it: [`super::stl`] for the binary form, `stl_text` for the text form.

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
    pub format: StlFormat,
    /// Solids in a text file (1 in a binary one).
    pub solids: usize,
    /// Bytes behind the last facet of a binary file.
    pub tail_bytes: usize,
}

impl RawPart {
    /// Keeps a facet of finite numbers; lists the others. The stored normal is not looked at.
    pub(super) fn push_checked(&mut self, facet: RawFacet, number: usize, byte: usize) {
        if facet.as_flattened().iter().all(|x| x.is_finite()) {
            self.facets.push(facet);
            return;
        }
        let nan = facet.as_flattened().iter().any(|x| x.is_nan());
        let fault = if nan { FacetFault::Nan } else { FacetFault::Infinite };
        self.invalid.push(InvalidFacet { facet: number, byte, fault });
    }
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
pub enum StlFormat {
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
