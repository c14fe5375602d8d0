//! INFORM jobs as this program writes them, read back: positions first, then what is done with them.

use super::{from_pulses, phrases};
use crate::cell::Setup;
use crate::cell::controllers::words::{number, numbers, said_lines};
use crate::program::dialect::{Goal, ProgramFile, Read, ReadError, ReadLine, ReadMove, Reading};
use crate::program::flange::{Travel, pose};
use crate::program::reading::from_nowhere;
use crate::program::steps::{Pace, Way};
use nalgebra::{Isometry3, Translation3};

/// The lines of a job and of those that it calls.
pub fn read(file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let mut reader = Reader { setup: reading.setup, out: Vec::new(), at: None };
    reader.job(file, Some(reading))?;
    Ok(reader.out)
}

struct Reader<'a> {
    setup: &'a Setup,
    out: Vec<ReadLine>,
    at: Option<Isometry3<f64>>,
}

/// A position of a job: where, and its `RCONF`.
#[derive(Clone, Debug)]
struct Position {
    goal: Goal,
    figure: String,
}

/// Where in a job a line stands.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Job,
    Name,
    Pos,
    Count,
    Positions,
    Head,
    Body,
    End,
}

/// The positions, and the state that counts for the next.
#[derive(Default)]
struct Positions {
    expected: usize,
    list: Vec<Position>,
    /// Whether the tool was said, which each kind of positions begins with.
    tool: bool,
    pulses: Option<bool>,
    /// The line after `///POSTYPE` that says the same again.
    owed: Option<&'static str>,
    figure: Option<String>,
}

impl Reader<'_> {
    /// One file; only the main one may call others.
    fn job(&mut self, file: &ProgramFile, calls: Option<&Reading<'_>>) -> Result<(), ReadError> {
        let mut positions = Positions::default();
        let mut part = Part::Job;
        let stem = file.name.strip_suffix(".JBI").unwrap_or(&file.name);
        for (line, text) in said_lines(&file.text) {
            let wrong = |what: String| ReadError::Line { file: file.name.clone(), line, what };
            let is = |expected: &str, next| {
                if text == expected { Ok(next) } else { Err(wrong(format!("expected {expected}"))) }
            };
            part = match part {
                Part::Job => is("/JOB", Part::Name)?,
                Part::Name => is(&format!("//NAME {stem}"), Part::Pos)?,
                Part::Pos => is("//POS", Part::Count)?,
                Part::Count => {
                    let count = text.strip_prefix("///NPOS ").and_then(|t| t.strip_suffix(",0,0,0,0,0"));
                    let count = count.and_then(|c| c.parse().ok());
                    positions.expected = count.ok_or_else(|| wrong("expected ///NPOS n,0,0,0,0,0".into()))?;
                    Part::Positions
                }
                Part::Positions if text == "//INST" => {
                    let (expected, found) = (positions.expected, positions.list.len());
                    if expected != found {
                        return Err(wrong(format!("NPOS says {expected} positions, but there are {found}")));
                    }
                    Part::Head
                }
                Part::Positions => {
                    positions.line(self.setup, text).map_err(wrong)?;
                    Part::Positions
                }
                Part::Head if text == "NOP" => Part::Body,
                Part::Head => {
                    if !self.setup.cell.yaskawa.start.iter().any(|s| s == text) {
                        return Err(wrong("not as in the cell file, yaskawa.start".into()));
                    }
                    self.said(file, line, Read::Other(text.into()));
                    Part::Head
                }
                Part::Body if text == "END" => Part::End,
                Part::Body => {
                    match (text.strip_prefix("CALL JOB:"), calls) {
                        (Some(_), None) => return Err(wrong("a part of a job calls none itself".into())),
                        (Some(name), Some(reading)) => {
                            let name = format!("{name}.JBI");
                            let Some(text) = (reading.open)(&name) else {
                                return Err(ReadError::Gone { file: file.name.clone(), line, called: name });
                            };
                            self.job(&ProgramFile { name, text }, None)?;
                        }
                        (None, _) if text.starts_with("MOVL ") && self.at.is_none() => {
                            return Err(from_nowhere(&self.out, &file.name, line));
                        }
                        (None, _) => {
                            let what = self.instruction(&positions.list, text).map_err(wrong)?;
                            self.said(file, line, what);
                        }
                    }
                    Part::Body
                }
                Part::End => return Err(wrong("nothing may stand after END".into())),
            };
        }
        if part == Part::End { Ok(()) } else { Err(ReadError::CutOff { file: file.name.clone(), expected: "END" }) }
    }

    fn said(&mut self, file: &ProgramFile, line: usize, what: Read) {
        self.out.push(ReadLine { file: file.name.clone(), line, what });
    }

    fn instruction(&mut self, positions: &[Position], text: &str) -> Result<Read, String> {
        let (way, rest) = if let Some(rest) = text.strip_prefix("MOVJ ") {
            (Way::Joint, rest)
        } else if let Some(rest) = text.strip_prefix("MOVL ") {
            (Way::Linear, rest)
        } else {
            let read = phrases(&self.setup.cell.yaskawa).read(text);
            return read.ok_or("no line of this job; expected MOVJ, MOVL, an output, a wait or a comment".into());
        };
        let words: Vec<&str> = rest.split_whitespace().collect();
        let [position, speed, level] = words[..] else {
            return Err("expected a position, a speed and PL".into());
        };
        let index = position.strip_prefix('C').filter(|n| n.len() == 5).and_then(|n| n.parse::<usize>().ok());
        let to = index.and_then(|i| positions.get(i)).ok_or(format!("there is no position {position}"))?.clone();
        let level = level.strip_prefix("PL=").filter(|l| matches!(l.as_bytes(), [b'0'..=b'8']));
        let level = level.ok_or("expected PL= of 0 to 8")?;
        let at = match to.goal {
            Goal::Joints(joints) => self.setup.robot.as_ref().map(|r| r.forward(&joints)),
            Goal::Flange(at) | Goal::Focus(at) => Some(at),
        };
        let (unit, value) = speed.split_once('=').ok_or("expected V=, VR= or VJ=")?;
        let value = number(value).filter(|v| *v > 0.0).ok_or("expected a speed above 0")?;
        let pace = match (way, unit) {
            (Way::Joint, "VJ") => Pace::Percent(value),
            (Way::Linear, "V" | "VR") => {
                let (Some(from), Some(to)) = (&self.at, &at) else {
                    return Err("a straight move to pulses, whose duration is known with a robot only".into());
                };
                let travel = Travel::between(from, to);
                Pace::Seconds(if unit == "V" { travel.mm } else { travel.deg } / value)
            }
            _ => return Err("expected VJ= with MOVJ, and V= or VR= with MOVL".into()),
        };
        self.at = at;
        Ok(Read::Move(ReadMove { way, goal: to.goal, pace, rest: format!("PL={level} {}", to.figure).trim().into() }))
    }
}

impl Positions {
    fn line(&mut self, setup: &Setup, text: &str) -> Result<(), String> {
        let yaskawa = &setup.cell.yaskawa;
        if let Some(owed) = self.owed.take() {
            return if text == owed { Ok(()) } else { Err(format!("expected {owed}")) };
        }
        if text.starts_with("///POSTYPE ") && !std::mem::take(&mut self.tool) {
            return Err("expected ///TOOL before it".into());
        }
        match text {
            "///POSTYPE BASE" => (self.pulses, self.owed, self.figure) = (Some(false), Some("///RECTAN"), None),
            "///POSTYPE PULSE" => (self.pulses, self.owed) = (Some(true), Some("///PULSE")),
            _ => {
                if let Some(tool) = text.strip_prefix("///TOOL ") {
                    self.tool = tool == yaskawa.tool.to_string();
                    return if self.tool { Ok(()) } else { Err(format!("expected tool {}", yaskawa.tool)) };
                }
                if let Some(figure) = text.strip_prefix("///RCONF ") {
                    let is_figure = figure.split(',').all(|f| matches!(f, "0" | "1")) && figure.split(',').count() == 8;
                    self.figure = is_figure.then(|| figure.into());
                    return self.figure.as_ref().map(|_| ()).ok_or("expected eight figures, 0 or 1".into());
                }
                return self.position(setup, text);
            }
        }
        Ok(())
    }

    fn position(&mut self, setup: &Setup, text: &str) -> Result<(), String> {
        let yaskawa = &setup.cell.yaskawa;
        let rest = text.strip_prefix(&format!("C{:05}=", self.list.len()));
        let rest = rest.ok_or(format!("expected position C{:05}", self.list.len()))?;
        let six: [f64; 6] = numbers(rest).ok_or("expected six numbers")?;
        let position = match self.pulses.ok_or("a position before ///POSTYPE")? {
            true => {
                let per_deg = yaskawa.pulses_per_deg.ok_or("pulses; give yaskawa.pulses_per_deg in the cell file")?;
                Position { goal: Goal::Joints(from_pulses(setup, &six, &per_deg)), figure: String::new() }
            }
            false => {
                let figure = self.figure.as_ref().ok_or("a pose before ///RCONF")?;
                let [x, y, z, rx, ry, rz] = six;
                let at = Translation3::new(0.0, 0.0, yaskawa.base_height_mm) * pose([x, y, z, rz, ry, rx]);
                Position { goal: Goal::Flange(at), figure: format!("RCONF={figure}") }
            }
        };
        self.list.push(position);
        Ok(())
    }
}
