//! Reads a URScript program back: functions without arguments, moves, outputs, waits, comments.

use super::dialect::{Goal, ProgramFile, Read, ReadError, ReadLine, ReadMove, Reading};
use super::reading::wrong;
use super::steps::{Pace, Way};
use crate::cell::controllers::Ur as Words;
use crate::cell::controllers::words::{matched, matched_key, number, numbers, said_lines};
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};

/// A function and what it does.
struct Function {
    name: String,
    lines: Vec<ReadLine>,
}

/// Reads a program.
pub fn read(file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let words = &reading.setup.cell.ur;
    let mut head: Vec<ReadLine> = Vec::new();
    let mut run: Option<Vec<ReadLine>> = None;
    let (mut open, mut done): (Vec<Function>, Vec<Function>) = (Vec::new(), Vec::new());
    for (line, text) in said_lines(&file.text) {
        let fail = |what: String| Err(wrong(&file.name, line, what));
        if run.is_some() {
            return fail("stands behind the call of the program; take it out".into());
        }
        if let Some(name) = matched_key("def {name}():", "name", text) {
            if open.iter().chain(&done).any(|f| f.name == name) {
                return fail(format!("{name} is defined twice"));
            }
            open.push(Function { name: name.into(), lines: Vec::new() });
        } else if text == "end" {
            match open.pop() {
                Some(function) => done.push(function),
                None => return fail("end of nothing".into()),
            }
        } else if let Some(i) = text.strip_suffix("()").and_then(|name| done.iter().position(|f| f.name == name)) {
            // Each is called once: what would be left over is taken as not said.
            let called = done.swap_remove(i).lines;
            match open.last_mut() {
                Some(caller) => caller.lines.extend(called),
                None => run = Some(called),
            }
        } else {
            let what = statement(words, text).map_err(|what| wrong(&file.name, line, what))?;
            let into = match (open.last_mut(), &what) {
                (Some(function), _) => &mut function.lines,
                (None, Read::Say(_)) => &mut head,
                (None, _) => return fail("stands outside the program's function".into()),
            };
            into.push(ReadLine { file: file.name.clone(), line, what });
        }
    }
    let cut = |expected| ReadError::CutOff { file: file.name.clone(), expected };
    if !open.is_empty() {
        return Err(cut("end"));
    }
    let run = run.ok_or_else(|| cut("the call of its program"))?;
    if let Some(idle) = done.first() {
        let line = idle.lines.first().map_or(1, |l| l.line);
        return Err(wrong(&file.name, line, format!("{} is never called", idle.name)));
    }
    head.extend(run);
    Ok(head)
}

fn statement(words: &Words, text: &str) -> Result<Read, String> {
    if let Some(said) = text.strip_prefix('#') {
        return Ok(Read::Say(said.trim().into()));
    }
    let bare = |text: &str| text.chars().filter(|c| !c.is_whitespace()).collect::<String>();
    let line = bare(text);
    if line.starts_with("movej(") || line.starts_with("movel(") {
        return go(words, &line).map(Read::Move);
    }
    if line.starts_with("set_tcp(p[") && line.ends_with("])") {
        return Ok(Read::Other(line));
    }
    if let Some(seconds) = matched_key("sleep({s})", "s", &line).and_then(number).filter(|s| *s >= 0.0) {
        return Ok(Read::Wait(seconds));
    }
    for (template, on) in [(&words.output_on, true), (&words.output_off, false)] {
        if let Some(number) = matched_key(&bare(template), "n", &line).and_then(|n| n.parse().ok()) {
            return Ok(Read::Output { number, on });
        }
    }
    for (template, group) in [(&words.analogue, false), (&words.group, true)] {
        let template = bare(template);
        let key = |key| matched_key(&template, key, &line);
        if let (Some(Ok(number)), Some(value)) = (key("n").map(str::parse), key("v").and_then(number)) {
            return Ok(Read::Level { number, value, group });
        }
    }
    Err(format!(
        "{text:?} is not understood; expected movej, movel, {:?}, {:?}, sleep, set_tcp, a comment, def or end",
        words.output_on, words.output_off
    ))
}

fn go(words: &Words, line: &str) -> Result<ReadMove, String> {
    let Some(&[(_, word), (_, six), (_, rest)]) = matched("{word}[{six}],{rest})", line).as_deref() else {
        return Err("give movej or movel([six numbers] or p[six numbers], a=, v=, t=, r=)".into());
    };
    let six: [f64; 6] = numbers(six).ok_or_else(|| format!("[{six}]: give six numbers"))?;
    let (way, full) = if word.starts_with("movej") {
        (Way::Joint, words.full_speed_deg_s.to_radians())
    } else {
        (Way::Linear, words.full_speed_mm_s / 1000.0)
    };
    let goal = match word.strip_prefix("movej(").or(word.strip_prefix("movel(")) {
        Some("") => Goal::Joints(six.map(f64::to_degrees)),
        Some("p") => {
            let [x, y, z, rx, ry, rz] = six;
            let turn = UnitQuaternion::from_scaled_axis(Vector3::new(rx, ry, rz));
            Goal::Flange(Isometry3::from_parts(Translation3::from(Vector3::new(x, y, z) * 1000.0), turn))
        }
        _ => return Err(format!("{word:?}: give a list of joints or p and a pose")),
    };
    let (mut time, mut speed, mut others, mut seen) = (None, None, Vec::new(), Vec::new());
    for argument in rest.split(',') {
        let (key, value) =
            argument.split_once('=').ok_or_else(|| format!("{argument:?}: name it, a=, v=, t= or r="))?;
        let value = number(value).ok_or_else(|| format!("{argument:?}: give a number"))?;
        if seen.contains(&key) {
            return Err(format!("{key}= stands there twice"));
        }
        seen.push(key);
        match key {
            "t" => time = Some(value),
            "a" | "v" | "r" => {
                others.push(argument);
                speed = if key == "v" { Some(value) } else { speed };
            }
            other => return Err(format!("{other}=: give a, v, t or r")),
        }
    }
    let pace = match (time, speed) {
        (Some(s), _) => Pace::Seconds(s),
        (None, Some(v)) => Pace::Percent(100.0 * v / full),
        (None, None) => return Err("neither t= nor v=".into()),
    };
    Ok(ReadMove { way, goal, pace, rest: others.join(",") })
}
