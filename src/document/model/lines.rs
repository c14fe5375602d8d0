//! The `[layers]` table of a job: how lines are laid on surfaces.

use super::declare::{count, parameters};
use crate::part::{Hasher, Keyed};
use crate::path::{Direction, Order, Strategy};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};

parameters! {
    /// How lines are laid on surfaces, and in which order they are done.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(default, deny_unknown_fields)]
    pub struct LineParameters in "layers" {
        /// Planes, lines that follow the surface, or a spiral.
        pub strategy: Strategy = Strategy::Planes,
        /// Normal of the planes: `x`, `y`, `z`, `auto` or `DX,DY,DZ`.
        pub direction: Direction = Direction::Auto,
        /// Distance of the planes, or of the lines on the surface, mm.
        pub spacing_mm: f64,
        /// Where the first plane lies.
        pub offset_mm: FirstPlane = FirstPlane::Centred,
        /// Sense and order of the lines.
        pub order: Order = Order::Zigzag,
        /// How often the surface is gone over.
        #[serde(deserialize_with = "count")]
        pub passes: u32,
        /// What lines keep from the rim, mm; negative: how far they run on over it.
        pub inset_mm: f64,
        /// Holes narrower than this keep no lines off, mm.
        pub ignore_holes_mm: f64,
        /// Pieces of a line with a gap up to this between them are one pass, the laser off over the gap, mm.
        pub join_mm: f64,
        /// Shorter pieces are left out, mm.
        pub shortest_mm: f64,
        /// How far a closed line begins behind where the one before does, mm.
        pub seam_shift_mm: f64,
        /// Between the two rasters of a cross, degrees.
        pub cross_deg: f64,
        /// For offset lines: the border to start from, 0 the longest; without it the whole outline.
        #[serde(skip_serializing_if = "Option::is_none")]
        pub border: Option<u32> = None,
        /// For a spiral: its centre, or the nearest point of the surface to it, in the part frame.
        #[serde(skip_serializing_if = "Option::is_none")]
        pub centre_mm: Option<[f64; 3]> = None,
        /// For a spiral: from the rim to the centre.
        #[serde(skip_serializing_if = "std::ops::Not::not")]
        pub inward: bool = false,
    }
}

/// Where the first plane of a family lies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FirstPlane {
    /// The family is centred on the extent.
    #[default]
    Centred,
    /// Height above the lowest point of the extent, mm.
    FromLowest(f64),
}

impl FirstPlane {
    /// The number, where there is one.
    pub fn mm(self) -> Option<f64> {
        match self {
            FirstPlane::Centred => None,
            FirstPlane::FromLowest(mm) => Some(mm),
        }
    }
}

impl Serialize for FirstPlane {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self {
            FirstPlane::Centred => s.serialize_str("centred"),
            FirstPlane::FromLowest(mm) => s.serialize_f64(*mm),
        }
    }
}

impl<'de> Deserialize<'de> for FirstPlane {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "give \"centred\" or a number of mm")]
        enum RawFirstPlane {
            Number(f64),
            Word(String),
        }
        match RawFirstPlane::deserialize(d)? {
            RawFirstPlane::Number(mm) => Ok(FirstPlane::FromLowest(mm)),
            RawFirstPlane::Word(w) if w == "centred" => Ok(FirstPlane::Centred),
            RawFirstPlane::Word(w) => Err(D::Error::custom(format!("{w:?}: give \"centred\" or a number of mm"))),
        }
    }
}

impl Keyed for FirstPlane {
    fn feed(&self, into: &mut Hasher) {
        match self {
            FirstPlane::Centred => "centred".feed(into),
            FirstPlane::FromLowest(mm) => mm.feed(into),
        }
    }
}
