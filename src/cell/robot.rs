//! A robot: kinematics, limits, speeds and its links. Its file is read in `file`.
//!
//! Joint angles are those of the file everywhere but in programs: where a controller couples joints
//! 2 and 3, its dialect adds and takes away. Limits are on absolute angles, over 360° too.

mod file;
mod link;
mod links;
mod meshes;

use super::opw::Opw;
use super::ur_kinematics::UrKinematics;
use nalgebra::Isometry3;
use serde::Deserialize;
use std::collections::BTreeMap;

pub use file::{RobotError, RobotFigureError};
pub use link::Link;
pub use links::{LinkCapsule, Links};
#[cfg(test)]
pub(crate) use meshes::tests::meshed;
pub use meshes::{LinkMesh, LinkMeshes, MOST_MESH_FACETS};

/// Keys of the shipped robots, and their files.
const SHIPPED: &[(&str, &str)] = super::shipped_files!("robots");

/// Angles of the six joints, degrees.
pub type Joints = [f64; 6];

/// A robot file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Robot {
    /// Name for people.
    pub name: String,
    /// The dialect of its controller.
    pub dialect: String,
    /// Whether the controller's joint 3 is this file's joint 3 less joint 2.
    pub couples_j2_j3: bool,
    /// Least and greatest angle of each joint.
    pub limits_deg: [[f64; 2]; 6],
    /// Full speed of each joint.
    pub speeds_deg_s: [f64; 6],
    /// From rest to full speed.
    pub acceleration_s: f64,
    /// Figures that nobody has checked.
    pub unverified: Vec<String>,
    /// Where each figure is from.
    pub sources: BTreeMap<String, String>,
    opw: Option<Opw>,
    ur: Option<UrKinematics>,
    /// The shape of the arm.
    pub links: Links,
}

impl Robot {
    /// Flange in the base, mm.
    pub fn forward(&self, joints_deg: &Joints) -> Isometry3<f64> {
        match (&self.opw, &self.ur) {
            (Some(opw), _) => opw.forward(joints_deg),
            (None, Some(ur)) => ur.forward(joints_deg),
            (None, None) => Isometry3::identity(),
        }
    }

    /// Frames that stand with the base and that move with each joint, in the base, mm; each joint's axis goes through
    /// the origin of its own.
    pub fn frames(&self, joints_deg: &Joints) -> [Isometry3<f64>; 7] {
        match (&self.opw, &self.ur) {
            (Some(opw), _) => opw.frames(joints_deg),
            (None, Some(ur)) => ur.frames(joints_deg),
            (None, None) => [Isometry3::identity(); 7],
        }
    }

    /// Joints for a pose of the flange, degrees in ±180, limits not looked at; the index names the
    /// branch.
    pub fn inverse(&self, base_from_flange: &Isometry3<f64>) -> [Option<Joints>; 8] {
        match (&self.opw, &self.ur) {
            (Some(opw), _) => opw.inverse(base_from_flange),
            (None, Some(ur)) => ur.inverse(base_from_flange),
            (None, None) => [None; 8],
        }
    }

    /// The solution nearest to some joints, within limits: turns and branch carry on from there.
    pub fn nearest_inverse(&self, base_from_flange: &Isometry3<f64>, joints_deg: &Joints) -> Option<Joints> {
        let carried_on = self.inverse(base_from_flange).into_iter().flatten().map(|solution| {
            std::array::from_fn(|j| solution[j] + 360.0 * libm::round((joints_deg[j] - solution[j]) / 360.0))
        });
        let farthest = |to: &Joints| (0..6).map(|j| (to[j] - joints_deg[j]).abs()).fold(0.0, f64::max);
        carried_on.filter(|joints| self.beyond(joints).is_none()).min_by(|a, b| farthest(a).total_cmp(&farthest(b)))
    }

    /// Distance from a singular pose, 0 (singular) to 1.
    pub fn singularity(&self, joints_deg: &Joints) -> f64 {
        match (&self.opw, &self.ur) {
            (Some(opw), _) => opw.singularity(joints_deg),
            (None, Some(ur)) => ur.singularity(joints_deg),
            (None, None) => 0.0,
        }
    }

    /// Length of the stretched arm from axis 2 to the flange, mm.
    pub fn reach_mm(&self) -> f64 {
        match (&self.opw, &self.ur) {
            (Some(o), _) => o.c2_mm + libm::hypot(o.a2_mm, o.c3_mm) + o.c4_mm.abs(),
            (None, Some(u)) => u.a2_mm.abs() + u.a3_mm.abs() + u.d5_mm.abs(),
            (None, None) => 0.0,
        }
    }

    /// The first joint that is beyond its limits, from 0.
    pub fn beyond(&self, joints_deg: &Joints) -> Option<usize> {
        (0..6).find(|&i| !(self.limits_deg[i][0]..=self.limits_deg[i][1]).contains(&joints_deg[i]))
    }

    /// Least distance of any joint from its limits, degrees; negative beyond.
    pub fn limit_margin_deg(&self, joints_deg: &Joints) -> f64 {
        (0..6)
            .map(|i| (joints_deg[i] - self.limits_deg[i][0]).min(self.limits_deg[i][1] - joints_deg[i]))
            .fold(f64::INFINITY, f64::min)
    }

    /// How far any point of the arm, up to the middle of the flange, is from each axis that moves
    /// it, at most, mm.
    pub fn levers_mm(&self) -> [f64; 6] {
        match (&self.opw, &self.ur) {
            (Some(opw), _) => opw.levers_mm(),
            (None, Some(ur)) => ur.levers_mm(),
            (None, None) => [0.0; 6],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::angle;
    use crate::part::rpy;
    use proptest::prelude::*;

    fn robot(key: &str) -> Robot {
        Robot::load(key, None).expect("shipped")
    }

    /// Pose pairs of a teach pendant: joints, then X, Y, Z, RZ, RY, RX.
    const PENDANT: [([f64; 6], [f64; 6]); 4] = [
        (
            [28.1579, -18.8069, 163.839, -0.710019, 35.8922, 152.731],
            [339.150, 182.108, 571.950, 0.301758, -1.00829, 0.060508],
        ),
        (
            [28.1557, -18.8049, 163.841, 34.0763, 35.8898, 152.727],
            [355.761, 163.565, 567.837, 29.5244, 3.54526, 19.2647],
        ),
        (
            [23.2932, -15.8386, 159.494, -35.6112, 53.2523, 185.217],
            [339.119, 182.571, 571.895, 6.5187, -18.922, -23.4265],
        ),
        (
            [-0.00219726, 0.00430813, 179.996, 0.00459559, 0.0046875, -0.000121055],
            [234.998, -0.00901, 692.029, -179.995, 0.00212, -0.00000003],
        ),
    ];

    fn agrees(at: &Isometry3<f64>, said: &[f64; 6]) {
        let there = nalgebra::Vector3::new(said[0], said[1], said[2]);
        assert!((at.translation.vector - there).norm() < 0.05, "{:?} for {said:?}", at.translation);
        let turn = rpy::to_rotation([said[3], said[4], said[5]]).rotation_to(&at.rotation.to_rotation_matrix());
        assert!(angle::turned_deg(&turn) < 0.01, "{} degrees for {said:?}", angle::turned_deg(&turn));
    }

    #[test]
    fn the_mz04_stands_where_its_pendant_says() {
        for (joints, said) in PENDANT {
            agrees(&robot("mz04").forward(&joints), &said);
        }
        let tool = nalgebra::Translation3::new(44.2, 0.0, 139.0);
        let joints = [25.5519, -22.283, 174.08, -0.767464, 29.1492, 155.426];
        let at = robot("mz04").forward(&joints) * tool;
        agrees(&at, &[357.026, 151.287, 711.747, 0.302115, -1.01447, 0.066286]);
        let forward = robot("mz04").forward(&[0.0, 90.0, 0.0, 0.0, 0.0, 0.0]);
        assert!((forward.translation.vector - nalgebra::Vector3::new(352.0, 0.0, 625.0)).norm() < 1e-9);
    }

    proptest! {
        /// Every branch leads back to the pose, and one of them to the joints.
        #[test]
        fn inverse_and_forward_agree(u in prop::array::uniform6(0.0..1.0f64), which in 0..12usize) {
            let robot = robot(Robot::shipped().nth(which).expect("twelve"));
            let joints: Joints = std::array::from_fn(|i| {
                let [low, high] = robot.limits_deg[i];
                low + (high - low) * u[i]
            });
            prop_assume!(robot.singularity(&joints) > 1e-3);
            let pose = robot.forward(&joints);
            let found: Vec<Joints> = robot.inverse(&pose).into_iter().flatten().collect();
            prop_assert!(!found.is_empty());
            for f in &found {
                let back = robot.forward(f);
                prop_assert!((back.translation.vector - pose.translation.vector).norm() < 1e-6);
                prop_assert!(back.rotation.angle_to(&pose.rotation) < 1e-8);
                prop_assert!(f.iter().all(|d| d.abs() <= 180.0 + 1e-9));
            }
            let near = |f: &Joints| (0..6).all(|i| {
                let d = f[i] - joints[i];
                (d - 360.0 * (d / 360.0).round()).abs() < 1e-6
            });
            prop_assert!(found.iter().any(near), "{joints:?} among {found:?}");
        }
    }

    proptest! {
        /// Turning one joint moves nothing farther than its lever tells.
        #[test]
        fn no_point_moves_farther_than_its_lever(u in prop::array::uniform6(0.0..1.0f64), which in 0..12usize,
                                                 joint in 0..6usize, turn in 0.1..30.0f64) {
            let robot = robot(Robot::shipped().nth(which).expect("twelve"));
            let joints: Joints = std::array::from_fn(|i| {
                let [low, high] = robot.limits_deg[i];
                low + (high - low) * u[i]
            });
            let mut turned = joints;
            turned[joint] += turn;
            // What moves with a joint, and nothing before it; its axis stays.
            let (still, moved) = (robot.frames(&joints), robot.frames(&turned));
            for k in 0..=joint {
                prop_assert!((still[k].to_homogeneous() - moved[k].to_homogeneous()).norm() < 1e-9, "joint {joint}, frame {k}");
            }
            let axis = (moved[joint + 1].translation.vector - still[joint + 1].translation.vector).norm();
            prop_assert!(axis < 1e-9, "the axis of joint {joint} moves {axis} mm");
            let held = |frames: &[Isometry3<f64>; 7], joints: &Joints| frames[6].inv_mul(&robot.forward(joints));
            let slip = held(&still, &joints).to_homogeneous() - held(&moved, &turned).to_homogeneous();
            prop_assert!(slip.norm() < 1e-9, "the flange leaves what carries it");
            let reach = robot.levers_mm()[joint] * turn.to_radians();
            for (before, after) in robot.capsules(&joints).iter().zip(&robot.capsules(&turned)) {
                let moved = (after.from - before.from).norm().max((after.to - before.to).norm());
                prop_assert!(moved <= reach + 1e-9, "{:?} moves {moved} of {reach}", before.link);
            }
        }
    }
}
