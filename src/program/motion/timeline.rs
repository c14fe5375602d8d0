//! A program over time: when the arm is where, and how long it works, travels and waits.
//!
//! The model of the controller is plain. Moves by per cent start and end at rest, each joint on a
//! trapezoid, the slowest deciding for all; moves that are given their seconds take them and run
//! evenly, as blended moves do. Laser and controller answer after the cell's latencies, on top of the
//! waits that the program makes.

use super::trapezoid::Trapezoid;
use crate::cell::{Joints, Robot, Setup};
use crate::program::neutral::lines::{Move, ProgramLine, lines};
use crate::program::neutral::steps::{Interpolation, MoveTiming, Steps};
use nalgebra::{Isometry3, Translation3, UnitQuaternion};

/// The end of a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimelineStop {
    /// Where the arm is then.
    pub joints_deg: Joints,
    /// How it got there.
    pub interpolation: Interpolation,
    /// Whether the laser was on under way.
    pub lit: bool,
    /// Pass and point, for a target.
    pub target: Option<(usize, usize)>,
    /// Waiting before the move, s.
    pub waiting_s: f64,
    /// The move, s.
    pub seconds: f64,
    /// When it ends, from the program's start, s.
    pub at_s: f64,
    /// Time that it runs up and slows down: none where it runs evenly, s.
    ramp_s: f64,
}

/// The arm at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Its joints.
    pub joints_deg: Joints,
    /// Its flange, mm.
    pub base_from_flange: Isometry3<f64>,
    /// Where that brings the focus, and how, mm.
    pub part_from_focus: Isometry3<f64>,
    /// Whether the laser is on.
    pub lit: bool,
    /// The stop that is being gone to, or was just reached.
    pub stop: usize,
}

/// What the time is spent on, s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Breakdown {
    /// Moves with the laser on.
    pub work_s: f64,
    /// Moves with the laser off.
    pub travel_s: f64,
    /// Waiting for laser and controller.
    pub waiting_s: f64,
}

/// A program over time. One stop for each move of [`lines()`], in that order.
#[derive(Clone, Debug)]
pub struct Timeline {
    stops: Vec<TimelineStop>,
    setup: Setup,
    robot: Robot,
}

impl Timeline {
    /// The program's timeline; `None` without a robot, or without the joints of a move.
    pub fn new(steps: &Steps, setup: &Setup) -> Option<Timeline> {
        let robot = setup.robot.clone()?;
        let timing = &setup.cell.timing;
        let mut stops: Vec<TimelineStop> = Vec::new();
        let (mut waiting_s, mut light) = (0.0, false);
        for line in lines(steps, setup) {
            match line {
                ProgramLine::Comment(_) | ProgramLine::OutputValue { .. } | ProgramLine::Force(_) => {}
                ProgramLine::Wait(s) => waiting_s += s,
                ProgramLine::Output { number, on } => {
                    if number == setup.cell.outputs.laser.number && on != light {
                        waiting_s += if on { timing.laser_on_s } else { timing.laser_off_s };
                        light = on;
                    }
                }
                ProgramLine::Move(m) => {
                    let Some(last) = stops.last().copied() else {
                        // The arm stands there when the program begins.
                        stops.push(first(&m)?);
                        continue;
                    };
                    let joints_deg = m.joints_deg?;
                    let (ramp_s, seconds) = match m.timing {
                        MoveTiming::Seconds(s) => (0.0, s.max(0.0)),
                        MoveTiming::Percent(p) => {
                            let t = Trapezoid::slowest(&robot, &last.joints_deg, &joints_deg, p);
                            (t.ramp_s, t.total_s)
                        }
                    };
                    // Blended moves follow each other at once; all others begin at rest.
                    if matches!(m.timing, MoveTiming::Percent(_)) || m.lit != last.lit {
                        waiting_s += timing.move_s;
                    }
                    let waiting_s = std::mem::take(&mut waiting_s);
                    let at_s = last.at_s + waiting_s + seconds;
                    let (interpolation, lit, target) = (m.interpolation, m.lit, m.target);
                    stops.push(TimelineStop {
                        joints_deg,
                        interpolation,
                        lit,
                        target,
                        waiting_s,
                        seconds,
                        at_s,
                        ramp_s,
                    });
                }
            }
        }
        (!stops.is_empty()).then(|| Timeline { stops, setup: setup.clone(), robot })
    }

    /// Every stop, in program order.
    pub fn stops(&self) -> &[TimelineStop] {
        &self.stops
    }

    /// The robot that it is for.
    pub fn robot(&self) -> &Robot {
        &self.robot
    }

    /// Where its frames are from.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// From the first move to the last, s.
    pub fn total_s(&self) -> f64 {
        self.stops.last().map_or(0.0, |s| s.at_s)
    }

    /// What the time is spent on.
    pub fn breakdown(&self) -> Breakdown {
        self.stops.iter().fold(Breakdown::default(), |b, s| Breakdown {
            work_s: b.work_s + if s.lit { s.seconds } else { 0.0 },
            travel_s: b.travel_s + if s.lit { 0.0 } else { s.seconds },
            waiting_s: b.waiting_s + s.waiting_s,
        })
    }

    /// Stretches of time with the laser on, from and to, s.
    pub fn lit_stretches(&self) -> Vec<[f64; 2]> {
        let mut out: Vec<[f64; 2]> = Vec::new();
        let mut goes_on = false;
        for s in &self.stops {
            match out.last_mut() {
                Some(last) if goes_on && s.lit => last[1] = s.at_s,
                _ if s.lit => out.push([s.at_s - s.seconds, s.at_s]),
                _ => {}
            }
            goes_on = s.lit;
        }
        out
    }

    /// The stop that is being gone to at a time, or was just reached.
    pub fn stop_at(&self, time_s: f64) -> usize {
        self.stops.partition_point(|s| s.at_s < time_s).min(self.stops.len() - 1)
    }

    /// The arm at a time, which is held within the program.
    pub fn moment(&self, time_s: f64) -> Moment {
        let stop = self.stop_at(time_s);
        let to = &self.stops[stop];
        let from = &self.stops[stop.saturating_sub(1)];
        let begun_s = time_s - (to.at_s - to.seconds);
        let time_share = if to.seconds > 0.0 { (begun_s / to.seconds).clamp(0.0, 1.0) } else { 1.0 };
        let share = Trapezoid { ramp_s: to.ramp_s, total_s: to.seconds }.share(time_share);
        let (joints_deg, base_from_flange) = self.between(from, to, share);
        Moment {
            joints_deg,
            base_from_flange,
            part_from_focus: self.setup.focus_for(&base_from_flange),
            lit: to.lit && begun_s >= 0.0,
            stop,
        }
    }

    /// Joints and flange on the way between two stops.
    fn between(&self, from: &TimelineStop, to: &TimelineStop, share: f64) -> (Joints, Isometry3<f64>) {
        let joints: Joints =
            std::array::from_fn(|i| from.joints_deg[i] + (to.joints_deg[i] - from.joints_deg[i]) * share);
        if share >= 1.0 {
            return (to.joints_deg, self.robot.forward(&to.joints_deg));
        }
        if share <= 0.0 || to.interpolation == Interpolation::Joint {
            return (joints, self.robot.forward(&joints));
        }
        let ends = [from, to].map(|s| self.robot.forward(&s.joints_deg));
        let flange = straight(&ends[0], &ends[1], share);
        // Where the way leaves the arm's reach between two poses within it, the joints are shown.
        match self.robot.nearest_inverse(&flange, &joints) {
            Some(joints) => (joints, flange),
            None => (joints, self.robot.forward(&joints)),
        }
    }
}

/// The first stop: no move leads there.
fn first(m: &Move) -> Option<TimelineStop> {
    Some(TimelineStop {
        joints_deg: m.joints_deg?,
        interpolation: m.interpolation,
        lit: false,
        target: m.target,
        waiting_s: 0.0,
        seconds: 0.0,
        at_s: 0.0,
        ramp_s: 0.0,
    })
}

/// Position straight, orientation about one axis.
fn straight(from: &Isometry3<f64>, to: &Isometry3<f64>, share: f64) -> Isometry3<f64> {
    let (a, b) = (from.translation.vector, to.translation.vector);
    let turn = (from.rotation.inverse() * to.rotation).scaled_axis();
    Isometry3::from_parts(
        Translation3::from(a + (b - a) * share),
        from.rotation * UnitQuaternion::from_scaled_axis(turn * share),
    )
}

#[cfg(test)]
#[path = "timeline_tests.rs"]
mod tests;
