//! ESTUN programs as they are written here, read back: the `.erd` first, then the `.erp`.

use super::{CONFIGURATION, NO_AXIS_SPEEDS, SPELLING, no_axes, templates};
use crate::cell::Setup;
use crate::cell::controllers::Estun;
use crate::cell::controllers::templates::{non_blank_lines, number};
use crate::program::dialect::{Goal, ProgramFile, ReadContext, ReadLine, ReadMove, Statement};
use crate::program::dialects::flange::{Speeds, Travel, joints, pose};
use crate::program::dialects::reading::unknown_start;
use crate::program::dialects::signals::SignalReader;
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::read_error::{LineFault, ReadError};
use nalgebra::Isometry3;
use std::collections::BTreeMap;

/// The lines of a program.
pub fn read(file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let estun = &reading.setup.cell.estun;
    let name = format!("{}.erd", file.name.strip_suffix(".erp").unwrap_or(&file.name));
    let Some(text) = (reading.open)(&name) else {
        return Err(ReadError::Gone { file: file.name.clone(), line: 1, called: name });
    };
    let data = ErdData::parse(reading.setup, &ProgramFile { name, text })?;
    let mut reader = ErpReader { setup: reading.setup, signals: SignalReader::new(&templates(estun)), data, at: None };
    let (mut out, mut begun, mut ended) = (Vec::new(), false, false);
    for (line, text) in non_blank_lines(&file.text) {
        let wrong = |fault: LineFault| fault.at(&file.name, line);
        let plain = SPELLING.plain(text);
        let what = if begun && !ended && plain == "End;" {
            ended = true;
            continue;
        } else if begun && !ended {
            if plain.starts_with("MovL{") && reader.at.is_none() {
                return Err(unknown_start(&out, &file.name, line));
            }
            reader.statement(text, &plain).map_err(wrong)?
        } else if ended {
            reader.signals.read_comment(text).ok_or_else(|| wrong(LineFault::BehindEnd { end: "End;".into() }))?
        } else if plain == "Start:" {
            begun = true;
            continue;
        } else {
            before_start(estun, text).map_err(wrong)?
        };
        out.push(ReadLine { file: file.name.clone(), line, what });
    }
    if ended { Ok(out) } else { Err(ReadError::CutOff { file: file.name.clone(), expected: "End;".into() }) }
}

/// A line before `Start:`. The one that says how the program is to be read has to be as the cell file has it.
fn before_start(estun: &Estun, text: &str) -> Result<Statement, LineFault> {
    let known = std::slice::from_ref(&estun.version);
    let version = SPELLING.known(known, text).or_else(|| {
        let name = estun.version.split(':').next().filter(|n| text.starts_with(n));
        name.map(|_| Statement::Other(text.into()))
    });
    let comment = || SPELLING.is_comment(text).then(|| Statement::Comment(text.into()));
    version.or_else(comment).ok_or_else(|| LineFault::expected([estun.version.clone(), "Start:".into()], text))
}

/// What was read, and where the arm stands then.
struct ErpReader<'a> {
    setup: &'a Setup,
    signals: SignalReader<'a>,
    data: ErdData,
    at: Option<Isometry3<f64>>,
}

impl ErpReader<'_> {
    fn statement(&mut self, text: &str, plain: &str) -> Result<Statement, LineFault> {
        let estun = &self.setup.cell.estun;
        if plain.starts_with("MovJ{") || plain.starts_with("MovL{") {
            return read_move(self.setup, &self.data, &mut self.at, plain).map(Statement::Move);
        }
        let known = SPELLING.known(&estun.start, text).or_else(|| self.signals.read(text));
        known.or_else(|| SPELLING.altered(&estun.start, text)).ok_or_else(|| {
            let known = [&estun.output_on, &estun.output_off, &estun.wait, &estun.comment].map(String::as_str);
            LineFault::expected(["MovJ{", "MovL{"].into_iter().chain(known).map(String::from), text)
        })
    }
}

fn read_move(
    setup: &Setup,
    data: &ErdData,
    at: &mut Option<Isometry3<f64>>,
    text: &str,
) -> Result<ReadMove, LineFault> {
    let interpolation = if text.starts_with("MovJ{") { Interpolation::Joint } else { Interpolation::Linear };
    let form = || LineFault::expected(["{P=t_l.P0000,V=t_l.V0000,B=…}"], text);
    let inside = text.get(5..).and_then(|t| t.strip_suffix('}')).ok_or_else(form)?;
    let (point, rest) = inside.strip_prefix("P=t_l.").and_then(|t| t.split_once(",V=t_l.")).ok_or_else(form)?;
    let (speed, rest) = rest.split_once(',').ok_or_else(form)?;
    let undefined = |name: &str| LineFault::Undefined { name: name.into() };
    let goal = *data.points.get(point).ok_or_else(|| undefined(point))?;
    let (percent, speeds) = *data.speeds.get(speed).ok_or_else(|| undefined(speed))?;
    let form = || LineFault::expected(["B=\"FINE\"", "B=\"RELATIVE\",C=t_s.…"], rest);
    rest.strip_prefix("B=").ok_or_else(form)?;
    let to = match goal {
        Goal::Joints(joints) => setup.robot.as_ref().map(|r| r.forward(&joints)),
        Goal::Flange(at) | Goal::Focus(at) => Some(at),
    };
    let timing = match (interpolation, *at, to) {
        (Interpolation::Joint, ..) => MoveTiming::Percent(percent),
        (Interpolation::Linear, Some(from), Some(to)) => {
            MoveTiming::Seconds(Travel::between(&from, &to).seconds(speeds))
        }
        _ => return Err(LineFault::NoDuration),
    };
    *at = to;
    // Of the speeds one counts for a move's time; the others have to be as they were written all the same.
    let Speeds { mm_s, deg_s } = speeds;
    Ok(ReadMove { interpolation, goal, timing, rest: format!("{rest},per={percent},tcp={mm_s},ori={deg_s}") })
}

/// The `.erd`.
struct ErdData {
    points: BTreeMap<String, Goal>,
    /// Per cent, and speeds of the flange.
    speeds: BTreeMap<String, (f64, Speeds)>,
}

impl ErdData {
    fn parse(setup: &Setup, file: &ProgramFile) -> Result<ErdData, ReadError> {
        let mut data = ErdData { points: BTreeMap::new(), speeds: BTreeMap::new() };
        for (line, text) in non_blank_lines(&file.text).filter(|(_, l)| !SPELLING.is_comment(l)) {
            data.line(setup, &SPELLING.plain(text)).map_err(|fault| fault.at(&file.name, line))?;
        }
        Ok(data)
    }

    fn line(&mut self, setup: &Setup, text: &str) -> Result<(), LineFault> {
        let form = |one_of: &[&'static str]| LineFault::expected(one_of.iter().copied(), text);
        let (name, value) = text.split_once("={_type=\"").ok_or_else(|| form(&["P0000={_type=", "V0000={_type="]))?;
        if self.points.contains_key(name) || self.speeds.contains_key(name) {
            return Err(LineFault::Twice { name: name.into() });
        }
        if let Some(fields) = value.strip_prefix("SPEED\",") {
            let speed = speed(fields).ok_or_else(|| form(&["per=,tcp=,ori=,exj_l=,exj_r="]))?;
            self.speeds.insert(name.into(), speed);
        } else {
            let goal = point(setup, value).ok_or_else(|| form(&["CPOS", "APOS"]))?;
            self.points.insert(name.into(), goal);
        }
        Ok(())
    }
}

fn point(setup: &Setup, text: &str) -> Option<Goal> {
    let fields = text.strip_suffix(&format!("{}}}", no_axes()))?;
    if let Some(fields) = fields.strip_prefix("APOS\",") {
        let angles = named(["a1", "a2", "a3", "a4", "a5", "a6"], fields)?;
        return Some(Goal::Joints(joints(setup, &angles)));
    }
    let fields = fields.strip_prefix("CPOS\",")?.strip_prefix(CONFIGURATION)?.strip_prefix(',')?;
    Some(Goal::Flange(pose(named(["x", "y", "z", "a", "b", "c"], fields)?)))
}

fn speed(text: &str) -> Option<(f64, Speeds)> {
    let fields = text.strip_suffix(&format!(",{NO_AXIS_SPEEDS}}}"))?;
    let [percent, mm_s, deg_s] = named(["per", "tcp", "ori"], fields)?;
    (percent > 0.0 && mm_s > 0.0 && deg_s > 0.0).then_some((percent, Speeds { mm_s, deg_s }))
}

/// The numbers of `x=1.000,y=2.000`, all of them, named in order.
fn named<const N: usize>(names: [&str; N], text: &str) -> Option<[f64; N]> {
    let fields: Vec<&str> = text.split(',').collect();
    if fields.len() != N {
        return None;
    }
    let mut out = [0.0; N];
    for ((slot, name), field) in out.iter_mut().zip(names).zip(fields) {
        let (said, value) = field.split_once('=')?;
        *slot = number(value).filter(|_| said == name)?;
    }
    Some(out)
}
