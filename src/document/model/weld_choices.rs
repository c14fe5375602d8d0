//! What a job decides of a weld beside numbers: its images, strokes on the mask, the areas and how they are ground, the
//! passes that were ground, and roughness readings.

use crate::part::{Hasher, Keyed, keyed, keyed_words};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};

/// A grey image and a depth image of one moment, and the camera that took both.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct WeldFiles {
    /// The grey image.
    pub gray: NamedImage,
    /// The depth image.
    pub depth: NamedImage,
    /// The camera's figures.
    pub camera: NamedImage,
}

/// A file of those.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct NamedImage {
    /// Path, relative to the job file.
    pub file: String,
    /// SHA-256 of its bytes when it was read, hexadecimal; empty: any.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub sha256: String,
}

/// How an area is ground (P4 5).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum GrindingStrategy {
    /// Parallel lines, all in one sense; the tool leaves at the end of each.
    OneWay,
    /// Parallel lines back and forth, joined at the rim.
    Zigzag,
    /// One spiral, its turns equally far apart on the surface.
    #[default]
    Spiral,
    /// Lines along the bead's centre line.
    Along,
}

impl GrindingStrategy {
    /// All of them, in the order of lists.
    pub const ALL: [GrindingStrategy; 4] =
        [GrindingStrategy::OneWay, GrindingStrategy::Zigzag, GrindingStrategy::Spiral, GrindingStrategy::Along];

    /// The word used on the command line and in jobs.
    pub fn word(self) -> &'static str {
        match self {
            GrindingStrategy::OneWay => "one-way",
            GrindingStrategy::Zigzag => "zigzag",
            GrindingStrategy::Spiral => "spiral",
            GrindingStrategy::Along => "along",
        }
    }

    /// The strategy of that word.
    pub fn from_word(word: &str) -> Option<GrindingStrategy> {
        GrindingStrategy::ALL.into_iter().find(|s| s.word() == word)
    }
}

/// Which areas are ground. They have no numbers that last from one image to the next, so those that are chosen are told by
/// pixels in them.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum AreaChoice {
    /// All.
    #[default]
    All,
    /// Those in which one of these pixels lies: column and row.
    At(Vec<[f64; 2]>),
}

/// A pass that was ground: the images before it, and what it should have left.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GroundPass {
    /// The images that it was planned from.
    pub images: WeldFiles,
    /// Greatest height of the bead before it, mm.
    pub height_mm: f64,
    /// The height that it should have left, mm.
    pub planned_mm: f64,
}

/// Roughness at a numbered point, as the operator measured it (P4 Fig. 28).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RoughnessReading {
    /// Number of the point.
    pub point: u32,
    /// Ra before grinding, µm.
    pub before_um: f64,
    /// Ra after it, µm; nobody has measured yet where it is not there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub after_um: Option<f64>,
}

impl WeldFiles {
    pub(super) fn is_none(&self) -> bool {
        self.gray.file.is_empty() && self.depth.file.is_empty()
    }
}

impl AreaChoice {
    pub(super) fn is_all(&self) -> bool {
        *self == AreaChoice::All
    }
}

keyed!(WeldFiles { gray, depth, camera });
keyed!(NamedImage { file, sha256 });
keyed!(GroundPass { images, height_mm, planned_mm });
keyed!(RoughnessReading { point, before_um, after_um });
keyed_words!(GrindingStrategy: OneWay, Zigzag, Spiral, Along);

impl Keyed for AreaChoice {
    fn feed(&self, into: &mut Hasher) {
        let places = match self {
            AreaChoice::All => None,
            AreaChoice::At(places) => Some(places),
        };
        places.feed(into);
    }
}

const EXPECTED: &str = "give \"all\" or a list of pixels in areas, [column, row]";

impl Serialize for AreaChoice {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self {
            AreaChoice::All => s.serialize_str("all"),
            AreaChoice::At(places) => places.serialize(s),
        }
    }
}

impl<'de> Deserialize<'de> for AreaChoice {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "give \"all\" or a list of pixels in areas, [column, row]")]
        enum RawAreas {
            Word(String),
            Places(Vec<[f64; 2]>),
        }
        match RawAreas::deserialize(d)? {
            RawAreas::Word(w) if w == "all" => Ok(AreaChoice::All),
            RawAreas::Word(w) => Err(D::Error::custom(format!("{w:?}: {EXPECTED}"))),
            RawAreas::Places(places) => Ok(AreaChoice::At(places)),
        }
    }
}
