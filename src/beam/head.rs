//! The laser head: a stack of cylinders and cones about the beam's axis, or facets from a file.
//!
//! Both are measured from the focus, the stack along a, against the light; facets stand with their
//! origin in the focus and its z along a. Cables and nozzles are pieces like any other.

use super::HeadPart;
use super::envelope::envelope;
use super::obstacle::Obstacle;
use crate::file::{self, FileError, Step, TomlError, line_of};
use crate::part::file::is_named_as_part;
use crate::part::{Hasher, Keyed, LoadError, Part};
use serde::Deserialize;
use std::path::Path;
use thiserror::Error;

/// A head.
#[derive(Clone, Debug, PartialEq)]
pub enum Head {
    /// Cylinders and cones.
    Stack(Vec<HeadPart>),
    /// Facets, and the stack that they sweep as they turn about the beam.
    Solid(Obstacle, Vec<HeadPart>),
}

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

/// Why a head cannot be loaded.
#[derive(Debug, Error)]
pub enum HeadError {
    /// It cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// It is not a stack, or its dimensions are implausible.
    #[error("{file}: {what}")]
    Stack {
        /// The file.
        file: String,
        /// What is wrong with it.
        what: StackError,
    },
    /// Its facets are not usable.
    #[error(transparent)]
    Solid(#[from] LoadError),
}

/// Why a text does not describe a stack of cylinders and cones.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum StackError {
    /// It is not TOML, or a key or value is unknown or missing.
    #[error("not parsed")]
    Toml(#[source] Box<TomlError>),
    /// It has no pieces.
    #[error("no part")]
    Empty,
    /// A piece ends before it begins, or lies implausibly far away.
    #[error("part {part} from {from_mm} to {to_mm}")]
    Span {
        /// Line of the file, from 1.
        line: usize,
        /// The piece, from 1.
        part: usize,
        /// Where it begins.
        from_mm: f64,
        /// Where it ends.
        to_mm: f64,
    },
    /// The radii of a piece are out of range, or both 0.
    #[error("part {part}, radii {r0_mm} and {r1_mm}")]
    Radii {
        /// Line of the file, from 1.
        line: usize,
        /// The piece, from 1.
        part: usize,
        /// Radius where it begins.
        r0_mm: f64,
        /// Radius where it ends.
        r1_mm: f64,
    },
}

impl Head {
    /// Reads a head: a file with the name of a part as facets, any other as a stack.
    ///
    /// # Errors
    /// It cannot be read, or its dimensions are implausible.
    pub fn load(file: &Path) -> Result<Head, HeadError> {
        let name = file.display().to_string();
        if is_named_as_part(file) {
            let mut solid = Obstacle::of_file(name, file);
            solid.load(None)?;
            let stack = envelope(&solid.solid().mesh);
            return Ok(Head::Solid(solid, stack));
        }
        let bytes = file::bytes(file)?;
        Head::from_toml(file::text(&bytes, &name)?).map_err(|what| HeadError::Stack { file: name, what })
    }

    /// A stack from the text of its file.
    ///
    /// # Errors
    /// Something is missing or implausible.
    pub fn from_toml(text: &str) -> Result<Head, StackError> {
        let file: StackFile = file::read_toml(text).map_err(|e| StackError::Toml(Box::new(e)))?;
        if file.part.is_empty() {
            return Err(StackError::Empty);
        }
        check_stack(text, &file.part)?;
        Ok(Head::Stack(file.part))
    }

    /// The file's text of a stack.
    pub fn to_toml(stack: &[HeadPart]) -> String {
        if stack.is_empty() {
            return "part = []\n".into();
        }
        let piece = |p: &HeadPart| {
            let HeadPart { from_mm, to_mm, r0_mm, r1_mm } = p;
            format!("[[part]]\nfrom_mm = {from_mm:?}\nto_mm = {to_mm:?}\nr0_mm = {r0_mm:?}\nr1_mm = {r1_mm:?}\n")
        };
        stack.iter().map(piece).collect::<Vec<_>>().join("\n")
    }

    /// Its facets, where it has any.
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

/// Whether the pieces of a stack, the `[[part]]`s of a file's text, are plausible.
///
/// # Errors
/// The first that is not.
pub(super) fn check_stack(text: &str, stack: &[HeadPart]) -> Result<(), StackError> {
    for (i, p) in stack.iter().enumerate() {
        let HeadPart { from_mm, to_mm, r0_mm, r1_mm } = *p;
        let part = i + 1;
        let line = line_of(text, &[Step::Key("part"), Step::Entry(i)]).unwrap_or(1);
        if !(from_mm < to_mm && from_mm >= -1000.0 && to_mm <= 10_000.0) {
            return Err(StackError::Span { line, part, from_mm, to_mm });
        }
        let good = |r: f64| (0.0..=2000.0).contains(&r);
        if !(good(r0_mm) && good(r1_mm) && r0_mm + r1_mm > 0.0) {
            return Err(StackError::Radii { line, part, r0_mm, r1_mm });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stack_is_read_and_an_absurd_one_refused() {
        let good = "[[part]]\nfrom_mm = 10\nto_mm = 60\nr0_mm = 4\nr1_mm = 20\n";
        let Ok(Head::Stack(parts)) = Head::from_toml(good) else { panic!("a good stack") };
        assert_eq!(parts, [HeadPart { from_mm: 10.0, to_mm: 60.0, r0_mm: 4.0, r1_mm: 20.0 }]);
        assert_eq!(Head::from_toml(&Head::to_toml(&parts)), Ok(Head::Stack(parts)));
        let refused = |text: &str| Head::from_toml(text).expect_err(text);
        assert_eq!(refused("part = []"), StackError::Empty);
        let back = refused("[[part]]\nfrom_mm = 10\nto_mm = 5\nr0_mm = 4\nr1_mm = 20\n");
        assert_eq!(back, StackError::Span { line: 1, part: 1, from_mm: 10.0, to_mm: 5.0 });
        let nan = refused("[[part]]\nfrom_mm = 0\nto_mm = 5\nr0_mm = nan\nr1_mm = 20\n");
        assert!(matches!(&nan, StackError::Toml(e) if (e.line, e.key.as_str()) == (4, "part.r0_mm")), "{nan}");
        let thin = refused("[[part]]\nfrom_mm = 0\nto_mm = 5\nr0_mm = 0\nr1_mm = 0\n");
        assert_eq!(thin, StackError::Radii { line: 1, part: 1, r0_mm: 0.0, r1_mm: 0.0 });
        for (bad, why) in
            [("", "part"), ("[[part]]\nfrom_mm = 0\nto_mm = 5\nr0_mm = 1\n", "r1_mm"), ("[[part]]\nfrom = 0\n", "from")]
        {
            let StackError::Toml(source) = refused(bad) else { panic!("read: {bad}") };
            assert!(source.to_string().contains(why), "{source}");
        }
    }
}
