//! The `[estun]` table of a cell file.

use super::templates::{check_force, check_signals};
use crate::cell::check::{FigureError, Letters, WordForm, name, plain_lines, ranges};
use serde::{Deserialize, Serialize};

/// What the ESTUN program needs; words that sources disagree on are templates.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Estun {
    /// Name of the program and its files.
    pub name: String,
    /// First line of the program.
    pub version: String,
    /// Lines after `Start:`.
    pub start: Vec<String>,
    /// Zone of points that the robot need not stop at, one of the system's.
    pub zone: String,
    /// Greatest speed of the flange, mm/s.
    pub max_mm_s: f64,
    /// Greatest speed of its turning, degrees per second.
    pub max_turn_deg_s: f64,
    /// Line that switches output `{n}` on.
    pub output_on: String,
    /// Line that switches it off.
    pub output_off: String,
    /// Line that sets analogue output `{n}` to `{v}`.
    pub analogue: String,
    /// Line that sets the group `{n}` of digital outputs to the whole number `{v}`.
    pub group: String,
    /// Line that waits `{s}` milliseconds.
    pub wait: String,
    /// Comment line; `{text}` is replaced.
    pub comment: String,
    /// Line that makes a contact tool press with `{f}` newtons from there on; empty: that is a comment.
    pub force_on: String,
    /// Line that ends it.
    pub force_off: String,
    /// Ends lines with CR LF.
    pub crlf: bool,
}

impl Default for Estun {
    fn default() -> Self {
        Estun {
            name: "clearbeam".into(),
            version: "// InstParseVersion: V1.02".into(),
            start: ["SetTool{Tool=t_s.nullTool}", "SetCoord{Coord=t_s.World}"].map(String::from).into(),
            zone: "C10".into(),
            max_mm_s: 2000.0,
            max_turn_deg_s: 360.0,
            output_on: "SetDO{IO=t_s.DO{n},Val=1}".into(),
            output_off: "SetDO{IO=t_s.DO{n},Val=0}".into(),
            analogue: "SetAO{IO=t_s.AO{n},Val={v}}".into(),
            group: "SetGO{IO=t_s.GO{n},Val={v}}".into(),
            wait: "Wait{T={s}}".into(),
            comment: "/* {text} */".into(),
            force_on: String::new(),
            force_off: String::new(),
            crlf: true,
        }
    }
}

impl Estun {
    /// Whether the controller can take all of it.
    ///
    /// # Errors
    /// The first that it cannot.
    pub fn check(&self) -> Result<(), FigureError> {
        name("estun.name", &self.name, Letters::Identifier, 32)?;
        name("estun.zone", &self.zone, Letters::Identifier, 32)?;
        plain_lines("estun.start", &self.start)?;
        if !self.version.starts_with("//") || !self.version.chars().all(|c| c.is_ascii_graphic() || c == ' ') {
            let value = format!("{:?}", self.version);
            return Err(FigureError::WordForm { key: "estun.version", value, form: WordForm::Version });
        }
        ranges(&[
            ("estun.max_mm_s", self.max_mm_s, 10.0, 10_000.0),
            ("estun.max_turn_deg_s", self.max_turn_deg_s, 1.0, 1000.0),
        ])?;
        let all = [&self.output_on, &self.output_off, &self.analogue, &self.group, &self.wait, &self.comment];
        check_signals("estun", all.map(|t| Some(t.as_str())))?;
        check_force("estun", &self.force_on, &self.force_off)?;
        Ok(())
    }
}
