//! Reads a NACHI program back: every line has to be one that is understood.

use super::dialect::{Goal, ProgramFile, Read, ReadError, ReadLine, ReadMove, Reading};
use super::reading::{Found, wrong};
use super::steps::{Pace, Way};
use crate::cell::controllers::Nachi as Words;
use crate::cell::controllers::words::{matched, matched_key, number, numbers, said_lines};
use crate::part::rpy;
use nalgebra::{Isometry3, Translation3, UnitQuaternion};

/// Reads a program and those it calls.
pub fn read(file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let mut found = Found::new();
    found.file(file, &|file, found| one_file(file, reading, found))?;
    Ok(found.lines)
}

fn one_file(file: &ProgramFile, reading: &Reading<'_>, found: &mut Found) -> Result<(), ReadError> {
    let words = &reading.setup.cell.nachi;
    let mut ended = false;
    for (line, text) in said_lines(&file.text) {
        if ended {
            return Err(wrong(&file.name, line, "stands behind END; take it out"));
        }
        if text == "END" {
            ended = true;
        } else if let Some(n) = matched_key(&words.call, "n", text) {
            let name = sub_program(&file.name, n).ok_or_else(|| wrong(&file.name, line, format!("calls {n:?}")))?;
            let called = found.called(name, &file.name, line, reading)?;
            found.file(&called, &|file, found| one_file(file, reading, found))?;
        } else {
            let what = statement(words, text).map_err(|what| wrong(&file.name, line, what))?;
            found.lines.push(ReadLine { file: file.name.clone(), line, what });
        }
    }
    if ended { Ok(()) } else { Err(ReadError::CutOff { file: file.name.clone(), expected: "END" }) }
}

/// The file of a sub-program stands beside its caller, under its own number.
fn sub_program(caller: &str, n: &str) -> Option<String> {
    let number: u32 = n.trim().parse().ok()?;
    let unit = caller.rsplit_once('.').map_or(caller, |(unit, _)| unit);
    Some(format!("{unit}.{number:03}"))
}

fn statement(words: &Words, text: &str) -> Result<Read, String> {
    if let Some(rest) = text.strip_prefix("MOVEX ") {
        return movex(rest).map(Read::Move);
    }
    let comment = matched_key(&words.comment, "text", text)
        .or_else(|| text.strip_prefix("REM ").map(|t| t.trim().trim_matches('"')))
        .or_else(|| text.strip_prefix('\'').map(str::trim));
    if let Some(text) = comment {
        return Ok(Read::Say(text.into()));
    }
    let output = |template: &str| matched_key(template, "n", text).and_then(|n| n.trim().parse().ok());
    for (template, on) in [(&words.output_on, true), (&words.output_off, false)] {
        if let Some(number) = output(template) {
            return Ok(Read::Output { number, on });
        }
    }
    if let Some(seconds) = matched_key(&words.wait, "s", text).and_then(number).filter(|s| *s >= 0.0) {
        return Ok(Read::Wait(seconds));
    }
    for (template, group) in [(&words.analogue, false), (&words.group, true)] {
        let key = |key| matched_key(template, key, text);
        if let (Some(Ok(number)), Some(value)) = (key("n").map(|n| n.trim().parse()), key("v").and_then(number)) {
            return Ok(Read::Level { number, value, group });
        }
    }
    Err(format!(
        "{text:?} is not understood; expected MOVEX, {:?}, {:?}, {:?}, {:?}, a comment or END",
        words.output_on, words.output_off, words.wait, words.call
    ))
}

/// What stands behind `MOVEX `.
fn movex(rest: &str) -> Result<ReadMove, String> {
    let bare: String = rest.chars().filter(|c| !c.is_whitespace()).collect();
    let form = "give MOVEX A=,AC=,SM=,M1J or M1X,P or L,(six numbers),T= or R=,H=,MS";
    let (before, behind) = bare.split_once("M1").ok_or(form)?;
    let Some(&[(_, kind), (_, way), (_, six), (_, pace), (_, after)]) =
        matched("{kind},{way},({six}),{pace},{rest}", behind).as_deref()
    else {
        return Err(form.into());
    };
    let way = match way {
        "P" => Way::Joint,
        "L" => Way::Linear,
        "C1" | "C2" => return Err("an arc (C1, C2) cannot be checked here; give straight moves".into()),
        other => return Err(format!("{other:?}: give P or L")),
    };
    let six: [f64; 6] = numbers(six).ok_or_else(|| format!("({six}): give six numbers"))?;
    let goal = match kind {
        "J" => Goal::Joints(six),
        "X" => {
            let [x, y, z, rz, ry, rx] = six;
            let turn = UnitQuaternion::from_rotation_matrix(&rpy::to_rotation([rz, ry, rx]));
            Goal::Flange(Isometry3::from_parts(Translation3::new(x, y, z), turn))
        }
        other => return Err(format!("M1{other}: give M1J or M1X")),
    };
    let pace = match pace.split_once('=').map(|(key, value)| (key, number(value))) {
        Some(("T", Some(s))) => Pace::Seconds(s),
        Some(("R", Some(p))) => Pace::Percent(p),
        Some(("S", _)) => {
            return Err("S= is the flange's speed, which says nothing of the spot's; give the move its time, T=".into());
        }
        _ => return Err(format!("{pace:?}: give T= or R= with a number")),
    };
    let whole = |text: &str, key: &str| {
        text.strip_prefix(key).is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
    };
    let known_before =
        |t: &str| t.is_empty() || whole(t.trim_end_matches('P'), "A=") || whole(t, "AC=") || whole(t, "SM=");
    let known_after = |t: &str| t == "MS" || whole(t, "H=") || whole(t, "CONF=");
    let odd = before.split(',').find(|t| !known_before(t)).or_else(|| after.split(',').find(|t| !known_after(t)));
    if let Some(odd) = odd {
        return Err(format!("{odd:?} is not understood; {form}"));
    }
    if after.split(',').filter(|t| *t == "MS").count() != 1 {
        return Err("MS has to stand there once".into());
    }
    Ok(ReadMove { way, goal, pace, rest: format!("{before}{after}") })
}
