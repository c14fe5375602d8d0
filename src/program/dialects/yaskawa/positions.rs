//! The positions of a job, read back: poses and pulses, with the lines that count for those after them.

use super::from_pulses;
use crate::cell::Setup;
use crate::cell::controllers::templates::numbers;
use crate::program::dialect::{Goal, Statement};
use crate::program::dialects::flange::pose;
use crate::program::read_error::LineFault;
use nalgebra::Translation3;

/// A position of a job: where, and its `RCONF`.
#[derive(Clone, Debug)]
pub struct ReadPosition {
    /// Where.
    pub goal: Goal,
    /// `RCONF=` and its figures; empty for pulses.
    pub figure: String,
}

/// The positions, and the state that counts for the next.
#[derive(Default)]
pub struct JobPositions {
    /// How many are promised.
    pub expected: usize,
    /// Those that were read.
    pub list: Vec<ReadPosition>,
    /// Whether the tool was said, which each kind of positions begins with.
    is_tool_said: bool,
    /// The tool of the last positions.
    tool: Option<String>,
    pulses: Option<bool>,
    /// The line after `///POSTYPE` that says the kind again.
    owed: Option<&'static str>,
    figure: Option<String>,
}

impl JobPositions {
    /// Takes a line. Gives what it says that counts for the whole job: another tool than before.
    pub fn line(&mut self, setup: &Setup, text: &str) -> Result<Option<Statement>, LineFault> {
        if let Some(owed) = self.owed.take() {
            return if text == owed { Ok(None) } else { Err(LineFault::expected([owed], text)) };
        }
        if text.starts_with("///POSTYPE ") && !std::mem::take(&mut self.is_tool_said) {
            return Err(LineFault::Before { missing: "///TOOL".into() });
        }
        match text {
            "///POSTYPE BASE" => (self.pulses, self.owed, self.figure) = (Some(false), Some("///RECTAN"), None),
            "///POSTYPE PULSE" => (self.pulses, self.owed) = (Some(true), Some("///PULSE")),
            _ if text.starts_with("///POSTYPE ") => {
                return Err(LineFault::expected(["///POSTYPE BASE", "///POSTYPE PULSE"], text));
            }
            _ => {
                if let Some(tool) = text.strip_prefix("///TOOL ") {
                    self.is_tool_said = true;
                    let is_another = self.tool.replace(tool.into()).is_none_or(|before| before != tool);
                    return Ok(is_another.then(|| Statement::Other(text.into())));
                }
                if let Some(figure) = text.strip_prefix("///RCONF ") {
                    let is_figure = figure.split(',').all(|f| matches!(f, "0" | "1")) && figure.split(',').count() == 8;
                    self.figure = is_figure.then(|| figure.into());
                    let form = || LineFault::expected(["///RCONF 0,0,0,0,0,0,0,0"], text);
                    return self.figure.as_ref().map(|_| None).ok_or_else(form);
                }
                self.position(setup, text)?;
            }
        }
        Ok(None)
    }

    fn position(&mut self, setup: &Setup, text: &str) -> Result<(), LineFault> {
        let yaskawa = &setup.cell.yaskawa;
        let start = format!("C{:05}=", self.list.len());
        let rest = text.strip_prefix(&start).ok_or_else(|| LineFault::expected([start.clone()], text))?;
        let six: [f64; 6] = numbers(rest).ok_or_else(|| LineFault::numbers(6, rest))?;
        let position = match self.pulses.ok_or(LineFault::Before { missing: "///POSTYPE".into() })? {
            true => {
                let per_deg = yaskawa.pulses_per_deg.ok_or(LineFault::NoPulsesPerDegree)?;
                ReadPosition { goal: Goal::Joints(from_pulses(setup, &six, &per_deg)), figure: String::new() }
            }
            false => {
                let figure = self.figure.as_ref().ok_or(LineFault::Before { missing: "///RCONF".into() })?;
                let [x, y, z, rx, ry, rz] = six;
                let at = Translation3::new(0.0, 0.0, yaskawa.base_height_mm) * pose([x, y, z, rz, ry, rx]);
                ReadPosition { goal: Goal::Flange(at), figure: format!("RCONF={figure}") }
            }
        };
        self.list.push(position);
        Ok(())
    }
}
