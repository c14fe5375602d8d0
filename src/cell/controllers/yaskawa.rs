//! The `[yaskawa]` table of a cell file.

use super::templates::check_signals;
use crate::cell::check::{FigureError, Letters, WordForm, name, plain_lines, ranges};
use serde::{Deserialize, Serialize};

/// What the INFORM job needs; words that sources disagree on are templates.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Yaskawa {
    /// Name of the job and its file; parts of a long one are numbered after it.
    pub name: String,
    /// Longest name that the controller takes: 8, newer ones 32.
    pub longest_name: usize,
    /// Tool number; its frame has to be the flange.
    pub tool: u32,
    /// Lines between `//INST` and `NOP`.
    pub start: Vec<String>,
    /// Height of the origin of the controller's base frame over that of the robot file, mm.
    pub base_height_mm: f64,
    /// Pulses of each axis for a degree, 0 at 0; without them no position is in joints.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pulses_per_deg: Option<[f64; 6]>,
    /// `PL=` of points that the robot need not stop at, 0 (exact) to 8.
    pub level: u32,
    /// Instructions of a job before it is split.
    pub max_lines: usize,
    /// Instruction that switches output `{n}` on.
    pub output_on: String,
    /// Instruction that switches it off.
    pub output_off: String,
    /// Instruction that sets analogue output `{n}` to `{v}`.
    pub analogue: String,
    /// Instruction that sets the group `{n}` of digital outputs to the whole number `{v}`.
    pub group: String,
    /// Instruction that waits `{s}` seconds.
    pub wait: String,
    /// Comment line; `{text}` is replaced.
    pub comment: String,
    /// Ends lines with CR LF.
    pub crlf: bool,
}

impl Default for Yaskawa {
    fn default() -> Self {
        let start =
            ["///DATE 2020/01/01 00:00", "///COMM clearbeam", "///ATTR SC,RW,RJ", "////FRAME BASE", "///GROUP1 RB1"];
        Yaskawa {
            name: "CLEAN".into(),
            longest_name: 8,
            tool: 0,
            start: start.map(String::from).into(),
            base_height_mm: 0.0,
            pulses_per_deg: None,
            level: 1,
            max_lines: 5000,
            output_on: "DOUT OT#({n}) ON".into(),
            output_off: "DOUT OT#({n}) OFF".into(),
            analogue: "AOUT AO#({n}) {v}".into(),
            group: "DOUT OG#({n}) {v}".into(),
            wait: "TIMER T={s}".into(),
            comment: "'{text}".into(),
            crlf: true,
        }
    }
}

impl Yaskawa {
    /// Whether the controller can take all of it.
    ///
    /// # Errors
    /// The first that it cannot.
    pub fn check(&self) -> Result<(), FigureError> {
        let wrong = |key, value, form| FigureError::WordForm { key, value, form };
        if !matches!(self.longest_name, 8 | 32) {
            return Err(wrong("yaskawa.longest_name", self.longest_name.to_string(), WordForm::LongestName));
        }
        // Parts add up to three digits.
        name("yaskawa.name", &self.name, Letters::Capitals, self.longest_name - 3)?;
        plain_lines("yaskawa.start", &self.start)?;
        if let Some(bad) = self.start.iter().find(|l| !l.starts_with("///")) {
            return Err(wrong("yaskawa.start", format!("{bad:?}"), WordForm::Attributes));
        }
        ranges(&[
            ("yaskawa.tool", f64::from(self.tool), 0.0, 63.0),
            ("yaskawa.base_height_mm", self.base_height_mm, -5000.0, 5000.0),
            ("yaskawa.level", f64::from(self.level), 0.0, 8.0),
            ("yaskawa.max_lines", self.max_lines as f64, 100.0, 99_999.0),
        ])?;
        for pulses in self.pulses_per_deg.iter().flatten() {
            if !(10.0..=1e6).contains(&pulses.abs()) {
                return Err(wrong("yaskawa.pulses_per_deg", pulses.to_string(), WordForm::Pulses));
            }
        }
        let all = [&self.output_on, &self.output_off, &self.analogue, &self.group, &self.wait, &self.comment];
        check_signals("yaskawa", all.map(|t| Some(t.as_str())))?;
        Ok(())
    }
}
