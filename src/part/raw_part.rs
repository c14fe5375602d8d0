//! The facets of a part's file before welding, with what the reader has to say of the file: what was dropped, passed
//! over, joined or not read. All readers of [`super::file`] fill it.

use super::units::StatedUnit;
use serde::Serialize;

/// Corners of one facet as stored, file units.
pub type RawFacet = [[f32; 3]; 3];

/// What a file held, before welding.
#[derive(Debug, Default, PartialEq)]
pub struct RawPart {
    /// Usable facets in file order.
    pub facets: Vec<RawFacet>,
    /// Facets that were dropped: number in the file, byte offset, why.
    pub invalid: Vec<InvalidFacet>,
    /// Solids that became one part.
    pub solids: usize,
    /// Bytes that belong to nothing that is known.
    pub passed_over: Option<PassedOver>,
    /// A count of facets that is not true.
    pub count_differs: Option<CountDiffers>,
    /// What the file holds beside facets, and what of it is not read.
    pub unread: Vec<Unread>,
    /// The unit that the file states.
    pub stated_unit: Option<StatedUnit>,
    /// How its facets were made, where the file has none.
    pub meshed: Option<Meshed>,
}

impl RawPart {
    /// Keeps a facet of finite numbers; lists the others. The stored normal is not looked at.
    pub(super) fn push_checked(&mut self, facet: RawFacet, byte: usize) {
        match fault_of(facet.as_flattened()) {
            None => self.facets.push(facet),
            Some(fault) => self.push_invalid(fault, byte),
        }
    }

    /// Lists a facet that cannot be used.
    pub(super) fn push_invalid(&mut self, fault: FacetFault, byte: usize) {
        let facet = self.facets.len() + self.invalid.len();
        self.invalid.push(InvalidFacet { facet, byte, fault });
    }

    /// Notes that bytes are passed over.
    pub(super) fn pass_over(&mut self, count: usize, at: usize) {
        let before = self.passed_over.get_or_insert(PassedOver { count: 0, at });
        before.count += count;
    }

    /// Notes that something is not read, if there is any of it.
    pub(super) fn leave_unread(&mut self, what: UnreadKind, count: usize) {
        if count > 0 {
            self.unread.push(Unread { what, count });
        }
    }
}

/// What of coordinates is no length.
pub(super) fn fault_of(coordinates: &[f32]) -> Option<FacetFault> {
    if coordinates.iter().all(|x| x.is_finite()) {
        return None;
    }
    let nan = coordinates.iter().any(|x| x.is_nan());
    Some(if nan { FacetFault::Nan } else { FacetFault::Infinite })
}

/// Facets that were laid through the points of a scan. Lengths in the unit of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meshed {
    /// Points that they were laid through.
    pub points: usize,
    /// Points that were left out.
    pub dropped: usize,
    /// Side of the cells: what is smaller is not there.
    pub cell: f64,
    /// Root of the mean square of the points' distances to them.
    pub rms: f64,
    /// Whether outside was guessed, since the points have no normals.
    pub is_side_guessed: bool,
}

/// Bytes that were passed over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PassedOver {
    /// How many.
    pub count: usize,
    /// Where the first of them stands in the file.
    pub at: usize,
}

/// A count of facets that is not true.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CountDiffers {
    /// Facets by the header.
    pub promised: usize,
    /// Facets that were read.
    pub read: usize,
}

/// Something in a file that is not read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unread {
    /// What.
    pub what: UnreadKind,
    /// How many of it.
    pub count: usize,
}

/// What of a file is not read.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum UnreadKind {
    /// Lines of an OBJ file, and faces of two corners.
    Lines,
    /// Points of an OBJ file, and faces of one corner.
    Points,
    /// Curves and surfaces of an OBJ file that are given by formulas.
    FreeForm,
    /// Lines of an OBJ file that begin with a word that the format does not know.
    UnknownLines,
    /// Rows of a PLY element that is neither vertex nor face, by its name.
    Element(String),
    /// Objects of a 3MF file that its build does not name.
    ObjectsNotBuilt,
    /// Objects of a 3MF file that only hold others while they are printed.
    Supports,
    /// Beams of a 3MF file's lattices.
    LatticeBeams,
}

/// A dropped facet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct InvalidFacet {
    /// Number in the file, from 0.
    pub facet: usize,
    /// Where it stands in the file (in a 3MF file: in its model).
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
    /// It has fewer or more than three vertices; a polygon: fewer.
    NotThreeVertices,
    /// Its vertices lie in one point or on one line.
    NoArea,
    /// A polygon whose outline crosses itself.
    CrossesItself,
    /// A polygon of more corners than can be cut into triangles.
    TooManyCorners,
}
