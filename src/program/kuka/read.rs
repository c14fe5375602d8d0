//! KRL as this program writes it, read back: poses, and durations from the speeds before them.

use super::{AXES, FRAME, phrases, settings};
use crate::cell::Setup;
use crate::cell::controllers::Kuka;
use crate::cell::controllers::words::{matched_key, number, said_lines};
use crate::program::dialect::{Goal, ProgramFile, Read, ReadError, ReadLine, ReadMove, Reading};
use crate::program::flange::{Speeds, Travel, joints, pose};
use crate::program::reading::from_nowhere;
use crate::program::steps::{Pace, Way};
use nalgebra::Isometry3;

/// The lines of a program and its sub-programs.
pub fn read(file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let kuka = &reading.setup.cell.kuka;
    let mut reader = Reader {
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

/// What the controller keeps from line to line, over sub-programs too.
struct Reader<'a> {
    setup: &'a Setup,
    kuka: &'a Kuka,
    settings: Vec<String>,
    out: Vec<ReadLine>,
    at: Option<Isometry3<f64>>,
    m_s: Option<f64>,
    deg_s: [Option<f64>; 2],
    percent: Option<f64>,
}

impl Reader<'_> {
    /// One file; only the main one may call others.
    fn module(&mut self, file: &ProgramFile, calls: Option<&Reading<'_>>) -> Result<(), ReadError> {
        let first = format!("DEF {}( )", file.name.strip_suffix(".src").unwrap_or(&file.name));
        let (mut begun, mut ended) = (false, false);
        for (line, text) in said_lines(&file.text) {
            let wrong = |what: String| ReadError::Line { file: file.name.clone(), line, what };
            if ended {
                return Err(wrong("nothing may stand after END".into()));
            }
            if !begun {
                begun = text == first;
                if !begun {
                    if !self.kuka.attributes.iter().any(|a| a == text) {
                        return Err(wrong(format!("expected {first:?}, the file's own name")));
                    }
                    self.out.push(ReadLine { file: file.name.clone(), line, what: Read::Other(text.into()) });
                }
                continue;
            }
            if text == "END" {
                ended = true;
                continue;
            }
            let called = text.strip_suffix("( )").filter(|n| n.starts_with(&format!("{}_", self.kuka.name)));
            if let Some(name) = called {
                let name = format!("{name}.src");
                let Some(reading) = calls else {
                    return Err(wrong("a sub-program calls none itself".into()));
                };
                let Some(text) = (reading.open)(&name) else {
                    return Err(ReadError::Gone { file: file.name.clone(), line, called: name });
                };
                self.module(&ProgramFile { name, text }, None)?;
                continue;
            }
            let what = match (text.strip_prefix("LIN "), self.at) {
                (None, _) => self.line(text).map_err(wrong)?,
                (Some(rest), Some(from)) => Some(self.lin(&from, rest).map_err(wrong)?),
                (Some(_), None) => return Err(from_nowhere(&self.out, &file.name, line)),
            };
            if let Some(what) = what {
                self.out.push(ReadLine { file: file.name.clone(), line, what });
            }
        }
        if ended { Ok(()) } else { Err(ReadError::CutOff { file: file.name.clone(), expected: "END" }) }
    }

    /// What a line that is no straight move does; `None` for a speed, which counts in the moves after it.
    fn line(&mut self, text: &str) -> Result<Option<Read>, String> {
        if let Some(rest) = text.strip_prefix("PTP ") {
            return self.ptp(rest).map(Some);
        }
        if let Some((name, value)) = text.strip_prefix("$VEL.").and_then(|t| t.split_once('=')) {
            let value = number(value).filter(|v| *v > 0.0).ok_or("expected a speed above 0")?;
            match name {
                "CP" => self.m_s = Some(value),
                "ORI1" => self.deg_s[0] = Some(value),
                "ORI2" => self.deg_s[1] = Some(value),
                _ => return Err("expected $VEL.CP, $VEL.ORI1 or $VEL.ORI2".into()),
            }
            return Ok(None);
        }
        if let Some(percent) = matched_key(&self.kuka.joint_speed, "percent", text) {
            let percent = number(percent).filter(|p| (1.0..=100.0).contains(p) && p.fract() == 0.0);
            self.percent = Some(percent.ok_or("expected whole per cent, 1 to 100")?);
            return Ok(None);
        }
        if self.settings.iter().any(|s| s == text) {
            return Ok(Some(Read::Other(text.into())));
        }
        match phrases(self.kuka).read(text) {
            Some(read) => Ok(Some(read)),
            None => Err("no line of this program; expected PTP, LIN, $VEL, an output, a wait or a comment".into()),
        }
    }

    fn ptp(&mut self, rest: &str) -> Result<Read, String> {
        let percent = self.percent.ok_or("a PTP before its speed in per cent")?;
        let goal = if let Some(axes) = braced(AXES, rest) {
            let joints_deg = joints(self.setup, &axes);
            self.at = self.setup.robot.as_ref().map(|r| r.forward(&joints_deg));
            Goal::Joints(joints_deg)
        } else {
            let at = pose(braced(FRAME, rest).ok_or("expected {A1 ..,A6 ..} or {X ..,C ..}")?);
            self.at = Some(at);
            Goal::Flange(at)
        };
        Ok(Read::Move(ReadMove { way: Way::Joint, goal, pace: Pace::Percent(percent), rest: String::new() }))
    }

    fn lin(&mut self, from: &Isometry3<f64>, rest: &str) -> Result<Read, String> {
        let (numbers, rest) = rest.split_once('}').ok_or("expected {X ..,C ..}")?;
        let rest = rest.trim();
        if !matches!(rest, "" | "C_DIS") {
            return Err("expected C_DIS or nothing after the pose".into());
        }
        let to = pose(braced(FRAME, &format!("{numbers}}}")).ok_or("expected {X ..,Y ..,Z ..,A ..,B ..,C ..}")?);
        let [Some(ori1), Some(ori2)] = self.deg_s else {
            return Err("a LIN before $VEL.ORI1 and $VEL.ORI2".into());
        };
        let m_s = self.m_s.ok_or("a LIN before $VEL.CP")?;
        let speeds = Speeds { mm_s: 1000.0 * m_s, deg_s: ori1.min(ori2) };
        let seconds = Travel::between(from, &to).seconds(speeds);
        self.at = Some(to);
        let (goal, pace) = (Goal::Flange(to), Pace::Seconds(seconds));
        Ok(Read::Move(ReadMove { way: Way::Linear, goal, pace, rest: rest.into() }))
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
