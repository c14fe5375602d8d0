//! The `[abb]` table of a cell file.

use super::templates::{check_force, check_signals};
use crate::cell::check::{FigureError, Letters, name, plain_lines, ranges};
use serde::{Deserialize, Serialize};

/// What the RAPID program needs; words that sources disagree on are templates.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Abb {
    /// Name of the module and its file.
    pub module: String,
    /// Procedure to start; parts of a long program are numbered after it.
    pub procedure: String,
    /// Name of the tool data: the laser.
    pub tool: String,
    /// Mass of what the robot carries, kg; RAPID refuses 0.
    pub mass_kg: f64,
    /// Name of the work object: the part.
    pub work_object: String,
    /// Statements before the first move.
    pub start: Vec<String>,
    /// Zone of points that the robot need not stop at.
    pub zone: String,
    /// Speed of the tool centre point that 100 per cent of a joint move stand for, mm/s.
    pub full_mm_s: f64,
    /// Moves of a procedure before it is split.
    pub max_moves: usize,
    /// Statement that switches output `{n}` on.
    pub output_on: String,
    /// Statement that switches it off.
    pub output_off: String,
    /// Statement that sets analogue output `{n}` to `{v}`.
    pub analogue: String,
    /// Statement that sets the group `{n}` of digital outputs to the whole number `{v}`.
    pub group: String,
    /// Statement that waits `{s}` seconds.
    pub wait: String,
    /// Comment line; `{text}` is replaced.
    pub comment: String,
    /// Statement that makes a contact tool press with `{f}` newtons from there on; empty: that is a comment.
    pub force_on: String,
    /// Statement that ends it.
    pub force_off: String,
    /// Ends lines with CR LF.
    pub crlf: bool,
}

impl Default for Abb {
    fn default() -> Self {
        Abb {
            module: "clearbeam".into(),
            procedure: "main".into(),
            tool: "tLaser".into(),
            mass_kg: 1.0,
            work_object: "oPart".into(),
            start: ["ConfJ\\Off;", "ConfL\\Off;"].map(String::from).into(),
            zone: "z0".into(),
            full_mm_s: 5000.0,
            max_moves: 5000,
            output_on: "SetDO do{n},1;".into(),
            output_off: "SetDO do{n},0;".into(),
            analogue: "SetAO ao{n},{v};".into(),
            group: "SetGO go{n},{v};".into(),
            wait: "WaitTime {s};".into(),
            comment: "! {text}".into(),
            force_on: "FCRefForce \\Fz:={f}; FCRefStart;".into(),
            force_off: "FCRefStop;".into(),
            crlf: true,
        }
    }
}

impl Abb {
    /// Whether the controller can take all of it.
    ///
    /// # Errors
    /// The first that it cannot.
    pub fn check(&self) -> Result<(), FigureError> {
        name("abb.module", &self.module, Letters::Identifier, 32)?;
        // 32 letters, and numbered parts add up to four.
        name("abb.procedure", &self.procedure, Letters::Identifier, 28)?;
        name("abb.tool", &self.tool, Letters::Identifier, 32)?;
        name("abb.work_object", &self.work_object, Letters::Identifier, 32)?;
        name("abb.zone", &self.zone, Letters::Identifier, 32)?;
        plain_lines("abb.start", &self.start)?;
        ranges(&[
            ("abb.mass_kg", self.mass_kg, 0.001, 2000.0),
            ("abb.full_mm_s", self.full_mm_s, 100.0, 20_000.0),
            ("abb.max_moves", self.max_moves as f64, 100.0, 100_000.0),
        ])?;
        let all = [&self.output_on, &self.output_off, &self.analogue, &self.group, &self.wait, &self.comment];
        check_signals("abb", all.map(|t| Some(t.as_str())))?;
        check_force("abb", &self.force_on, &self.force_off)?;
        Ok(())
    }
}
