//! RAPID as it is written here, read back: targets as poses of the focus in the part.

use super::{FULL_DEG_S, SPELLING, data, is_attribute, share, target, templates};
use crate::cell::Setup;
use crate::cell::controllers::templates::non_blank_lines;
use crate::program::dialect::{Goal, ProgramFile, ReadLine, ReadMove, Statement};
use crate::program::dialects::flange::joints;
use crate::program::dialects::signals::SignalReader;
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::read_error::{LineFault, ReadError};
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};

/// Statements of a procedure, with their line numbers.
struct Procedure<'t> {
    line: usize,
    /// In large letters.
    name: String,
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
    let signals = SignalReader::new(&templates(abb));
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
    let main_name = SPELLING.plain(&abb.procedure);
    let main = find(&main_name).ok_or_else(|| cut(format!("PROC {}()", abb.procedure)))?;
    let subprogram = format!("{main_name}_");
    let called =
        |text: &str| SPELLING.plain(text).strip_suffix(';').filter(|t| t.starts_with(&subprogram)).map(str::to_owned);
    let calls: Vec<Option<String>> = main.body.iter().map(|(_, text)| called(text)).collect();
    let is_called = |p: &Procedure<'_>| calls.iter().flatten().any(|name| *name == p.name);
    if let Some(idle) = module.procedures.iter().find(|p| p.name != main.name && !is_called(p)) {
        return Err(LineFault::NeverCalled { name: idle.name.clone() }.at(&file.name, idle.line));
    }
    let gone = |line, name: &str| ReadError::Gone { file: file.name.clone(), line, called: format!("PROC {name}") };
    let read = |line: usize, text: &str| statement(setup, &signals, text).map_err(|fault| fault.at(&file.name, line));
    for ((line, text), call) in main.body.iter().zip(&calls) {
        let Some(name) = call else {
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
        let plain = SPELLING.plain(text);
        if !self.open && (plain.is_empty() || (!self.begun && is_attribute(text))) {
            return Ok(Some(Statement::Comment(SPELLING.comment_of(text).into())));
        }
        if self.ended {
            return Err(LineFault::BehindEnd { end: "ENDMODULE".into() });
        }
        if !self.begun {
            let first = format!("MODULE {}", abb.module);
            self.begun = plain == SPELLING.plain(&first);
            return if self.begun { Ok(None) } else { Err(LineFault::expected([first], text)) };
        }
        if self.open {
            if plain == "ENDPROC" {
                self.open = false;
            } else if let Some(procedure) = self.procedures.last_mut() {
                procedure.body.push((line, text));
            }
            return Ok(None);
        }
        if let Some(name) = plain.strip_prefix("PROC ").and_then(|t| t.strip_suffix("()")) {
            if self.procedures.iter().any(|p| p.name == name) {
                return Err(LineFault::Twice { name: name.into() });
            }
            self.procedures.push(Procedure { line, name: name.into(), body: Vec::new() });
            self.open = true;
            return Ok(None);
        }
        if plain == "ENDMODULE" {
            self.ended = true;
            return Ok(None);
        }
        let data = data(setup);
        let declared = SPELLING.known(&data, text).or_else(|| SPELLING.altered(&data, text));
        let form = || LineFault::expected(["PERS tooldata", "PERS wobjdata", "PROC", "ENDMODULE"], text);
        declared.ok_or_else(form).map(Some)
    }
}

/// What a statement does.
fn statement(setup: &Setup, signals: &SignalReader<'_>, text: &str) -> Result<Statement, LineFault> {
    let abb = &setup.cell.abb;
    let plain = SPELLING.plain(text);
    for (word, interpolation, is_joints) in [
        ("MOVEABSJ", Interpolation::Joint, true),
        ("MOVEJ", Interpolation::Joint, false),
        ("MOVEL", Interpolation::Linear, false),
    ] {
        let Some(rest) = plain.strip_prefix(word).filter(|rest| rest.starts_with('[')) else { continue };
        let (fields, rest) = brackets(rest).ok_or_else(|| LineFault::expected(["[[…],[…]]"], rest))?;
        let (goal, configured) = if is_joints { absolute(setup, &fields)? } else { focus(setup, &fields)? };
        let (timing, rest) = speed(setup, rest)?;
        let form = || LineFault::expected([format!("{},{}\\WObj:={};", abb.zone, abb.tool, abb.work_object)], rest);
        let rest = rest.strip_suffix(';').ok_or_else(form)?;
        return Ok(Statement::Move(ReadMove { interpolation, goal, timing, rest: format!("{configured}{rest}") }));
    }
    let known = SPELLING.known(&abb.start, text).or_else(|| signals.read(text));
    known.or_else(|| SPELLING.altered(&abb.start, text)).ok_or_else(|| {
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
    let angles = figures(angles).ok_or_else(|| LineFault::numbers(6, angles))?;
    no_axes(axes)?;
    Ok((Goal::Joints(joints(setup, &angles)), String::new()))
}

fn focus(setup: &Setup, fields: &[&str]) -> Result<(Goal, String), LineFault> {
    let [position, turn, configuration, axes] = fields else {
        let form = "[[x,y,z],[q1,q2,q3,q4],[cf1,cf4,cf6,cfx],[external axes]]";
        return Err(LineFault::expected([form], &fields.join("],[")));
    };
    let [x, y, z] = figures(position).ok_or_else(|| LineFault::numbers(3, position))?;
    let [q1, q2, q3, q4] = figures(turn).ok_or_else(|| LineFault::numbers(4, turn))?;
    let q = Quaternion::new(q1, q2, q3, q4);
    if (q.norm() - 1.0).abs() > 1e-5 {
        return Err(LineFault::Quaternion { length: q.norm() });
    }
    let whole = |c: &f64| c.fract() == 0.0 && c.abs() <= 16.0;
    if !figures::<4>(configuration).is_some_and(|c| c.iter().all(whole)) {
        return Err(LineFault::expected(["[cf1,cf4,cf6,cfx]"], configuration));
    }
    no_axes(axes)?;
    let at = Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::new_normalize(q));
    // The half turn is its own way back.
    Ok((Goal::Focus(target(setup.mount, &at)), format!("[{configuration}],")))
}

fn no_axes(axes: &str) -> Result<(), LineFault> {
    let none = figures::<6>(axes).is_some_and(|axes| axes == [9e9; 6]);
    if none { Ok(()) } else { Err(LineFault::expected(["9E9,9E9,9E9,9E9,9E9,9E9"], axes)) }
}

/// Exactly `N` figures between commas. RAPID gives back small and large ones with exponents.
fn figures<const N: usize>(text: &str) -> Option<[f64; N]> {
    let is_plain = |t: &str| t.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+' | b'E'));
    let figure = |t: &str| t.parse().ok().filter(|v: &f64| is_plain(t) && v.is_finite());
    let list: Vec<f64> = text.split(',').map(figure).collect::<Option<_>>()?;
    list.try_into().ok()
}

/// The speed, and what follows its comma.
fn speed<'t>(setup: &Setup, text: &'t str) -> Result<(MoveTiming, &'t str), LineFault> {
    let abb = &setup.cell.abb;
    let form = |found: &str| LineFault::expected(["v100\\T:=", "[mm/s,degrees per second,5000,1000]"], found);
    if let Some(timed) = text.strip_prefix("V100\\T:=") {
        let (seconds, rest) = timed.split_once(',').ok_or_else(|| form(text))?;
        let above_zero = figures(seconds).filter(|[s]| *s > 0.0);
        let [seconds] = above_zero.ok_or_else(|| LineFault::NotAboveZero { found: seconds.into() })?;
        return Ok((MoveTiming::Seconds(seconds), rest));
    }
    let (inside, rest) = text.strip_prefix('[').and_then(|t| t.split_once("],")).ok_or_else(|| form(text))?;
    let [mm_s, deg_s, linear, rotary] = figures(inside).ok_or_else(|| LineFault::numbers(4, inside))?;
    let percent = mm_s / abb.full_mm_s * 100.0;
    let turns_along = (deg_s - percent / 100.0 * FULL_DEG_S).abs() < 2e-3;
    if mm_s <= 0.0 || !turns_along || [linear, rotary] != [5000.0, 1000.0] {
        return Err(LineFault::expected([share(abb, percent)], &format!("[{inside}]")));
    }
    Ok((MoveTiming::Percent(percent), rest))
}
