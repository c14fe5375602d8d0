//! KUKA KRL: `.src` with its `.dat`. The flange moves in the robot's base, both frames null; joint
//! moves are `PTP` with axis values, straight ones `LIN`.
//!
//! KRL knows no duration of a move. The speed before a `LIN` gives it: `$VEL.CP` is the flange's
//! way over the time, and where the flange turns on the spot `$VEL.ORI1` and `$VEL.ORI2` are its
//! angle over the time. Without a position before it a straight move has neither, and is refused.
//! Long programs call sub-programs with files of their own; the split is where the laser is off.

mod read;

use super::dialect::{Dialect, Program, ProgramFile, ReadError, ReadLine, Reading, WriteError};
use super::flange::{Speeds, Travel, as_read, flows_on, printed, printed_joints, stands_at};
use super::lines::{Line, Move};
use super::pages::pages;
use super::phrases::Phrases;
use super::steps::{Pace, Way};
use crate::cell::Setup;
use crate::cell::controllers::Kuka;
use crate::cell::controllers::words::{self, filled, fixed};
use nalgebra::Isometry3;

/// The dialect.
pub struct Krl;

/// What the head says of the text: nobody ran it.
const UNVERIFIED: [&str; 4] = [
    "Not verified on a controller: BAS and INTERRUPT of the head, rounding by C_DIS,",
    "$VEL.ORI1 and $VEL.ORI2 of moves that turn on the spot, status and turn of PTP",
    "to poses. Flange poses in the robot's base, tool and base null: the speeds give",
    "each move its time at 100 per cent override.",
];

impl Dialect for Krl {
    fn name(&self) -> &'static str {
        "kuka"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        let kuka = &program.setup.cell.kuka;
        let mut writer =
            Writer { kuka, setup: program.setup, at: None, cp: String::new(), ori: String::new(), percent: None };
        let laser = program.setup.cell.outputs.laser.number;
        let pages = pages(&program.lines, laser, kuka.max_lines, text_lines);
        let head = UNVERIFIED.into_iter().map(String::from).chain(program.head.iter().cloned()).map(Line::Say);
        let mut main: Vec<String> = head.flat_map(|line| phrases(kuka).write(&line)).collect();
        main.extend(settings(kuka));
        let mut files = Vec::new();
        let mut index = 0;
        for (number, page) in pages.iter().enumerate() {
            let mut body = Vec::new();
            for line in *page {
                writer.line(&mut body, &program.lines, index, line)?;
                index += 1;
            }
            if pages.len() == 1 {
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

    fn claims(&self, text: &str) -> bool {
        let first = words::said_lines(text).map(|(_, l)| l).find(|l| !l.starts_with('&') && !l.starts_with(';'));
        first.is_some_and(|l| l.starts_with("DEF ") && l.ends_with(')'))
    }

    fn read(&self, file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
        read::read(file, reading)
    }
}

/// Lines of text of a line of the program, about.
fn text_lines(line: &Line) -> usize {
    match line {
        // The speed and the move.
        Line::Move(_) => 2,
        _ => 1,
    }
}

fn phrases(kuka: &Kuka) -> Phrases<'_> {
    Phrases {
        output_on: &kuka.output_on,
        output_off: &kuka.output_off,
        analogue: &kuka.analogue,
        group: &kuka.group,
        wait: &kuka.wait,
        wait_per_s: 1.0,
        wait_decimals: 3,
        comment: &kuka.comment,
        forbidden: &[],
        width: 100,
    }
}

/// The settings before the first move.
fn settings(kuka: &Kuka) -> Vec<String> {
    let mut out = kuka.start.clone();
    out.extend(["$BASE=$NULLFRAME", "$TOOL=$NULLFRAME", "$IPO_MODE=#BASE"].map(String::from));
    out.push(format!("$APO.CDIS={}", fixed(kuka.blend_mm, 3)));
    out
}

/// Both files of a module.
fn module(kuka: &Kuka, name: &str, body: &[String]) -> [ProgramFile; 2] {
    let file = |ending: &str, first: String, body: &[String], last: &str| {
        let lines = [&kuka.attributes[..], &[first], body, &[last.into()]].concat();
        ProgramFile { name: format!("{name}.{ending}"), text: words::text(&lines, kuka.crlf) }
    };
    [file("src", format!("DEF {name}( )"), body, "END"), file("dat", format!("DEFDAT {name}"), &kuka.data, "ENDDAT")]
}

/// What the controller keeps from line to line.
struct Writer<'a> {
    kuka: &'a Kuka,
    setup: &'a Setup,
    at: Option<Isometry3<f64>>,
    cp: String,
    ori: String,
    percent: Option<String>,
}

impl Writer<'_> {
    fn line(&mut self, out: &mut Vec<String>, all: &[Line], index: usize, line: &Line) -> Result<(), WriteError> {
        match line {
            Line::Move(m) => self.go(out, m, flows_on(all, index)),
            _ => {
                out.extend(phrases(self.kuka).write(line));
                Ok(())
            }
        }
    }

    fn go(&mut self, out: &mut Vec<String>, m: &Move, flows: bool) -> Result<(), WriteError> {
        match (m.way, m.pace) {
            (Way::Joint, Pace::Percent(percent)) => {
                // $VEL_AXIS is a whole number.
                let percent = fixed(percent.clamp(1.0, 100.0), 0);
                if self.percent.as_ref() != Some(&percent) {
                    out.push(filled(&self.kuka.joint_speed, &[("percent", &percent)]));
                    self.percent = Some(percent);
                }
                self.joint(out, m)
            }
            (Way::Linear, Pace::Seconds(seconds)) => {
                let (Some(from), Some(to)) = (self.at, &m.base_from_flange) else {
                    return Err(WriteError::Rule(
                        "kuka: a straight move from home has a speed only with a robot; give --robot".into(),
                    ));
                };
                let to_read = as_read(to);
                self.speed(out, Travel::between(&from, &to_read), seconds);
                out.push(format!("LIN {}{}", frame(to), if flows { " C_DIS" } else { "" }));
                self.at = Some(to_read);
                Ok(())
            }
            (Way::Joint, Pace::Seconds(_)) => {
                Err(WriteError::Rule("kuka: a PTP has no duration; give its speed in per cent".into()))
            }
            (Way::Linear, Pace::Percent(_)) => {
                Err(WriteError::Rule("kuka: a LIN has no speed in per cent; give its duration".into()))
            }
        }
    }

    fn joint(&mut self, out: &mut Vec<String>, m: &Move) -> Result<(), WriteError> {
        match (&m.joints_deg, &m.base_from_flange) {
            (Some(joints), _) => {
                out.push(format!("PTP {}", braced(AXES, &printed_joints(self.setup, joints))));
                self.at = stands_at(self.setup, joints);
                Ok(())
            }
            (None, Some(flange)) => {
                out.push(format!("PTP {}", frame(flange)));
                self.at = Some(as_read(flange));
                Ok(())
            }
            (None, None) => Err(WriteError::NoRobot("kuka")),
        }
    }

    fn speed(&mut self, out: &mut Vec<String>, travel: Travel, seconds: f64) {
        let most = Speeds { mm_s: 1000.0 * self.kuka.max_m_s, deg_s: self.kuka.max_turn_deg_s };
        let Speeds { mm_s, deg_s } = travel.speeds(seconds, most);
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

const AXES: [&str; 6] = ["A1", "A2", "A3", "A4", "A5", "A6"];
const FRAME: [&str; 6] = ["X", "Y", "Z", "A", "B", "C"];

fn frame(base_from_flange: &Isometry3<f64>) -> String {
    braced(FRAME, &printed(base_from_flange))
}

/// `{X 1.000,Y 2.000,...}`.
fn braced(names: [&str; 6], numbers: &[String; 6]) -> String {
    let fields: Vec<String> = names.iter().zip(numbers).map(|(name, n)| format!("{name} {n}")).collect();
    format!("{{{}}}", fields.join(","))
}
