//! What offset lines start from, as a recipe names it: one border of the surface, or its whole outline in place
//! of the border that the job has.

use super::model::Job;
use crate::part::{Hasher, Keyed, SurfaceId};
use crate::path::Strategy;
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

/// As people read it: borders count from 1.
impl fmt::Display for StartFrom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StartFrom::Whole => f.write_str("whole outline"),
            StartFrom::Border(b) => write!(f, "border {}", b.saturating_add(1)),
        }
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
        struct Read;
        impl Visitor<'_> for Read {
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
        d.deserialize_any(Read)
    }
}

impl Job {
    /// Where the lines of a surface start; `None`: it is not worked in offset lines.
    pub fn offset_start(&self, surface: SurfaceId) -> Option<StartFrom> {
        let recipe = self.recipe_of(surface);
        let strategy = recipe.and_then(|r| r.strategy).unwrap_or(self.layers.strategy);
        let own = self.settings.of(surface).border.or(recipe.and_then(|r| r.border));
        (strategy == Strategy::Offset).then(|| own.unwrap_or(self.layers.border.into()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Recipe;

    fn read(text: &str) -> Result<Recipe, String> {
        toml::from_str(&format!("name = \"R\"\nborder = {text}\n")).map_err(|e| e.to_string())
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
            assert!(read(text).is_err_and(|e| e.contains("for the whole outline")), "{text}");
        }
    }

    #[test]
    fn the_whole_outline_of_a_recipe_goes_before_the_border_of_the_job() {
        let mut job = Job::default();
        assert_eq!(job.offset_start(SurfaceId(1)), None, "planes");
        (job.layers.strategy, job.layers.border) = (Strategy::Offset, Some(2));
        let whole = Recipe { name: "W".into(), border: Some(StartFrom::Whole), ..Recipe::default() };
        let silent = Recipe { name: "S".into(), ..Recipe::default() };
        let raster = Recipe { name: "P".into(), strategy: Some(Strategy::Planes), ..Recipe::default() };
        job.put_recipe(&whole, &[SurfaceId(1)]);
        job.put_recipe(&silent, &[SurfaceId(2)]);
        job.put_recipe(&raster, &[SurfaceId(3)]);
        let starts = |job: &Job| [1, 2, 4].map(|n| job.offset_start(SurfaceId(n)));
        let worked = |job: &Job| [1, 2, 4].map(|n| job.of_surface(SurfaceId(n)).layers.border);
        assert_eq!(starts(&job), [StartFrom::Whole, StartFrom::Border(2), StartFrom::Border(2)].map(Some));
        assert_eq!(worked(&job), [None, Some(2), Some(2)]);
        assert_eq!(job.offset_start(SurfaceId(3)), None);
        assert_eq!(whole.without_places().border, Some(StartFrom::Whole), "that of any part");
        // What is said of the surface itself goes before both.
        job.settings.change(SurfaceId(1), |s| s.border = Some(StartFrom::Border(7)));
        job.settings.change(SurfaceId(3), |s| s.border = Some(StartFrom::Border(7)));
        job.settings.change(SurfaceId(4), |s| (s.border, s.centre_mm) = (Some(StartFrom::Whole), Some([1.0; 3])));
        assert_eq!(starts(&job), [StartFrom::Border(7), StartFrom::Border(2), StartFrom::Whole].map(Some));
        assert_eq!(worked(&job), [Some(7), Some(2), None]);
        assert_eq!(job.offset_start(SurfaceId(3)), None, "it is not worked in offset lines");
        assert_eq!(job.of_surface(SurfaceId(4)).layers.centre_mm, Some([1.0; 3]));
    }
}
