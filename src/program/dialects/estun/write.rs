//! ESTUN programs as they are written.

use super::{CONFIGURATION, NO_AXIS_SPEEDS, no_axes, templates, words};
use crate::cell::Setup;
use crate::cell::controllers::templates::{fixed, text};
use crate::program::dialect::{Program, ProgramFile};
use crate::program::dialects::flange::{Speeds, Travel, flows_on, printed, printed_joints};
use crate::program::dialects::pace::read_at;
use crate::program::neutral::comment::{Caveat, Comment};
use crate::program::neutral::lines::{Move, ProgramLine};
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::write_error::WriteError;
use nalgebra::Isometry3;
use std::collections::BTreeMap;

/// Both files of the program.
pub fn write(program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
    let estun = &program.setup.cell.estun;
    templates(estun).check()?;
    let mut writer = ErpWriter { setup: program.setup, at: None, points: Vec::new(), speeds: BTreeMap::new() };
    let mut out = vec![estun.version.clone(), "Start:".into()];
    out.extend(templates(estun).head(&[Comment::Caveat(Caveat::Erp)], program.wording));
    out.extend(templates(estun).head(&program.head, program.wording));
    out.extend(estun.start.iter().cloned());
    for (index, line) in program.lines.iter().enumerate() {
        match line {
            ProgramLine::Move(m) => out.push(writer.write_move(m, flows_on(&program.lines, index))?),
            _ => out.extend(templates(estun).write(line, program.wording)?),
        }
    }
    out.push("End;".into());
    let file = |ending, lines| ProgramFile { name: format!("{}.{ending}", estun.name), text: text(lines, estun.crlf) };
    Ok(vec![file("erp", &out), file("erd", &writer.data())])
}

/// The program as it is written on.
struct ErpWriter<'a> {
    setup: &'a Setup,
    at: Option<Isometry3<f64>>,
    points: Vec<String>,
    /// Numbers of speeds by their text: equal ones are one.
    speeds: BTreeMap<String, usize>,
}

impl ErpWriter<'_> {
    fn write_move(&mut self, m: &Move, flows: bool) -> Result<String, WriteError> {
        let estun = &self.setup.cell.estun;
        let most = words(estun).most;
        let from = std::mem::replace(&mut self.at, read_at(self.setup, m));
        match (m.interpolation, m.timing) {
            (Interpolation::Joint, MoveTiming::Percent(percent)) => {
                let point = match (&m.joints_deg, &m.base_from_flange) {
                    (Some(joints), _) => {
                        let numbers = printed_joints(self.setup, joints);
                        let axes: Vec<String> = (1..).zip(&numbers).map(|(i, n)| format!("a{i}={n}")).collect();
                        self.point(format!("_type=\"APOS\",{}{}", axes.join(","), no_axes()))
                    }
                    (None, Some(flange)) => self.pose(flange),
                    (None, None) => return Err(WriteError::NoRobot("estun")),
                };
                let speed = self.speed(percent.clamp(0.1, 100.0), most);
                Ok(format!("MovJ{{P=t_l.{point},V=t_l.{speed},B=\"FINE\"}}"))
            }
            (Interpolation::Linear, MoveTiming::Seconds(seconds)) => {
                let (Some(from), Some(at), Some(to)) = (from, self.at, &m.base_from_flange) else {
                    return Err(WriteError::FromUnknownPose("estun"));
                };
                let speeds = Travel::between(&from, &at).speeds(seconds, most);
                let (point, speed) = (self.pose(to), self.speed(100.0, speeds));
                let zone = match flows {
                    true => format!("B=\"RELATIVE\",C=t_s.{}", estun.zone),
                    false => "B=\"FINE\"".into(),
                };
                Ok(format!("MovL{{P=t_l.{point},V=t_l.{speed},{zone}}}"))
            }
            (Interpolation::Joint, MoveTiming::Seconds(_)) => Err(WriteError::TimedJointMove("estun")),
            (Interpolation::Linear, MoveTiming::Percent(_)) => Err(WriteError::StraightInPercent("estun")),
        }
    }

    fn pose(&mut self, base_from_flange: &Isometry3<f64>) -> String {
        let [x, y, z, a, b, c] = printed(base_from_flange);
        self.point(format!("_type=\"CPOS\",{CONFIGURATION},x={x},y={y},z={z},a={a},b={b},c={c}{}", no_axes()))
    }

    fn point(&mut self, fields: String) -> String {
        let name = format!("P{:04}", self.points.len());
        self.points.push(format!("{name}={{{fields}}}"));
        name
    }

    fn speed(&mut self, percent: f64, speeds: Speeds) -> String {
        let fields = format!("per={},tcp={},ori={}", fixed(percent, 6), fixed(speeds.mm_s, 6), fixed(speeds.deg_s, 6));
        let next = self.speeds.len();
        format!("V{:04}", self.speeds.entry(fields).or_insert(next))
    }

    /// The `.erd`: points, then speeds by their numbers.
    fn data(&self) -> Vec<String> {
        let mut speeds: Vec<(usize, &str)> = self.speeds.iter().map(|(text, n)| (*n, text.as_str())).collect();
        speeds.sort_unstable();
        let speed = |(n, text): (usize, &str)| format!("V{n:04}={{_type=\"SPEED\",{text},{NO_AXIS_SPEEDS}}}");
        self.points.iter().cloned().chain(speeds.into_iter().map(speed)).collect()
    }
}
