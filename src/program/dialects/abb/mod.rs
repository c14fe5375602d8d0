//! ABB RAPID, one `.mod`: joint moves are `MoveAbsJ`, straight ones `MoveL`, each with its time `\T`.
//!
//! The spot itself is programmed, so that the controller moves it straight over the part. Part in
//! hand: the tool is the fixed laser (`robhold` FALSE) and the work object the part in the gripper
//! (`robhold` TRUE), so that a target is the focus in the part. Tool in hand: the robot holds the
//! tool, whose z points with the light, and the target is the focus turned half about y.
//!
//! Configurations `[cf1,cf4,cf6,cfx]`: the quarter that axes 1, 4 and 6 stand in, and
//! `cfx = 4·(wrist behind axis 1) + 2·(wrist behind the lower arm) + (axis 5 below 0)`; without a
//! robot all 0. That rule is not verified, and supervision is off (`ConfL\Off`).
//! Words of force control are from memory of the option's manual and not verified: it has to be activated (`FCAct`)
//! and its force frame set in the lines of `start`.
//!
//! Long programs call numbered procedures of the same module; the split is where the laser is off.

mod read;
mod write;

use super::pace;
use super::spelling::Spelling;
use super::templates::SignalTemplates;
use crate::cell::controllers::Abb;
use crate::cell::controllers::templates::{fixed, non_blank_lines};
use crate::cell::mounting::half_turn;
use crate::cell::{Cell, Mount, Setup};
use crate::program::dialect::{Dialect, Program, ProgramFile, ReadContext, ReadLine};
use crate::program::neutral::lines::ProgramLine;
use crate::program::neutral::steps::MoveTiming;
use crate::program::neutral::variant::Variant;
use crate::program::read_error::ReadError;
use crate::program::write_error::WriteError;
use nalgebra::Isometry3;

/// The dialect.
pub struct AbbDialect;

/// Speed of turning that 100 per cent stand for, degrees per second.
const FULL_DEG_S: f64 = 500.0;

impl Dialect for AbbDialect {
    fn name(&self) -> &'static str {
        "abb"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        write::write(program)
    }

    fn rename(&self, cell: &mut Cell, variant: Variant) {
        cell.abb.module = variant.name(&cell.abb.module, 32);
    }

    fn paces(&self, lines: &[ProgramLine], _setup: &Setup) -> Vec<MoveTiming> {
        pace::each(lines, |m| match m.timing {
            MoveTiming::Seconds(s) => pace::seconds(s, 4),
            percent @ MoveTiming::Percent(_) => percent,
        })
    }

    fn unverified(&self, setup: &Setup) -> Vec<&'static str> {
        let force = setup.keeps_force().then_some(["abb.force_on", "abb.force_off"]);
        ["confdata", "speeddata", "zonedata", "robhold"].into_iter().chain(force.into_iter().flatten()).collect()
    }

    fn claims(&self, text: &str) -> bool {
        let first = non_blank_lines(text).map(|(_, l)| l).find(|l| !is_attribute(l) && !l.starts_with('!'));
        first.is_some_and(|l| SPELLING.plain(l).starts_with("MODULE "))
    }

    fn read(&self, file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
        read::read(file, reading.setup)
    }
}

/// Comments begin with `!`, behind code as well.
const SPELLING: Spelling =
    Spelling { folds_case: true, comment: Some('!'), names_in_brackets: false, comment_starts: &["!"] };

/// A line of what the controller sets before a module: `%%%`, `VERSION:1`, `LANGUAGE:ENGLISH`, `%%%`.
fn is_attribute(line: &str) -> bool {
    ["%%%", "VERSION:", "LANGUAGE:"].iter().any(|start| SPELLING.plain(line).starts_with(start))
}

fn templates(abb: &Abb) -> SignalTemplates<'_> {
    SignalTemplates {
        dialect: "abb",
        output_on: &abb.output_on,
        output_off: &abb.output_off,
        analogue: &abb.analogue,
        analogue_decimals: 3,
        group: &abb.group,
        force_on: &abb.force_on,
        force_off: &abb.force_off,
        wait: &abb.wait,
        seconds: |s| fixed(s, 3),
        wait_per_s: 1.0,
        comment: &abb.comment,
        forbidden: &[],
        width: Some(100),
        spelling: SPELLING,
    }
}

/// Tool and work object.
fn data(setup: &Setup) -> [String; 2] {
    let (abb, cell) = (&setup.cell.abb, &setup.cell);
    let in_hand = setup.mount == Mount::ToolInHand;
    let (tool, part) = match setup.mount {
        Mount::PartInHand => (&cell.base_from_laser, &cell.flange_from_part),
        Mount::ToolInHand => (&cell.flange_from_tool, &cell.base_from_part),
    };
    let word = |holds: bool| if holds { "TRUE" } else { "FALSE" };
    let load = format!("[{},[0,0,1],[1,0,0,0],0,0,0]", fixed(abb.mass_kg, 3));
    [
        format!("PERS tooldata {}:=[{},{},{load}];", abb.tool, word(in_hand), pose(&tool.isometry())),
        format!(
            "PERS wobjdata {}:=[{},TRUE,\"\",{},[[0,0,0],[1,0,0,0]]];",
            abb.work_object,
            word(!in_hand),
            pose(&part.isometry())
        ),
    ]
}

/// `[x,y,z],[q1,q2,q3,q4]` in brackets: mm and a unit quaternion, w first. RAPID keeps 7 digits.
fn pose(at: &Isometry3<f64>) -> String {
    let position: Vec<String> = at.translation.vector.iter().map(|v| fixed(*v, 4)).collect();
    let q = at.rotation.quaternion();
    let sign = if q.w < 0.0 { -1.0 } else { 1.0 };
    let turn: Vec<String> = [q.w, q.i, q.j, q.k].iter().map(|v| fixed(sign * v, 9)).collect();
    format!("[[{}],[{}]]", position.join(","), turn.join(","))
}

/// A pose of the focus in the part, and what RAPID calls the tool in the work object: both ways.
fn target(mount: Mount, part_from_focus: &Isometry3<f64>) -> Isometry3<f64> {
    match mount {
        Mount::PartInHand => *part_from_focus,
        Mount::ToolInHand => part_from_focus * half_turn(),
    }
}

/// A speed that stands for per cent of the joints' full speed.
fn share(abb: &Abb, percent: f64) -> String {
    let share = percent / 100.0;
    format!("[{},{},5000,1000]", fixed(share * abb.full_mm_s, 3), fixed(share * FULL_DEG_S, 3))
}
