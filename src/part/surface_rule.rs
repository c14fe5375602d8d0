//! What feature surfaces follow from: the rule that makes them of facets, and the operator's edits.

use super::digest::{Hasher, Keyed};
use serde::{Deserialize, Serialize};

/// How facets become surfaces before the operator's own edits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceRule {
    /// Dihedral angle from which an edge is a crease, degrees (α of P1).
    pub angle_deg: f64,
    /// Surfaces smaller than this are absorbed by the neighbour with the smoothest border; 0 = off.
    pub min_area_mm2: f64,
    /// An edge from this angle on is a crease too where a chain of such edges leads to a crease
    /// of α; 0 = off.
    pub hysteresis_deg: f64,
}

/// One edit of the operator, in the order made.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum SurfaceEdit {
    /// These become one, under the lowest of the numbers.
    Merge {
        /// Surface numbers.
        merge: Vec<u32>,
    },
    /// This one is cut again at a lower angle; the part with the lowest facet keeps the number.
    Split {
        /// Surface number.
        split: u32,
        /// The local angle, degrees.
        angle_deg: f64,
    },
    /// These of its facets become a surface of their own, under the next number.
    Cut {
        /// Surface number.
        cut: u32,
        /// Facets, those of other surfaces are passed over.
        facets: Vec<u32>,
    },
}

super::keyed!(SurfaceRule { angle_deg, min_area_mm2, hysteresis_deg });

impl Keyed for SurfaceEdit {
    fn feed(&self, into: &mut Hasher) {
        match self {
            SurfaceEdit::Merge { merge } => {
                "merge".feed(into);
                merge.feed(into);
            }
            SurfaceEdit::Split { split, angle_deg } => {
                "split".feed(into);
                split.feed(into);
                angle_deg.feed(into);
            }
            SurfaceEdit::Cut { cut, facets } => {
                "cut".feed(into);
                cut.feed(into);
                facets.feed(into);
            }
        }
    }
}
