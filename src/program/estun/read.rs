//! ESTUN programs as this program writes them, read back: the `.erd` first, then the `.erp`.

use super::{CONFIGURATION, NO_AXIS_SPEEDS, no_axes, phrases};
use crate::cell::Setup;
use crate::cell::controllers::words::{number, said_lines};
use crate::program::dialect::{Goal, ProgramFile, Read, ReadError, ReadLine, ReadMove, Reading};
use crate::program::flange::{Speeds, Travel, joints, pose};
use crate::program::reading::from_nowhere;
use crate::program::steps::{Pace, Way};
use nalgebra::Isometry3;
use std::collections::BTreeMap;

/// The lines of a program.
pub fn read(file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let estun = &reading.setup.cell.estun;
    let name = format!("{}.erd", file.name.strip_suffix(".erp").unwrap_or(&file.name));
    let Some(text) = (reading.open)(&name) else {
        return Err(ReadError::Gone { file: file.name.clone(), line: 1, called: name });
    };
    let data = Data::parse(reading.setup, &ProgramFile { name, text })?;
    let (mut out, mut at, mut begun, mut ended) = (Vec::new(), None, false, false);
    for (line, text) in said_lines(&file.text) {
        let wrong = |what: String| ReadError::Line { file: file.name.clone(), line, what };
        if ended {
            return Err(wrong("nothing may stand after End;".into()));
        }
        if !begun {
            begun = text == "Start:";
            if !begun {
                if text != estun.version {
                    return Err(wrong(format!("expected {:?} or Start:", estun.version)));
                }
                out.push(ReadLine { file: file.name.clone(), line, what: Read::Other(text.into()) });
            }
            continue;
        }
        if text == "End;" {
            ended = true;
            continue;
        }
        if text.starts_with("MovL{") && at.is_none() {
            return Err(from_nowhere(&out, &file.name, line));
        }
        let what = if text.starts_with("MovJ{") || text.starts_with("MovL{") {
            Read::Move(go(reading.setup, &data, &mut at, text).map_err(wrong)?)
        } else if estun.start.iter().any(|s| s == text) {
            Read::Other(text.into())
        } else {
            let read = phrases(estun).read(text);
            read.ok_or_else(|| wrong("expected MovJ, MovL, an output, a wait or a comment".into()))?
        };
        out.push(ReadLine { file: file.name.clone(), line, what });
    }
    if ended { Ok(out) } else { Err(ReadError::CutOff { file: file.name.clone(), expected: "End;" }) }
}

fn go(setup: &Setup, data: &Data, at: &mut Option<Isometry3<f64>>, text: &str) -> Result<ReadMove, String> {
    let way = if text.starts_with("MovJ{") { Way::Joint } else { Way::Linear };
    let inside = text.get(5..).and_then(|t| t.strip_suffix('}')).ok_or("expected } at its end")?;
    let (point, rest) =
        inside.strip_prefix("P=t_l.").and_then(|t| t.split_once(",V=t_l.")).ok_or("expected P and V")?;
    let (speed, rest) = rest.split_once(',').ok_or("expected B after V")?;
    let goal = *data.points.get(point).ok_or(format!("there is no point {point} in the .erd"))?;
    let (percent, speeds) = *data.speeds.get(speed).ok_or(format!("there is no speed {speed} in the .erd"))?;
    let flowing = format!("B=\"RELATIVE\",C=t_s.{}", setup.cell.estun.zone);
    if rest != "B=\"FINE\"" && rest != flowing {
        return Err(format!("expected B=\"FINE\" or {flowing}"));
    }
    let to = match goal {
        Goal::Joints(joints) => setup.robot.as_ref().map(|r| r.forward(&joints)),
        Goal::Flange(at) | Goal::Focus(at) => Some(at),
    };
    let pace = match (way, *at, to) {
        (Way::Joint, ..) => Pace::Percent(percent),
        (Way::Linear, Some(from), Some(to)) => Pace::Seconds(Travel::between(&from, &to).seconds(speeds)),
        _ => return Err("a straight move to joint angles, whose duration is known with a robot only".into()),
    };
    *at = to;
    Ok(ReadMove { way, goal, pace, rest: rest.into() })
}

/// The `.erd`.
struct Data {
    points: BTreeMap<String, Goal>,
    /// Per cent, and speeds of the flange.
    speeds: BTreeMap<String, (f64, Speeds)>,
}

impl Data {
    fn parse(setup: &Setup, file: &ProgramFile) -> Result<Data, ReadError> {
        let mut data = Data { points: BTreeMap::new(), speeds: BTreeMap::new() };
        for (line, text) in said_lines(&file.text) {
            let wrong = |what: &str| ReadError::Line { file: file.name.clone(), line, what: what.into() };
            let (name, value) = text.split_once("={_type=\"").ok_or_else(|| wrong("expected a point or a speed"))?;
            if data.points.contains_key(name) || data.speeds.contains_key(name) {
                return Err(wrong("the name is taken"));
            }
            if let Some(fields) = value.strip_prefix("SPEED\",") {
                let speed = speed(fields).ok_or_else(|| wrong("expected per, tcp, ori and the speeds of axes"))?;
                data.speeds.insert(name.into(), speed);
            } else {
                let goal = point(setup, value).ok_or_else(|| wrong("expected a CPOS or an APOS of this program"))?;
                data.points.insert(name.into(), goal);
            }
        }
        Ok(data)
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
