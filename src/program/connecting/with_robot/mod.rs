//! Connecting moves that the arm can make: straight out along the beam, round, and straight in again.
//!
//! Ways are tried from the short to the long one: a straight hop, one move by joints, stations over
//! the part, by way of home. Each is looked at in steps: no joint beyond its range, focus and beam
//! clear of the part, arm and part clear of what stands in the cell.

mod clear;
mod way_in;

use super::pose_cache::{ArmStand, JointBits, PoseCache};
use super::transfer_space::TransferSpace;
use crate::cell::collision::Collision;
use crate::cell::mounting::Mounted;
use crate::cell::{Joints, Mount, Robot, Setup};
use crate::program::neutral::steps::{Go, Interpolation, MoveTiming, Station};

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
    pub space: &'a TransferSpace<'a>,
    /// What was found out so far.
    pub cache: &'a ConnectingMoveCache,
}

/// Stands on the way to straight above a piece's end, and that one.
type WayIn = (Vec<ArmStand>, ArmStand);

/// Moves that were looked at.
#[derive(Default)]
pub struct ConnectingMoveCache {
    /// Ways in from home or a gate.
    ways_in: PoseCache<[JointBits; 2], Option<WayIn>>,
    /// Whether a move by joints is clear.
    clear: PoseCache<[JointBits; 2], bool>,
}

/// The way from one lit piece (or home) to the next (or home), its last move included; `None`: there
/// is none.
pub fn connecting_moves(arm: &MovingArm<'_>, from: Option<&ArmStand>, to: Option<&ArmStand>) -> Option<Vec<Go>> {
    match (from, to) {
        (None, None) => Some(Vec::new()),
        (None, Some(to)) => {
            let entry = arm.gate(arm.setup.cell.air.entry_joints_deg)?;
            let (stands, above) = arm.way_in(entry.as_ref().unwrap_or(&arm.home()), to)?;
            let moves = entry.iter().chain(&stands).map(|s| arm.joint_move(s));
            Some(moves.chain([arm.straight_move(&above, to)]).collect())
        }
        (Some(from), None) => {
            // The way in, backwards; home itself is gone to by the program's end.
            let exit = arm.gate(arm.setup.cell.air.exit_joints_deg)?;
            let (mut stands, out) = arm.way_in(exit.as_ref().unwrap_or(&arm.home()), from)?;
            stands.pop();
            let moves = stands.iter().rev().chain(&exit).map(|s| arm.joint_move(s));
            Some([arm.straight_move(from, &out)].into_iter().chain(moves).collect())
        }
        (Some(from), Some(to)) => {
            let tries: [&dyn Fn() -> Option<Vec<Go>>; 5] = [
                &|| arm.hop(from, to),
                &|| arm.by_safe_plane(from, to),
                &|| arm.by_one_joint_move(from, to),
                &|| arm.over_part(from, to),
                &|| arm.by_home(from, to),
            ];
            tries.iter().find_map(|way| way())
        }
    }
}

impl MovingArm<'_> {
    /// A hop: straight up, straight over, straight down.
    fn hop(&self, from: &ArmStand, to: &ArmStand) -> Option<Vec<Go>> {
        if !self.space.can_go_straight(&from.at, &to.at) {
            return None;
        }
        let up = self.along_beam(from, &self.space.drawn_back(&from.at), 1.0)?;
        let down = self.along_beam(to, &self.space.drawn_back(&to.at), 1.0)?;
        self.is_straight_move_clear(&up, &down)
            .then(|| vec![self.straight_move(from, &up), self.straight_move(&up, &down), self.straight_move(&down, to)])
    }

    /// Tool in hand: up to the safe plane, straight across, down.
    fn by_safe_plane(&self, from: &ArmStand, to: &ArmStand) -> Option<Vec<Go>> {
        let setup = self.setup;
        let height_mm = setup.cell.air.safe_plane_mm.filter(|_| setup.mount == Mount::ToolInHand)?;
        let base_from_part = setup.cell.base_from_part.isometry();
        let lifted = |stand: &ArmStand| {
            let back = self.along_beam(stand, &self.space.drawn_back(&stand.at), 1.0)?;
            let mut x = base_from_part * back.at.x;
            x.z = x.z.max(height_mm);
            let up = self.along_beam(&back, &Station { x: base_from_part.inverse() * x, ..back.at }, 1.0)?;
            Some((back, up))
        };
        let ((back, up), (down, above)) = (lifted(from)?, lifted(to)?);
        self.is_straight_move_clear(&up, &above).then(|| {
            let stands = [from, &back, &up, &above, &down, to];
            stands.windows(2).map(|w| self.straight_move(w[0], w[1])).collect()
        })
    }

    /// By way of home: out and home, then in from there.
    fn by_home(&self, from: &ArmStand, to: &ArmStand) -> Option<Vec<Go>> {
        let home = self.home();
        let (mut back, out) = self.way_in(&home, from)?;
        let (forth, above) = self.way_in(&home, to)?;
        back.pop();
        let moves = back.iter().rev().chain([&home]).chain(&forth).map(|s| self.joint_move(s));
        Some(
            [self.straight_move(from, &out)].into_iter().chain(moves).chain([self.straight_move(&above, to)]).collect(),
        )
    }

    /// Straight out, one move by joints, straight in.
    fn by_one_joint_move(&self, from: &ArmStand, to: &ArmStand) -> Option<Vec<Go>> {
        let (out, above) = (self.stands_above(from).next()?, self.stands_above(to).next()?);
        self.is_joint_move_clear(&out.joints_deg, &above.joints_deg)
            .then(|| vec![self.straight_move(from, &out), self.joint_move(&above), self.straight_move(&above, to)])
    }

    /// Straight out, over the part from station to station, straight in.
    fn over_part(&self, from: &ArmStand, to: &ArmStand) -> Option<Vec<Go>> {
        let (out, above) = (self.stands_above(from).next()?, self.stands_above(to).next()?);
        let stands = self.along_sphere(&out, &above)?;
        let moves = stands.iter().map(|s| self.joint_move(s));
        Some(
            [self.straight_move(from, &out)].into_iter().chain(moves).chain([self.straight_move(&above, to)]).collect(),
        )
    }

    fn home(&self) -> ArmStand {
        self.arm_stand(self.setup.home_joints_deg())
    }

    fn arm_stand(&self, joints_deg: Joints) -> ArmStand {
        ArmStand { at: Station::at(&self.mounted.focus_for(&self.robot.forward(&joints_deg))), joints_deg }
    }

    fn joint_move(&self, to: &ArmStand) -> Go {
        Go {
            to: to.at,
            interpolation: Interpolation::Joint,
            joints_deg: Some(to.joints_deg),
            timing: MoveTiming::Percent(self.setup.cell.air.home_percent),
            target: None,
        }
    }

    /// A straight move in the time that speed, turn and the slowest joint need.
    fn straight_move(&self, from: &ArmStand, to: &ArmStand) -> Go {
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
}
