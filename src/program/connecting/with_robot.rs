//! Connecting moves that the arm can make: straight out along the beam, round, and straight in again.
//!
//! Ways are tried from the short to the long one: a straight hop, one move by joints, stations over
//! the part, by way of home. Each is looked at in steps: no joint beyond its range, focus and beam
//! clear of the part, arm and part clear of what stands in the cell.

use super::memo::{ArmStand, JointBits, Memo, bits};
use super::space::Space;
use crate::cell::collision::Collision;
use crate::cell::motion::{Arm, State};
use crate::cell::mounting::Mounted;
use crate::cell::{Joints, Mount, Robot, Setup};
use crate::part::angle;
use crate::program::neutral::steps::{Go, Interpolation, MoveTiming, Station};
use nalgebra::Vector3;

/// On a move by joints no joint turns further than this between two looks, degrees.
const LOOK_DEG: f64 = 1.0;
/// On a straight move the focus goes no further than this between two looks, mm.
const LOOK_MM: f64 = 0.5;
/// And the part turns no further, degrees.
const LOOK_TURN_DEG: f64 = 2.0;
/// A straight connecting move turns no joint further than this.
const MOST_STRAIGHT_DEG: f64 = 60.0;
/// How much of the way out to the sphere is tried, in steps of this share.
const OUT_STEPS: usize = 8;
/// Spins looked at on the way, degrees apart.
const SPINS_DEG: f64 = 30.0;
/// Where gates stand around the part: along its axes and between them.
const DIRECTIONS: [[f64; 3]; 14] = [
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
    [1.0, 1.0, 1.0],
    [1.0, 1.0, -1.0],
    [1.0, -1.0, 1.0],
    [1.0, -1.0, -1.0],
    [-1.0, 1.0, 1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [-1.0, -1.0, -1.0],
];
/// Stands tried at a station, and gates.
const MOST_TRIED: usize = 6;
/// Stations over the part stand this far apart, and are turned by this much at most, degrees.
const ARC_DEG: f64 = 20.0;

/// The arm that makes the moves, and what it must not touch.
pub struct MovingArm<'a> {
    /// The cell with the robot in it.
    pub setup: &'a Setup,
    /// Its frames.
    pub mounted: &'a Mounted,
    /// The robot of the setup.
    pub robot: &'a Robot,
    /// Speed of the focus in the air, mm/s.
    pub air_mm_s: f64,
    /// What the arm and all it carries may touch; `None`: nothing.
    pub collision: Option<&'a Collision<'a>>,
    /// The space around the part.
    pub space: &'a Space<'a>,
    /// What was found out so far.
    pub known: &'a KnownMoves,
}

/// Stands on the way to straight above a piece's end, and that one.
type WayIn = (Vec<ArmStand>, ArmStand);

/// Moves that were looked at.
#[derive(Default)]
pub struct KnownMoves {
    /// Ways in from home or a gate.
    ways_in: Memo<[JointBits; 2], Option<WayIn>>,
    /// Whether a move by joints is clear.
    clear: Memo<[JointBits; 2], bool>,
}

/// The way from one lit piece (or home) to the next (or home), its last move included; `None`: there
/// is none.
pub fn way(arm: &MovingArm<'_>, from: Option<&ArmStand>, to: Option<&ArmStand>) -> Option<Vec<Go>> {
    match (from, to) {
        (None, None) => Some(Vec::new()),
        (None, Some(to)) => {
            let entry = arm.gate(arm.setup.cell.air.entry_joints_deg)?;
            let (stands, above) = arm.way_in(entry.as_ref().unwrap_or(&arm.home()), to)?;
            let moves = entry.iter().chain(&stands).map(|s| arm.by_joints(s));
            Some(moves.chain([arm.straight(&above, to)]).collect())
        }
        (Some(from), None) => {
            // The way in, backwards; home itself is gone to by the program's end.
            let exit = arm.gate(arm.setup.cell.air.exit_joints_deg)?;
            let (mut stands, out) = arm.way_in(exit.as_ref().unwrap_or(&arm.home()), from)?;
            stands.pop();
            let moves = stands.iter().rev().chain(&exit).map(|s| arm.by_joints(s));
            Some([arm.straight(from, &out)].into_iter().chain(moves).collect())
        }
        (Some(from), Some(to)) => {
            let tries: [&dyn Fn() -> Option<Vec<Go>>; 5] = [
                &|| arm.hop(from, to),
                &|| arm.by_safe_plane(from, to),
                &|| arm.direct(from, to),
                &|| arm.over(from, to),
                &|| arm.by_home(from, to),
            ];
            tries.iter().find_map(|way| way())
        }
    }
}

impl MovingArm<'_> {
    /// The stand at a station, carried on from some joints.
    fn stand(&self, at: Station, near: &Joints) -> Option<ArmStand> {
        let joints_deg = self.robot.near(&self.mounted.flange_for(&at.frame()), near)?;
        Some(ArmStand { at, joints_deg })
    }

    /// Along the beam, away from the part, by a share of the way between two stations.
    fn along(&self, from: &ArmStand, end: &Station, share: f64) -> Option<ArmStand> {
        let mut here = *from;
        for k in 1..=4 {
            let x = from.at.x + (end.x - from.at.x) * (share * f64::from(k) / 4.0);
            let next = self.stand(Station { x, ..from.at }, &here.joints_deg)?;
            let touches = |c: &Collision<'_>| c.first_between(&here.joints_deg, &next.joints_deg).is_some();
            if self.collision.is_some_and(touches)
                || self.space.head_hit(&here.at, &next.at).is_some()
                || farthest(&here.joints_deg, &next.joints_deg) > MOST_STRAIGHT_DEG
            {
                return None;
            }
            here = next;
        }
        Some(here)
    }

    /// Stands straight above a piece's end: on the sphere around the part, then nearer and nearer.
    fn outs<'b>(&'b self, stand: &'b ArmStand) -> impl Iterator<Item = ArmStand> + 'b {
        let sphere = self.space.outside(&stand.at);
        (1..=OUT_STEPS).rev().filter_map(move |k| self.along(stand, &sphere, k as f64 / OUT_STEPS as f64))
    }

    /// Straight up, straight over, straight down.
    fn hop(&self, from: &ArmStand, to: &ArmStand) -> Option<Vec<Go>> {
        if !self.space.is_hop(&from.at, &to.at) {
            return None;
        }
        let up = self.along(from, &self.space.drawn_back(&from.at), 1.0)?;
        let down = self.along(to, &self.space.drawn_back(&to.at), 1.0)?;
        self.straight_clear(&up, &down)
            .then(|| vec![self.straight(from, &up), self.straight(&up, &down), self.straight(&down, to)])
    }

    /// Tool in hand: up to the safe plane, straight across, down.
    fn by_safe_plane(&self, from: &ArmStand, to: &ArmStand) -> Option<Vec<Go>> {
        let setup = self.setup;
        let height_mm = setup.cell.air.safe_plane_mm.filter(|_| setup.mount == Mount::ToolInHand)?;
        let base_from_part = setup.cell.base_from_part.isometry();
        let lifted = |stand: &ArmStand| {
            let back = self.along(stand, &self.space.drawn_back(&stand.at), 1.0)?;
            let mut x = base_from_part * back.at.x;
            x.z = x.z.max(height_mm);
            let up = self.along(&back, &Station { x: base_from_part.inverse() * x, ..back.at }, 1.0)?;
            Some((back, up))
        };
        let ((back, up), (down, above)) = (lifted(from)?, lifted(to)?);
        self.straight_clear(&up, &above).then(|| {
            let stands = [from, &back, &up, &above, &down, to];
            stands.windows(2).map(|w| self.straight(w[0], w[1])).collect()
        })
    }

    /// Out and home, then in from there.
    fn by_home(&self, from: &ArmStand, to: &ArmStand) -> Option<Vec<Go>> {
        let home = self.home();
        let (mut back, out) = self.way_in(&home, from)?;
        let (forth, above) = self.way_in(&home, to)?;
        back.pop();
        let moves = back.iter().rev().chain([&home]).chain(&forth).map(|s| self.by_joints(s));
        Some([self.straight(from, &out)].into_iter().chain(moves).chain([self.straight(&above, to)]).collect())
    }

    /// Out, one move by joints, in.
    fn direct(&self, from: &ArmStand, to: &ArmStand) -> Option<Vec<Go>> {
        let (out, above) = (self.outs(from).next()?, self.outs(to).next()?);
        self.joints_clear(&out.joints_deg, &above.joints_deg)
            .then(|| vec![self.straight(from, &out), self.by_joints(&above), self.straight(&above, to)])
    }

    /// Out, over the part from station to station, in.
    fn over(&self, from: &ArmStand, to: &ArmStand) -> Option<Vec<Go>> {
        let (out, above) = (self.outs(from).next()?, self.outs(to).next()?);
        let stands = self.along_sphere(&out, &above)?;
        let moves = stands.iter().map(|s| self.by_joints(s));
        Some([self.straight(from, &out)].into_iter().chain(moves).chain([self.straight(&above, to)]).collect())
    }

    /// Stands over the part, the last one included. The spin turns on the way as well.
    fn along_sphere(&self, out: &ArmStand, above: &ArmStand) -> Option<Vec<ArmStand>> {
        let (u, v) = (self.space.radial(&out.at)?, self.space.radial(&above.at)?);
        let arc = angle::Arc::new(&u, &v);
        let (p, q) = (out.at.frame().rotation, above.at.frame().rotation);
        let steps = (angle::between_deg(&u, &v).max(out.at.turn_deg(&above.at)) / ARC_DEG).ceil().max(1.0) as usize;
        let arm = Arm::with_step(self.robot, self.setup, SPINS_DEG);
        let mut stands = Vec::new();
        let mut here = *out;
        for k in 0..=steps {
            let t = k as f64 / steps as f64;
            let station = self.space.on_top(&arc.at(t), &(p.slerp(&q, t) * Vector3::y()));
            let next =
                self.stand(station, &here.joints_deg).filter(|n| self.joints_clear(&here.joints_deg, &n.joints_deg));
            here = match next.or_else(|| self.some_stand(&arm, &station, &here.joints_deg, &above.joints_deg)) {
                Some(next) => next,
                // The last station stands where the next move would begin: it may be left out.
                None if k == steps => break,
                None => return None,
            };
            stands.push(here);
        }
        self.joints_clear(&here.joints_deg, &above.joints_deg).then(|| {
            stands.push(*above);
            stands
        })
    }

    fn home(&self) -> ArmStand {
        self.stand_of(self.setup.home_joints_deg())
    }

    fn stand_of(&self, joints_deg: Joints) -> ArmStand {
        ArmStand { at: Station::at(&self.mounted.focus_for(&self.robot.forward(&joints_deg))), joints_deg }
    }

    /// A stand between home and the work, if the cell has one; `None`: the way to it from home is not clear.
    fn gate(&self, joints_deg: Option<Joints>) -> Option<Option<ArmStand>> {
        let Some(joints) = joints_deg else { return Some(None) };
        self.joints_clear(&self.setup.home_joints_deg(), &joints).then(|| Some(self.stand_of(joints)))
    }

    /// Stands from home (or a gate) to straight above a piece's end, that one included and given once
    /// more: at once, or by stands around the part from which a way leads over it.
    fn way_in(&self, from: &ArmStand, to: &ArmStand) -> Option<WayIn> {
        self.known.ways_in.get([from, to].map(|s| bits(&s.joints_deg)), || self.new_way_in(from, to))
    }

    fn new_way_in(&self, from: &ArmStand, to: &ArmStand) -> Option<WayIn> {
        let home = from.joints_deg;
        if let Some(above) = self.outs(to).find(|above| self.joints_clear(&home, &above.joints_deg)) {
            return Some((vec![above], above));
        }
        let above = self.outs(to).next()?;
        let arm = Arm::with_step(self.robot, self.setup, 2.0 * SPINS_DEG);
        let mut gates: Vec<(f64, ArmStand)> = Vec::new();
        for direction in DIRECTIONS {
            let radial = Vector3::from(direction).normalize();
            let station = self.space.on_top(&radial, &angle::any_square_to(&radial));
            let states = arm.states(&station.frame()).unwrap_or_default();
            gates.extend(states.iter().map(|s| {
                let at = Station::at(&arm.turned(&station.frame(), s.spin));
                let length = farthest(&home, &s.joints_deg) + farthest(&s.joints_deg, &above.joints_deg);
                (length, ArmStand { at, joints_deg: s.joints_deg })
            }));
        }
        gates.sort_by(|a, b| a.0.total_cmp(&b.0));
        // The gates are the same for every piece.
        let is_open = |gate: &Joints| self.known.clear.get([&home, gate].map(bits), || self.joints_clear(&home, gate));
        let open = gates.iter().filter(|g| is_open(&g.1.joints_deg)).take(MOST_TRIED);
        open.into_iter().find_map(|(_, gate)| {
            let mut stands = vec![*gate];
            stands.extend(self.along_sphere(gate, &above)?);
            Some((stands, above))
        })
    }

    /// A stand at a station with any spin: the one that lies best between two others.
    fn some_stand(&self, arm: &Arm<'_>, station: &Station, from: &Joints, to: &Joints) -> Option<ArmStand> {
        let states = arm.states(&station.frame()).ok()?;
        let length = |s: &State| farthest(from, &s.joints_deg) + 0.5 * farthest(&s.joints_deg, to);
        let mut order: Vec<(f64, &State)> = states.iter().map(|s| (length(s), s)).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        order
            .into_iter()
            .take(MOST_TRIED)
            .map(|(_, s)| ArmStand { at: Station::at(&arm.turned(&station.frame(), s.spin)), joints_deg: s.joints_deg })
            .find(|n| self.joints_clear(from, &n.joints_deg))
    }

    fn by_joints(&self, to: &ArmStand) -> Go {
        Go {
            to: to.at,
            interpolation: Interpolation::Joint,
            joints_deg: Some(to.joints_deg),
            timing: MoveTiming::Percent(self.setup.cell.air.home_percent),
            target: None,
        }
    }

    /// A straight move in the time that speed, turn and the slowest joint need.
    fn straight(&self, from: &ArmStand, to: &ArmStand) -> Go {
        let joints = (0..6)
            .map(|j| (to.joints_deg[j] - from.joints_deg[j]).abs() / self.robot.speeds_deg_s[j])
            .fold(0.0, f64::max);
        let seconds = self.space.seconds(&from.at, &to.at, self.air_mm_s).max(2.0 * joints);
        Go {
            to: to.at,
            interpolation: Interpolation::Linear,
            joints_deg: Some(to.joints_deg),
            timing: MoveTiming::Seconds(seconds),
            target: None,
        }
    }

    /// Whether nothing is in the way of a move by joints. Where the head is known, it is what must not
    /// touch a part in hand; where it is not, the beam stands for it.
    fn joints_clear(&self, from: &Joints, to: &Joints) -> bool {
        let setup = self.setup;
        let head_known = setup.mount == Mount::PartInHand && !setup.cell.bodies.head.is_empty();
        let steps = (farthest(from, to) / LOOK_DEG).ceil().max(1.0);
        let is_clear = |k: usize| {
            let t = k as f64 / steps;
            let joints: Joints = std::array::from_fn(|j| from[j] + (to[j] - from[j]) * t);
            let focus = self.mounted.focus_for(&self.robot.forward(&joints));
            if head_known { self.space.is_head_clear_at(&focus) } else { self.space.is_clear_at(&focus) }
        };
        (head_known && !self.space.knows_head() || (0..=steps as usize).all(is_clear))
            && self.collision.is_none_or(|c| c.first_between(from, to).is_none())
    }

    /// Whether nothing is in the way where the flange goes straight, and the arm can follow.
    fn straight_clear(&self, from: &ArmStand, to: &ArmStand) -> bool {
        if farthest(&from.joints_deg, &to.joints_deg) > MOST_STRAIGHT_DEG {
            return false;
        }
        let setup = self.mounted;
        let (a, b) = (setup.flange_for(&from.at.frame()), setup.flange_for(&to.at.frame()));
        let steps = ((to.at.x - from.at.x).norm() / LOOK_MM).max(from.at.turn_deg(&to.at) / LOOK_TURN_DEG);
        let steps = steps.ceil().max(1.0);
        let mut here = from.joints_deg;
        for k in 0..=steps as usize {
            let flange = a.lerp_slerp(&b, k as f64 / steps);
            match self.robot.near(&flange, &here) {
                Some(joints) if farthest(&here, &joints) <= 0.5 * MOST_STRAIGHT_DEG => here = joints,
                _ => return false,
            }
            let touches = self.collision.is_some_and(|c| c.first(&here).is_some());
            if touches || !self.space.is_clear_at(&setup.focus_for(&flange)) {
                return false;
            }
        }
        // The way must end in the joints that the next piece starts from.
        farthest(&here, &to.joints_deg) < 1e-6
    }
}

/// Largest difference of a joint, degrees.
fn farthest(a: &Joints, b: &Joints) -> f64 {
    (0..6).map(|j| (a[j] - b[j]).abs()).fold(0.0, f64::max)
}
