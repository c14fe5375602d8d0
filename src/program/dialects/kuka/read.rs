//! KRL as it is written here, read back: poses, and durations from the speeds before them.

use super::{AXES, FRAME, settings, templates};
use crate::cell::Setup;
use crate::cell::controllers::Kuka;
use crate::cell::controllers::templates::{matched_key, non_blank_lines, number};
use crate::program::dialect::{Goal, ProgramFile, ReadContext, ReadLine, ReadMove, Statement};
use crate::program::dialects::flange::{Speeds, Travel, joints, pose};
use crate::program::dialects::reading::unknown_start;
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::read_error::{LineFault, ReadError};
use nalgebra::Isometry3;

/// The lines of a program and its subprograms.
pub fn read(file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let kuka = &reading.setup.cell.kuka;
    let mut reader = KrlReader {
        setup: reading.setup,
        kuka,
        settings: settings(kuka),
        out: Vec::new(),
        at: None,
        m_s: None,
        deg_s: [None; 2],
        percent: None,
    };
    reader.module(file, Some(reading))?;
    Ok(reader.out)
}

/// What the controller keeps from line to line, over subprograms too.
struct KrlReader<'a> {
    setup: &'a Setup,
    kuka: &'a Kuka,
    settings: Vec<String>,
    out: Vec<ReadLine>,
    at: Option<Isometry3<f64>>,
    m_s: Option<f64>,
    deg_s: [Option<f64>; 2],
    percent: Option<f64>,
}

impl KrlReader<'_> {
    /// One file; only the main one may call others.
    fn module(&mut self, file: &ProgramFile, calls: Option<&ReadContext<'_>>) -> Result<(), ReadError> {
        let first = format!("DEF {}( )", file.name.strip_suffix(".src").unwrap_or(&file.name));
        let (mut begun, mut ended) = (false, false);
        for (line, text) in non_blank_lines(&file.text) {
            let wrong = |fault: LineFault| fault.at(&file.name, line);
            if ended {
                return Err(wrong(LineFault::BehindEnd { end: "END".into() }));
            }
            if !begun {
                begun = text == first;
                if !begun {
                    if !self.kuka.attributes.iter().any(|a| a == text) {
                        return Err(wrong(LineFault::expected([first], text)));
                    }
                    self.out.push(ReadLine { file: file.name.clone(), line, what: Statement::Other(text.into()) });
                }
                continue;
            }
            if text == "END" {
                ended = true;
                continue;
            }
            let called = text.strip_suffix("( )").filter(|n| n.starts_with(&format!("{}_", self.kuka.name)));
            if let Some(name) = called {
                let reading = calls.ok_or_else(|| wrong(LineFault::NestedCall))?;
                let name = format!("{name}.src");
                let Some(text) = (reading.open)(&name) else {
                    return Err(ReadError::Gone { file: file.name.clone(), line, called: name });
                };
                self.module(&ProgramFile { name, text }, None)?;
                continue;
            }
            let what = match (text.strip_prefix("LIN "), self.at) {
                (None, _) => self.line(text).map_err(wrong)?,
                (Some(rest), Some(from)) => Some(self.lin(&from, rest).map_err(wrong)?),
                (Some(_), None) => return Err(unknown_start(&self.out, &file.name, line)),
            };
            self.out.extend(what.map(|what| ReadLine { file: file.name.clone(), line, what }));
        }
        if ended { Ok(()) } else { Err(ReadError::CutOff { file: file.name.clone(), expected: "END".into() }) }
    }

    /// What a line that is no straight move does; `None` for a speed, which counts in the moves after it.
    fn line(&mut self, text: &str) -> Result<Option<Statement>, LineFault> {
        if let Some(rest) = text.strip_prefix("PTP ") {
            return self.ptp(rest).map(Some);
        }
        if let Some((name, value)) = text.strip_prefix("$VEL.").and_then(|t| t.split_once('=')) {
            let above_zero = number(value).filter(|v| *v > 0.0);
            let value = above_zero.ok_or_else(|| LineFault::NotAboveZero { found: value.into() })?;
            match name {
                "CP" => self.m_s = Some(value),
                "ORI1" => self.deg_s[0] = Some(value),
                "ORI2" => self.deg_s[1] = Some(value),
                _ => return Err(LineFault::expected(["$VEL.CP", "$VEL.ORI1", "$VEL.ORI2"], text)),
            }
            return Ok(None);
        }
        if let Some(percent) = matched_key(&self.kuka.joint_speed, "percent", text) {
            let whole = number(percent).filter(|p| (1.0..=100.0).contains(p) && p.fract() == 0.0);
            self.percent = Some(whole.ok_or_else(|| LineFault::expected(["1 … 100"], percent))?);
            return Ok(None);
        }
        if self.settings.iter().any(|s| s == text) {
            return Ok(Some(Statement::Other(text.into())));
        }
        templates(self.kuka).read(text).map(Some).ok_or_else(|| {
            let k = self.kuka;
            let known = [&k.output_on, &k.output_off, &k.wait, &k.comment].map(String::as_str);
            LineFault::expected(["PTP", "LIN", "$VEL."].into_iter().chain(known).map(String::from), text)
        })
    }

    fn ptp(&mut self, rest: &str) -> Result<Statement, LineFault> {
        let percent =
            self.percent.ok_or_else(|| LineFault::Before { missing: self.kuka.joint_speed.clone().into() })?;
        let goal = if let Some(axes) = braced(AXES, rest) {
            let joints_deg = joints(self.setup, &axes);
            self.at = self.setup.robot.as_ref().map(|r| r.forward(&joints_deg));
            Goal::Joints(joints_deg)
        } else {
            let form = || LineFault::expected(["{A1 …,A6 …}", "{X …,C …}"], rest);
            let at = pose(braced(FRAME, rest).ok_or_else(form)?);
            self.at = Some(at);
            Goal::Flange(at)
        };
        let timing = MoveTiming::Percent(percent);
        Ok(Statement::Move(ReadMove { interpolation: Interpolation::Joint, goal, timing, rest: String::new() }))
    }

    fn lin(&mut self, from: &Isometry3<f64>, text: &str) -> Result<Statement, LineFault> {
        let form = || LineFault::expected(["{X …,Y …,Z …,A …,B …,C …}"], text);
        let (numbers, rest) = text.split_once('}').ok_or_else(form)?;
        let rest = rest.trim();
        if !matches!(rest, "" | "C_DIS") {
            return Err(LineFault::expected(["C_DIS"], rest));
        }
        let to = pose(braced(FRAME, &format!("{numbers}}}")).ok_or_else(form)?);
        let [Some(ori1), Some(ori2)] = self.deg_s else {
            return Err(LineFault::Before { missing: "$VEL.ORI1, $VEL.ORI2".into() });
        };
        let m_s = self.m_s.ok_or(LineFault::Before { missing: "$VEL.CP".into() })?;
        let speeds = Speeds { mm_s: 1000.0 * m_s, deg_s: ori1.min(ori2) };
        let seconds = Travel::between(from, &to).seconds(speeds);
        self.at = Some(to);
        let (goal, timing) = (Goal::Flange(to), MoveTiming::Seconds(seconds));
        Ok(Statement::Move(ReadMove { interpolation: Interpolation::Linear, goal, timing, rest: rest.into() }))
    }
}

/// The numbers of `{X 1.000,Y 2.000,...}`, all six, named in order.
fn braced(names: [&str; 6], text: &str) -> Option<[f64; 6]> {
    let fields: Vec<&str> = text.trim().strip_prefix('{')?.strip_suffix('}')?.split(',').collect();
    if fields.len() != names.len() {
        return None;
    }
    let mut out = [0.0; 6];
    for ((slot, name), field) in out.iter_mut().zip(names).zip(fields) {
        let (said, value) = field.trim().split_once(' ')?;
        *slot = number(value).filter(|_| said == name)?;
    }
    Some(out)
}
