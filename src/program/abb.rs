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
//! Long programs call numbered procedures of the same module; the split is where the laser is off.

mod read;

use super::arm::Shape;
use super::dialect::{Dialect, Program, ProgramFile, ReadError, ReadLine, Reading, WriteError};
use super::flange::{SHORTEST_S, flows_on, printed_joints};
use super::lines::{Line, Move};
use super::pages::{moves, pages};
use super::phrases::Phrases;
use super::steps::{Pace, Way};
use crate::cell::controllers::Abb;
use crate::cell::controllers::words::{self, fixed};
use crate::cell::mounting::half_turn;
use crate::cell::{Joints, Mount, Setup};
use nalgebra::Isometry3;

/// The dialect.
pub struct Rapid;

/// What the head says of the text: nobody ran it.
const UNVERIFIED: [&str; 4] = [
    "Not verified on a controller: configurations (ConfL is off), speeds of joint moves,",
    "robhold of tool and work object, rounding by zones. Targets are the focus on the part:",
    "tool data and work object below are the cell's frames. Set the load that the robot",
    "carries, and run at 100 per cent: with \\T each move takes its time.",
];

/// External axes that are not there.
const NO_AXES: &str = "[9E9,9E9,9E9,9E9,9E9,9E9]";
/// Speed of turning that 100 per cent stand for, degrees per second.
const FULL_DEG_S: f64 = 500.0;

impl Dialect for Rapid {
    fn name(&self) -> &'static str {
        "abb"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        let (setup, abb) = (program.setup, &program.setup.cell.abb);
        let laser = setup.cell.outputs.laser.number;
        let pages = pages(&program.lines, laser, abb.max_moves, moves);
        let mut out = vec![format!("MODULE {}", abb.module)];
        let head = UNVERIFIED.into_iter().map(String::from).chain(program.head.iter().cloned()).map(Line::Say);
        out.extend(head.flat_map(|line| phrases(abb).write(&line)).map(|l| format!("  {l}")));
        out.extend(data(setup).map(|l| format!("  {l}")));
        let mut main = abb.start.clone();
        let mut procedures = Vec::new();
        let mut index = 0;
        for (number, page) in pages.iter().enumerate() {
            let mut body = Vec::new();
            for line in *page {
                match line {
                    Line::Move(m) => body.push(statement(setup, m, flows_on(&program.lines, index))?),
                    _ => body.extend(phrases(abb).write(line)),
                }
                index += 1;
            }
            if pages.len() == 1 {
                main.append(&mut body);
            } else {
                let name = format!("{}_{}", abb.procedure, number + 1);
                main.push(format!("{name};"));
                procedures.push((name, body));
            }
        }
        procedures.insert(0, (abb.procedure.clone(), main));
        for (name, body) in procedures {
            out.push(format!("  PROC {name}()"));
            out.extend(body.into_iter().map(|l| format!("    {l}")));
            out.push("  ENDPROC".into());
        }
        out.push("ENDMODULE".into());
        Ok(vec![ProgramFile { name: format!("{}.mod", abb.module), text: words::text(&out, abb.crlf) }])
    }

    fn claims(&self, text: &str) -> bool {
        let first = words::said_lines(text).map(|(_, l)| l).find(|l| !l.starts_with('!') && !l.starts_with('%'));
        first.is_some_and(|l| l.starts_with("MODULE "))
    }

    fn read(&self, file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
        read::read(file, reading.setup)
    }
}

fn phrases(abb: &Abb) -> Phrases<'_> {
    Phrases {
        output_on: &abb.output_on,
        output_off: &abb.output_off,
        analogue: &abb.analogue,
        group: &abb.group,
        wait: &abb.wait,
        wait_per_s: 1.0,
        wait_decimals: 3,
        comment: &abb.comment,
        forbidden: &[],
        width: 100,
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

fn statement(setup: &Setup, m: &Move, flows: bool) -> Result<String, WriteError> {
    let abb = &setup.cell.abb;
    let speed = match m.pace {
        Pace::Seconds(s) => format!("v100\\T:={}", fixed(s.max(SHORTEST_S), 4)),
        Pace::Percent(p) => share(abb, p),
    };
    let flows = flows && m.way == Way::Linear;
    let zone = if flows { &abb.zone } else { "fine" };
    let end = format!("{speed},{zone},{}\\WObj:={};", abb.tool, abb.work_object);
    if let (Way::Joint, Some(joints)) = (m.way, &m.joints_deg) {
        return Ok(format!("MoveAbsJ [[{}],{NO_AXES}],{end}", printed_joints(setup, joints).join(",")));
    }
    let focus = m.part_from_focus.or_else(|| m.base_from_flange.map(|flange| setup.focus_for(&flange)));
    let at = pose(&target(setup.mount, &focus.ok_or(WriteError::NoRobot("abb"))?));
    let at = at.strip_suffix(']').unwrap_or(&at);
    let word = if m.way == Way::Joint { "MoveJ" } else { "MoveL" };
    Ok(format!("{word} {at},{},{NO_AXES}],{end}", configuration(setup, m.joints_deg.as_ref())))
}

/// A speed that stands for per cent of the joints' full speed.
fn share(abb: &Abb, percent: f64) -> String {
    let share = percent / 100.0;
    format!("[{},{},5000,1000]", fixed(share * abb.full_mm_s, 3), fixed(share * FULL_DEG_S, 3))
}

/// `[cf1,cf4,cf6,cfx]`.
fn configuration(setup: &Setup, joints_deg: Option<&Joints>) -> String {
    let (Some(robot), Some(j)) = (&setup.robot, joints_deg) else {
        return "[0,0,0,0]".into();
    };
    let quarter = |deg: f64| fixed((deg / 90.0).floor(), 0);
    let shape = Shape::of(robot, j);
    let cfx = 4 * u32::from(shape.over_the_back) + 2 * u32::from(shape.elbow_down) + u32::from(j[4] < 0.0);
    format!("[{},{},{},{cfx}]", quarter(j[0]), quarter(j[3]), quarter(j[5]))
}
