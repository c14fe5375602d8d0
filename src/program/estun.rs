//! ESTUN: an `.erp` of instructions and an `.erd` of the points and speeds that they name.
//!
//! No arm and no controller of this make is known here: everything is from public files of others,
//! and unverified. The flange moves in the robot's base, tool and coordinate system null. As in KRL
//! a speed of the flange gives a move its time: `tcp` of way, `ori` where it turns on the spot.
//! One program however long: how one calls another is not known.

mod read;

use super::dialect::{Dialect, Program, ProgramFile, ReadError, ReadLine, Reading, WriteError};
use super::flange::{Speeds, Travel, as_read, flows_on, printed, printed_joints, stands_at};
use super::lines::{Line, Move};
use super::phrases::Phrases;
use super::steps::{Pace, Way};
use crate::cell::Setup;
use crate::cell::controllers::Estun;
use crate::cell::controllers::words::{self, fixed};
use nalgebra::Isometry3;
use std::collections::BTreeMap;

/// The dialect.
pub struct Erp;

/// What the head says of the text: nobody ran it.
const UNVERIFIED: [&str; 3] = [
    "UNVERIFIED: no controller of this make was at hand; every word is from public examples.",
    "Outputs, levels, frames and zones are templates of the cell file. Try it in the simulator.",
    "Flange poses in World with the null tool; speeds give each move its time at 100 per cent.",
];

impl Dialect for Erp {
    fn name(&self) -> &'static str {
        "estun"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        let estun = &program.setup.cell.estun;
        let mut writer = Writer { setup: program.setup, at: None, points: Vec::new(), speeds: BTreeMap::new() };
        let mut out = vec![estun.version.clone(), "Start:".into()];
        let head = UNVERIFIED.into_iter().map(String::from).chain(program.head.iter().cloned()).map(Line::Say);
        out.extend(head.flat_map(|line| phrases(estun).write(&line)));
        out.extend(estun.start.iter().cloned());
        for (index, line) in program.lines.iter().enumerate() {
            match line {
                Line::Move(m) => out.push(writer.go(m, flows_on(&program.lines, index))?),
                _ => out.extend(phrases(estun).write(line)),
            }
        }
        out.push("End;".into());
        let file = |ending, lines| ProgramFile {
            name: format!("{}.{ending}", estun.name),
            text: words::text(lines, estun.crlf),
        };
        Ok(vec![file("erp", &out), file("erd", &writer.data())])
    }

    fn claims(&self, text: &str) -> bool {
        let first = words::said_lines(text).map(|(_, l)| l).find(|l| !l.starts_with("//") && !l.starts_with("/*"));
        first == Some("Start:")
    }

    fn read(&self, file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
        read::read(file, reading)
    }
}

fn phrases(estun: &Estun) -> Phrases<'_> {
    Phrases {
        output_on: &estun.output_on,
        output_off: &estun.output_off,
        analogue: &estun.analogue,
        group: &estun.group,
        wait: &estun.wait,
        wait_per_s: 1000.0,
        wait_decimals: 0,
        comment: &estun.comment,
        forbidden: &['*'],
        width: 100,
    }
}

/// External axes 7 to 16, none of which is there.
fn no_axes() -> String {
    (7..=16).map(|i| format!(",a{i}=0.0000000")).collect()
}

/// Arm configuration left to the controller.
const CONFIGURATION: &str = "confdata={_type=\"POSCFG\",mode=0,cf1=0,cf2=0,cf3=0,cf4=0,cf5=0,cf6=0}";
/// What a speed says of external axes.
const NO_AXIS_SPEEDS: &str = "exj_l=360.000000,exj_r=180.000000";

struct Writer<'a> {
    setup: &'a Setup,
    at: Option<Isometry3<f64>>,
    points: Vec<String>,
    /// Numbers of speeds by their text: equal ones are one.
    speeds: BTreeMap<String, usize>,
}

impl Writer<'_> {
    fn go(&mut self, m: &Move, flows: bool) -> Result<String, WriteError> {
        let estun = &self.setup.cell.estun;
        let most = Speeds { mm_s: estun.max_mm_s, deg_s: estun.max_turn_deg_s };
        match (m.way, m.pace) {
            (Way::Joint, Pace::Percent(percent)) => {
                let point = match (&m.joints_deg, &m.base_from_flange) {
                    (Some(joints), _) => {
                        self.at = stands_at(self.setup, joints);
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
            (Way::Linear, Pace::Seconds(seconds)) => {
                let (Some(from), Some(to)) = (self.at, &m.base_from_flange) else {
                    return Err(rule("a straight move from home has a speed only with a robot; give --robot"));
                };
                let speeds = Travel::between(&from, &as_read(to)).speeds(seconds, most);
                let (point, speed) = (self.pose(to), self.speed(100.0, speeds));
                let zone = match flows {
                    true => format!("B=\"RELATIVE\",C=t_s.{}", estun.zone),
                    false => "B=\"FINE\"".into(),
                };
                Ok(format!("MovL{{P=t_l.{point},V=t_l.{speed},{zone}}}"))
            }
            (Way::Joint, Pace::Seconds(_)) => Err(rule("a MovJ has no duration; give its speed in per cent")),
            (Way::Linear, Pace::Percent(_)) => Err(rule("a MovL has no speed in per cent; give its duration")),
        }
    }

    fn pose(&mut self, base_from_flange: &Isometry3<f64>) -> String {
        self.at = Some(as_read(base_from_flange));
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

fn rule(what: &str) -> WriteError {
    WriteError::Rule(format!("estun: {what}"))
}
