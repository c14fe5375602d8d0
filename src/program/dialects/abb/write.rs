//! RAPID modules as they are written.

use super::{data, pose, share, target, templates};
use crate::cell::controllers::templates::{fixed, text};
use crate::cell::{Joints, Setup};
use crate::program::dialect::{Program, ProgramFile};
use crate::program::dialects::arm_shape::ArmShape;
use crate::program::dialects::flange::{SHORTEST_S, flows_on, printed_joints};
use crate::program::dialects::subprograms::{moves, subprograms};
use crate::program::neutral::comment::{Caveat, Comment};
use crate::program::neutral::lines::{Move, ProgramLine};
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::write_error::WriteError;

/// External axes that are not there.
const NO_AXES: &str = "[9E9,9E9,9E9,9E9,9E9,9E9]";

/// The module.
pub fn write(program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
    let (setup, abb) = (program.setup, &program.setup.cell.abb);
    templates(abb).check()?;
    let mut out = vec![format!("MODULE {}", abb.module)];
    let mut head = templates(abb).head(&[Comment::Caveat(Caveat::Rapid)], program.wording);
    head.extend(templates(abb).head(&program.head, program.wording));
    out.extend(head.into_iter().chain(data(setup)).map(|l| format!("  {l}")));
    for (name, body) in procedures(program)? {
        out.push(format!("  PROC {name}()"));
        out.extend(body.into_iter().map(|l| format!("    {l}")));
        out.push("  ENDPROC".into());
    }
    out.push("ENDMODULE".into());
    Ok(vec![ProgramFile { name: format!("{}.mod", abb.module), text: text(&out, abb.crlf) }])
}

/// Names and statements of the procedures, the main one first: each subprogram of a long program is one.
fn procedures(program: &Program<'_>) -> Result<Vec<(String, Vec<String>)>, WriteError> {
    let (setup, abb) = (program.setup, &program.setup.cell.abb);
    let subprograms = subprograms(&program.lines, setup.cell.outputs.laser.number, abb.max_moves, moves);
    let mut main = abb.start.clone();
    let mut out = Vec::new();
    let mut index = 0;
    for (number, subprogram) in subprograms.iter().enumerate() {
        let mut body = Vec::new();
        for line in *subprogram {
            match line {
                ProgramLine::Move(m) => body.push(statement(setup, m, flows_on(&program.lines, index))?),
                _ => body.extend(templates(abb).write(line, program.wording)?),
            }
            index += 1;
        }
        if subprograms.len() == 1 {
            main.append(&mut body);
        } else {
            let name = format!("{}_{}", abb.procedure, number + 1);
            main.push(format!("{name};"));
            out.push((name, body));
        }
    }
    out.insert(0, (abb.procedure.clone(), main));
    Ok(out)
}

fn statement(setup: &Setup, m: &Move, flows: bool) -> Result<String, WriteError> {
    let abb = &setup.cell.abb;
    let speed = match m.timing {
        MoveTiming::Seconds(s) => format!("v100\\T:={}", fixed(s.max(SHORTEST_S), 4)),
        MoveTiming::Percent(p) => share(abb, p),
    };
    let flows = flows && m.interpolation == Interpolation::Linear;
    let zone = if flows { &abb.zone } else { "fine" };
    let end = format!("{speed},{zone},{}\\WObj:={};", abb.tool, abb.work_object);
    if let (Interpolation::Joint, Some(joints)) = (m.interpolation, &m.joints_deg) {
        return Ok(format!("MoveAbsJ [[{}],{NO_AXES}],{end}", printed_joints(setup, joints).join(",")));
    }
    let focus = m.part_from_focus.or_else(|| m.base_from_flange.map(|flange| setup.focus_for(&flange)));
    let at = pose(&target(setup.mount, &focus.ok_or(WriteError::NoRobot("abb"))?));
    let at = at.strip_suffix(']').unwrap_or(&at);
    let word = if m.interpolation == Interpolation::Joint { "MoveJ" } else { "MoveL" };
    Ok(format!("{word} {at},{},{NO_AXES}],{end}", configuration(setup, m.joints_deg.as_ref())))
}

/// `[cf1,cf4,cf6,cfx]`.
fn configuration(setup: &Setup, joints_deg: Option<&Joints>) -> String {
    let (Some(robot), Some(j)) = (&setup.robot, joints_deg) else {
        return "[0,0,0,0]".into();
    };
    let quarter = |deg: f64| fixed((deg / 90.0).floor(), 0);
    let shape = ArmShape::of(robot, j);
    let cfx = 4 * u32::from(shape.over_the_back) + 2 * u32::from(shape.elbow_down) + u32::from(j[4] < 0.0);
    format!("[{},{},{},{cfx}]", quarter(j[0]), quarter(j[3]), quarter(j[5]))
}
