//! The `[nachi]` table of a cell file.

use crate::cell::check::{FigureError, WordForm, ranges};
use serde::{Deserialize, Serialize};

/// What the NACHI program needs; words that sources disagree on are templates.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Nachi {
    /// Unit name, the first half of the file name.
    pub unit: String,
    /// Program number, the second half.
    pub number: u32,
    /// Tool number, `H=`.
    pub tool: u32,
    /// Accuracy 1 (finest) to 8, `A=`.
    pub accuracy: u32,
    /// What targets are given as; without a robot they are poses.
    pub form: NachiForm,
    /// Moves in one program; longer programs call subprograms, numbered on from this one.
    pub max_moves: u32,
    /// Line that switches output `{n}` on.
    pub output_on: String,
    /// Line that switches it off.
    pub output_off: String,
    /// Line that waits `{s}` seconds.
    pub wait: String,
    /// Line that sets analogue output `{n}` to `{v}`; no source has it, so it is empty.
    pub analogue: String,
    /// Line that sets the group of outputs `{n}` to `{v}`; empty as well.
    pub group: String,
    /// Line that calls program `{n}`.
    pub call: String,
    /// Comment line; `{text}` is replaced.
    pub comment: String,
    /// Ends lines with CR LF.
    pub crlf: bool,
}

/// What a target is given as.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum NachiForm {
    /// `M1J`, joint angles: no configuration to guess.
    #[default]
    #[serde(rename = "M1J")]
    Joints,
    /// `M1X`, the pose of the flange.
    #[serde(rename = "M1X")]
    Pose,
}

impl Default for Nachi {
    fn default() -> Self {
        Nachi {
            unit: "MZ04-01".into(),
            number: 1,
            tool: 1,
            accuracy: 1,
            form: NachiForm::Joints,
            max_moves: 1000,
            output_on: "SET O{n}".into(),
            output_off: "RESET O{n}".into(),
            wait: "DELAY {s}".into(),
            analogue: String::new(),
            group: String::new(),
            call: "CALLP {n}".into(),
            comment: "REM \"{text}\"".into(),
            crlf: false,
        }
    }
}

impl Nachi {
    /// Whether the controller can take all of it.
    ///
    /// # Errors
    /// The first that it cannot.
    pub fn check(&self) -> Result<(), FigureError> {
        ranges(&[
            ("nachi.number", f64::from(self.number), 0.0, 999.0),
            ("nachi.accuracy", f64::from(self.accuracy), 1.0, 8.0),
            ("nachi.tool", f64::from(self.tool), 0.0, 32.0),
            ("nachi.max_moves", f64::from(self.max_moves), 10.0, 1e6),
        ])?;
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
        if self.unit.is_empty() || !self.unit.chars().all(plain) {
            let value = format!("{:?}", self.unit);
            return Err(FigureError::WordForm { key: "nachi.unit", value, form: WordForm::Unit });
        }
        Ok(())
    }
}
