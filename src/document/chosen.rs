//! Which surfaces are named to be cleaned, as job file and command line write it: all, or a list in the order
//! of work.

use crate::part::SurfaceId;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};
use std::collections::BTreeSet;

/// All surfaces, or some in the order of work.
#[derive(Clone, Debug, PartialEq)]
pub enum Chosen {
    /// All, in the order of their numbers.
    All,
    /// These.
    These(Vec<SurfaceId>),
}

impl Default for Chosen {
    fn default() -> Self {
        Chosen::These(Vec::new())
    }
}

impl Chosen {
    /// The first surface that stands twice in the list.
    pub fn repeated(&self) -> Option<SurfaceId> {
        let Chosen::These(list) = self else { return None };
        let mut seen = BTreeSet::new();
        list.iter().copied().find(|id| !seen.insert(*id))
    }
}

/// Numbers in the order of work.
impl<const N: usize> From<[u32; N]> for Chosen {
    fn from(numbers: [u32; N]) -> Chosen {
        numbers.to_vec().into()
    }
}

impl From<Vec<u32>> for Chosen {
    fn from(numbers: Vec<u32>) -> Chosen {
        Chosen::These(numbers.into_iter().map(SurfaceId).collect())
    }
}

impl Serialize for Chosen {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self {
            Chosen::All => s.serialize_str("all"),
            Chosen::These(list) => list.serialize(s),
        }
    }
}

impl<'de> Deserialize<'de> for Chosen {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "give \"all\" or a list of surface numbers")]
        enum RawChosen {
            Word(String),
            List(Vec<SurfaceId>),
        }
        match RawChosen::deserialize(d)? {
            RawChosen::Word(w) if w == "all" => Ok(Chosen::All),
            RawChosen::Word(w) => Err(D::Error::custom(format!("{w:?}: give \"all\" or a list of surface numbers"))),
            RawChosen::List(list) => Ok(Chosen::These(list)),
        }
    }
}
