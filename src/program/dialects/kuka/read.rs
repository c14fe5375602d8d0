//! KRL as it is written here, read back: poses, and durations from the speeds before them.

use super::{AXES, FRAME, SPELLING, settings, templates};
use crate::cell::controllers::Kuka;
use crate::cell::controllers::templates::{matched_key, non_blank_lines, number};
use crate::program::dialect::{Goal, ProgramFile, ReadContext, ReadLine, ReadMove, Statement};
use crate::program::dialects::flange::{Speeds, Travel, joints, pose};
use crate::program::dialects::reading::unknown_start;
use crate::program::dialects::signals::SignalReader;
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::read_error::{LineFault, ReadError};
use nalgebra::Isometry3;

/// The lines of a program and its subprograms.
pub fn read(file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let kuka = &reading.setup.cell.kuka;
    let mut reader = KrlReader {
        reading,
        kuka,
        settings: settings(kuka),
        signals: SignalReader::new(&templates(kuka)),
        joint_speed: SPELLING.plain(&kuka.joint_speed),
        out: Vec::new(),
        at: None,
        m_s: None,
        deg_s: [None; 2],
        percent: None,
    };
    reader.module(file, true)?;
    Ok(reader.out)
}

/// What the controller keeps from line to line, over subprograms too.
struct KrlReader<'a> {
    reading: &'a ReadContext<'a>,
    kuka: &'a Kuka,
    settings: Vec<String>,
    signals: SignalReader<'a>,
    joint_speed: String,
    out: Vec<ReadLine>,
    at: Option<Isometry3<f64>>,
    m_s: Option<f64>,
    deg_s: [Option<f64>; 2],
    percent: Option<f64>,
}

/// Where in a module a line stands.
#[derive(Clone, Copy, PartialEq)]
enum ModuleSection {
    Before,
    Body,
    Ended,
}

impl KrlReader<'_> {
    /// One module; only the main one may call others.
    fn module(&mut self, file: &ProgramFile, is_main: bool) -> Result<(), ReadError> {
        self.data_list(file);
        let stem = file.name.strip_suffix(".src").unwrap_or(&file.name);
        let mut section = ModuleSection::Before;
        for (line, text) in non_blank_lines(&file.text) {
            let wrong = |fault: LineFault| fault.at(&file.name, line);
            let plain = SPELLING.plain(text);
            // Attributes are the controller's own: it counts changes in them.
            let idle = plain.is_empty() || (section == ModuleSection::Before && text.starts_with('&'));
            if idle {
                let comment = self.signals.read_comment(text);
                self.push(file, line, comment.unwrap_or_else(|| Statement::Comment(text.into())));
                continue;
            }
            section = match section {
                ModuleSection::Ended => return Err(wrong(LineFault::BehindEnd { end: "END".into() })),
                ModuleSection::Before => {
                    let names = [stem, self.kuka.name.as_str()];
                    let names = if is_main { &names[..] } else { &names[..1] };
                    let is_first = names.iter().any(|name| SPELLING.plain(&format!("DEF {name}( )")) == plain);
                    let first = || LineFault::expected([format!("DEF {stem}( )")], text);
                    if is_first { ModuleSection::Body } else { return Err(wrong(first())) }
                }
                ModuleSection::Body if plain == "END" => ModuleSection::Ended,
                ModuleSection::Body => {
                    self.body(file, (line, text), &plain, is_main)?;
                    ModuleSection::Body
                }
            };
        }
        let expected = "END".into();
        let is_whole = section == ModuleSection::Ended;
        if is_whole { Ok(()) } else { Err(ReadError::CutOff { file: file.name.clone(), expected }) }
    }

    fn push(&mut self, file: &ProgramFile, line: usize, what: Statement) {
        self.out.push(ReadLine { file: file.name.clone(), line, what });
    }

    /// Of the data list beside a module the declarations that say which outputs a name stands for. No other is used.
    fn data_list(&mut self, module: &ProgramFile) {
        let name = format!("{}.dat", module.name.strip_suffix(".src").unwrap_or(&module.name));
        let text = (self.reading.open)(&name).unwrap_or_default();
        let file = ProgramFile { name, text };
        for (line, text) in non_blank_lines(&file.text) {
            if SPELLING.plain(text).split(' ').any(|word| word == "SIGNAL") {
                let known = SPELLING.known(&self.kuka.data, text);
                self.push(&file, line, known.unwrap_or_else(|| Statement::Other(SPELLING.code(text).into())));
            }
        }
    }

    fn body(
        &mut self,
        file: &ProgramFile,
        (line, text): (usize, &str),
        plain: &str,
        is_main: bool,
    ) -> Result<(), ReadError> {
        let wrong = |fault: LineFault| fault.at(&file.name, line);
        let subprogram = SPELLING.plain(&format!("{}_", self.kuka.name));
        if let Some(number) = plain.strip_suffix("()").and_then(|n| n.strip_prefix(&subprogram)) {
            if !is_main {
                return Err(wrong(LineFault::NestedCall));
            }
            let name = format!("{}_{number}.src", self.kuka.name);
            return match (self.reading.open)(&name) {
                Some(text) => self.module(&ProgramFile { name, text }, false),
                None => Err(ReadError::Gone { file: file.name.clone(), line, called: name }),
            };
        }
        let what = match (plain.strip_prefix("LIN "), self.at) {
            (None, _) => self.line(text, plain).map_err(wrong)?,
            (Some(rest), Some(from)) => self.lin(&from, rest).map_err(wrong)?,
            (Some(_), None) => return Err(unknown_start(&self.out, &file.name, line)),
        };
        self.push(file, line, what);
        Ok(())
    }

    /// What a line that is no straight move does. A speed counts in the moves after it.
    fn line(&mut self, text: &str, plain: &str) -> Result<Statement, LineFault> {
        if let Some(rest) = plain.strip_prefix("PTP ") {
            return self.ptp(rest);
        }
        if let Some((name, value)) = plain.strip_prefix("$VEL.").and_then(|t| t.split_once('=')) {
            let above_zero = number(value).filter(|v| *v > 0.0);
            let value = above_zero.ok_or_else(|| LineFault::NotAboveZero { found: value.into() })?;
            match name {
                "CP" => self.m_s = Some(value),
                "ORI1" => self.deg_s[0] = Some(value),
                "ORI2" => self.deg_s[1] = Some(value),
                _ => return Err(LineFault::expected(["$VEL.CP", "$VEL.ORI1", "$VEL.ORI2"], text)),
            }
            return Ok(Statement::Other(plain.into()));
        }
        let known = SPELLING.known(&self.settings, text).or_else(|| self.signals.read(text));
        if let Some(known) = known {
            return Ok(known);
        }
        if let Some(percent) = matched_key(&self.joint_speed, "percent", plain) {
            let whole = number(percent).filter(|p| (1.0..=100.0).contains(p) && p.fract() == 0.0);
            self.percent = Some(whole.ok_or_else(|| LineFault::expected(["1 … 100"], percent))?);
            return Ok(Statement::Other(plain.into()));
        }
        SPELLING.altered(&self.settings, text).ok_or_else(|| {
            let k = self.kuka;
            let known = [&k.output_on, &k.output_off, &k.wait, &k.comment].map(String::as_str);
            LineFault::expected(["PTP", "LIN", "$VEL."].into_iter().chain(known).map(String::from), text)
        })
    }

    fn ptp(&mut self, rest: &str) -> Result<Statement, LineFault> {
        let percent =
            self.percent.ok_or_else(|| LineFault::Before { missing: self.kuka.joint_speed.clone().into() })?;
        let form = || LineFault::expected(["{A1 …,A6 …}", "{X …,C …}"], rest);
        let (target, blending) = target(rest).ok_or_else(form)?;
        let setup = self.reading.setup;
        let goal = if let Some(axes) = braced(AXES, target) {
            let joints_deg = joints(setup, &axes);
            self.at = setup.robot.as_ref().map(|r| r.forward(&joints_deg));
            Goal::Joints(joints_deg)
        } else {
            let at = pose(braced(FRAME, target).ok_or_else(form)?);
            self.at = Some(at);
            Goal::Flange(at)
        };
        let (timing, rest) = (MoveTiming::Percent(percent), blending.to_owned());
        Ok(Statement::Move(ReadMove { interpolation: Interpolation::Joint, goal, timing, rest }))
    }

    fn lin(&mut self, from: &Isometry3<f64>, text: &str) -> Result<Statement, LineFault> {
        let form = || LineFault::expected(["{X …,Y …,Z …,A …,B …,C …}"], text);
        let (target, blending) = target(text).ok_or_else(form)?;
        let to = pose(braced(FRAME, target).ok_or_else(form)?);
        let [Some(ori1), Some(ori2)] = self.deg_s else {
            return Err(LineFault::Before { missing: "$VEL.ORI1, $VEL.ORI2".into() });
        };
        let m_s = self.m_s.ok_or(LineFault::Before { missing: "$VEL.CP".into() })?;
        let speeds = Speeds { mm_s: 1000.0 * m_s, deg_s: ori1.min(ori2) };
        let seconds = Travel::between(from, &to).seconds(speeds);
        self.at = Some(to);
        let (goal, timing) = (Goal::Flange(to), MoveTiming::Seconds(seconds));
        Ok(Statement::Move(ReadMove { interpolation: Interpolation::Linear, goal, timing, rest: blending.into() }))
    }
}

/// The braces of a move, and how it goes over into the next.
fn target(text: &str) -> Option<(&str, &str)> {
    let (target, blending) = text.split_at(text.find('}')? + 1);
    Some((target, blending.trim()))
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
