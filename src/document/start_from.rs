//! What offset lines start from, as a recipe or a surface names it: one border of the surface, or its whole outline
//! in place of the border that the job has.

use crate::part::{Hasher, Keyed};
use serde::de::{Deserialize, Deserializer, Error, Unexpected, Visitor};
use serde::{Serialize, Serializer};
use std::fmt;

/// How the whole outline is written.
const WHOLE: &str = "whole";

/// Where offset lines start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StartFrom {
    /// All borders at once; written `"whole"`.
    Whole,
    /// One border, 0 the longest; written as its number.
    Border(u32),
}

impl StartFrom {
    /// The border; `None`: the whole outline.
    pub fn border(self) -> Option<u32> {
        match self {
            StartFrom::Whole => None,
            StartFrom::Border(b) => Some(b),
        }
    }
}

impl Keyed for StartFrom {
    fn feed(&self, into: &mut Hasher) {
        match self {
            StartFrom::Whole => "whole".feed(into),
            StartFrom::Border(border) => border.feed(into),
        }
    }
}

impl From<Option<u32>> for StartFrom {
    fn from(border: Option<u32>) -> StartFrom {
        border.map_or(StartFrom::Whole, StartFrom::Border)
    }
}

impl Serialize for StartFrom {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self {
            StartFrom::Whole => s.serialize_str(WHOLE),
            StartFrom::Border(b) => s.serialize_u32(*b),
        }
    }
}

impl<'de> Deserialize<'de> for StartFrom {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<StartFrom, D::Error> {
        struct StartFromVisitor;
        impl Visitor<'_> for StartFromVisitor {
            type Value = StartFrom;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "the number of a border, 0 for the longest, or {WHOLE:?} for the whole outline")
            }

            fn visit_i64<E: Error>(self, v: i64) -> Result<StartFrom, E> {
                u32::try_from(v).map(StartFrom::Border).map_err(|_| E::invalid_value(Unexpected::Signed(v), &self))
            }

            fn visit_u64<E: Error>(self, v: u64) -> Result<StartFrom, E> {
                u32::try_from(v).map(StartFrom::Border).map_err(|_| E::invalid_value(Unexpected::Unsigned(v), &self))
            }

            fn visit_str<E: Error>(self, v: &str) -> Result<StartFrom, E> {
                if v == WHOLE { Ok(StartFrom::Whole) } else { Err(E::invalid_value(Unexpected::Str(v), &self)) }
            }
        }
        d.deserialize_any(StartFromVisitor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Recipe;

    fn read(text: &str) -> Result<Recipe, toml::de::Error> {
        toml::from_str(&format!("name = \"R\"\nborder = {text}\n"))
    }

    #[test]
    fn a_recipe_names_a_border_or_the_whole_outline() {
        for (text, start) in [("\"whole\"", StartFrom::Whole), ("0", StartFrom::Border(0)), ("7", StartFrom::Border(7))]
        {
            let recipe = read(text).expect("reads");
            assert_eq!(recipe.border, Some(start));
            let again = toml::to_string(&recipe).expect("writes");
            assert!(again.contains(&format!("border = {text}")), "{again}");
        }
        for text in ["-1", "\"all\"", "5000000000", "1.5"] {
            assert!(read(text).is_err_and(|e| e.message().contains("for the whole outline")), "{text}");
        }
    }
}
