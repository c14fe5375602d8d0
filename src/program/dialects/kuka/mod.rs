//! KUKA KRL: `.src` with its `.dat`. The flange moves in the robot's base, both frames null; joint
//! moves are `PTP` with axis values, straight ones `LIN`.
//!
//! KRL knows no duration of a move. The speed before a `LIN` gives it: `$VEL.CP` is the flange's
//! way over the time, and where the flange turns on the spot `$VEL.ORI1` and `$VEL.ORI2` are its
//! angle over the time; a move that needs more than the greatest of one of them is slower. Without a position before it a straight move has neither, and is refused.
//! Long programs call subprograms with files of their own; the split is where the laser is off.

mod read;
mod write;

use super::flange::Speeds;
use super::pace::FlangeWords;
use super::spelling::Spelling;
use super::templates::SignalTemplates;
use crate::cell::controllers::Kuka;
use crate::cell::controllers::templates::{fixed, non_blank_lines};
use crate::cell::{Cell, Setup};
use crate::program::dialect::{Dialect, Program, ProgramFile, ReadContext, ReadLine};
use crate::program::neutral::lines::ProgramLine;
use crate::program::neutral::steps::MoveTiming;
use crate::program::neutral::variant::Variant;
use crate::program::read_error::ReadError;
use crate::program::write_error::WriteError;

/// The dialect.
pub struct KukaDialect;

impl Dialect for KukaDialect {
    fn name(&self) -> &'static str {
        "kuka"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        write::write(program)
    }

    fn rename(&self, cell: &mut Cell, variant: Variant) {
        // 24 letters, and subprograms add up to four.
        cell.kuka.name = variant.name(&cell.kuka.name, 20);
    }

    fn paces(&self, lines: &[ProgramLine], setup: &Setup) -> Vec<MoveTiming> {
        words(&setup.cell.kuka).paces(lines, setup)
    }

    fn unverified(&self, setup: &Setup) -> Vec<&'static str> {
        // Joint moves to poses have no status and turn; with a robot they go to axis values.
        let to_poses = setup.robot.is_none().then_some("PTP");
        ["BAS", "INTERRUPT", "C_DIS", "$VEL.ORI1", "$VEL.ORI2"].into_iter().chain(to_poses).collect()
    }

    fn claims(&self, text: &str) -> bool {
        let first = non_blank_lines(text).map(|(_, l)| l).find(|l| !l.starts_with(['&', ';']));
        first.map(|l| SPELLING.plain(l)).is_some_and(|l| l.starts_with("DEF ") && l.ends_with(')'))
    }

    fn read(&self, file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
        read::read(file, reading)
    }
}

/// `$VEL.CP` has eight decimals in m/s, `$VEL.ORI1` five, and per cents none.
fn words(kuka: &Kuka) -> FlangeWords {
    let most = Speeds { mm_s: 1000.0 * kuka.max_m_s, deg_s: kuka.max_turn_deg_s };
    FlangeWords { most, decimals: 5, percent_decimals: 0 }
}

/// Comments and folds begin with `;`, behind code as well.
const SPELLING: Spelling =
    Spelling { folds_case: true, comment: Some(';'), names_in_brackets: false, comment_starts: &[";"] };

fn templates(kuka: &Kuka) -> SignalTemplates<'_> {
    SignalTemplates {
        dialect: "kuka",
        output_on: &kuka.output_on,
        output_off: &kuka.output_off,
        analogue: &kuka.analogue,
        analogue_decimals: 3,
        group: &kuka.group,
        force_on: &kuka.force_on,
        force_off: &kuka.force_off,
        wait: &kuka.wait,
        seconds: |s| fixed(s, 3),
        wait_per_s: 1.0,
        comment: &kuka.comment,
        forbidden: &[],
        width: Some(100),
        spelling: SPELLING,
    }
}

/// The settings before the first move.
fn settings(kuka: &Kuka) -> Vec<String> {
    let mut out = kuka.start.clone();
    out.extend(["$BASE=$NULLFRAME", "$TOOL=$NULLFRAME", "$IPO_MODE=#BASE"].map(String::from));
    out.push(format!("$APO.CDIS={}", fixed(kuka.blend_mm, 3)));
    out
}

const AXES: [&str; 6] = ["A1", "A2", "A3", "A4", "A5", "A6"];
const FRAME: [&str; 6] = ["X", "Y", "Z", "A", "B", "C"];
