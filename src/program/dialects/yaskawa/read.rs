//! INFORM jobs as they are written here, read back: positions first, then what is done with them.

use super::positions::{JobPositions, ReadPosition};
use super::{SPELLING, templates};
use crate::cell::Setup;
use crate::cell::controllers::templates::{non_blank_lines, number};
use crate::program::dialect::{Goal, ProgramFile, ReadContext, ReadLine, ReadMove, Statement};
use crate::program::dialects::flange::Travel;
use crate::program::dialects::reading::unknown_start;
use crate::program::dialects::signals::SignalReader;
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::read_error::{LineFault, ReadError};
use nalgebra::Isometry3;

/// The lines of a job and of those that it calls.
pub fn read(file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let signals = SignalReader::new(&templates(&reading.setup.cell.yaskawa));
    let mut reader = JobReader { setup: reading.setup, signals, out: Vec::new(), at: None };
    reader.job(file, Some(reading))?;
    Ok(reader.out)
}

/// What was read, and where the arm stands then.
struct JobReader<'a> {
    setup: &'a Setup,
    signals: SignalReader<'a>,
    out: Vec<ReadLine>,
    at: Option<Isometry3<f64>>,
}

/// Where in a job a line stands.
#[derive(Clone, Copy, Debug, PartialEq)]
enum JobSection {
    Job,
    Name,
    Pos,
    Count,
    Positions,
    Head,
    Body,
    End,
}

impl JobReader<'_> {
    /// One file; only the main one may call others.
    fn job(&mut self, file: &ProgramFile, calls: Option<&ReadContext<'_>>) -> Result<(), ReadError> {
        let mut positions = JobPositions::default();
        let mut section = JobSection::Job;
        for (line, text) in non_blank_lines(&file.text) {
            let wrong = |fault: LineFault| fault.at(&file.name, line);
            let plain = SPELLING.plain(text);
            section = match section {
                JobSection::Head if plain == "NOP" => JobSection::Body,
                JobSection::Head => {
                    let what = self.attribute(text, &plain).map_err(wrong)?;
                    self.out.push(ReadLine { file: file.name.clone(), line, what });
                    JobSection::Head
                }
                JobSection::Body if plain == "END" => JobSection::End,
                JobSection::Body => {
                    self.body(file, (line, text), &plain, &positions.list, calls)?;
                    JobSection::Body
                }
                JobSection::End => {
                    let comment = self.signals.read_comment(text);
                    let what = comment.ok_or_else(|| wrong(LineFault::BehindEnd { end: "END".into() }))?;
                    self.out.push(ReadLine { file: file.name.clone(), line, what });
                    JobSection::End
                }
                JobSection::Positions if plain != "//INST" => {
                    let what = positions.line(self.setup, &plain).map_err(wrong)?;
                    self.out.extend(what.map(|what| ReadLine { file: file.name.clone(), line, what }));
                    JobSection::Positions
                }
                _ => self.head(section, (file, calls.is_some()), &plain, &mut positions).map_err(wrong)?,
            };
        }
        let expected = "END".into();
        if section == JobSection::End { Ok(()) } else { Err(ReadError::CutOff { file: file.name.clone(), expected }) }
    }

    /// A line between `//INST` and `NOP`. The controller sets date, comment and who may edit; whether positions are
    /// relative (`RJ`), frame and axes have to be as in the cell file.
    fn attribute(&self, text: &str, plain: &str) -> Result<Statement, LineFault> {
        let start = &self.setup.cell.yaskawa.start;
        if let Some(list) = plain.strip_prefix("///ATTR ") {
            let is_relative = list.split(',').any(|a| a == "RJ");
            return Ok(if is_relative {
                Statement::Other("///ATTR RJ".into())
            } else {
                Statement::Comment(text.into())
            });
        }
        if ["///DATE", "///COMM"].iter().any(|word| plain.starts_with(word)) {
            return Ok(Statement::Comment(text.into()));
        }
        let known = SPELLING.known(start, text).or_else(|| SPELLING.altered(start, text));
        known.ok_or(LineFault::NotAsInCell { expected: "yaskawa.start".into() })
    }

    /// A line of names and positions; where the next one stands.
    fn head(
        &self,
        section: JobSection,
        (file, is_main): (&ProgramFile, bool),
        text: &str,
        positions: &mut JobPositions,
    ) -> Result<JobSection, LineFault> {
        let is = |expected: &str, next| {
            if text == expected { Ok(next) } else { Err(LineFault::expected([expected.to_owned()], text)) }
        };
        match section {
            JobSection::Job => is("/JOB", JobSection::Name),
            JobSection::Name => {
                // The job that is started may stand in a file of another name; it has its own all the same.
                let own = &self.setup.cell.yaskawa.name;
                let stem = file.name.strip_suffix(".JBI").unwrap_or(&file.name);
                let is_own = is_main && text.strip_prefix("//NAME ") == Some(own);
                is(&format!("//NAME {}", if is_own { own } else { stem }), JobSection::Pos)
            }
            JobSection::Pos => is("//POS", JobSection::Count),
            JobSection::Count => {
                let count = text.strip_prefix("///NPOS ").and_then(|t| t.strip_suffix(",0,0,0,0,0"));
                let form = || LineFault::expected(["///NPOS n,0,0,0,0,0"], text);
                positions.expected = count.and_then(|c| c.parse().ok()).ok_or_else(form)?;
                Ok(JobSection::Positions)
            }
            _ => {
                let (promised, found) = (positions.expected, positions.list.len());
                if promised != found {
                    return Err(LineFault::Count { of: "///NPOS", promised: Some(promised.to_string()), found });
                }
                Ok(JobSection::Head)
            }
        }
    }

    /// A line after `NOP`.
    fn body(
        &mut self,
        file: &ProgramFile,
        (line, text): (usize, &str),
        plain: &str,
        positions: &[ReadPosition],
        calls: Option<&ReadContext<'_>>,
    ) -> Result<(), ReadError> {
        if let Some(name) = plain.strip_prefix("CALL JOB:") {
            let reading = calls.ok_or_else(|| LineFault::NestedCall.at(&file.name, line))?;
            let name = format!("{name}.JBI");
            let Some(text) = (reading.open)(&name) else {
                return Err(ReadError::Gone { file: file.name.clone(), line, called: name });
            };
            return self.job(&ProgramFile { name, text }, None);
        }
        if plain.starts_with("MOVL ") && self.at.is_none() {
            return Err(unknown_start(&self.out, &file.name, line));
        }
        let what = self.instruction(positions, text).map_err(|fault| fault.at(&file.name, line))?;
        self.out.push(ReadLine { file: file.name.clone(), line, what });
        Ok(())
    }

    fn instruction(&mut self, positions: &[ReadPosition], text: &str) -> Result<Statement, LineFault> {
        let code = SPELLING.plain(text);
        let (interpolation, rest) = if let Some(rest) = code.strip_prefix("MOVJ ") {
            (Interpolation::Joint, rest)
        } else if let Some(rest) = code.strip_prefix("MOVL ") {
            (Interpolation::Linear, rest)
        } else {
            let yaskawa = &self.setup.cell.yaskawa;
            return self.signals.read(text).ok_or_else(|| {
                let known = [&yaskawa.output_on, &yaskawa.output_off, &yaskawa.wait, &yaskawa.comment];
                let known = known.into_iter().map(String::as_str);
                LineFault::expected(["MOVJ", "MOVL"].into_iter().chain(known).map(String::from), text)
            });
        };
        let fields: Vec<&str> = rest.split_whitespace().collect();
        let [position, speed, ref settings @ ..] = fields[..] else {
            return Err(LineFault::expected(["MOVJ C00000 VJ= PL=", "MOVL C00000 V= PL="], text));
        };
        let index = position.strip_prefix('C').filter(|n| n.len() == 5).and_then(|n| n.parse::<usize>().ok());
        let undefined = || LineFault::Undefined { name: position.into() };
        let to = index.and_then(|i| positions.get(i)).ok_or_else(undefined)?.clone();
        let at = match to.goal {
            Goal::Joints(joints) => self.setup.robot.as_ref().map(|r| r.forward(&joints)),
            Goal::Flange(at) | Goal::Focus(at) => Some(at),
        };
        let timing = self.timing(interpolation, speed, at.as_ref())?;
        self.at = at;
        let rest = format!("{} {}", settings.join(" "), to.figure).trim().into();
        Ok(Statement::Move(ReadMove { interpolation, goal: to.goal, timing, rest }))
    }

    /// How fast a move is that leads to a pose of the flange.
    fn timing(
        &self,
        interpolation: Interpolation,
        speed: &str,
        to: Option<&Isometry3<f64>>,
    ) -> Result<MoveTiming, LineFault> {
        let units: &[&'static str] = match interpolation {
            Interpolation::Joint => &["VJ="],
            Interpolation::Linear => &["V=", "VR="],
        };
        let form = || LineFault::expected(units.iter().copied(), speed);
        let (unit, value) = speed.split_once('=').ok_or_else(form)?;
        let above_zero = number(value).filter(|v| *v > 0.0);
        let value = above_zero.ok_or_else(|| LineFault::NotAboveZero { found: value.into() })?;
        match (interpolation, unit) {
            (Interpolation::Joint, "VJ") => Ok(MoveTiming::Percent(value)),
            (Interpolation::Linear, "V" | "VR") => {
                let (Some(from), Some(to)) = (&self.at, to) else { return Err(LineFault::NoDuration) };
                let travel = Travel::between(from, to);
                Ok(MoveTiming::Seconds(if unit == "V" { travel.mm } else { travel.deg } / value))
            }
            _ => Err(form()),
        }
    }
}
