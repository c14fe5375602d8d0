//! Ways over the part, station by station, and ways in from home by gates around it.

use super::clear::farthest;
use super::{MovingArm, WayIn};
use crate::cell::Joints;
use crate::cell::motion::{Arm, ArmState};
use crate::part::angle;
use crate::program::connecting::pose_cache::{ArmStand, bits};
use crate::program::neutral::steps::Station;
use nalgebra::Vector3;

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

impl MovingArm<'_> {
    /// The entry or exit pose of the cell, if it has one; `None`: the move to it from home is not clear.
    pub(super) fn gate(&self, joints_deg: Option<Joints>) -> Option<Option<ArmStand>> {
        let Some(joints) = joints_deg else { return Some(None) };
        self.is_joint_move_clear(&self.setup.home_joints_deg(), &joints).then(|| Some(self.arm_stand(joints)))
    }

    /// Stands from home (or a gate) to straight above a piece's end, that one included and given once
    /// more: at once, or by stands around the part from which a way leads over it.
    pub(super) fn way_in(&self, from: &ArmStand, to: &ArmStand) -> Option<WayIn> {
        self.cache.ways_in.get([from, to].map(|s| bits(&s.joints_deg)), || self.new_way_in(from, to))
    }

    fn new_way_in(&self, from: &ArmStand, to: &ArmStand) -> Option<WayIn> {
        let home = from.joints_deg;
        if let Some(above) = self.stands_above(to).find(|above| self.is_joint_move_clear(&home, &above.joints_deg)) {
            return Some((vec![above], above));
        }
        let above = self.stands_above(to).next()?;
        let arm = Arm::with_step(self.robot, self.setup, 2.0 * SPINS_DEG);
        let mut gates: Vec<(f64, ArmStand)> = Vec::new();
        for direction in DIRECTIONS {
            let radial = Vector3::from(direction).normalize();
            let station = self.space.on_top(&radial, &angle::any_square_to(&radial));
            let states = arm.states(&station.frame()).unwrap_or_default();
            gates.extend(states.iter().map(|s| {
                let at = Station::at(&arm.with_spin(&station.frame(), s.spin));
                let length = farthest(&home, &s.joints_deg) + farthest(&s.joints_deg, &above.joints_deg);
                (length, ArmStand { at, joints_deg: s.joints_deg })
            }));
        }
        gates.sort_by(|a, b| a.0.total_cmp(&b.0));
        // All pieces share the gates.
        let is_open =
            |gate: &Joints| self.cache.clear.get([&home, gate].map(bits), || self.is_joint_move_clear(&home, gate));
        let open = gates.iter().filter(|g| is_open(&g.1.joints_deg)).take(MOST_TRIED);
        open.into_iter().find_map(|(_, gate)| {
            let mut stands = vec![*gate];
            stands.extend(self.along_sphere(gate, &above)?);
            Some((stands, above))
        })
    }

    /// Poses of the arm over the part from one to another, the last one included. The spin turns on the way as well.
    pub(super) fn along_sphere(&self, out: &ArmStand, above: &ArmStand) -> Option<Vec<ArmStand>> {
        let (u, v) = (self.space.radial(&out.at)?, self.space.radial(&above.at)?);
        let arc = angle::GreatCircle::new(&u, &v);
        let (p, q) = (out.at.frame().rotation, above.at.frame().rotation);
        let steps = (angle::between_deg(&u, &v).max(out.at.turn_deg(&above.at)) / ARC_DEG).ceil().max(1.0) as usize;
        let arm = Arm::with_step(self.robot, self.setup, SPINS_DEG);
        let mut stands = Vec::new();
        let mut here = *out;
        for k in 0..=steps {
            let t = k as f64 / steps as f64;
            let station = self.space.on_top(&arc.at(t), &(p.slerp(&q, t) * Vector3::y()));
            let next = self
                .arm_stand_at(station, &here.joints_deg)
                .filter(|n| self.is_joint_move_clear(&here.joints_deg, &n.joints_deg));
            here = match next.or_else(|| self.any_arm_stand(&arm, &station, &here.joints_deg, &above.joints_deg)) {
                Some(next) => next,
                // The last station stands where the next move would begin: it may be left out.
                None if k == steps => break,
                None => return None,
            };
            stands.push(here);
        }
        self.is_joint_move_clear(&here.joints_deg, &above.joints_deg).then(|| {
            stands.push(*above);
            stands
        })
    }

    /// The arm at a station with any spin: the pose that lies best between two others.
    fn any_arm_stand(&self, arm: &Arm<'_>, station: &Station, from: &Joints, to: &Joints) -> Option<ArmStand> {
        let states = arm.states(&station.frame()).ok()?;
        let length = |s: &ArmState| farthest(from, &s.joints_deg) + 0.5 * farthest(&s.joints_deg, to);
        let mut order: Vec<(f64, &ArmState)> = states.iter().map(|s| (length(s), s)).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        order
            .into_iter()
            .take(MOST_TRIED)
            .map(|(_, s)| ArmStand {
                at: Station::at(&arm.with_spin(&station.frame(), s.spin)),
                joints_deg: s.joints_deg,
            })
            .find(|n| self.is_joint_move_clear(from, &n.joints_deg))
    }
}
