//! Reads a URScript program back: functions without arguments, moves, outputs, waits, comments.

use super::{SPELLING, templates};
use crate::cell::controllers::Ur;
use crate::cell::controllers::templates::{matched, matched_key, non_blank_lines, number, numbers};
use crate::program::dialect::{Goal, ProgramFile, ReadContext, ReadLine, ReadMove, Statement};
use crate::program::dialects::signals::SignalReader;
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::read_error::{LineFault, ReadError};
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};

/// A function and what it does.
struct Function {
    name: String,
    lines: Vec<ReadLine>,
}

/// What was read so far.
#[derive(Default)]
struct Script {
    /// Comments before the program.
    head: Vec<ReadLine>,
    /// Functions that have not ended.
    open: Vec<Function>,
    /// Functions that nothing has called yet.
    done: Vec<Function>,
    /// What the call of the program runs.
    run: Option<Vec<ReadLine>>,
}

/// Reads a program.
pub fn read(file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let ur = &reading.setup.cell.ur;
    let signals = SignalReader::new(&templates(ur));
    let call = format!("{}()", ur.program);
    let mut script = Script::default();
    for (line, text) in non_blank_lines(&file.text) {
        script.line(ur, &signals, file, (line, text)).map_err(|fault| fault.at(&file.name, line))?;
    }
    let cut = |expected: String| ReadError::CutOff { file: file.name.clone(), expected: expected.into() };
    if !script.open.is_empty() {
        return Err(cut("end".into()));
    }
    let run = script.run.ok_or_else(|| cut(call))?;
    if let Some(idle) = script.done.into_iter().next() {
        let line = idle.lines.first().map_or(1, |l| l.line);
        return Err(LineFault::NeverCalled { name: idle.name }.at(&file.name, line));
    }
    Ok(script.head.into_iter().chain(run).collect())
}

impl Script {
    fn line(
        &mut self,
        ur: &Ur,
        signals: &SignalReader<'_>,
        file: &ProgramFile,
        (line, text): (usize, &str),
    ) -> Result<(), LineFault> {
        let plain = SPELLING.plain(text);
        if let Some(run) = &mut self.run {
            let comment = signals.read_comment(text);
            let what = comment.ok_or_else(|| LineFault::BehindEnd { end: format!("{}()", ur.program).into() })?;
            run.push(ReadLine { file: file.name.clone(), line, what });
        } else if let Some(name) = matched_key("def {name}():", "name", &plain) {
            if self.open.iter().chain(&self.done).any(|f| f.name == name) {
                return Err(LineFault::Twice { name: name.into() });
            }
            self.open.push(Function { name: name.into(), lines: Vec::new() });
        } else if plain == "end" {
            self.done.push(self.open.pop().ok_or(LineFault::OutsideFunction)?);
        } else if let Some(i) = plain.strip_suffix("()").and_then(|name| self.done.iter().position(|f| f.name == name))
        {
            // Each is called once: what would be left over is taken as not said.
            let called = self.done.swap_remove(i).lines;
            match self.open.last_mut() {
                Some(caller) => caller.lines.extend(called),
                None => self.run = Some(called),
            }
        } else {
            let what = statement(ur, signals, text, &plain)?;
            let into = match (self.open.last_mut(), &what) {
                (Some(function), _) => &mut function.lines,
                (None, Statement::Comment(_)) => &mut self.head,
                (None, _) => return Err(LineFault::OutsideFunction),
            };
            into.push(ReadLine { file: file.name.clone(), line, what });
        }
        Ok(())
    }
}

fn statement(ur: &Ur, signals: &SignalReader<'_>, text: &str, plain: &str) -> Result<Statement, LineFault> {
    if plain.starts_with("movej(") || plain.starts_with("movel(") {
        return read_move(ur, plain).map(Statement::Move);
    }
    if plain.starts_with("set_tcp(p[") && plain.ends_with("])") {
        return Ok(Statement::Other(plain.into()));
    }
    signals.read(text).ok_or_else(|| {
        let known = ["movej", "movel", &ur.output_on, &ur.output_off, "sleep", "set_tcp", "#", "def", "end"];
        LineFault::expected(known.map(String::from), text)
    })
}

fn read_move(ur: &Ur, line: &str) -> Result<ReadMove, LineFault> {
    let Some(&[(_, word), (_, six), (_, rest)]) = matched("{word}[{six}],{rest})", line).as_deref() else {
        let forms = ["movej([six numbers], a=, v=, t=, r=)", "movel(p[six numbers], a=, v=, t=, r=)"];
        return Err(LineFault::expected(forms, line));
    };
    let six: [f64; 6] = numbers(six).ok_or_else(|| LineFault::numbers(6, six))?;
    let (interpolation, full) = if word.starts_with("movej") {
        (Interpolation::Joint, ur.full_speed_deg_s.to_radians())
    } else {
        (Interpolation::Linear, ur.full_speed_mm_s / 1000.0)
    };
    let goal = match word.strip_prefix("movej(").or(word.strip_prefix("movel(")) {
        Some("") => Goal::Joints(six.map(f64::to_degrees)),
        Some("p") => {
            let [x, y, z, rx, ry, rz] = six;
            let turn = UnitQuaternion::from_scaled_axis(Vector3::new(rx, ry, rz));
            Goal::Flange(Isometry3::from_parts(Translation3::from(Vector3::new(x, y, z) * 1000.0), turn))
        }
        _ => return Err(LineFault::expected(["[", "p["], word)),
    };
    let (timing, rest) = arguments(rest, full)?;
    Ok(ReadMove { interpolation, goal, timing, rest })
}

/// How fast a move is, by its named arguments, and all others in one order. A move without rounding has one of 0.
fn arguments(text: &str, full: f64) -> Result<(MoveTiming, String), LineFault> {
    const NAMES: [&str; 4] = ["a", "v", "t", "r"];
    let mut said: [Option<&str>; NAMES.len()] = [None; NAMES.len()];
    let form = |found: &str| LineFault::expected(["a=", "v=", "t=", "r="], found);
    for argument in text.split(',') {
        let (key, value) = argument.split_once('=').ok_or_else(|| form(argument))?;
        number(value).ok_or_else(|| LineFault::numbers(1, argument))?;
        let at = NAMES.iter().position(|n| *n == key).ok_or_else(|| form(argument))?;
        if said[at].replace(value).is_some() {
            return Err(LineFault::Twice { name: format!("{key}=") });
        }
    }
    let [a, v, t, r] = said;
    let timing = match (t.and_then(number), v.and_then(number)) {
        (Some(s), _) => MoveTiming::Seconds(s),
        (None, Some(v)) => MoveTiming::Percent(100.0 * v / full),
        (None, None) => return Err(LineFault::expected(["t=", "v="], text)),
    };
    let others = [("a", a), ("v", v), ("r", r.or(Some("0")))];
    let others: Vec<String> = others.iter().filter_map(|(key, value)| Some(format!("{key}={}", (*value)?))).collect();
    Ok((timing, others.join(",")))
}
