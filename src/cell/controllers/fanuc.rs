//! The `[fanuc]` table of a cell file.

use super::templates::check_force;
use crate::cell::check::{FigureError, Letters, WordForm, name, ranges};
use serde::{Deserialize, Serialize};

/// What the program needs; words that sources disagree on are templates.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Fanuc {
    /// Name of the program and its file; subprograms add a number.
    pub program: String,
    /// User frame, `UF`: its origin in the robot's foot, as the poses are.
    pub user_frame: u32,
    /// User tool, `UT`: without any offset, because the poses are the flange's.
    pub user_tool: u32,
    /// How one lit move goes over into the next.
    pub termination: String,
    /// Configuration of targets that are poses; joints need none.
    pub configuration: String,
    /// Lines in one program; longer programs call subprograms.
    pub max_lines: u32,
    /// Instruction that switches output `{n}` on.
    pub output_on: String,
    /// Instruction that switches it off.
    pub output_off: String,
    /// Instruction that sets analogue output `{n}` to `{v}`.
    pub analogue: String,
    /// Instruction that sets the group of outputs `{n}` to `{v}`.
    pub group: String,
    /// Line that makes a contact tool press with `{f}` newtons from there on; empty: that is a comment.
    pub force_on: String,
    /// Line that ends it.
    pub force_off: String,
    /// Ends lines with CR LF.
    pub crlf: bool,
}

impl Default for Fanuc {
    fn default() -> Self {
        Fanuc {
            program: "CLEAN".into(),
            user_frame: 0,
            user_tool: 0,
            termination: "CNT100".into(),
            configuration: "N U T, 0, 0, 0".into(),
            max_lines: 9999,
            output_on: "DO[{n}]=ON".into(),
            output_off: "DO[{n}]=OFF".into(),
            analogue: "AO[{n}]={v}".into(),
            group: "GO[{n}]={v}".into(),
            force_on: String::new(),
            force_off: String::new(),
            crlf: false,
        }
    }
}

impl Fanuc {
    /// Whether the controller can take all of it.
    ///
    /// # Errors
    /// The first that it cannot.
    pub fn check(&self) -> Result<(), FigureError> {
        ranges(&[
            ("fanuc.user_frame", f64::from(self.user_frame), 0.0, 61.0),
            ("fanuc.user_tool", f64::from(self.user_tool), 0.0, 29.0),
            ("fanuc.max_lines", f64::from(self.max_lines), 50.0, 9999.0),
        ])?;
        check_force("fanuc", &self.force_on, &self.force_off)?;
        name("fanuc.program", &self.program, Letters::CapitalIdentifier, 32)?;
        let wrong = |key, value: &str, form| FigureError::WordForm { key, value: format!("{value:?}"), form };
        let share = self.termination.strip_prefix("CNT").and_then(|n| n.parse().ok());
        if self.termination != "FINE" && share.is_none_or(|n: u32| n > 100) {
            return Err(wrong("fanuc.termination", &self.termination, WordForm::Termination));
        }
        let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, ' ' | ',' | '-');
        if self.configuration.is_empty() || !self.configuration.chars().all(plain) {
            return Err(wrong("fanuc.configuration", &self.configuration, WordForm::Configuration));
        }
        Ok(())
    }
}
