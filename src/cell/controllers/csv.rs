//! The `[csv]` table of a cell file.

use crate::cell::check::{FigureError, Letters, name};
use serde::{Deserialize, Serialize};

/// What the program as a table needs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Csv {
    /// Name of the file.
    pub name: String,
}

impl Default for Csv {
    fn default() -> Self {
        Csv { name: "program".into() }
    }
}

impl Csv {
    /// Whether the name can stand.
    ///
    /// # Errors
    /// It has other letters, or too many.
    pub fn check(&self) -> Result<(), FigureError> {
        name("csv.name", &self.name, Letters::Identifier, 32)
    }
}
