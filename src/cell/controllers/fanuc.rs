//! The `[fanuc]` table of a cell file.

use serde::{Deserialize, Serialize};

/// What the program needs; words that sources disagree on are templates.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Fanuc {
    /// Name of the program and its file; sub-programs add a number.
    pub program: String,
    /// User frame, `UF`: its origin in the robot's foot, as the poses are.
    pub user_frame: u32,
    /// User tool, `UT`: without any offset, because the poses are the flange's.
    pub user_tool: u32,
    /// How one lit move goes over into the next.
    pub termination: String,
    /// Configuration of targets that are poses; joints need none.
    pub configuration: String,
    /// Lines in one program; longer programs call sub-programs.
    pub max_lines: u32,
    /// Instruction that switches output `{n}` on.
    pub output_on: String,
    /// Instruction that switches it off.
    pub output_off: String,
    /// Instruction that sets analogue output `{n}` to `{v}`.
    pub analogue: String,
    /// Instruction that sets the group of outputs `{n}` to `{v}`.
    pub group: String,
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
            crlf: false,
        }
    }
}

impl Fanuc {
    /// # Errors
    /// Which figure makes no sense, and what it may be.
    pub fn check(&self) -> Result<(), String> {
        let ranges = [
            ("fanuc.user_frame", self.user_frame, 0, 61),
            ("fanuc.user_tool", self.user_tool, 0, 29),
            ("fanuc.max_lines", self.max_lines, 50, 9999),
        ];
        if let Some((name, value, low, high)) = ranges.into_iter().find(|(_, v, lo, hi)| !(lo..=hi).contains(&v)) {
            return Err(format!("{name} = {value}: give {low} to {high}"));
        }
        let name = &self.program;
        let plain = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
        if !name.starts_with(|c: char| c.is_ascii_uppercase()) || !name.chars().all(plain) || name.len() > 32 {
            return Err(format!("fanuc.program = {name:?}: give a capital, then capitals, digits and _, 32 at most"));
        }
        let share = self.termination.strip_prefix("CNT").and_then(|n| n.parse().ok());
        if self.termination != "FINE" && share.is_none_or(|n: u32| n > 100) {
            return Err(format!("fanuc.termination = {:?}: give FINE, or CNT0 to CNT100", self.termination));
        }
        let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, ' ' | ',' | '-');
        if self.configuration.is_empty() || !self.configuration.chars().all(plain) {
            return Err(format!("fanuc.configuration = {:?}: give the like of N U T, 0, 0, 0", self.configuration));
        }
        Ok(())
    }
}
