//! Yaskawa INFORM: a `.JBI` job of positions and instructions. Straight moves are `MOVL` to flange
//! poses in the base frame (`RECTAN`), joint moves `MOVJ`: to `PULSE` positions where the cell file
//! says how many pulses make a degree, else to poses.
//!
//! INFORM knows no duration of a move. `V=` (mm/s) or, where the flange mostly turns, `VR=` (degrees
//! per second) is its way or angle over the time. Both have one decimal, and of the two the one
//! that keeps more digits is taken; without a position before it a move has neither, and is refused.
//!
//! `RCONF` says the arm's shape, all 0 without a robot: R-axis beyond ±90°, elbow down, wrist behind
//! axis 1, then R, T and S beyond ±180°. That rule is not verified. Long jobs `CALL` numbered ones;
//! the split is where the laser is off.

mod read;

use super::arm::Shape;
use super::dialect::{Dialect, Program, ProgramFile, ReadError, ReadLine, Reading, WriteError};
use super::flange::{SHORTEST_S, Travel, as_read, coupled, flows_on, joints, printed};
use super::lines::{Line, Move};
use super::pages::pages;
use super::phrases::Phrases;
use super::steps::{Pace, Way};
use crate::cell::controllers::Yaskawa;
use crate::cell::controllers::words::{self, fixed};
use crate::cell::{Joints, Setup};
use nalgebra::{Isometry3, Translation3};

/// The dialect.
pub struct Jbi;

/// What the head says of the job: nobody ran it. Comments hold 28 characters.
const UNVERIFIED: [&str; 8] = [
    "Not verified on a controller",
    "RCONF, VR, PL, relative job,",
    "and where the base frame has",
    "its origin: base_height_mm.",
    "Poses of the flange in BASE,",
    "so the tool has to be null.",
    "Speeds give each move its",
    "time at 100 per cent.",
];

impl Dialect for Jbi {
    fn name(&self) -> &'static str {
        "yaskawa"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        let yaskawa = &program.setup.cell.yaskawa;
        let laser = program.setup.cell.outputs.laser.number;
        let pages = pages(&program.lines, laser, yaskawa.max_lines, |_| 1);
        let mut main = Job { setup: program.setup, positions: Vec::new(), instructions: Vec::new() };
        for text in UNVERIFIED.into_iter().map(String::from).chain(program.head.iter().cloned()) {
            main.instructions.extend(phrases(yaskawa).write(&Line::Say(text)));
        }
        let mut files = Vec::new();
        let (mut at, mut index) = (None, 0);
        for (number, page) in pages.iter().enumerate() {
            let mut part = Job { setup: program.setup, positions: Vec::new(), instructions: Vec::new() };
            let job = if pages.len() == 1 { &mut main } else { &mut part };
            for line in *page {
                match line {
                    Line::Move(m) => at = job.go(at, m, flows_on(&program.lines, index))?,
                    _ => job.instructions.extend(phrases(yaskawa).write(line)),
                }
                index += 1;
            }
            if pages.len() > 1 {
                let name = format!("{}{}", yaskawa.name, number + 1);
                main.instructions.push(format!("CALL JOB:{name}"));
                files.push(part.file(&name));
            }
        }
        files.insert(0, main.file(&yaskawa.name));
        Ok(files)
    }

    fn claims(&self, text: &str) -> bool {
        words::said_lines(text).next().is_some_and(|(_, l)| l == "/JOB")
    }

    fn read(&self, file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
        read::read(file, reading)
    }
}

fn phrases(yaskawa: &Yaskawa) -> Phrases<'_> {
    Phrases {
        output_on: &yaskawa.output_on,
        output_off: &yaskawa.output_off,
        analogue: &yaskawa.analogue,
        group: &yaskawa.group,
        wait: &yaskawa.wait,
        wait_per_s: 1.0,
        wait_decimals: 2,
        comment: &yaskawa.comment,
        forbidden: &[],
        width: 28,
    }
}

/// A position of a job.
enum Position {
    /// Its `RCONF`, and X, Y, Z, Rx, Ry, Rz.
    Pose(String, [String; 6]),
    /// Pulses of the six axes.
    Pulses([String; 6]),
}

/// A job on the way.
struct Job<'a> {
    setup: &'a Setup,
    positions: Vec<Position>,
    instructions: Vec<String>,
}

impl Job<'_> {
    /// Writes a move from `at`; where it leads, as a reader will know it.
    fn go(&mut self, at: Option<Isometry3<f64>>, m: &Move, flows: bool) -> Result<Option<Isometry3<f64>>, WriteError> {
        let number = self.positions.len();
        if number > 99_999 {
            return Err(rule("more than 100000 positions without a pause of the laser; space the targets out"));
        }
        match (m.way, m.pace) {
            (Way::Joint, Pace::Percent(percent)) => {
                let to = self.joint(m)?;
                self.instructions.push(format!("MOVJ C{number:05} VJ={} PL=0", fixed(percent.clamp(0.01, 100.0), 2)));
                Ok(to)
            }
            (Way::Linear, Pace::Seconds(seconds)) => {
                let (Some(from), Some(flange)) = (at, &m.base_from_flange) else {
                    return Err(rule("a straight move from home has a speed only with a robot; give --robot"));
                };
                let to = self.pose(flange, m.joints_deg.as_ref());
                let speed = speed(Travel::between(&from, &to), seconds.max(SHORTEST_S));
                let level = if flows { self.setup.cell.yaskawa.level } else { 0 };
                self.instructions.push(format!("MOVL C{number:05} {speed} PL={level}"));
                Ok(Some(to))
            }
            (Way::Joint, Pace::Seconds(_)) => Err(rule("a MOVJ has no duration; give its speed in per cent")),
            (Way::Linear, Pace::Percent(_)) => Err(rule("a MOVL has no speed in per cent; give its duration")),
        }
    }

    fn joint(&mut self, m: &Move) -> Result<Option<Isometry3<f64>>, WriteError> {
        let robot = self.setup.robot.as_ref();
        match (&m.joints_deg, &self.setup.cell.yaskawa.pulses_per_deg, m.base_from_flange) {
            (Some(joints_deg), Some(per_deg), _) => {
                let pendant = coupled(self.setup, joints_deg, -1.0);
                let pulses: Joints = std::array::from_fn(|i| (pendant[i] * per_deg[i]).round());
                self.positions.push(Position::Pulses(pulses.map(|p| fixed(p, 0))));
                let read = from_pulses(self.setup, &pulses, per_deg);
                Ok(robot.map(|r| r.forward(&read)))
            }
            (joints_deg, _, Some(flange)) => Ok(Some(self.pose(&flange, joints_deg.as_ref()))),
            (Some(joints_deg), None, None) => match robot {
                Some(robot) => Ok(Some(self.pose(&robot.forward(joints_deg), Some(joints_deg)))),
                None => Err(rule("home is known by its joints only; give --robot, or pulses_per_deg in the cell file")),
            },
            (None, _, None) => Err(WriteError::NoRobot("yaskawa")),
        }
    }

    /// Adds a pose; as a reader will know it.
    fn pose(&mut self, base_from_flange: &Isometry3<f64>, joints_deg: Option<&Joints>) -> Isometry3<f64> {
        let height = Translation3::new(0.0, 0.0, self.setup.cell.yaskawa.base_height_mm);
        let at = height.inverse() * base_from_flange;
        let [x, y, z, rz, ry, rx] = printed(&at);
        self.positions.push(Position::Pose(figure(self.setup, joints_deg), [x, y, z, rx, ry, rz]));
        height * as_read(&at)
    }

    fn file(self, name: &str) -> ProgramFile {
        let yaskawa = &self.setup.cell.yaskawa;
        let mut out = vec!["/JOB".into(), format!("//NAME {name}"), "//POS".into()];
        out.push(format!("///NPOS {},0,0,0,0,0", self.positions.len()));
        // What the positions before were.
        let mut state: Option<Option<&str>> = None;
        for (number, position) in self.positions.iter().enumerate() {
            let (figure, numbers) = match position {
                Position::Pose(figure, numbers) => (Some(figure.as_str()), numbers),
                Position::Pulses(numbers) => (None, numbers),
            };
            if state.is_none_or(|s| s.is_none() != figure.is_none()) {
                out.push(format!("///TOOL {}", yaskawa.tool));
                let kind =
                    if figure.is_some() { ["///POSTYPE BASE", "///RECTAN"] } else { ["///POSTYPE PULSE", "///PULSE"] };
                out.extend(kind.map(String::from));
            }
            if let Some(figure) = figure
                && state != Some(Some(figure))
            {
                out.push(format!("///RCONF {figure}"));
            }
            state = Some(figure);
            out.push(format!("C{number:05}={}", numbers.join(",")));
        }
        out.push("//INST".into());
        out.extend(yaskawa.start.iter().cloned());
        out.push("NOP".into());
        out.extend(self.instructions);
        out.push("END".into());
        ProgramFile { name: format!("{name}.JBI"), text: words::text(&out, yaskawa.crlf) }
    }
}

/// Joint angles of pulses, as in the robot file.
fn from_pulses(setup: &Setup, pulses: &Joints, per_deg: &[f64; 6]) -> Joints {
    joints(setup, &std::array::from_fn(|i| pulses[i] / per_deg[i]))
}

/// `V=` or `VR=`, in tenths.
fn speed(travel: Travel, seconds: f64) -> String {
    let (mm_s, deg_s) = (travel.mm / seconds, travel.deg / seconds);
    // The controller takes 1500 mm/s and 180 degrees per second at most.
    if mm_s >= deg_s || (travel.mm > 0.0 && deg_s > 180.0) {
        format!("V={}", fixed(mm_s.clamp(0.1, 1500.0), 1))
    } else {
        format!("VR={}", fixed(deg_s.clamp(0.1, 180.0), 1))
    }
}

/// The first eight figures of `RCONF`.
fn figure(setup: &Setup, joints_deg: Option<&Joints>) -> String {
    let (Some(robot), Some(j)) = (&setup.robot, joints_deg) else {
        return "0,0,0,0,0,0,0,0".into();
    };
    let shape = Shape::of(robot, j);
    let turned = j[3] - 360.0 * (j[3] / 360.0).round();
    let far = |deg: f64| deg.abs() >= 180.0;
    let bits = [turned.abs() > 90.0, shape.elbow_down, shape.over_the_back, far(j[3]), far(j[5]), far(j[0])];
    let bits: Vec<&str> = bits.iter().map(|b| if *b { "1" } else { "0" }).collect();
    format!("{},0,0", bits.join(","))
}

fn rule(what: &str) -> WriteError {
    WriteError::Rule(format!("yaskawa: {what}"))
}
