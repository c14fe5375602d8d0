//! Reads a NACHI program back: every line has to be one that is understood.

use super::{SPELLING, templates};
use crate::cell::controllers::Nachi;
use crate::cell::controllers::templates::{matched, matched_key, non_blank_lines, number, numbers};
use crate::program::dialect::{Goal, ProgramFile, ReadContext, ReadLine, ReadMove, Statement};
use crate::program::dialects::flange::pose;
use crate::program::dialects::reading::Found;
use crate::program::dialects::signals::SignalReader;
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::read_error::{LineFault, ReadError};

/// Reads a program and those it calls.
pub fn read(file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let mut found = Found::new();
    found.file(file, &|file, found| one_file(file, reading, found))?;
    Ok(found.lines)
}

fn one_file(file: &ProgramFile, reading: &ReadContext<'_>, found: &mut Found) -> Result<(), ReadError> {
    let nachi = &reading.setup.cell.nachi;
    let (signals, call) = (SignalReader::new(&templates(nachi)), SPELLING.plain(&nachi.call));
    let mut ended = false;
    for (line, text) in non_blank_lines(&file.text) {
        let plain = SPELLING.plain(text);
        if ended {
            let comment = signals.read_comment(text);
            let what = comment.ok_or_else(|| LineFault::BehindEnd { end: "END".into() }.at(&file.name, line))?;
            found.lines.push(ReadLine { file: file.name.clone(), line, what });
        } else if plain == "END" {
            ended = true;
        } else if let Some(n) = matched_key(&call, "n", &plain) {
            let name = sub_program(&file.name, n)
                .ok_or_else(|| LineFault::BadCall { called: n.into() }.at(&file.name, line))?;
            let called = found.called(name, &file.name, line, reading)?;
            found.file(&called, &|file, found| one_file(file, reading, found))?;
        } else {
            let what = statement(nachi, &signals, text, &plain).map_err(|fault| fault.at(&file.name, line))?;
            found.lines.push(ReadLine { file: file.name.clone(), line, what });
        }
    }
    if ended { Ok(()) } else { Err(ReadError::CutOff { file: file.name.clone(), expected: "END".into() }) }
}

/// The file of a subprogram stands beside its caller, under its own number.
fn sub_program(caller: &str, n: &str) -> Option<String> {
    let number: u32 = n.trim().parse().ok()?;
    let unit = caller.rsplit_once('.').map_or(caller, |(unit, _)| unit);
    Some(format!("{unit}.{number:03}"))
}

fn statement(nachi: &Nachi, signals: &SignalReader<'_>, text: &str, plain: &str) -> Result<Statement, LineFault> {
    if let Some(rest) = plain.strip_prefix("MOVEX ") {
        return movex(rest).map(Statement::Move);
    }
    signals.read(text).ok_or_else(|| {
        let known = [&nachi.output_on, &nachi.output_off, &nachi.wait, &nachi.call, &nachi.comment];
        let known = known.into_iter().map(String::as_str);
        LineFault::expected(["MOVEX"].into_iter().chain(known).chain(["END"]).map(String::from), text)
    })
}

/// The form of a move.
const MOVEX: &str = "MOVEX A=,AC=,SM=,M1J or M1X,P or L,(six numbers),T= or R=,H=,MS";

/// What stands behind `MOVEX `.
fn movex(rest: &str) -> Result<ReadMove, LineFault> {
    let bare: String = rest.chars().filter(|c| !c.is_whitespace()).collect();
    let form = |found: &str| LineFault::expected([MOVEX], found);
    let (before, behind) = bare.split_once("M1").ok_or_else(|| form(rest))?;
    let Some(&[(_, kind), (_, way), (_, six), (_, speed), (_, after)]) =
        matched("{kind},{way},({six}),{speed},{rest}", behind).as_deref()
    else {
        return Err(form(rest));
    };
    let interpolation = match way {
        "P" => Interpolation::Joint,
        "L" => Interpolation::Linear,
        "C1" | "C2" => return Err(LineFault::Arc { found: way.into() }),
        other => return Err(LineFault::expected(["P", "L"], other)),
    };
    let six: [f64; 6] = numbers(six).ok_or_else(|| LineFault::numbers(6, six))?;
    let goal = match kind {
        "J" => Goal::Joints(six),
        "X" => Goal::Flange(pose(six)),
        other => return Err(LineFault::expected(["M1J", "M1X"], &format!("M1{other}"))),
    };
    let timing = match speed.split_once('=').map(|(key, value)| (key, number(value))) {
        Some(("T", Some(s))) => MoveTiming::Seconds(s),
        Some(("R", Some(p))) => MoveTiming::Percent(p),
        Some(("S", _)) => return Err(LineFault::FlangeSpeed { found: speed.into(), one_of: &["T="] }),
        _ => return Err(LineFault::expected(["T=", "R="], speed)),
    };
    settings(before, after)?;
    Ok(ReadMove { interpolation, goal, timing, rest: format!("{before}{after}") })
}

/// Whether all other arguments of a move are known, and `MS` among them once.
fn settings(before: &str, after: &str) -> Result<(), LineFault> {
    let whole = |text: &str, key: &str| {
        text.strip_prefix(key).is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
    };
    let known_before =
        |t: &str| t.is_empty() || whole(t.trim_end_matches('P'), "A=") || whole(t, "AC=") || whole(t, "SM=");
    let known_after = |t: &str| t == "MS" || whole(t, "H=") || whole(t, "CONF=");
    let odd = before.split(',').find(|t| !known_before(t)).or_else(|| after.split(',').find(|t| !known_after(t)));
    if let Some(odd) = odd {
        return Err(LineFault::expected([MOVEX], odd));
    }
    if after.split(',').filter(|t| *t == "MS").count() == 1 { Ok(()) } else { Err(LineFault::expected(["MS"], after)) }
}
