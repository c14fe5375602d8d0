//! Yaskawa INFORM: a `.JBI` job of positions and instructions. Straight moves are `MOVL` to flange
//! poses in the base frame (`RECTAN`), joint moves `MOVJ`: to `PULSE` positions where the cell file
//! says how many pulses make a degree, else to poses.
//!
//! INFORM knows no duration of a move. `V=` (mm/s) or, where the flange mostly turns, `VR=` (degrees
//! per second) is its way or angle over the time. Both have one decimal, and of the two the one
//! that keeps more digits is taken; without a position before it a move has neither, and is refused.
//!
//! `RCONF` says the arm's shape, all 0 without a robot: R-axis beyond ±90°, elbow down, wrist behind
//! axis 1, then R, T and S beyond ±180°. That rule is not verified. Long jobs `CALL` numbered ones;
//! the split is where the laser is off.

mod positions;
mod read;
mod write;

use super::flange::joints;
use super::spelling::Spelling;
use super::templates::SignalTemplates;
use crate::cell::controllers::Yaskawa;
use crate::cell::controllers::templates::{fixed, non_blank_lines};
use crate::cell::{Cell, Joints, Setup};
use crate::program::dialect::{Dialect, Program, ProgramFile, ReadContext, ReadLine};
use crate::program::neutral::lines::ProgramLine;
use crate::program::neutral::steps::MoveTiming;
use crate::program::neutral::variant::Variant;
use crate::program::read_error::ReadError;
use crate::program::write_error::WriteError;

/// The dialect.
pub struct YaskawaDialect;

impl Dialect for YaskawaDialect {
    fn name(&self) -> &'static str {
        "yaskawa"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        write::write(program)
    }

    fn rename(&self, cell: &mut Cell, variant: Variant) {
        // Parts add up to three digits.
        cell.yaskawa.name = variant.name(&cell.yaskawa.name, cell.yaskawa.longest_name - 3);
    }

    fn paces(&self, lines: &[ProgramLine], setup: &Setup) -> Vec<MoveTiming> {
        write::paces(lines, setup)
    }

    fn unverified(&self, _setup: &Setup) -> Vec<&'static str> {
        vec!["RCONF", "VR", "PL", "///ATTR", "yaskawa.base_height_mm"]
    }

    fn claims(&self, text: &str) -> bool {
        non_blank_lines(text).next().is_some_and(|(_, l)| l == "/JOB")
    }

    fn read(&self, file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
        read::read(file, reading)
    }
}

/// Comments are lines of their own.
const SPELLING: Spelling =
    Spelling { folds_case: false, comment: None, names_in_brackets: false, comment_starts: &["'"] };

fn templates(yaskawa: &Yaskawa) -> SignalTemplates<'_> {
    SignalTemplates {
        dialect: "yaskawa",
        output_on: &yaskawa.output_on,
        output_off: &yaskawa.output_off,
        analogue: &yaskawa.analogue,
        analogue_decimals: 3,
        group: &yaskawa.group,
        force_on: "",
        force_off: "",
        wait: &yaskawa.wait,
        seconds: |s| fixed(s, 2),
        wait_per_s: 1.0,
        comment: &yaskawa.comment,
        forbidden: &[],
        width: Some(28),
        spelling: SPELLING,
    }
}

/// Joint angles of pulses, as in the robot file.
fn from_pulses(setup: &Setup, pulses: &Joints, per_deg: &[f64; 6]) -> Joints {
    joints(setup, &std::array::from_fn(|i| pulses[i] / per_deg[i]))
}
