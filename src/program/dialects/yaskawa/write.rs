//! INFORM jobs as they are written.

use super::{from_pulses, templates};
use crate::cell::controllers::templates::{fixed, text};
use crate::cell::{Joints, Setup};
use crate::program::dialect::{Program, ProgramFile};
use crate::program::dialects::arm_shape::ArmShape;
use crate::program::dialects::flange::{SHORTEST_S, Speeds, Travel, as_read, coupled, flows_on, printed};
use crate::program::dialects::pace;
use crate::program::dialects::subprograms::subprograms;
use crate::program::neutral::comment::{Caveat, Comment};
use crate::program::neutral::lines::{Move, ProgramLine};
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::write_error::WriteError;
use nalgebra::{Isometry3, Translation3};

/// What the controller takes at most in `V=` and `VR=`.
const MOST: Speeds = Speeds { mm_s: 1500.0, deg_s: 180.0 };

/// The job, and a job for each subprogram of a long one.
pub fn write(program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
    let yaskawa = &program.setup.cell.yaskawa;
    templates(yaskawa).check()?;
    let laser = program.setup.cell.outputs.laser.number;
    let subprograms = subprograms(&program.lines, laser, yaskawa.max_lines, |_| 1);
    let mut main = JobText::new(program.setup);
    main.instructions.extend(templates(yaskawa).head(&[Comment::Caveat(Caveat::Inform)], program.wording));
    main.instructions.extend(templates(yaskawa).head(&program.head, program.wording));
    let mut files = Vec::new();
    let (mut at, mut index) = (None, 0);
    for (number, subprogram) in subprograms.iter().enumerate() {
        let mut part = JobText::new(program.setup);
        let job = if subprograms.len() == 1 { &mut main } else { &mut part };
        for line in *subprogram {
            match line {
                ProgramLine::Move(m) => at = job.write_move(at, m, flows_on(&program.lines, index))?,
                _ => job.instructions.extend(templates(yaskawa).write(line, program.wording)?),
            }
            index += 1;
        }
        if subprograms.len() > 1 {
            let name = format!("{}{}", yaskawa.name, number + 1);
            main.instructions.push(format!("CALL JOB:{name}"));
            files.push(part.file(&name));
        }
    }
    files.insert(0, main.file(&yaskawa.name));
    Ok(files)
}

/// A position of a job.
enum WrittenPosition {
    /// Its `RCONF`, and X, Y, Z, Rx, Ry, Rz.
    Pose(String, [String; 6]),
    /// Pulses of the six axes.
    Pulses([String; 6]),
}

/// A job on the way.
struct JobText<'a> {
    setup: &'a Setup,
    positions: Vec<WrittenPosition>,
    instructions: Vec<String>,
}

impl<'a> JobText<'a> {
    fn new(setup: &'a Setup) -> JobText<'a> {
        JobText { setup, positions: Vec::new(), instructions: Vec::new() }
    }

    /// Writes a move from `at`; where it leads, as a reader will know it.
    fn write_move(
        &mut self,
        at: Option<Isometry3<f64>>,
        m: &Move,
        flows: bool,
    ) -> Result<Option<Isometry3<f64>>, WriteError> {
        let number = self.positions.len();
        if number > 99_999 {
            return Err(WriteError::TooManyPositions);
        }
        match (m.interpolation, m.timing) {
            (Interpolation::Joint, MoveTiming::Percent(percent)) => {
                let to = self.joint(m)?;
                self.instructions.push(format!("MOVJ C{number:05} VJ={} PL=0", fixed(percent.clamp(0.01, 100.0), 2)));
                Ok(to)
            }
            (Interpolation::Linear, MoveTiming::Seconds(seconds)) => {
                let (Some(from), Some(flange)) = (at, &m.base_from_flange) else {
                    return Err(WriteError::FromUnknownPose("yaskawa"));
                };
                let to = self.pose(flange, m.joints_deg.as_ref());
                let speed = Speed::of(Travel::between(&from, &to), seconds).words();
                let level = if flows { self.setup.cell.yaskawa.level } else { 0 };
                self.instructions.push(format!("MOVL C{number:05} {speed} PL={level}"));
                Ok(Some(to))
            }
            (Interpolation::Joint, MoveTiming::Seconds(_)) => Err(WriteError::TimedJointMove("yaskawa")),
            (Interpolation::Linear, MoveTiming::Percent(_)) => Err(WriteError::StraightInPercent("yaskawa")),
        }
    }

    fn joint(&mut self, m: &Move) -> Result<Option<Isometry3<f64>>, WriteError> {
        let robot = self.setup.robot.as_ref();
        match (&m.joints_deg, &self.setup.cell.yaskawa.pulses_per_deg, m.base_from_flange) {
            (Some(joints_deg), Some(per_deg), _) => {
                let pendant = coupled(self.setup, joints_deg, -1.0);
                let pulses: Joints = std::array::from_fn(|i| (pendant[i] * per_deg[i]).round());
                self.positions.push(WrittenPosition::Pulses(pulses.map(|p| fixed(p, 0))));
                let read = from_pulses(self.setup, &pulses, per_deg);
                Ok(robot.map(|r| r.forward(&read)))
            }
            (joints_deg, _, Some(flange)) => Ok(Some(self.pose(&flange, joints_deg.as_ref()))),
            (Some(joints_deg), None, None) => match robot {
                Some(robot) => Ok(Some(self.pose(&robot.forward(joints_deg), Some(joints_deg)))),
                None => Err(WriteError::HomeNeedsPulses),
            },
            (None, _, None) => Err(WriteError::NoRobot("yaskawa")),
        }
    }

    /// Adds a pose; as a reader will know it.
    fn pose(&mut self, base_from_flange: &Isometry3<f64>, joints_deg: Option<&Joints>) -> Isometry3<f64> {
        let height = Translation3::new(0.0, 0.0, self.setup.cell.yaskawa.base_height_mm);
        let at = height.inverse() * base_from_flange;
        let [x, y, z, rz, ry, rx] = printed(&at);
        self.positions.push(WrittenPosition::Pose(figure(self.setup, joints_deg), [x, y, z, rx, ry, rz]));
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
                WrittenPosition::Pose(figure, numbers) => (Some(figure.as_str()), numbers),
                WrittenPosition::Pulses(numbers) => (None, numbers),
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
        ProgramFile { name: format!("{name}.JBI"), text: text(&out, yaskawa.crlf) }
    }
}

/// How fast the words make the moves: each speed has one decimal, per cents two.
pub fn paces(lines: &[ProgramLine], setup: &Setup) -> Vec<MoveTiming> {
    // Positions are rounded as they are written.
    let (mut job, mut at) = (JobText::new(setup), None);
    pace::each(lines, |m| {
        let to = match m.interpolation {
            Interpolation::Joint => job.joint(m).ok().flatten(),
            Interpolation::Linear => m.base_from_flange.map(|flange| job.pose(&flange, m.joints_deg.as_ref())),
        };
        match (m.timing, std::mem::replace(&mut at, to), to) {
            (MoveTiming::Percent(p), ..) => pace::percent(p, 2),
            (MoveTiming::Seconds(s), Some(from), Some(to)) => {
                let travel = Travel::between(&from, &to);
                MoveTiming::Seconds(Speed::of(travel, s).paced_s(travel))
            }
            (timing, ..) => timing,
        }
    })
}

/// Speed of a straight move; the words have its tenths, one at least.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Speed {
    /// `V=`: of the way, mm/s.
    Way(f64),
    /// `VR=`: of the angle, degrees per second.
    Angle(f64),
}

impl Speed {
    /// The speed at which a move takes so many seconds, or longer where the words end.
    fn of(travel: Travel, seconds: f64) -> Speed {
        let seconds = seconds.max(SHORTEST_S).max(travel.mm / MOST.mm_s).max(travel.deg / MOST.deg_s);
        let (mm_s, deg_s) = (travel.mm / seconds, travel.deg / seconds);
        // Of the two the one that keeps more digits.
        if mm_s >= deg_s { Speed::Way(mm_s) } else { Speed::Angle(deg_s) }
    }

    /// What a move takes at the greatest tenth that is not above.
    fn paced_s(self, travel: Travel) -> f64 {
        let tenths = |v: f64| pace::at_most(v, 1).max(0.1);
        match self {
            Speed::Way(mm_s) => travel.mm / tenths(mm_s),
            Speed::Angle(deg_s) => travel.deg / tenths(deg_s),
        }
    }

    fn words(self) -> String {
        match self {
            Speed::Way(mm_s) => format!("V={}", fixed(mm_s.max(0.1), 1)),
            Speed::Angle(deg_s) => format!("VR={}", fixed(deg_s.max(0.1), 1)),
        }
    }
}

/// The first eight figures of `RCONF`.
fn figure(setup: &Setup, joints_deg: Option<&Joints>) -> String {
    let (Some(robot), Some(j)) = (&setup.robot, joints_deg) else {
        return "0,0,0,0,0,0,0,0".into();
    };
    let shape = ArmShape::of(robot, j);
    let turned = j[3] - 360.0 * (j[3] / 360.0).round();
    let far = |deg: f64| deg.abs() >= 180.0;
    let bits = [turned.abs() > 90.0, shape.elbow_down, shape.over_the_back, far(j[3]), far(j[5]), far(j[0])];
    let bits: Vec<&str> = bits.iter().map(|b| if *b { "1" } else { "0" }).collect();
    format!("{},0,0", bits.join(","))
}
