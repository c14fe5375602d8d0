//! Whether a move that the arm could make is clear, and where it stands along the beam.

use super::MovingArm;
use crate::cell::collision::Collision;
use crate::cell::{Joints, Mount};
use crate::program::connecting::pose_cache::ArmStand;
use crate::program::neutral::steps::Station;

/// On a move by joints no joint turns further than this between two looks, degrees.
const LOOK_DEG: f64 = 1.0;
/// On a straight move the focus goes no further than this between two looks, mm.
const LOOK_MM: f64 = 0.5;
/// On a straight move the part turns no further than this between two looks, degrees.
const LOOK_TURN_DEG: f64 = 2.0;
/// A straight connecting move turns no joint further than this.
const MOST_STRAIGHT_DEG: f64 = 60.0;
/// How much of the way out to the sphere is tried, in steps of this share.
const OUT_STEPS: usize = 8;

impl MovingArm<'_> {
    /// The arm at a station, by the solution nearest to some joints.
    pub(super) fn arm_stand_at(&self, at: Station, near: &Joints) -> Option<ArmStand> {
        let joints_deg = self.robot.nearest_inverse(&self.mounted.flange_for(&at.frame()), near)?;
        Some(ArmStand { at, joints_deg })
    }

    /// The arm drawn back along the beam, by a share of the way to the station `end`; `None`: that is not clear.
    pub(super) fn along_beam(&self, from: &ArmStand, end: &Station, share: f64) -> Option<ArmStand> {
        let mut here = *from;
        for k in 1..=4 {
            let x = from.at.x + (end.x - from.at.x) * (share * f64::from(k) / 4.0);
            let next = self.arm_stand_at(Station { x, ..from.at }, &here.joints_deg)?;
            let touches = |c: &Collision<'_>| c.first_contact_between(&here.joints_deg, &next.joints_deg).is_some();
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

    /// Poses straight above a piece's end: on the sphere around the part, then nearer and nearer.
    pub(super) fn stands_above<'b>(&'b self, stand: &'b ArmStand) -> impl Iterator<Item = ArmStand> + 'b {
        let sphere = self.space.on_sphere(&stand.at);
        (1..=OUT_STEPS).rev().filter_map(move |k| self.along_beam(stand, &sphere, k as f64 / OUT_STEPS as f64))
    }

    /// Whether nothing is in the way of a move by joints. Where the head is known, it is what must not
    /// touch a part in hand; where it is not, the beam stands for it.
    pub(super) fn is_joint_move_clear(&self, from: &Joints, to: &Joints) -> bool {
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
            && self.collision.is_none_or(|c| c.first_contact_between(from, to).is_none())
    }

    /// Whether nothing is in the way where the flange goes straight, and the arm can follow.
    pub(super) fn is_straight_move_clear(&self, from: &ArmStand, to: &ArmStand) -> bool {
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
            match self.robot.nearest_inverse(&flange, &here) {
                Some(joints) if farthest(&here, &joints) <= 0.5 * MOST_STRAIGHT_DEG => here = joints,
                _ => return false,
            }
            let touches = self.collision.is_some_and(|c| c.first_contact(&here).is_some());
            if touches || !self.space.is_clear_at(&setup.focus_for(&flange)) {
                return false;
            }
        }
        // The way must end in the joints that the next piece starts from.
        farthest(&here, &to.joints_deg) < 1e-6
    }
}

/// Largest difference of a joint, degrees.
pub(super) fn farthest(a: &Joints, b: &Joints) -> f64 {
    (0..6).map(|j| (a[j] - b[j]).abs()).fold(0.0, f64::max)
}
