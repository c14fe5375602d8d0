//! The program as a list of steps, before any controller's words: go to a station, switch the
//! laser, say something; here without a robot, as poses of the focus.

use super::air::Space;
use super::lit::Straight;
use super::pieces::{self, Spaces};
use super::remarks::remarks;
use super::sweep::LitMove;
use crate::beam::{Body, Work};
use crate::cell::Setup;
use crate::cell::motion::Refusal;
use crate::cell::mounting::Mounted;
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
    /// Travel axis, unit, square to a; of the two senses the one nearer to the station before.
    pub o: Vector3<f64>,
}

impl Station {
    /// The station of a target.
    pub fn of(t: &Target, work: &Work) -> Station {
        Station { x: t.focus(work.defocus_mm), a: t.a, o: t.o }
    }

    /// The station of a target, turned about the beam by a spin.
    pub fn spun(t: &Target, work: &Work, spin_deg: f64) -> Station {
        Station { x: t.focus(work.defocus_mm), a: t.a, o: angle::turned(&t.o, &t.a, spin_deg) }
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

    /// With the sense of travel that needs the smaller turn from `before`: lines of a zigzag need
    /// no half turn of the part.
    fn nearest_to(self, before: &Station) -> Station {
        let other = Station { o: -self.o, ..self };
        if before.turn_deg(&other) < before.turn_deg(&self) { other } else { self }
    }
}

/// One step of a program.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// A comment.
    Say(String),
    /// What follows is worked with this.
    Work(Work),
    /// The laser is switched.
    Laser(bool),
    /// Home, all joints in proportion.
    Home,
    /// A move.
    Go(Go),
}

/// A move to a station.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Go {
    /// Where to; turned by the spin, where a robot chose one.
    pub to: Station,
    /// By joints or straight.
    pub way: Way,
    /// Joints at its end, degrees; `None` without a robot.
    pub joints_deg: Option<[f64; 6]>,
    /// How fast.
    pub pace: Pace,
    /// Pass and point, for a target; `None` in the air, and between two targets.
    pub target: Option<(usize, usize)>,
}

/// How a move goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Way {
    /// All joints in proportion.
    Joint,
    /// The tool centre point straight, the orientation about one axis.
    Linear,
}

/// How fast a move goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pace {
    /// Its duration, s: that is what gives the spot its speed on the part.
    Seconds(f64),
    /// Share of the joints' full speed, per cent.
    Percent(f64),
}

/// A program's steps, and what its air moves come to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Steps {
    /// In order.
    pub list: Vec<Step>,
    /// Length of the moves with the laser off, mm.
    pub air_mm: f64,
    /// Duration of all moves but those from and to home, s.
    pub time_s: f64,
    /// What is not as it was wanted, by surface.
    pub remarks: Vec<(u32, String)>,
}

/// The farthest that the focus stands from the part on any pass, mm.
pub fn farthest_focus_mm(passes: &[Pass]) -> f64 {
    passes.iter().map(|p| p.work.defocus_mm).fold(0.0, f64::max)
}

/// The space around a part, for what is carried in the air: `straight` knows part and margin.
pub(super) fn space<'a>(straight: &Straight<'a>, setup: &'a Setup, passes: &[Pass]) -> Space<'a> {
    let head = Body::head_alone(&setup.tool, straight.prover.margin_mm());
    Space::new(straight.prover.whole(), (head, straight.prover.mounted), &setup.cell.air, farthest_focus_mm(passes))
}

/// Turns passes into steps. Blocked targets are not gone to. `air_mm_s`: speed of the focus in the air.
///
/// # Errors
/// Targets to which the beam does not keep its line as the flange goes straight, and pieces from which the head
/// cannot be drawn back; the rest has to be tried again without them.
pub fn steps(straight: &Straight<'_>, setup: &Setup, passes: &[Pass], air_mm_s: f64) -> Result<Steps, Vec<Refusal>> {
    let space = space(straight, setup, passes);
    let spaces = Spaces::new(&space, &straight.prover, passes);
    let pieces = pieces::pieces(&spaces, passes);
    let hops = pieces::hops(&spaces, passes, &pieces);
    let mut refused = pieces::stuck(&spaces, passes, &pieces, &hops);
    let mut out = Steps::default();
    let mut at: Option<Station> = None;
    let mut said = None;
    out.list.push(Step::Home);
    for (index, piece) in pieces.iter().enumerate() {
        let (number, pass) = (piece.pass, &passes[piece.pass]);
        let mut here = match at {
            None => {
                let entry = space.outside(&piece.entry);
                // From home the arm goes by joints: how far is not known without a robot.
                out.list.push(Step::Go(Go {
                    to: entry,
                    way: Way::Joint,
                    joints_deg: None,
                    pace: Pace::Percent(setup.cell.air.home_percent),
                    target: None,
                }));
                entry
            }
            Some(from) => {
                let to = piece.entry.nearest_to(&from);
                let mut before = from;
                for via in space.between(&from, &to, hops[index - 1]) {
                    let via = via.nearest_to(&before);
                    out.air(&space, before, via, air_mm_s);
                    before = via;
                }
                before
            }
        };
        if said != Some(number) {
            out.list.push(Step::Say(pass.title(number)));
            said = Some(number);
        }
        let first = Some((number, piece.first));
        let start = Station::of(&pass.targets[piece.first], &pass.work).nearest_to(&here);
        match piece.leads.before {
            None => out.down(&space, here, start, air_mm_s, first),
            Some(l) => {
                let to = Station { o: start.o, ..l.at };
                out.down(&space, here, to, air_mm_s, None);
                out.air_mm += (start.x - to.x).norm();
                out.go(start, l.seconds, first);
            }
        }
        here = start;
        out.with(&pass.work);
        out.list.push(Step::Laser(true));
        for i in piece.first + 1..=piece.last {
            let next = Station::of(&pass.targets[i], &pass.work).nearest_to(&here);
            let spot_mm = (pass.targets[i].p - pass.targets[i - 1].p).norm();
            let seconds = spot_mm / pass.work.speed_mm_s;
            let mut done = 0.0;
            match straight.between(&here, &next, &pass.work) {
                Ok(between) => {
                    for (share, station) in between {
                        out.go(station, seconds * (share - done), None);
                        done = share;
                    }
                }
                Err((cause, why)) => refused.push(Refusal { pass: number, point: i, cause, why }),
            }
            out.go(next, seconds * (1.0 - done), Some((number, i)));
            here = next;
        }
        out.list.push(Step::Laser(false));
        if let Some(l) = piece.leads.behind {
            let to = Station { o: here.o, ..l.at };
            out.air_mm += (to.x - here.x).norm();
            out.go(to, l.seconds, None);
            here = to;
        }
        at = Some(here);
    }
    if let Some(end) = at {
        let exit = space.outside(&end);
        out.air(&space, end, exit, air_mm_s);
    }
    out.list.push(Step::Home);
    out.remarks = remarks(pieces.iter().map(|p| (&passes[p.pass], p.leads.left_out)), &setup.cell.outputs);
    if refused.is_empty() { Ok(out) } else { Err(refused) }
}

impl Steps {
    /// The moves with the laser on, as the flange makes them.
    pub fn lit_moves(&self, mounted: &Mounted) -> Vec<LitMove> {
        let (mut lit, mut at, mut work) = (false, None, Work::default());
        let mut out = Vec::new();
        for step in &self.list {
            match step {
                Step::Laser(on) => lit = *on,
                Step::Work(with) => work = *with,
                Step::Go(go) => {
                    let to = mounted.flange_for(&go.to.frame());
                    out.extend(at.filter(|_| lit).map(|from| LitMove { from, to, by_focus: false, work }));
                    at = Some(to);
                }
                Step::Say(_) | Step::Home => {}
            }
        }
        out
    }

    /// Says what the next piece is worked with, where that changes.
    pub(super) fn with(&mut self, work: &Work) {
        let before = self.list.iter().rev().find_map(|s| if let Step::Work(work) = s { Some(work) } else { None });
        if before != Some(work) {
            self.list.push(Step::Work(*work));
        }
    }

    pub(super) fn go(&mut self, to: Station, seconds: f64, target: Option<(usize, usize)>) {
        let (way, pace) = (Way::Linear, Pace::Seconds(seconds));
        self.list.push(Step::Go(Go { to, way, joints_deg: None, pace, target }));
        self.time_s += seconds;
    }

    fn air(&mut self, space: &Space<'_>, from: Station, to: Station, air_mm_s: f64) {
        self.down(space, from, to, air_mm_s, None);
    }

    /// A move in the air, to a target.
    fn down(&mut self, space: &Space<'_>, from: Station, to: Station, air_mm_s: f64, target: Option<(usize, usize)>) {
        self.air_mm += (to.x - from.x).norm();
        self.go(to, space.seconds(&from, &to, air_mm_s), target);
    }
}
