//! NACHI AX/FD text program (SLIM): `MOVEX` with joints (`M1J`) or flange poses (`M1X`), and the time `T=` of each
//! move.
//!
//! The time is what sets the spot's speed on the part: the flange travels otherwise far than the spot. Positions have
//! three decimals of a millimetre and four of a degree. Not verified on a controller: that it keeps so many, brackets
//! of outputs, and how long a program may be; the cell file has the last two.

mod read;
mod write;

use super::pace;
use super::spelling::Spelling;
use super::templates::SignalTemplates;
use crate::cell::controllers::Nachi;
use crate::cell::controllers::templates::{fixed, non_blank_lines};
use crate::cell::{Cell, Setup};
use crate::program::dialect::{Dialect, Program, ProgramFile, ReadContext, ReadLine};
use crate::program::neutral::lines::ProgramLine;
use crate::program::neutral::steps::MoveTiming;
use crate::program::neutral::variant::Variant;
use crate::program::read_error::ReadError;
use crate::program::write_error::WriteError;

/// The dialect.
pub struct NachiDialect;

impl Dialect for NachiDialect {
    fn name(&self) -> &'static str {
        "nachi"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        write::write(program)
    }

    fn rename(&self, cell: &mut Cell, variant: Variant) {
        cell.nachi.number = variant.number(cell.nachi.number);
    }

    fn paces(&self, lines: &[ProgramLine], _setup: &Setup) -> Vec<MoveTiming> {
        pace::each(lines, |m| match m.timing {
            MoveTiming::Seconds(s) => pace::seconds(s, 4),
            MoveTiming::Percent(p) => pace::percent(p, 1),
        })
    }

    fn unverified(&self, _setup: &Setup) -> Vec<&'static str> {
        vec!["nachi.output_on", "nachi.output_off", "nachi.wait", "nachi.max_moves", "nachi.form"]
    }

    fn claims(&self, text: &str) -> bool {
        non_blank_lines(text).any(|(_, l)| matches!(l.split_whitespace().next(), Some("MOVEX" | "CALLP")))
    }

    fn read(&self, file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
        read::read(file, reading)
    }
}

/// Name of the program file, `<unit>-A.<3-digit number>`.
pub fn file_name(cell: &Cell) -> String {
    numbered(&cell.nachi, cell.nachi.number)
}

fn numbered(nachi: &Nachi, number: u32) -> String {
    format!("{}-A.{number:03}", nachi.unit)
}

/// Comments are `REM` or begin with an apostrophe.
const SPELLING: Spelling =
    Spelling { folds_case: false, comment: None, names_in_brackets: false, comment_starts: &["REM ", "'"] };

fn templates(nachi: &Nachi) -> SignalTemplates<'_> {
    SignalTemplates {
        dialect: "nachi",
        output_on: &nachi.output_on,
        output_off: &nachi.output_off,
        analogue: &nachi.analogue,
        analogue_decimals: 3,
        group: &nachi.group,
        force_on: "",
        force_off: "",
        wait: &nachi.wait,
        seconds: |s| fixed(s, 3),
        wait_per_s: 1.0,
        comment: &nachi.comment,
        forbidden: &['"'],
        width: None,
        spelling: SPELLING,
    }
}
