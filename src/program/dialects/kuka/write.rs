//! KRL programs as they are written.

use super::{AXES, FRAME, settings, templates, words};
use crate::cell::Setup;
use crate::cell::controllers::Kuka;
use crate::cell::controllers::templates::{filled, fixed, text};
use crate::program::dialect::{Program, ProgramFile};
use crate::program::dialects::flange::{Speeds, Travel, flows_on, printed, printed_joints};
use crate::program::dialects::pace::read_at;
use crate::program::dialects::subprograms::subprograms;
use crate::program::neutral::comment::{Caveat, Comment};
use crate::program::neutral::lines::{Move, ProgramLine};
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::write_error::WriteError;
use nalgebra::Isometry3;

/// Both files of the program, and of each subprogram of a long one.
pub fn write(program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
    let kuka = &program.setup.cell.kuka;
    templates(kuka).check()?;
    let mut writer =
        KrlWriter { kuka, setup: program.setup, at: None, cp: String::new(), ori: String::new(), percent: None };
    let laser = program.setup.cell.outputs.laser.number;
    let subprograms = subprograms(&program.lines, laser, kuka.max_lines, text_line_count);
    let mut main = templates(kuka).head(&[Comment::Caveat(Caveat::Krl)], program.wording);
    main.extend(templates(kuka).head(&program.head, program.wording));
    main.extend(settings(kuka));
    let mut files = Vec::new();
    let mut index = 0;
    for (number, subprogram) in subprograms.iter().enumerate() {
        let mut body = Vec::new();
        for line in *subprogram {
            match line {
                ProgramLine::Move(m) => writer.write_move(&mut body, m, flows_on(&program.lines, index))?,
                _ => body.extend(templates(kuka).write(line, program.wording)?),
            }
            index += 1;
        }
        if subprograms.len() == 1 {
            main.append(&mut body);
        } else {
            let name = format!("{}_{}", kuka.name, number + 1);
            main.push(format!("{name}( )"));
            files.extend(module(kuka, &name, &body));
        }
    }
    let mut all = module(kuka, &kuka.name, &main).to_vec();
    all.append(&mut files);
    Ok(all)
}

/// About how many lines of text a line of the program takes.
fn text_line_count(line: &ProgramLine) -> usize {
    match line {
        // The speed and the move.
        ProgramLine::Move(_) => 2,
        _ => 1,
    }
}

/// Both files of a module.
fn module(kuka: &Kuka, name: &str, body: &[String]) -> [ProgramFile; 2] {
    let file = |ending: &str, first: String, body: &[String], last: &str| {
        let lines = [&kuka.attributes[..], &[first], body, &[last.into()]].concat();
        ProgramFile { name: format!("{name}.{ending}"), text: text(&lines, kuka.crlf) }
    };
    [file("src", format!("DEF {name}( )"), body, "END"), file("dat", format!("DEFDAT {name}"), &kuka.data, "ENDDAT")]
}

/// What the controller keeps from line to line.
struct KrlWriter<'a> {
    kuka: &'a Kuka,
    setup: &'a Setup,
    at: Option<Isometry3<f64>>,
    cp: String,
    ori: String,
    percent: Option<String>,
}

impl KrlWriter<'_> {
    fn write_move(&mut self, out: &mut Vec<String>, m: &Move, flows: bool) -> Result<(), WriteError> {
        match (m.interpolation, m.timing) {
            (Interpolation::Joint, MoveTiming::Percent(percent)) => {
                // $VEL_AXIS is a whole number.
                let percent = fixed(percent.clamp(1.0, 100.0), 0);
                if self.percent.as_ref() != Some(&percent) {
                    out.push(filled(&self.kuka.joint_speed, &[("percent", &percent)]));
                    self.percent = Some(percent);
                }
                self.joint(out, m)
            }
            (Interpolation::Linear, MoveTiming::Seconds(seconds)) => {
                let (Some(from), Some(to)) = (self.at, &m.base_from_flange) else {
                    return Err(WriteError::FromUnknownPose("kuka"));
                };
                let to_read = read_at(self.setup, m);
                self.speed(out, Travel::between(&from, &to_read.unwrap_or(from)), seconds);
                out.push(format!("LIN {}{}", frame(to), if flows { " C_DIS" } else { "" }));
                self.at = to_read;
                Ok(())
            }
            (Interpolation::Joint, MoveTiming::Seconds(_)) => Err(WriteError::TimedJointMove("kuka")),
            (Interpolation::Linear, MoveTiming::Percent(_)) => Err(WriteError::StraightInPercent("kuka")),
        }
    }

    fn joint(&mut self, out: &mut Vec<String>, m: &Move) -> Result<(), WriteError> {
        out.push(match (&m.joints_deg, &m.base_from_flange) {
            (Some(joints), _) => format!("PTP {}", braced(AXES, &printed_joints(self.setup, joints))),
            (None, Some(flange)) => format!("PTP {}", frame(flange)),
            (None, None) => return Err(WriteError::NoRobot("kuka")),
        });
        self.at = read_at(self.setup, m);
        Ok(())
    }

    fn speed(&mut self, out: &mut Vec<String>, travel: Travel, seconds: f64) {
        let Speeds { mm_s, deg_s } = travel.speeds(seconds, words(self.kuka).most);
        let (cp, ori) = (fixed(mm_s / 1000.0, 8), fixed(deg_s, 5));
        if cp != self.cp {
            out.push(format!("$VEL.CP={cp}"));
            self.cp = cp;
        }
        if ori != self.ori {
            out.push(format!("$VEL.ORI1={ori}"));
            out.push(format!("$VEL.ORI2={ori}"));
            self.ori = ori;
        }
    }
}

fn frame(base_from_flange: &Isometry3<f64>) -> String {
    braced(FRAME, &printed(base_from_flange))
}

/// `{X 1.000,Y 2.000,...}`.
fn braced(names: [&str; 6], numbers: &[String; 6]) -> String {
    let fields: Vec<String> = names.iter().zip(numbers).map(|(name, n)| format!("{name} {n}")).collect();
    format!("{{{}}}", fields.join(","))
}
