//! FANUC TP program as a listing (`.LS`): numbered lines, and the positions behind them as joints, or as poses
//! without a robot. The controller's joint 3 is the robot file's less joint 2.
//!
//! Not verified on a controller: more than three decimals in positions, and that user frame and tool are as the cell
//! file says.

mod read;
mod write;

use super::spelling::Spelling;
use super::templates::SignalTemplates;
use crate::cell::Setup;
use crate::cell::controllers::Fanuc;
use crate::cell::controllers::templates::{fixed, non_blank_lines};
use crate::program::dialect::{Dialect, Program, ProgramFile, ReadContext, ReadLine};
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
