//! RAPID as it is written here, read back: targets as poses of the focus in the part.

use super::{FULL_DEG_S, data, share, target, templates};
use crate::cell::Setup;
use crate::cell::controllers::templates::{non_blank_lines, number, numbers};
use crate::program::dialect::{Goal, ProgramFile, ReadLine, ReadMove, Statement};
use crate::program::dialects::flange::joints;
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::read_error::{LineFault, ReadError};
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};

/// Statements of a procedure, with their line numbers.
struct Procedure<'t> {
    line: usize,
    name: &'t str,
    body: Vec<(usize, &'t str)>,
}

/// A module in its parts.
#[derive(Default)]
struct Module<'t> {
    begun: bool,
    ended: bool,
    /// Whether the last procedure has not ended.
    open: bool,
    procedures: Vec<Procedure<'t>>,
}

/// The lines of a module: its data, then its main procedure with those that it calls.
pub fn read(file: &ProgramFile, setup: &Setup) -> Result<Vec<ReadLine>, ReadError> {
    let abb = &setup.cell.abb;
    let mut out = Vec::new();
    let mut add = |line: usize, what: Statement| out.push(ReadLine { file: file.name.clone(), line, what });
    let mut module = Module::default();
    for (line, text) in non_blank_lines(&file.text) {
        if let Some(what) = module.line(setup, line, text).map_err(|fault| fault.at(&file.name, line))? {
            add(line, what);
        }
    }
    let cut = |expected: String| ReadError::CutOff { file: file.name.clone(), expected: expected.into() };
    if module.open || !module.ended {
        return Err(cut(if module.open { "ENDPROC" } else { "ENDMODULE" }.into()));
    }
    let find = |name: &str| module.procedures.iter().find(|p| p.name == name);
    let main = find(&abb.procedure).ok_or_else(|| cut(format!("PROC {}()", abb.procedure)))?;
    let is_called = |p: &Procedure<'_>| main.body.iter().any(|(_, t)| t.strip_suffix(';') == Some(p.name));
    if let Some(idle) = module.procedures.iter().find(|p| p.name != main.name && !is_called(p)) {
        return Err(LineFault::NeverCalled { name: idle.name.into() }.at(&file.name, idle.line));
    }
    let gone = |line, name: &str| ReadError::Gone { file: file.name.clone(), line, called: format!("PROC {name}") };
    let read = |line: usize, text: &str| statement(setup, text).map_err(|fault| fault.at(&file.name, line));
    for (line, text) in &main.body {
        let called = text.strip_suffix(';').filter(|t| t.starts_with(&format!("{}_", abb.procedure)));
        let Some(name) = called else {
            add(*line, read(*line, text)?);
            continue;
        };
        for (line, text) in &find(name).ok_or_else(|| gone(*line, name))?.body {
            add(*line, read(*line, text)?);
        }
    }
    Ok(out)
}

impl<'t> Module<'t> {
    /// Takes a line; what it says by itself, outside the procedures.
    fn line(&mut self, setup: &Setup, line: usize, text: &'t str) -> Result<Option<Statement>, LineFault> {
        let abb = &setup.cell.abb;
        if self.ended {
            return Err(LineFault::BehindEnd { end: "ENDMODULE".into() });
        }
        if !self.begun {
            let first = format!("MODULE {}", abb.module);
            self.begun = text == first;
            return if self.begun { Ok(None) } else { Err(LineFault::expected([first], text)) };
        }
        if self.open {
            if text == "ENDPROC" {
                self.open = false;
            } else if let Some(procedure) = self.procedures.last_mut() {
                procedure.body.push((line, text));
            }
            return Ok(None);
        }
        if let Some(name) = text.strip_prefix("PROC ").and_then(|t| t.strip_suffix("()")) {
            if self.procedures.iter().any(|p| p.name == name) {
                return Err(LineFault::Twice { name: name.into() });
            }
            self.procedures.push(Procedure { line, name, body: Vec::new() });
            self.open = true;
            return Ok(None);
        }
        if text == "ENDMODULE" {
            self.ended = true;
            return Ok(None);
        }
        declaration(setup, text).map(Some)
    }
}

/// What a line outside procedures says.
fn declaration(setup: &Setup, text: &str) -> Result<Statement, LineFault> {
    if let Some(Statement::Comment(comment)) = templates(&setup.cell.abb).read(text) {
        return Ok(Statement::Comment(comment));
    }
    let data = data(setup);
    if data.iter().any(|d| d == text) {
        return Ok(Statement::Other(text.into()));
    }
    let named = data.iter().find(|d| d.split(":=").next() == text.split(":=").next());
    Err(match named {
        Some(expected) => LineFault::NotAsInCell { expected: expected.clone() },
        None => LineFault::expected(["PERS tooldata", "PERS wobjdata", "PROC", "ENDMODULE"], text),
    })
}

/// What a statement does.
fn statement(setup: &Setup, text: &str) -> Result<Statement, LineFault> {
    let abb = &setup.cell.abb;
    for (word, interpolation, is_joints) in [
        ("MoveAbsJ ", Interpolation::Joint, true),
        ("MoveJ ", Interpolation::Joint, false),
        ("MoveL ", Interpolation::Linear, false),
    ] {
        let Some(rest) = text.strip_prefix(word) else { continue };
        let (fields, rest) = brackets(rest).ok_or_else(|| LineFault::expected(["[[…],[…]]"], rest))?;
        let (goal, configured) = if is_joints { absolute(setup, &fields)? } else { focus(setup, &fields)? };
        let (timing, rest) = speed(setup, rest)?;
        let end = format!(",{}\\WObj:={};", abb.tool, abb.work_object);
        let zone = rest.strip_suffix(&end).ok_or_else(|| LineFault::expected([end.clone()], rest))?;
        if zone != "fine" && zone != abb.zone {
            return Err(LineFault::expected(["fine".to_owned(), abb.zone.clone()], zone));
        }
        return Ok(Statement::Move(ReadMove { interpolation, goal, timing, rest: format!("{configured}{zone}") }));
    }
    if abb.start.iter().any(|s| s == text) {
        return Ok(Statement::Other(text.into()));
    }
    templates(abb).read(text).ok_or_else(|| {
        let known = [&abb.output_on, &abb.output_off, &abb.wait, &abb.comment].map(String::as_str);
        LineFault::expected(["MoveAbsJ", "MoveJ", "MoveL"].into_iter().chain(known).map(String::from), text)
    })
}

/// The inner brackets of `[[..],[..]]`, and what follows its comma.
fn brackets(text: &str) -> Option<(Vec<&str>, &str)> {
    let (inside, rest) = text.strip_prefix("[[")?.split_once("]],")?;
    Some((inside.split("],[").collect(), rest))
}

fn absolute(setup: &Setup, fields: &[&str]) -> Result<(Goal, String), LineFault> {
    let [angles, axes] = fields else {
        return Err(LineFault::expected(["[[six angles],[external axes]]"], &fields.join("],[")));
    };
    let angles = numbers(angles).ok_or_else(|| LineFault::numbers(6, angles))?;
    no_axes(axes)?;
    Ok((Goal::Joints(joints(setup, &angles)), String::new()))
}

fn focus(setup: &Setup, fields: &[&str]) -> Result<(Goal, String), LineFault> {
    let [position, turn, configuration, axes] = fields else {
        let form = "[[x,y,z],[q1,q2,q3,q4],[cf1,cf4,cf6,cfx],[external axes]]";
        return Err(LineFault::expected([form], &fields.join("],[")));
    };
    let [x, y, z] = numbers(position).ok_or_else(|| LineFault::numbers(3, position))?;
    let [q1, q2, q3, q4] = numbers(turn).ok_or_else(|| LineFault::numbers(4, turn))?;
    let q = Quaternion::new(q1, q2, q3, q4);
    if (q.norm() - 1.0).abs() > 1e-5 {
        return Err(LineFault::Quaternion { length: q.norm() });
    }
    let whole = |c: &f64| c.fract() == 0.0 && c.abs() <= 16.0;
    if !numbers::<4>(configuration).is_some_and(|c| c.iter().all(whole)) {
        return Err(LineFault::expected(["[cf1,cf4,cf6,cfx]"], configuration));
    }
    no_axes(axes)?;
    let at = Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::new_normalize(q));
    // The half turn is its own way back.
    Ok((Goal::Focus(target(setup.mount, &at)), format!("[{configuration}],")))
}

fn no_axes(axes: &str) -> Result<(), LineFault> {
    let none = axes.split(',').count() == 6 && axes.split(',').all(|a| a == "9E9");
    if none { Ok(()) } else { Err(LineFault::expected(["9E9,9E9,9E9,9E9,9E9,9E9"], axes)) }
}

/// The speed, and what follows its comma.
fn speed<'t>(setup: &Setup, text: &'t str) -> Result<(MoveTiming, &'t str), LineFault> {
    let abb = &setup.cell.abb;
    let form = |found: &str| LineFault::expected(["v100\\T:=", "[mm/s,degrees per second,5000,1000]"], found);
    if let Some(timed) = text.strip_prefix("v100\\T:=") {
        let (seconds, rest) = timed.split_once(',').ok_or_else(|| form(text))?;
        let above_zero = number(seconds).filter(|s| *s > 0.0);
        let seconds = above_zero.ok_or_else(|| LineFault::NotAboveZero { found: seconds.into() })?;
        return Ok((MoveTiming::Seconds(seconds), rest));
    }
    let (inside, rest) = text.strip_prefix('[').and_then(|t| t.split_once("],")).ok_or_else(|| form(text))?;
    let [mm_s, deg_s, linear, rotary] = numbers(inside).ok_or_else(|| LineFault::numbers(4, inside))?;
    let percent = mm_s / abb.full_mm_s * 100.0;
    let turns_along = (deg_s - percent / 100.0 * FULL_DEG_S).abs() < 2e-3;
    if mm_s <= 0.0 || !turns_along || [linear, rotary] != [5000.0, 1000.0] {
        return Err(LineFault::expected([share(abb, percent)], &format!("[{inside}]")));
    }
    Ok((MoveTiming::Percent(percent), rest))
}
