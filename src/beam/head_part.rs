//! One piece of the stack that a laser head is described by.

use serde::{Deserialize, Serialize};

/// A piece of the stack: a cylinder or a cut cone, its ends flat.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HeadPart {
    /// Where it begins, mm from the focus along a.
    pub from_mm: f64,
    /// Where it ends, mm from the focus along a.
    pub to_mm: f64,
    /// Radius where it begins, mm.
    pub r0_mm: f64,
    /// Radius where it ends, mm.
    pub r1_mm: f64,
}

crate::part::keyed!(HeadPart { from_mm, to_mm, r0_mm, r1_mm });
