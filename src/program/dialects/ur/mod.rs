//! URScript: one file with one program, `def Clean(): … end` and its call. The tool centre point is set to the
//! flange, so the poses are the flange's. Long programs are cut into functions.
//!
//! Not verified on a controller: how many moves a function may have, and how the arm keeps the times of short moves
//! that are rounded; and how `force_mode`, whose direction is that of the flange where it begins, follows a curved
//! surface.

mod read;
mod write;

use super::pace;
use super::spelling::Spelling;
use super::templates::SignalTemplates;
use crate::cell::controllers::Ur;
use crate::cell::controllers::templates::{fixed, non_blank_lines};
use crate::cell::{Cell, Setup};
use crate::program::dialect::{Dialect, Program, ProgramFile, ReadContext, ReadLine};
use crate::program::neutral::lines::ProgramLine;
use crate::program::neutral::steps::MoveTiming;
use crate::program::neutral::variant::Variant;
use crate::program::read_error::ReadError;
use crate::program::write_error::WriteError;

/// The dialect.
pub struct UrDialect;

impl Dialect for UrDialect {
    fn name(&self) -> &'static str {
        "ur"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        write::write(program)
    }

    fn rename(&self, cell: &mut Cell, variant: Variant) {
        cell.ur.program = variant.name(&cell.ur.program, 32);
    }

    fn paces(&self, lines: &[ProgramLine], _setup: &Setup) -> Vec<MoveTiming> {
        pace::each(lines, |m| match m.timing {
            MoveTiming::Seconds(s) => pace::seconds(s, 4),
            percent @ MoveTiming::Percent(_) => percent,
        })
    }

    fn unverified(&self, setup: &Setup) -> Vec<&'static str> {
        let force = setup.keeps_force().then_some(["ur.force_on", "ur.force_off"]);
        ["ur.max_moves", "ur.blend_mm"].into_iter().chain(force.into_iter().flatten()).collect()
    }

    fn claims(&self, text: &str) -> bool {
        let code = || non_blank_lines(text).map(|(_, l)| l).filter(|l| !l.starts_with('#'));
        let is_call = |l: &str| ["movej(", "movel(", "set_tcp("].iter().any(|call| l.starts_with(call));
        code().any(|l| l.starts_with("def ")) && code().any(is_call)
    }

    fn read(&self, file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
        read::read(file, reading)
    }
}

/// Comments begin with `#`, behind code as well.
const SPELLING: Spelling =
    Spelling { folds_case: false, comment: Some('#'), names_in_brackets: false, comment_starts: &["#"] };

fn templates(ur: &Ur) -> SignalTemplates<'_> {
    SignalTemplates {
        dialect: "ur",
        output_on: &ur.output_on,
        output_off: &ur.output_off,
        analogue: &ur.analogue,
        analogue_decimals: 4,
        group: &ur.group,
        force_on: &ur.force_on,
        force_off: &ur.force_off,
        wait: "sleep({s})",
        seconds: |s| fixed(s, 3),
        wait_per_s: 1.0,
        comment: "# {text}",
        forbidden: &[],
        width: None,
        spelling: SPELLING,
    }
}
