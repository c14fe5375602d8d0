//! The `[nachi]` table of a cell file.

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
    /// Moves in one program; longer programs call sub-programs, numbered on from this one.
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
    /// # Errors
    /// Which figure makes no sense, and what it may be.
    pub fn check(&self) -> Result<(), String> {
        let ranges = [
            ("nachi.number", self.number, 0, 999),
            ("nachi.accuracy", self.accuracy, 1, 8),
            ("nachi.tool", self.tool, 0, 32),
            ("nachi.max_moves", self.max_moves, 10, 1_000_000),
        ];
        if let Some((name, value, low, high)) = ranges.into_iter().find(|(_, v, lo, hi)| !(lo..=hi).contains(&v)) {
            return Err(format!("{name} = {value}: give {low} to {high}"));
        }
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
        if self.unit.is_empty() || !self.unit.chars().all(plain) {
            return Err(format!("nachi.unit = {:?}: give letters, digits, - and _; it becomes a file name", self.unit));
        }
        Ok(())
    }
}
