//! Reads a FANUC listing back: line numbers, the promised count and every position have to be right.

use super::{is_coupled, templates};
use crate::cell::controllers::Fanuc;
use crate::cell::controllers::templates::{matched, matched_key, non_blank_lines, number};
use crate::program::dialect::{Goal, ProgramFile, ReadContext, ReadLine, ReadMove, Statement};
use crate::program::dialects::flange::pose;
use crate::program::dialects::reading::Found;
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::read_error::{LineFault, ReadError};
use std::collections::BTreeMap;

/// Positions by number: goal, and how it is said.
type ListedPositions = BTreeMap<u32, (Goal, String)>;

/// A listing in its parts.
#[derive(Default)]
struct Listing<'a> {
    /// `LINE_COUNT`.
    promised: Option<usize>,
    /// `DEFAULT_GROUP`: which axes the program moves. Other attributes are the controller's to change.
    group: Option<(usize, &'a str)>,
    /// Line of the file, and instruction.
    body: Vec<(usize, &'a str)>,
    positions: ListedPositions,
    /// Number of the position that is open, and what was said of it.
    open: Option<(u32, String)>,
}

/// Where in a listing a line stands.
#[derive(Clone, Copy, PartialEq)]
enum ListingSection {
    Before,
    Named,
    Attributes,
    Body,
    Positions,
    Ended,
}

/// Reads a program and those it calls.
pub fn read(file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let mut found = Found::new();
    found.file(file, &|file, found| one_file(file, reading, found))?;
    Ok(found.lines)
}

fn one_file(file: &ProgramFile, reading: &ReadContext<'_>, found: &mut Found) -> Result<(), ReadError> {
    let fanuc = &reading.setup.cell.fanuc;
    let listing = sections(file, is_coupled(reading.setup))?;
    if listing.promised != Some(listing.body.len()) {
        let promised = listing.promised.map(|n| n.to_string());
        let fault = LineFault::Count { of: "LINE_COUNT", promised, found: listing.body.len() };
        return Err(fault.at(&file.name, 1));
    }
    let Some((line, group)) = listing.group else {
        return Err(LineFault::NoMotionGroup.at(&file.name, 1));
    };
    // How many subprograms a program has depends on its comments: what they all say alike counts once.
    if !found.lines.iter().any(|l| matches!(&l.what, Statement::Other(said) if said == group)) {
        found.lines.push(ReadLine { file: file.name.clone(), line, what: Statement::Other(group.into()) });
    }
    let mut used = 0;
    for (line, text) in &listing.body {
        if let Some(name) = text.strip_prefix("CALL ") {
            let called = found.called(format!("{}.LS", name.trim()), &file.name, *line, reading)?;
            found.file(&called, &|file, found| one_file(file, reading, found))?;
            continue;
        }
        let what = statement(fanuc, text, &listing.positions).map_err(|fault| fault.at(&file.name, *line))?;
        used += usize::from(matches!(what, Statement::Move(_)));
        found.lines.push(ReadLine { file: file.name.clone(), line: *line, what });
    }
    let positions = listing.positions.len();
    if used == positions {
        Ok(())
    } else {
        Err(LineFault::MovesAndPositions { moves: used, positions }.at(&file.name, 1))
    }
}

fn sections(file: &ProgramFile, coupled: bool) -> Result<Listing<'_>, ReadError> {
    let mut listing = Listing::default();
    let mut section = ListingSection::Before;
    for (line, text) in non_blank_lines(&file.text) {
        section = listing.line(section, line, text, coupled).map_err(|fault| fault.at(&file.name, line))?;
    }
    match section {
        ListingSection::Ended => Ok(listing),
        _ => Err(ReadError::CutOff { file: file.name.clone(), expected: "/END".into() }),
    }
}

impl<'a> Listing<'a> {
    /// Takes a line; where the next one stands.
    fn line(
        &mut self,
        section: ListingSection,
        line: usize,
        text: &'a str,
        coupled: bool,
    ) -> Result<ListingSection, LineFault> {
        match (section, text) {
            (ListingSection::Before, t) if t.starts_with("/PROG ") => return Ok(ListingSection::Named),
            (ListingSection::Named, "/ATTR") => return Ok(ListingSection::Attributes),
            (ListingSection::Attributes, "/MN") => return Ok(ListingSection::Body),
            (ListingSection::Body, "/POS") => return Ok(ListingSection::Positions),
            (ListingSection::Positions, "/END") if self.open.is_none() => return Ok(ListingSection::Ended),
            (ListingSection::Before, t) => return Err(LineFault::expected(["/PROG"], t)),
            (ListingSection::Named, t) => return Err(LineFault::expected(["/ATTR"], t)),
            (ListingSection::Attributes, t) => self.attribute(line, t)?,
            (ListingSection::Body, t) => self.instruction(line, t)?,
            (ListingSection::Positions, t) => self.position(t, coupled)?,
            (ListingSection::Ended, _) => return Err(LineFault::BehindEnd { end: "/END".into() }),
        }
        Ok(section)
    }

    fn attribute(&mut self, line: usize, text: &'a str) -> Result<(), LineFault> {
        if !text.contains('=') || !text.ends_with([';', ',']) {
            return Err(LineFault::expected(["NAME = VALUE;", "/MN"], text));
        }
        if let Some(n) = text.strip_prefix("LINE_COUNT") {
            let n = n.trim_start().trim_start_matches('=').trim_end_matches(';').trim();
            self.promised = n.parse().ok();
        }
        if text.starts_with("DEFAULT_GROUP") {
            self.group = Some((line, text));
        }
        Ok(())
    }

    fn instruction(&mut self, line: usize, text: &'a str) -> Result<(), LineFault> {
        let split = text.split_once(':').map(|(n, rest)| (n.trim().parse::<usize>(), rest.trim().strip_suffix(';')));
        let expected = self.body.len() + 1;
        let Some((Ok(n), Some(instruction))) = split else {
            return Err(LineFault::Expected { one_of: vec![format!("{expected}: … ;").into()], found: text.into() });
        };
        if n != expected {
            return Err(LineFault::OutOfOrder { found: n.to_string(), expected });
        }
        self.body.push((line, instruction.trim()));
        Ok(())
    }

    fn position(&mut self, text: &str, coupled: bool) -> Result<(), LineFault> {
        self.open = match (self.open.take(), text) {
            (None, _) => match matched_key("P[{n}]{", "n", text).and_then(|n| n.parse().ok()) {
                Some(n) if self.positions.contains_key(&n) => {
                    return Err(LineFault::Twice { name: format!("P[{n}]") });
                }
                Some(n) => Some((n, String::new())),
                None => return Err(LineFault::expected(["P[1]{"], text)),
            },
            (Some((n, said)), "};") => {
                self.positions.insert(n, position(&said, coupled)?);
                None
            }
            (Some((n, said)), more) => {
                let more = more.chars().filter(|c| !c.is_whitespace());
                Some((n, said.chars().chain(more).collect()))
            }
        };
        Ok(())
    }
}

/// What is said of a position, without blanks.
fn position(said: &str, coupled: bool) -> Result<(Goal, String), LineFault> {
    let joints = "GP1:UF:{f},UT:{t},J1={a}deg,J2={b}deg,J3={c}deg,J4={d}deg,J5={e}deg,J6={g}deg";
    let pose_form = "GP1:UF:{f},UT:{t},CONFIG:'{config}',X={x}mm,Y={y}mm,Z={z}mm,W={a}deg,P={b}deg,R={c}deg";
    let six = |list: &[(&str, &str)]| -> Result<[f64; 6], LineFault> {
        let numbers: Option<Vec<f64>> = list.iter().map(|(_, v)| number(v)).collect();
        numbers.and_then(|n| n.try_into().ok()).ok_or_else(|| LineFault::numbers(6, said))
    };
    if let Some([(_, uf), (_, ut), rest @ ..]) = matched(joints, said).as_deref() {
        let mut j = six(rest)?;
        if coupled {
            j[2] += j[1];
        }
        return Ok((Goal::Joints(j), format!("UF{uf} UT{ut}")));
    }
    if let Some([(_, uf), (_, ut), (_, config), rest @ ..]) = matched(pose_form, said).as_deref() {
        let [x, y, z, rx, ry, rz] = six(rest)?;
        return Ok((Goal::Flange(pose([x, y, z, rz, ry, rx])), format!("UF{uf} UT{ut} {config}")));
    }
    let forms = ["UF, UT, J1= deg, …, J6= deg", "UF, UT, CONFIG, X= mm, Y= mm, Z= mm, W= deg, P= deg, R= deg"];
    Err(LineFault::expected(forms, said))
}

fn statement(fanuc: &Fanuc, text: &str, positions: &ListedPositions) -> Result<Statement, LineFault> {
    if text.starts_with("J P[") || text.starts_with("L P[") {
        return read_move(text, positions).map(Statement::Move);
    }
    if text.starts_with("UFRAME_NUM=") || text.starts_with("UTOOL_NUM=") {
        return Ok(Statement::Other(text.into()));
    }
    templates(fanuc).read(text).ok_or_else(|| {
        let known =
            ["J P[", "L P[", &fanuc.output_on, &fanuc.output_off, "WAIT", "CALL", "UFRAME_NUM", "UTOOL_NUM", "!"];
        LineFault::expected(known.map(String::from), text)
    })
}

fn read_move(text: &str, positions: &ListedPositions) -> Result<ReadMove, LineFault> {
    let fields: Vec<&str> = text.split_whitespace().collect();
    let &[way, position, speed, termination] = fields.as_slice() else {
        return Err(LineFault::expected(["J P[n] % FINE", "L P[n] sec or msec, FINE or CNT"], text));
    };
    let interpolation = if way == "J" { Interpolation::Joint } else { Interpolation::Linear };
    let n: Option<u32> = matched_key("P[{n}]", "n", position).and_then(|n| n.parse().ok());
    let undefined = || LineFault::Undefined { name: position.into() };
    let (goal, said) = n.and_then(|n| positions.get(&n)).ok_or_else(undefined)?;
    let figure = |unit| speed.strip_suffix(unit).and_then(number);
    let timing = match (figure("msec"), figure("sec"), figure("%")) {
        (Some(ms), ..) => MoveTiming::Seconds(ms / 1000.0),
        (None, Some(s), _) => MoveTiming::Seconds(s),
        (None, None, Some(p)) => MoveTiming::Percent(p),
        (None, None, None) => {
            return Err(LineFault::FlangeSpeed { found: speed.into(), one_of: &["sec", "msec", "%"] });
        }
    };
    let share = termination.strip_prefix("CNT").map(str::parse::<u32>);
    if termination != "FINE" && !matches!(share, Some(Ok(0..=100))) {
        return Err(LineFault::expected(["FINE", "CNT0 … CNT100"], termination));
    }
    Ok(ReadMove { interpolation, goal: *goal, timing, rest: format!("{termination} {said}") })
}
