//! Reads a FANUC listing back. What a controller counts and dates in it by itself is passed over, numbers of lines
//! included; every instruction and every position has to be understood.

use super::{SPELLING, is_coupled, templates};
use crate::cell::controllers::Fanuc;
use crate::cell::controllers::templates::{matched, matched_key, non_blank_lines, number};
use crate::program::dialect::{Goal, ProgramFile, ReadContext, ReadLine, ReadMove, Statement};
use crate::program::dialects::flange::pose;
use crate::program::dialects::reading::Found;
use crate::program::dialects::signals::SignalReader;
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::read_error::{LineFault, ReadError};
use std::collections::BTreeMap;

/// Positions by number: goal, and how it is said.
type ListedPositions = BTreeMap<u32, (Goal, String)>;

/// A listing in its parts.
#[derive(Default)]
struct Listing<'a> {
    /// Names that it may have.
    names: Vec<&'a str>,
    /// Whether `LINE_COUNT` stands there: a listing that was cut may lack it.
    is_counted: bool,
    /// `DEFAULT_GROUP`: which axes the program moves. Other attributes are the controller's to change.
    group: Option<(usize, String)>,
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
    /// Of the controller's application software.
    Application,
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
    let signals = SignalReader::new(&templates(fanuc));
    // The program that is started may stand in a file of another name; it has its own all the same.
    let stem = file.name.rsplit_once('.').map_or(file.name.as_str(), |(stem, _)| stem);
    let own = Some(fanuc.program.as_str()).filter(|_| found.is_main());
    let listing = sections(file, Some(stem).into_iter().chain(own).collect(), is_coupled(reading.setup))?;
    if !listing.is_counted {
        let fault = LineFault::Count { of: "LINE_COUNT", promised: None, found: listing.body.len() };
        return Err(fault.at(&file.name, 1));
    }
    let Some((line, group)) = listing.group else {
        return Err(LineFault::NoMotionGroup.at(&file.name, 1));
    };
    // How many subprograms a program has depends on its comments: what they all say alike counts once.
    if !found.lines.iter().any(|l| matches!(&l.what, Statement::Other(said) if *said == group)) {
        found.lines.push(ReadLine { file: file.name.clone(), line, what: Statement::Other(group) });
    }
    for (line, text) in &listing.body {
        let plain = SPELLING.plain(text);
        if let Some(name) = plain.strip_prefix("CALL ") {
            let called = found.called(format!("{name}.LS"), &file.name, *line, reading)?;
            found.file(&called, &|file, found| one_file(file, reading, found))?;
            continue;
        }
        let what = statement(fanuc, &signals, text, &plain, &listing.positions);
        let what = what.map_err(|fault| fault.at(&file.name, *line))?;
        found.lines.push(ReadLine { file: file.name.clone(), line: *line, what });
    }
    Ok(())
}

fn sections<'a>(file: &'a ProgramFile, names: Vec<&'a str>, coupled: bool) -> Result<Listing<'a>, ReadError> {
    let mut listing = Listing { names, ..Listing::default() };
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
        let plain = SPELLING.plain(text);
        match (section, plain.as_str()) {
            (ListingSection::Before, t) => return self.named(text, t),
            (ListingSection::Named, "/ATTR") => return Ok(ListingSection::Attributes),
            (ListingSection::Attributes, "/APPL") => return Ok(ListingSection::Application),
            (ListingSection::Attributes | ListingSection::Application, "/MN") => return Ok(ListingSection::Body),
            (ListingSection::Body, "/POS") => return Ok(ListingSection::Positions),
            (ListingSection::Body, "/END") => return Ok(ListingSection::Ended),
            (ListingSection::Positions, "/END") if self.open.is_none() => return Ok(ListingSection::Ended),
            (ListingSection::Named, _) => return Err(LineFault::expected(["/ATTR"], text)),
            (ListingSection::Attributes, t) => self.attribute(line, text, t)?,
            (ListingSection::Application, _) => {}
            (ListingSection::Body, _) => self.instruction(line, text)?,
            (ListingSection::Positions, t) => self.position(text, t, coupled)?,
            (ListingSection::Ended, _) => return Err(LineFault::BehindEnd { end: "/END".into() }),
        }
        Ok(section)
    }

    /// The first line, with the name that the controller knows the program by.
    fn named(&self, text: &str, plain: &str) -> Result<ListingSection, LineFault> {
        let name = plain.strip_prefix("/PROG ").and_then(|rest| rest.split(' ').next()).unwrap_or_default();
        if self.names.iter().any(|own| name.eq_ignore_ascii_case(own)) {
            return Ok(ListingSection::Named);
        }
        Err(LineFault::expected(self.names.iter().map(|own| format!("/PROG {own}")), text))
    }

    fn attribute(&mut self, line: usize, text: &str, plain: &str) -> Result<(), LineFault> {
        if !plain.contains('=') || !plain.ends_with([';', ',']) {
            return Err(LineFault::expected(["NAME = VALUE;", "/MN"], text));
        }
        self.is_counted |= plain.starts_with("LINE_COUNT=");
        if plain.starts_with("DEFAULT_GROUP=") {
            self.group = Some((line, plain.into()));
        }
        Ok(())
    }

    /// Numbers of lines are the controller's own: it counts them anew.
    fn instruction(&mut self, line: usize, text: &'a str) -> Result<(), LineFault> {
        let form = || LineFault::expected(["1: … ;"], text);
        let (number, rest) = text.split_once(':').ok_or_else(form)?;
        let is_number = number.trim().bytes().all(|b| b.is_ascii_digit());
        let instruction = rest.trim().strip_suffix(';').filter(|_| is_number).ok_or_else(form)?;
        self.body.push((line, instruction.trim()));
        Ok(())
    }

    fn position(&mut self, text: &str, plain: &str, coupled: bool) -> Result<(), LineFault> {
        self.open = match (self.open.take(), plain) {
            (None, _) => match matched_key("P[{n}]{", "n", plain).and_then(|n| n.parse().ok()) {
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
            (Some(_), group) if group.starts_with("GP") && group != "GP1:" => {
                return Err(LineFault::OtherMotionGroup { found: group.trim_end_matches(':').into() });
            }
            (Some((n, said)), _) => {
                let more = text.chars().filter(|c| !c.is_whitespace()).map(|c| c.to_ascii_uppercase());
                Some((n, said.chars().chain(more).collect()))
            }
        };
        Ok(())
    }
}

/// What is said of a position, without blanks and in large letters.
fn position(said: &str, coupled: bool) -> Result<(Goal, String), LineFault> {
    let joints = "GP1:UF:{f},UT:{t},J1={a}DEG,J2={b}DEG,J3={c}DEG,J4={d}DEG,J5={e}DEG,J6={g}DEG";
    let pose_form = "GP1:UF:{f},UT:{t},CONFIG:'{config}',X={x}MM,Y={y}MM,Z={z}MM,W={a}DEG,P={b}DEG,R={c}DEG";
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

fn statement(
    fanuc: &Fanuc,
    signals: &SignalReader<'_>,
    text: &str,
    plain: &str,
    positions: &ListedPositions,
) -> Result<Statement, LineFault> {
    if plain.starts_with("J P[") || plain.starts_with("L P[") {
        return read_move(plain, positions).map(Statement::Move);
    }
    if plain.starts_with("UFRAME_NUM=") || plain.starts_with("UTOOL_NUM=") {
        return Ok(Statement::Other(plain.into()));
    }
    signals.read(text).ok_or_else(|| {
        let known =
            ["J P[", "L P[", &fanuc.output_on, &fanuc.output_off, "WAIT", "CALL", "UFRAME_NUM", "UTOOL_NUM", "!"];
        LineFault::expected(known.map(String::from), text)
    })
}

/// A move in its plain spelling: `L P[3]1666MSEC CNT100`, and what else it says.
fn read_move(text: &str, positions: &ListedPositions) -> Result<ReadMove, LineFault> {
    let form = || LineFault::expected(["J P[n] % FINE", "L P[n] sec or msec, FINE or CNT"], text);
    let (way, rest) = text.split_once(" P[").ok_or_else(form)?;
    let (n, rest) = rest.split_once(']').ok_or_else(form)?;
    let interpolation = if way == "J" { Interpolation::Joint } else { Interpolation::Linear };
    let undefined = || LineFault::Undefined { name: format!("P[{n}]") };
    let n: u32 = n.parse().map_err(|_| undefined())?;
    let (goal, said) = positions.get(&n).ok_or_else(undefined)?;
    let (figure, unit) = rest.split_at(rest.find(|c: char| !(c.is_ascii_digit() || c == '.')).ok_or_else(form)?);
    let (unit, more) =
        unit.strip_prefix('%').map_or_else(|| unit.split_once(' '), |m| Some(("%", m))).ok_or_else(form)?;
    let timing = match (unit, number(figure)) {
        ("MSEC", Some(ms)) => MoveTiming::Seconds(ms / 1000.0),
        ("SEC", Some(s)) => MoveTiming::Seconds(s),
        ("%", Some(p)) => MoveTiming::Percent(p),
        _ => return Err(LineFault::FlangeSpeed { found: format!("{figure}{unit}"), one_of: &["sec", "msec", "%"] }),
    };
    Ok(ReadMove { interpolation, goal: *goal, timing, rest: format!("{} {said}", more.trim()) })
}
