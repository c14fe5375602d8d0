//! A contact tool: a grinding disc or a belt on its contact wheel, with what is mounted behind it, as its TOML file
//! describes it. Where it stands at a point of the part is `grinding`'s, the space that it takes up is `contact_body`'s.
//!
//! ```toml
//! kind = "disc"
//! radius_mm = 62.5
//! edge_mm = 3
//! thickness_mm = 7
//! contact = "rim"
//!
//! [[part]] # guard and spindle, mm from the reference point along the tool's axis
//! from_mm = 10
//! to_mm = 60
//! r0_mm = 25
//! r1_mm = 25
//! ```
//! The reference point is the tool centre point: of a disc that touches with its rim the centre of the ring that its
//! edge is rounded about, of all others the point of contact.

pub mod contact_body;
pub mod grinding;

use super::HeadPart;
use super::head::{StackError, check_stack};
use crate::file::{self, FileError, Step, TomlError, line_of};
use crate::part::{Hasher, Keyed, keyed, keyed_words};
use serde::Deserialize;
use std::path::Path;
use thiserror::Error;

/// A contact tool.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactTool {
    /// What touches the part.
    pub abrasive: Abrasive,
    /// What is mounted behind it, from the reference point along the axis. It may be nothing.
    pub stack: Vec<HeadPart>,
}

keyed!(ContactTool { abrasive, stack });

/// What of a contact tool touches the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Abrasive {
    /// A disc with a rounded edge.
    Disc {
        /// Radius r, mm.
        radius_mm: f64,
        /// Radius ρ that its edge is rounded with, mm.
        edge_mm: f64,
        /// Thickness, mm; twice ρ at least.
        thickness_mm: f64,
        /// What of it touches.
        side: ContactSide,
    },
    /// A belt where it runs over its contact wheel.
    Belt {
        /// Radius of the wheel, belt included, mm.
        radius_mm: f64,
        /// Width of the belt, mm.
        width_mm: f64,
    },
}

impl Keyed for Abrasive {
    fn feed(&self, into: &mut Hasher) {
        match self {
            Abrasive::Disc { radius_mm, edge_mm, thickness_mm, side } => {
                "disc".feed(into);
                [*radius_mm, *edge_mm, *thickness_mm].feed(into);
                side.feed(into);
            }
            Abrasive::Belt { radius_mm, width_mm } => {
                "belt".feed(into);
                [*radius_mm, *width_mm].feed(into);
            }
        }
    }
}

/// What of a disc touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ContactSide {
    /// Its rounded edge: the disc leans over by its lead.
    Rim,
    /// Its flat face: the axis stands along the surface normal.
    Face,
}

keyed_words!(ContactSide: Rim, Face);

/// The word for what touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum AbrasiveKind {
    Disc,
    Belt,
}

/// The TOML file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ContactToolFile {
    kind: AbrasiveKind,
    radius_mm: f64,
    edge_mm: Option<f64>,
    thickness_mm: Option<f64>,
    contact: Option<ContactSide>,
    width_mm: Option<f64>,
    #[serde(default)]
    part: Vec<HeadPart>,
}

/// Why a contact tool cannot be loaded.
#[derive(Debug, Error)]
pub enum ContactToolError {
    /// It cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// It describes no contact tool.
    #[error("{file}: {what}")]
    Tool {
        /// The file.
        file: String,
        /// What is wrong with it.
        what: ContactToolFault,
    },
}

/// Why a text describes no contact tool.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ContactToolFault {
    /// It is not TOML, or a key or value is unknown or missing.
    #[error("not parsed")]
    Toml(#[source] Box<TomlError>),
    /// A dimension that this kind of tool has is missing.
    #[error("no {key}")]
    Missing {
        /// Its key.
        key: &'static str,
    },
    /// A key that this kind of tool has no use for.
    #[error("line {line}: {key}")]
    Needless {
        /// Line of the file, from 1.
        line: usize,
        /// The key.
        key: &'static str,
    },
    /// A dimension is out of its range.
    #[error("line {line}: {key} = {value}, not from {low} to {high}")]
    Range {
        /// Line of the file, from 1.
        line: usize,
        /// Its key.
        key: &'static str,
        /// What stands there.
        value: f64,
        /// Least value.
        low: f64,
        /// Greatest value.
        high: f64,
    },
    /// What is mounted behind it is implausible.
    #[error(transparent)]
    Stack(StackError),
}

/// The tool that is shipped.
const SHIPPED: &str = include_str!("../../assets/tools/disc.toml");

/// An edge sharper than this cuts rather than grinds; and what a disc may reach into the skin is taken off its edge, so
/// that there must be one, mm.
const LEAST_EDGE_MM: f64 = 0.5;

impl ContactTool {
    /// Reads a contact tool.
    ///
    /// # Errors
    /// It cannot be read, or its dimensions are implausible.
    pub fn load(file: &Path) -> Result<ContactTool, ContactToolError> {
        let name = file.display().to_string();
        let bytes = file::bytes(file)?;
        ContactTool::from_toml(file::text(&bytes, &name)?)
            .map_err(|what| ContactToolError::Tool { file: name.clone(), what })
    }

    /// The disc that is ground with where no tool is named.
    pub fn shipped() -> ContactTool {
        let side = ContactSide::Rim;
        let abrasive = Abrasive::Disc { radius_mm: 30.0, edge_mm: 3.0, thickness_mm: 6.0, side };
        ContactTool::from_toml(SHIPPED).unwrap_or(ContactTool { abrasive, stack: Vec::new() })
    }

    /// A contact tool from the text of its file.
    ///
    /// # Errors
    /// Something is missing or implausible.
    pub fn from_toml(text: &str) -> Result<ContactTool, ContactToolFault> {
        let file: ContactToolFile = file::read_toml(text).map_err(|e| ContactToolFault::Toml(Box::new(e)))?;
        check_stack(text, &file.part).map_err(ContactToolFault::Stack)?;
        let line = |key: &'static str| line_of(text, &[Step::Key(key)]).unwrap_or(1);
        let within = |key: &'static str, value: Option<f64>, low: f64, high: f64| match value {
            None => Err(ContactToolFault::Missing { key }),
            Some(value) if (low..=high).contains(&value) => Ok(value),
            Some(value) => Err(ContactToolFault::Range { line: line(key), key, value, low, high }),
        };
        let needless = |keys: &[(&'static str, bool)]| match keys.iter().find(|k| k.1) {
            Some(&(key, _)) => Err(ContactToolFault::Needless { line: line(key), key }),
            None => Ok(()),
        };
        let radius_mm = within("radius_mm", Some(file.radius_mm), 2.0, 1000.0)?;
        let abrasive = match file.kind {
            AbrasiveKind::Disc => {
                needless(&[("width_mm", file.width_mm.is_some())])?;
                let edge_mm = within("edge_mm", file.edge_mm, LEAST_EDGE_MM, 0.5 * radius_mm)?;
                let thickness_mm = within("thickness_mm", file.thickness_mm, 2.0 * edge_mm, 500.0)?;
                let side = file.contact.ok_or(ContactToolFault::Missing { key: "contact" })?;
                Abrasive::Disc { radius_mm, edge_mm, thickness_mm, side }
            }
            AbrasiveKind::Belt => {
                let of_disc = [
                    ("edge_mm", file.edge_mm.is_some()),
                    ("thickness_mm", file.thickness_mm.is_some()),
                    ("contact", file.contact.is_some()),
                ];
                needless(&of_disc)?;
                Abrasive::Belt { radius_mm, width_mm: within("width_mm", file.width_mm, 1.0, 1000.0)? }
            }
        };
        Ok(ContactTool { abrasive, stack: file.part })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DISC: &str = "kind = \"disc\"\nradius_mm = 50\nedge_mm = 3\nthickness_mm = 7\ncontact = \"rim\"\n";

    #[test]
    fn discs_and_belts_are_read() {
        let stack = "[[part]]\nfrom_mm = 10\nto_mm = 60\nr0_mm = 25\nr1_mm = 25\n";
        let disc = ContactTool::from_toml(&format!("{DISC}{stack}")).expect("a disc");
        let side = ContactSide::Rim;
        assert_eq!(disc.abrasive, Abrasive::Disc { radius_mm: 50.0, edge_mm: 3.0, thickness_mm: 7.0, side });
        assert_eq!(disc.stack, [HeadPart { from_mm: 10.0, to_mm: 60.0, r0_mm: 25.0, r1_mm: 25.0 }]);
        let belt = ContactTool::from_toml("kind = \"belt\"\nradius_mm = 40\nwidth_mm = 20\n").expect("a belt");
        assert_eq!(belt.abrasive, Abrasive::Belt { radius_mm: 40.0, width_mm: 20.0 });
        assert!(belt.stack.is_empty());
    }

    #[test]
    fn the_shipped_tool_is_a_disc_with_its_guard() {
        let shipped = ContactTool::shipped();
        assert!(matches!(shipped.abrasive, Abrasive::Disc { side: ContactSide::Rim, .. }));
        assert_eq!(Ok(shipped.clone()), ContactTool::from_toml(SHIPPED));
        assert_eq!(shipped.stack.len(), 2);
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        let refused = |text: &str| ContactTool::from_toml(text).expect_err(text);
        let sharp = refused(&DISC.replace("edge_mm = 3", "edge_mm = 0.1"));
        assert_eq!(sharp, ContactToolFault::Range { line: 3, key: "edge_mm", value: 0.1, low: 0.5, high: 25.0 });
        let thin = refused(&DISC.replace("thickness_mm = 7", "thickness_mm = 5"));
        assert_eq!(thin, ContactToolFault::Range { line: 4, key: "thickness_mm", value: 5.0, low: 6.0, high: 500.0 });
        assert_eq!(refused("kind = \"belt\"\nradius_mm = 9\n"), ContactToolFault::Missing { key: "width_mm" });
        let both = refused(&format!("{DISC}width_mm = 4\n"));
        assert_eq!(both, ContactToolFault::Needless { line: 6, key: "width_mm" });
        let turned = refused(&format!("{DISC}[[part]]\nfrom_mm = 9\nto_mm = 1\nr0_mm = 4\nr1_mm = 4\n"));
        let span = StackError::Span { line: 6, part: 1, from_mm: 9.0, to_mm: 1.0 };
        assert_eq!(turned, ContactToolFault::Stack(span));
        assert!(matches!(refused("kind = \"saw\"\n"), ContactToolFault::Toml(e) if e.line == 1));
    }
}
