//! Why the bytes of a file are no part. Sentences of it stand in `text`.

use super::fault::{ObjFault, PlyFault, ThreeMfFault};
use super::kind::FileKind;
use crate::part::raw_part::FacetFault;
use crate::progress::Cancelled;
use thiserror::Error;

/// Why a file cannot be used at all.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum PartFileError {
    /// The work was cancelled.
    #[error("cancelled")]
    Cancelled,
    /// Nothing in it.
    #[error("empty file")]
    Empty,
    /// It is something else, which is known.
    #[error("{}", .0.word())]
    Other(FileKind),
    /// It is nothing that is known.
    #[error("not a part")]
    Unknown,
    /// The header of a binary STL promises more facets than there are bytes.
    #[error("binary cut off: {promised} facets promised, {needed} bytes needed, {present} present")]
    CutOff {
        /// Facets by the header.
        promised: u64,
        /// Bytes those would need.
        needed: u64,
        /// Bytes there are.
        present: u64,
    },
    /// Behind the facets that a binary STL promises stand more, and then something that is none.
    #[error("{promised} facets promised, {more} more follow and then none")]
    CountDoubtful {
        /// Facets by the header.
        promised: usize,
        /// Facets behind those.
        more: usize,
    },
    /// A text STL without its `endsolid`.
    #[error("text cut off after {facets} facets, byte {byte}")]
    TextCutOff {
        /// Whole facets read before.
        facets: usize,
        /// Length of the file.
        byte: usize,
    },
    /// Numbers are written with a comma.
    #[error("decimal comma, byte {byte}")]
    DecimalComma {
        /// Where the first one stands.
        byte: usize,
    },
    /// Read, but nothing usable in it.
    #[error("no usable facet: {dropped} dropped, first: {first:?}")]
    NoFacet {
        /// Facets dropped.
        dropped: usize,
        /// What is wrong with the first; `None`: the file holds none.
        first: Option<FacetFault>,
    },
    /// Points without faces.
    #[error("{points} points, no face")]
    PointCloud {
        /// How many.
        points: usize,
    },
    /// An OBJ file that cannot be read.
    #[error("OBJ, line {line}: {fault:?}")]
    Obj {
        /// The line, from 1.
        line: usize,
        /// What is wrong there.
        fault: ObjFault,
    },
    /// A PLY file that cannot be read.
    #[error("PLY: {0:?}")]
    Ply(PlyFault),
    /// A 3MF file that cannot be read.
    #[error("3MF: {0:?}")]
    ThreeMf(ThreeMfFault),
}

impl From<PlyFault> for PartFileError {
    fn from(fault: PlyFault) -> Self {
        PartFileError::Ply(fault)
    }
}

impl From<ThreeMfFault> for PartFileError {
    fn from(fault: ThreeMfFault) -> Self {
        PartFileError::ThreeMf(fault)
    }
}

impl From<Cancelled> for PartFileError {
    fn from(_: Cancelled) -> PartFileError {
        PartFileError::Cancelled
    }
}
