//! The program as a list of steps, before any controller's words: go to a station, switch the laser, say something.

use super::comment::Comment;
use super::shortfall::{OffSpeed, Shortfall};
use crate::beam::ProcessSettings;
use crate::part::angle;
use crate::pose::target::frame;
use crate::pose::{Pass, Target};
use nalgebra::{Isometry3, Point3, Vector3};

/// Where the focus stands and how: path frame in the part frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Focus, mm.
    pub x: Point3<f64>,
    /// Beam axis, unit.
    pub a: Vector3<f64>,
    /// Second axis of the frame, unit, square to a: the travel direction or its opposite, whichever turns the flange
    /// less from the station before; turned about a by the spin, where a robot chose one.
    pub o: Vector3<f64>,
}

impl Station {
    /// The station of a target.
    pub fn of(t: &Target, settings: &ProcessSettings) -> Station {
        Station { x: t.focus(settings.defocus_mm), a: t.a, o: t.o }
    }

    /// The station of a target, turned about the beam by a spin.
    pub fn spun(t: &Target, settings: &ProcessSettings, spin_deg: f64) -> Station {
        Station { x: t.focus(settings.defocus_mm), a: t.a, o: angle::turned(&t.o, &t.a, spin_deg) }
    }

    /// The station of a path frame.
    pub fn at(part_from_focus: &Isometry3<f64>) -> Station {
        let axis = |v: Vector3<f64>| part_from_focus.rotation * v;
        Station { x: part_from_focus.translation.vector.into(), a: axis(Vector3::z()), o: axis(Vector3::y()) }
    }

    /// `[n o a | x]`.
    pub fn frame(&self) -> Isometry3<f64> {
        frame(&self.x, &self.a, &self.o)
    }

    /// Angle by which the part is turned between two stations, degrees.
    pub fn turn_deg(&self, to: &Station) -> f64 {
        let q = self.frame().rotation.rotation_to(&to.frame().rotation);
        2.0 * libm::atan2(q.imag().norm(), q.w.abs()).to_degrees()
    }

    /// With o or its opposite, whichever needs the smaller turn from `before`: so the lines of a zigzag need no half
    /// turn of the part.
    pub fn nearest_to(self, before: &Station) -> Station {
        let other = Station { o: -self.o, ..self };
        if before.turn_deg(&other) < before.turn_deg(&self) { other } else { self }
    }
}

/// One step of a program.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// A comment.
    Comment(Comment),
    /// What follows is worked with this.
    Process(ProcessSettings),
    /// The laser is switched.
    Laser(bool),
    /// Home, all joints in proportion, at so many per cent of their full speed.
    Home {
        /// Per cent.
        percent: f64,
    },
    /// A move.
    Go(Go),
}

/// A move to a station.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Go {
    /// Where to; turned by the spin, where a robot chose one.
    pub to: Station,
    /// By joints or straight.
    pub interpolation: Interpolation,
    /// Joints at its end, degrees; `None` without a robot.
    pub joints_deg: Option<[f64; 6]>,
    /// How fast.
    pub timing: MoveTiming,
    /// Pass and point, for a target; `None` in the air, and between two targets.
    pub target: Option<(usize, usize)>,
}

/// How a move goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// All joints in proportion.
    Joint,
    /// The flange goes straight (in `abb` programs the focus), and turns about one axis.
    Linear,
}

/// How fast a move goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MoveTiming {
    /// Its duration, s: it gives the spot its speed on the part.
    Seconds(f64),
    /// Share of the joints' full speed, per cent.
    Percent(f64),
}

/// A program's steps, with the length of its air moves and its time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Steps {
    /// In order.
    pub list: Vec<Step>,
    /// Length of the moves with the laser off, mm.
    pub air_mm: f64,
    /// Duration of all moves but those from and to home, s.
    pub time_s: f64,
    /// What is not as it was wanted, by surface.
    pub shortfalls: Vec<(u32, Shortfall)>,
    /// Surfaces on which the spot does not have its speed everywhere.
    pub off_speed: Vec<OffSpeed>,
    /// What the last piece is worked with.
    pub(crate) process: Option<ProcessSettings>,
}

impl Steps {
    /// Says what the next piece is worked with, where that changes.
    pub fn set_process(&mut self, settings: &ProcessSettings) {
        if self.process.as_ref() != Some(settings) {
            self.process = Some(*settings);
            self.list.push(Step::Process(*settings));
        }
    }

    /// Adds the comment that says which pass begins.
    pub fn say_pass(&mut self, number: usize, pass: &Pass) {
        let (surface, layer) = (pass.surface, pass.settings.layer);
        self.list.push(Step::Comment(Comment::Pass { number, surface, layer }));
    }
}
