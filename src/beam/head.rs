//! The laser head: a stack of cylinders and cones about the beam's axis, or an STL.
//!
//! Both are measured from the focus, the stack along a, against the light; an STL stands with its
//! origin in the focus and its z along a. Cables and nozzles are pieces like any other.

use super::envelope::envelope;
use super::obstacle::Obstacle;
use crate::part::{Hasher, Keyed, LoadError, Part};
use serde::{Deserialize, Serialize};
use std::path::Path;
use thiserror::Error;

/// A piece of the stack: a cylinder or a cut cone, its ends flat.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HeadPart {
    /// Where it begins, mm from the focus along a.
    pub from_mm: f64,
    /// Where it ends.
    pub to_mm: f64,
    /// Radius where it begins, mm.
    pub r0_mm: f64,
    /// Radius where it ends, mm.
    pub r1_mm: f64,
}

/// A head.
#[derive(Clone, Debug, PartialEq)]
pub enum Head {
    /// Cylinders and cones.
    Stack(Vec<HeadPart>),
    /// Facets, and the stack that they sweep as they turn about the beam.
    Solid(Obstacle, Vec<HeadPart>),
}

crate::part::keyed!(HeadPart { from_mm, to_mm, r0_mm, r1_mm });

impl Keyed for Head {
    fn feed(&self, into: &mut Hasher) {
        match self {
            Head::Stack(stack) => stack.feed(into),
            Head::Solid(solid, swept) => {
                solid.feed(into);
                swept.feed(into);
            }
        }
    }
}

/// The TOML file of a stack.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StackFile {
    part: Vec<HeadPart>,
}

/// Why there is no head.
#[derive(Debug, Error)]
pub enum HeadError {
    /// It cannot be read.
    #[error("{file}: cannot be read: {source}")]
    Read {
        /// The file.
        file: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// It is no stack, or has absurd figures.
    #[error("{file}: {what}; a head is a list of [[part]] with from_mm, to_mm, r0_mm and r1_mm, or an STL")]
    Stack {
        /// The file.
        file: String,
        /// What and where.
        what: String,
    },
    /// It is no STL.
    #[error(transparent)]
    Solid(#[from] LoadError),
}

impl Head {
    /// Reads a head: a `.stl` file as facets, any other as a stack.
    ///
    /// # Errors
    /// It cannot be read, or has absurd figures.
    pub fn load(file: &Path) -> Result<Head, HeadError> {
        let name = file.display().to_string();
        if file.extension().is_some_and(|e| e.eq_ignore_ascii_case("stl")) {
            let mut solid = Obstacle::named(name);
            solid.load(None)?;
            let stack = envelope(&solid.solid().mesh);
            return Ok(Head::Solid(solid, stack));
        }
        let text = std::fs::read_to_string(file).map_err(|source| HeadError::Read { file: name.clone(), source })?;
        Head::from_toml(&text).map_err(|what| HeadError::Stack { file: name, what })
    }

    /// A stack from the text of its file.
    ///
    /// # Errors
    /// What is missing or absurd.
    pub fn from_toml(text: &str) -> Result<Head, String> {
        let file: StackFile = toml::from_str(text).map_err(|e| e.to_string().trim_end().replace('\n', " "))?;
        if file.part.is_empty() {
            return Err("it has no part".into());
        }
        for (i, p) in file.part.iter().enumerate() {
            let HeadPart { from_mm, to_mm, r0_mm, r1_mm } = *p;
            if !(from_mm < to_mm && from_mm >= -1000.0 && to_mm <= 10_000.0) {
                return Err(format!(
                    "part {}: from_mm = {from_mm}, to_mm = {to_mm}: give -1000 to 10000, the lower first",
                    i + 1
                ));
            }
            let good = |r: f64| (0.0..=2000.0).contains(&r);
            if !(good(r0_mm) && good(r1_mm) && r0_mm + r1_mm > 0.0) {
                return Err(format!("part {}: r0_mm = {r0_mm}, r1_mm = {r1_mm}: give 0 to 2000, not both 0", i + 1));
            }
        }
        Ok(Head::Stack(file.part))
    }

    /// Its facets, where it is an STL.
    pub fn solid(&self) -> Option<&Part> {
        match self {
            Head::Stack(_) => None,
            Head::Solid(o, _) => Some(o.solid()),
        }
    }

    /// The cylinders and cones that it counts as.
    pub fn stack(&self) -> &[HeadPart] {
        match self {
            Head::Stack(parts) | Head::Solid(_, parts) => parts,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stack_is_read_and_an_absurd_one_refused() {
        let good = "[[part]]\nfrom_mm = 10\nto_mm = 60\nr0_mm = 4\nr1_mm = 20\n";
        let Ok(Head::Stack(parts)) = Head::from_toml(good) else { panic!("a good stack") };
        assert_eq!(parts, [HeadPart { from_mm: 10.0, to_mm: 60.0, r0_mm: 4.0, r1_mm: 20.0 }]);
        for (bad, why) in [
            ("", "part"),
            ("part = []", "no part"),
            ("[[part]]\nfrom_mm = 10\nto_mm = 5\nr0_mm = 4\nr1_mm = 20\n", "the lower first"),
            ("[[part]]\nfrom_mm = 0\nto_mm = 5\nr0_mm = nan\nr1_mm = 20\n", "r0_mm"),
            ("[[part]]\nfrom_mm = 0\nto_mm = 5\nr0_mm = 0\nr1_mm = 0\n", "not both 0"),
            ("[[part]]\nfrom_mm = 0\nto_mm = 5\nr0_mm = 1\n", "r1_mm"),
            ("[[part]]\nfrom = 0\n", "from"),
        ] {
            let said = Head::from_toml(bad).expect_err(bad);
            assert!(said.contains(why), "{said}");
        }
    }
}
