//! FANUC TP program as a listing (`.LS`): numbered lines, and the positions behind them as joints, or as poses
//! without a robot. The controller's joint 3 is the robot file's less joint 2.
//!
//! Not verified on a controller: more than three decimals in positions, and that user frame and tool are as the cell
//! file says.

mod read;
mod write;

use super::pace;
use super::spelling::Spelling;
use super::templates::SignalTemplates;
use crate::cell::controllers::Fanuc;
use crate::cell::controllers::templates::{fixed, non_blank_lines};
use crate::cell::{Cell, Setup};
use crate::program::dialect::{Dialect, Program, ProgramFile, ReadContext, ReadLine};
use crate::program::neutral::lines::ProgramLine;
use crate::program::neutral::steps::MoveTiming;
use crate::program::neutral::variant::Variant;
use crate::program::read_error::ReadError;
use crate::program::write_error::WriteError;

/// The dialect.
pub struct FanucDialect;

impl Dialect for FanucDialect {
    fn name(&self) -> &'static str {
        "fanuc"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        write::write(program)
    }

    fn rename(&self, cell: &mut Cell, variant: Variant) {
        // 32 letters, and subprograms add up to four.
        cell.fanuc.program = variant.name(&cell.fanuc.program, 28);
    }

    fn paces(&self, lines: &[ProgramLine], _setup: &Setup) -> Vec<MoveTiming> {
        pace::each(lines, |m| match m.timing {
            MoveTiming::Seconds(s) => MoveTiming::Seconds(paced_s(s)),
            MoveTiming::Percent(p) => pace::percent(p, 0),
        })
    }

    fn most_lit_moves(&self, setup: &Setup) -> Option<usize> {
        Some((setup.cell.fanuc.max_lines as usize).saturating_sub(LINES_OF_SWITCHING))
    }

    fn unverified(&self, _setup: &Setup) -> Vec<&'static str> {
        vec!["/POS", "UFRAME_NUM", "UTOOL_NUM"]
    }

    fn claims(&self, text: &str) -> bool {
        non_blank_lines(text).next().is_some_and(|(_, l)| SPELLING.plain(l).starts_with("/PROG"))
    }

    fn read(&self, file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
        read::read(file, reading)
    }
}

/// Whether the controller's joint 3 is the file's less joint 2. Every FANUC arm known here has it so.
fn is_coupled(setup: &Setup) -> bool {
    setup.robot.as_ref().is_none_or(|r| r.couples_j2_j3)
}

/// Longest time in `msec`; above it is `sec` with one decimal.
const MOST_MSEC: f64 = 32000.0;

/// The least time of the words that is not below so many seconds: whole milliseconds, or tenths of a second.
fn paced_s(seconds: f64) -> f64 {
    let msec = pace::at_least(1000.0 * seconds, 0).max(1.0);
    if msec <= MOST_MSEC { msec / 1000.0 } else { pace::at_least(seconds, 1) }
}

/// Lines that switch laser and powder on and off about a lit piece, with their waits.
const LINES_OF_SWITCHING: usize = 8;

/// Longest comment.
const REMARK: usize = 32;

/// Comments are instructions of their own; outputs and positions may be named.
const SPELLING: Spelling =
    Spelling { folds_case: true, comment: None, names_in_brackets: true, comment_starts: &["!", "--eg:"] };

/// Instructions without their semicolons.
fn templates(fanuc: &Fanuc) -> SignalTemplates<'_> {
    SignalTemplates {
        dialect: "fanuc",
        output_on: &fanuc.output_on,
        output_off: &fanuc.output_off,
        analogue: &fanuc.analogue,
        analogue_decimals: 3,
        group: &fanuc.group,
        force_on: &fanuc.force_on,
        force_off: &fanuc.force_off,
        wait: "WAIT {s}(sec)",
        // A dwell of 0 would say nothing.
        seconds: |s| fixed(s.max(0.01), 2).trim_start_matches('0').into(),
        wait_per_s: 1.0,
        comment: "!{text}",
        forbidden: &[';'],
        width: Some(REMARK),
        spelling: SPELLING,
    }
}
