//! RAPID as this program writes it, read back: targets as poses of the focus in the part.

use super::{FULL_DEG_S, data, phrases, share, target};
use crate::cell::Setup;
use crate::cell::controllers::words::{number, numbers, said_lines};
use crate::program::dialect::{Goal, ProgramFile, Read, ReadError, ReadLine, ReadMove};
use crate::program::flange::joints;
use crate::program::steps::{Pace, Way};
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};

/// Statements of a procedure, with their line numbers.
struct Procedure<'t> {
    line: usize,
    name: &'t str,
    body: Vec<(usize, &'t str)>,
}

/// The lines of a module: its data, then its main procedure with those that it calls.
pub fn read(file: &ProgramFile, setup: &Setup) -> Result<Vec<ReadLine>, ReadError> {
    let abb = &setup.cell.abb;
    let wrong = |line: usize, what: String| ReadError::Line { file: file.name.clone(), line, what };
    let mut out = Vec::new();
    let mut said = |line: usize, what: Read| out.push(ReadLine { file: file.name.clone(), line, what });
    let data = data(setup);
    let (mut begun, mut ended, mut open) = (false, false, false);
    let mut procedures: Vec<Procedure<'_>> = Vec::new();
    for (line, text) in said_lines(&file.text) {
        if ended {
            return Err(wrong(line, "nothing may stand after ENDMODULE".into()));
        }
        if !begun {
            begun = text == format!("MODULE {}", abb.module);
            if !begun {
                return Err(wrong(line, format!("expected MODULE {}", abb.module)));
            }
        } else if open {
            if text == "ENDPROC" {
                open = false;
            } else if let Some(procedure) = procedures.last_mut() {
                procedure.body.push((line, text));
            }
        } else if let Some(name) = text.strip_prefix("PROC ").and_then(|t| t.strip_suffix("()")) {
            if procedures.iter().any(|p| p.name == name) {
                return Err(wrong(line, format!("there is a procedure {name} already")));
            }
            procedures.push(Procedure { line, name, body: Vec::new() });
            open = true;
        } else if text == "ENDMODULE" {
            ended = true;
        } else if let Some(Read::Say(text)) = phrases(abb).read(text) {
            said(line, Read::Say(text));
        } else if data.iter().any(|d| d == text) {
            said(line, Read::Other(text.into()));
        } else if let Some(expected) = data.iter().find(|d| d.split(":=").next() == text.split(":=").next()) {
            return Err(wrong(line, format!("not as in the cell file: expected {expected}")));
        } else {
            return Err(wrong(line, "no line of this module; expected tool data, work object, PROC".into()));
        }
    }
    if open || !ended {
        let expected = if open { "ENDPROC" } else { "ENDMODULE" };
        return Err(ReadError::CutOff { file: file.name.clone(), expected });
    }
    let find = |name: &str| procedures.iter().find(|p| p.name == name);
    let Some(main) = find(&abb.procedure) else {
        return Err(ReadError::CutOff { file: file.name.clone(), expected: "a main procedure" });
    };
    let is_called = |p: &Procedure<'_>| main.body.iter().any(|(_, t)| t.strip_suffix(';') == Some(p.name));
    if let Some(idle) = procedures.iter().find(|p| p.name != main.name && !is_called(p)) {
        return Err(wrong(idle.line, format!("{} is never called", idle.name)));
    }
    let gone = |line, name: &str| ReadError::Gone { file: file.name.clone(), line, called: format!("PROC {name}") };
    for (line, text) in &main.body {
        let called = text.strip_suffix(';').filter(|t| t.starts_with(&format!("{}_", abb.procedure)));
        let Some(name) = called else {
            said(*line, statement(setup, text).map_err(|what| wrong(*line, what))?);
            continue;
        };
        for (line, text) in &find(name).ok_or_else(|| gone(*line, name))?.body {
            said(*line, statement(setup, text).map_err(|what| wrong(*line, what))?);
        }
    }
    Ok(out)
}

/// What a statement does.
fn statement(setup: &Setup, text: &str) -> Result<Read, String> {
    let abb = &setup.cell.abb;
    for (word, way, is_joints) in
        [("MoveAbsJ ", Way::Joint, true), ("MoveJ ", Way::Joint, false), ("MoveL ", Way::Linear, false)]
    {
        let Some(rest) = text.strip_prefix(word) else { continue };
        let (fields, rest) = brackets(rest).ok_or("expected a target in brackets")?;
        let (goal, configured) = if is_joints { absolute(setup, &fields)? } else { focus(setup, &fields)? };
        let (pace, rest) = speed(setup, rest)?;
        let expected = format!(",{}\\WObj:={};", abb.tool, abb.work_object);
        let zone = rest.strip_suffix(&expected).ok_or(format!("expected {expected} at its end"))?;
        if zone != "fine" && zone != abb.zone {
            return Err(format!("zone {zone:?}: expected fine or {}", abb.zone));
        }
        return Ok(Read::Move(ReadMove { way, goal, pace, rest: format!("{configured}{zone}") }));
    }
    if abb.start.iter().any(|s| s == text) {
        return Ok(Read::Other(text.into()));
    }
    let read = phrases(abb).read(text);
    read.ok_or("no statement of this program; expected a move, an output, a wait or a comment".into())
}

/// The inner brackets of `[[..],[..]]`, and what follows its comma.
fn brackets(text: &str) -> Option<(Vec<&str>, &str)> {
    let (inside, rest) = text.strip_prefix("[[")?.split_once("]],")?;
    Some((inside.split("],[").collect(), rest))
}

fn absolute(setup: &Setup, fields: &[&str]) -> Result<(Goal, String), String> {
    let [angles, axes] = fields else {
        return Err("expected [[six angles],[external axes]]".into());
    };
    let angles = numbers(angles).ok_or("expected six angles")?;
    no_axes(axes)?;
    Ok((Goal::Joints(joints(setup, &angles)), String::new()))
}

fn focus(setup: &Setup, fields: &[&str]) -> Result<(Goal, String), String> {
    let [position, turn, configuration, axes] = fields else {
        return Err("expected [[x,y,z],[q1,q2,q3,q4],[cf1,cf4,cf6,cfx],[external axes]]".into());
    };
    let [x, y, z] = numbers(position).ok_or("expected x, y and z")?;
    let [q1, q2, q3, q4] = numbers(turn).ok_or("expected four parts of a quaternion")?;
    let q = Quaternion::new(q1, q2, q3, q4);
    if (q.norm() - 1.0).abs() > 1e-5 {
        return Err(format!("the quaternion has length {}, not 1", q.norm()));
    }
    let whole = |c: &f64| c.fract() == 0.0 && c.abs() <= 16.0;
    if !numbers::<4>(configuration).is_some_and(|c| c.iter().all(whole)) {
        return Err("expected four whole numbers for the configuration".into());
    }
    no_axes(axes)?;
    let at = Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::new_normalize(q));
    // The half turn is its own way back.
    Ok((Goal::Focus(target(setup.mount, &at)), format!("[{configuration}],")))
}

fn no_axes(axes: &str) -> Result<(), String> {
    let none = axes.split(',').count() == 6 && axes.split(',').all(|a| a == "9E9");
    if none { Ok(()) } else { Err("expected six external axes of 9E9, which stands for none".into()) }
}

/// The speed, and what follows its comma.
fn speed<'t>(setup: &Setup, text: &'t str) -> Result<(Pace, &'t str), String> {
    let abb = &setup.cell.abb;
    if let Some(timed) = text.strip_prefix("v100\\T:=") {
        let (seconds, rest) = timed.split_once(',').ok_or("expected a zone after the time")?;
        let seconds = number(seconds).filter(|s| *s > 0.0).ok_or("expected a time above 0")?;
        return Ok((Pace::Seconds(seconds), rest));
    }
    let (inside, rest) = text.strip_prefix('[').and_then(|t| t.split_once("],")).ok_or("expected a speed")?;
    let [mm_s, deg_s, linear, rotary] = numbers(inside).ok_or("expected a speed of four numbers")?;
    let percent = mm_s / abb.full_mm_s * 100.0;
    let turns_along = (deg_s - percent / 100.0 * FULL_DEG_S).abs() < 2e-3;
    if mm_s <= 0.0 || !turns_along || [linear, rotary] != [5000.0, 1000.0] {
        return Err(format!("speed [{inside}]: expected {}", share(abb, percent)));
    }
    Ok((Pace::Percent(percent), rest))
}
