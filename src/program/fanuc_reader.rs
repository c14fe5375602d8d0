//! Reads a FANUC listing back: line numbers, the promised count and every position have to be right.

use super::dialect::{Goal, ProgramFile, Read, ReadError, ReadLine, ReadMove, Reading};
use super::fanuc::is_coupled;
use super::reading::{Found, wrong};
use super::steps::{Pace, Way};
use crate::cell::controllers::Fanuc as Words;
use crate::cell::controllers::words::{matched, matched_key, number, said_lines};
use crate::part::rpy;
use nalgebra::{Isometry3, Translation3, UnitQuaternion};
use std::collections::BTreeMap;

/// A listing in its parts.
#[derive(Default)]
struct Listing<'a> {
    /// `LINE_COUNT`.
    promised: Option<usize>,
    /// `DEFAULT_GROUP`: which axes the program moves. Other attributes are the controller's to change.
    group: Option<(usize, &'a str)>,
    /// Line of the file, and instruction.
    body: Vec<(usize, &'a str)>,
    /// By number: goal, and how it is said.
    positions: BTreeMap<u32, (Goal, String)>,
}

/// Where in a listing a line stands.
#[derive(Clone, Copy, PartialEq)]
enum Section {
    Before,
    Named,
    Attributes,
    Body,
    Positions,
    Ended,
}

/// Reads a program and those it calls.
pub fn read(file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let mut found = Found::new();
    found.file(file, &|file, found| one_file(file, reading, found))?;
    Ok(found.lines)
}

fn one_file(file: &ProgramFile, reading: &Reading<'_>, found: &mut Found) -> Result<(), ReadError> {
    let words = &reading.setup.cell.fanuc;
    let listing = sections(file, is_coupled(reading.setup))?;
    if listing.promised != Some(listing.body.len()) {
        let promised = listing.promised.map_or("none".into(), |n| n.to_string());
        let what = format!("LINE_COUNT promises {promised}, and {} lines are there", listing.body.len());
        return Err(wrong(&file.name, 1, what));
    }
    let Some((line, group)) = listing.group else {
        return Err(wrong(&file.name, 1, "no DEFAULT_GROUP says which axes the program moves"));
    };
    found.lines.push(ReadLine { file: file.name.clone(), line, what: Read::Other(group.into()) });
    let mut used = 0;
    for (line, text) in &listing.body {
        if let Some(name) = text.strip_prefix("CALL ") {
            let called = found.called(format!("{}.LS", name.trim()), &file.name, *line, reading)?;
            found.file(&called, &|file, found| one_file(file, reading, found))?;
            continue;
        }
        let what = statement(words, text, &listing.positions).map_err(|what| wrong(&file.name, *line, what))?;
        used += usize::from(matches!(what, Read::Move(_)));
        found.lines.push(ReadLine { file: file.name.clone(), line: *line, what });
    }
    if used != listing.positions.len() {
        let what = format!("{used} moves and {} positions; every move has its own", listing.positions.len());
        return Err(wrong(&file.name, 1, what));
    }
    Ok(())
}

fn sections(file: &ProgramFile, coupled: bool) -> Result<Listing<'_>, ReadError> {
    let mut listing = Listing::default();
    let mut section = Section::Before;
    // Number of the position that is open, and what was said of it.
    let mut open: Option<(u32, String)> = None;
    for (line, text) in said_lines(&file.text) {
        let fail = |what: String| Err(wrong(&file.name, line, what));
        section = match (section, text) {
            (Section::Before, t) if t.starts_with("/PROG ") => Section::Named,
            (Section::Named, "/ATTR") => Section::Attributes,
            (Section::Attributes, "/MN") => Section::Body,
            (Section::Body, "/POS") => Section::Positions,
            (Section::Positions, "/END") if open.is_none() => Section::Ended,
            (Section::Before | Section::Named, _) => return fail(format!("{text:?}: expected /PROG and /ATTR")),
            (Section::Attributes, t) => {
                if !t.contains('=') || !t.ends_with([';', ',']) {
                    return fail(format!("{t:?} is no attribute"));
                }
                if let Some(n) = t.strip_prefix("LINE_COUNT") {
                    let n = n.trim_start().trim_start_matches('=').trim_end_matches(';').trim();
                    listing.promised = n.parse().ok();
                }
                if t.starts_with("DEFAULT_GROUP") {
                    listing.group = Some((line, t));
                }
                section
            }
            (Section::Body, t) => {
                let split =
                    t.split_once(':').map(|(n, rest)| (n.trim().parse::<usize>(), rest.trim().strip_suffix(';')));
                let Some((Ok(n), Some(instruction))) = split else {
                    return fail(format!("{t:?}: expected a number, a colon, an instruction and ;"));
                };
                if listing.body.len() + 1 != n {
                    return fail(format!("line {n} comes where line {} should", listing.body.len() + 1));
                }
                listing.body.push((line, instruction.trim()));
                section
            }
            (Section::Positions, t) => {
                open = match (open.take(), t) {
                    (None, _) => match matched_key("P[{n}]{", "n", t).and_then(|n| n.parse().ok()) {
                        Some(n) if listing.positions.contains_key(&n) => return fail(format!("P[{n}] stands twice")),
                        Some(n) => Some((n, String::new())),
                        None => return fail(format!("{t:?}: expected the like of P[1]{{")),
                    },
                    (Some((n, said)), "};") => {
                        let goal = position(&said, coupled)
                            .map_err(|what| wrong(&file.name, line, format!("P[{n}]: {what}")))?;
                        listing.positions.insert(n, goal);
                        None
                    }
                    (Some((n, said)), more) => {
                        let more = more.chars().filter(|c| !c.is_whitespace());
                        Some((n, said.chars().chain(more).collect()))
                    }
                };
                section
            }
            (Section::Ended, _) => return fail("stands behind /END; take it out".into()),
        };
    }
    match section {
        Section::Ended => Ok(listing),
        _ => Err(ReadError::CutOff { file: file.name.clone(), expected: "/END" }),
    }
}

/// What is said of a position, without blanks.
fn position(said: &str, coupled: bool) -> Result<(Goal, String), String> {
    let joints = "GP1:UF:{f},UT:{t},J1={a}deg,J2={b}deg,J3={c}deg,J4={d}deg,J5={e}deg,J6={g}deg";
    let pose = "GP1:UF:{f},UT:{t},CONFIG:'{config}',X={x}mm,Y={y}mm,Z={z}mm,W={a}deg,P={b}deg,R={c}deg";
    let six = |list: &[(&str, &str)]| -> Result<[f64; 6], String> {
        let numbers: Option<Vec<f64>> = list.iter().map(|(_, v)| number(v)).collect();
        numbers.and_then(|n| n.try_into().ok()).ok_or_else(|| format!("{said:?} has no six numbers"))
    };
    if let Some([(_, uf), (_, ut), rest @ ..]) = matched(joints, said).as_deref() {
        let mut j = six(rest)?;
        if coupled {
            j[2] += j[1];
        }
        return Ok((Goal::Joints(j), format!("UF{uf} UT{ut}")));
    }
    if let Some([(_, uf), (_, ut), (_, config), rest @ ..]) = matched(pose, said).as_deref() {
        let [x, y, z, rx, ry, rz] = six(rest)?;
        let turn = UnitQuaternion::from_rotation_matrix(&rpy::to_rotation([rz, ry, rx]));
        let goal = Goal::Flange(Isometry3::from_parts(Translation3::new(x, y, z), turn));
        return Ok((goal, format!("UF{uf} UT{ut} {config}")));
    }
    Err(format!("{said:?}: expected UF, UT and J1 to J6 in deg, or CONFIG, X Y Z in mm and W P R in deg"))
}

fn statement(words: &Words, text: &str, positions: &BTreeMap<u32, (Goal, String)>) -> Result<Read, String> {
    if let Some(said) = text.strip_prefix('!') {
        return Ok(Read::Say(said.trim().into()));
    }
    if text.starts_with("J P[") || text.starts_with("L P[") {
        return go(text, positions).map(Read::Move);
    }
    if text.starts_with("UFRAME_NUM=") || text.starts_with("UTOOL_NUM=") {
        return Ok(Read::Other(text.into()));
    }
    for (template, on) in [(&words.output_on, true), (&words.output_off, false)] {
        if let Some(number) = matched_key(template, "n", text).and_then(|n| n.trim().parse().ok()) {
            return Ok(Read::Output { number, on });
        }
    }
    if let Some(seconds) = matched_key("WAIT {s}(sec)", "s", text).and_then(number).filter(|s| *s >= 0.0) {
        return Ok(Read::Wait(seconds));
    }
    for (template, group) in [(&words.analogue, false), (&words.group, true)] {
        let key = |key| matched_key(template, key, text);
        if let (Some(Ok(number)), Some(value)) = (key("n").map(|n| n.trim().parse()), key("v").and_then(number)) {
            return Ok(Read::Level { number, value, group });
        }
    }
    Err(format!(
        "{text:?} is not understood; expected J, L, {:?}, {:?}, WAIT, CALL, UFRAME_NUM, UTOOL_NUM or a remark",
        words.output_on, words.output_off
    ))
}

fn go(text: &str, positions: &BTreeMap<u32, (Goal, String)>) -> Result<ReadMove, String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let &[way, position, pace, termination] = words.as_slice() else {
        return Err(format!("{text:?}: give J or L, P[n], a time or %, and FINE or CNT, nothing else"));
    };
    let way = if way == "J" { Way::Joint } else { Way::Linear };
    let n: Option<u32> = matched_key("P[{n}]", "n", position).and_then(|n| n.parse().ok());
    let (goal, said) = n.and_then(|n| positions.get(&n)).ok_or_else(|| format!("{position} is not among /POS"))?;
    let figure = |unit| pace.strip_suffix(unit).and_then(number);
    let pace = match (figure("msec"), figure("sec"), figure("%")) {
        (Some(ms), ..) => Pace::Seconds(ms / 1000.0),
        (None, Some(s), _) => Pace::Seconds(s),
        (None, None, Some(p)) => Pace::Percent(p),
        (None, None, None) => {
            return Err(format!("{pace}: a speed of the flange says nothing of the spot's; give sec, msec or %"));
        }
    };
    let share = termination.strip_prefix("CNT").map(str::parse::<u32>);
    if termination != "FINE" && !matches!(share, Some(Ok(0..=100))) {
        return Err(format!("{termination}: give FINE, or CNT0 to CNT100"));
    }
    Ok(ReadMove { way, goal: *goal, pace, rest: format!("{termination} {said}") })
}
