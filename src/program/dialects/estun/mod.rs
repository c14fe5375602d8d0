//! ESTUN: an `.erp` of instructions and an `.erd` of the points and speeds that they name.
//!
//! No arm and no controller of this make is known here: everything is from public files of others,
//! and unverified. The flange moves in the robot's base, tool and coordinate system null. As in KRL
//! a speed of the flange gives a move its time: `tcp` of way, `ori` where it turns on the spot.
//! One program however long: how one calls another is not known.

mod read;
mod write;

use super::flange::Speeds;
use super::pace::FlangeWords;
use super::spelling::Spelling;
use super::templates::SignalTemplates;
use crate::cell::controllers::Estun;
use crate::cell::controllers::templates::{fixed, non_blank_lines};
use crate::cell::{Cell, Setup};
use crate::program::dialect::{Dialect, Program, ProgramFile, ReadContext, ReadLine};
use crate::program::neutral::lines::ProgramLine;
use crate::program::neutral::steps::MoveTiming;
use crate::program::neutral::variant::Variant;
use crate::program::read_error::ReadError;
use crate::program::write_error::WriteError;

/// The dialect.
pub struct EstunDialect;

impl Dialect for EstunDialect {
    fn name(&self) -> &'static str {
        "estun"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        write::write(program)
    }

    fn rename(&self, cell: &mut Cell, variant: Variant) {
        cell.estun.name = variant.name(&cell.estun.name, 32);
    }

    fn paces(&self, lines: &[ProgramLine], setup: &Setup) -> Vec<MoveTiming> {
        words(&setup.cell.estun).paces(lines, setup)
    }

    fn unverified(&self, _setup: &Setup) -> Vec<&'static str> {
        // No controller of this make is known here: all of it.
        vec![
            "estun.version",
            "estun.start",
            "MovJ",
            "MovL",
            "APOS",
            "CPOS",
            "SPEED",
            "estun.zone",
            "estun.output_on",
            "estun.output_off",
            "estun.analogue",
            "estun.group",
            "estun.wait",
            "estun.comment",
        ]
    }

    fn claims(&self, text: &str) -> bool {
        let first = non_blank_lines(text).map(|(_, l)| l).find(|l| !l.starts_with("//") && !l.starts_with("/*"));
        first == Some("Start:")
    }

    fn read(&self, file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
        read::read(file, reading)
    }
}

/// Speeds and per cents have six decimals.
fn words(estun: &Estun) -> FlangeWords {
    let most = Speeds { mm_s: estun.max_mm_s, deg_s: estun.max_turn_deg_s };
    FlangeWords { most, decimals: 6, percent_decimals: 6 }
}

/// Comments are lines of their own.
const SPELLING: Spelling =
    Spelling { folds_case: false, comment: None, names_in_brackets: false, comment_starts: &["//", "/*"] };

fn templates(estun: &Estun) -> SignalTemplates<'_> {
    SignalTemplates {
        dialect: "estun",
        output_on: &estun.output_on,
        output_off: &estun.output_off,
        analogue: &estun.analogue,
        analogue_decimals: 3,
        group: &estun.group,
        force_on: &estun.force_on,
        force_off: &estun.force_off,
        wait: &estun.wait,
        seconds: |s| fixed(1000.0 * s, 0),
        wait_per_s: 1000.0,
        comment: &estun.comment,
        forbidden: &['*'],
        width: Some(100),
        spelling: SPELLING,
    }
}

/// External axes 7 to 16, none of which is there.
fn no_axes() -> String {
    (7..=16).map(|i| format!(",a{i}=0.0000000")).collect()
}

/// Arm configuration left to the controller.
const CONFIGURATION: &str = "confdata={_type=\"POSCFG\",mode=0,cf1=0,cf2=0,cf3=0,cf4=0,cf5=0,cf6=0}";
/// What a speed says of external axes.
const NO_AXIS_SPEEDS: &str = "exj_l=360.000000,exj_r=180.000000";
