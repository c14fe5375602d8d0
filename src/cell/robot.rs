//! A robot: kinematics, limits, speeds and the thickness of its links, from a TOML file.
//!
//! Joint angles are those of the file everywhere but in programs: where a controller couples joints
//! 2 and 3, its dialect adds and takes away. Limits are on absolute angles, over 360° too.

use super::opw::Opw;
use super::ur::Ur;
use nalgebra::{Isometry3, Point3};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;
use thiserror::Error;

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
    ur: Option<Ur>,
    /// Radii of the capsules that stand for the arm.
    pub links: Links,
}

/// Radii of the capsules that stand for the arm, mm.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Links {
    /// Base to axis 2.
    pub base_mm: f64,
    /// Around axis 2.
    pub shoulder_mm: f64,
    /// Axis 2 to axis 3.
    pub upper_arm_mm: f64,
    /// Axis 3 to the wrist.
    pub forearm_mm: f64,
    /// Wrist to flange.
    pub wrist_mm: f64,
}

/// A link as a capsule in the base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkCapsule {
    /// Name for people.
    pub name: &'static str,
    /// One end of its axis, mm.
    pub from: Point3<f64>,
    /// The other.
    pub to: Point3<f64>,
    /// mm.
    pub radius_mm: f64,
}

/// Why a robot cannot be used.
#[derive(Debug, Error)]
pub enum RobotError {
    /// Neither a shipped robot nor a file.
    #[error("{name:?} is neither a shipped robot ({shipped}) nor a robot file")]
    Unknown {
        /// What was asked for.
        name: String,
        /// Those there are.
        shipped: String,
    },
    /// It cannot be read.
    #[error("{file}: cannot be read: {source}")]
    Io {
        /// The file.
        file: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// It is no robot file, or a figure is missing.
    #[error("{file}: {message}")]
    Toml {
        /// The file.
        file: String,
        /// Where and what.
        message: String,
    },
    /// A figure makes no sense.
    #[error("{file}: {what}")]
    Figure {
        /// The file.
        file: String,
        /// Which, and what it may be.
        what: String,
    },
}

/// Keys of the shipped robots, and their files.
const SHIPPED: &[(&str, &str)] = super::shipped_files!("robots");

impl Robot {
    /// Keys of the shipped robots.
    pub fn shipped() -> impl Iterator<Item = &'static str> {
        SHIPPED.iter().map(|(key, _)| *key)
    }

    /// Whether a name is the key of a shipped robot, and not a file.
    pub fn is_shipped(name: &str) -> bool {
        Robot::shipped().any(|key| key == name)
    }

    /// A shipped robot by its key, or a robot file by its path.
    ///
    /// # Errors
    /// It is neither, or has missing or absurd figures.
    pub fn load(name: &str, beside: Option<&Path>) -> Result<Robot, RobotError> {
        if let Some((key, text)) = SHIPPED.iter().find(|(key, _)| *key == name) {
            return Robot::parse(text, &format!("assets/robots/{key}.toml"));
        }
        let path = beside.map_or_else(|| name.into(), |folder| folder.join(name));
        if !path.is_file() {
            let shipped = Robot::shipped().collect::<Vec<_>>().join(" ");
            return Err(RobotError::Unknown { name: name.into(), shipped });
        }
        let file = path.display().to_string();
        let text = std::fs::read_to_string(&path).map_err(|source| RobotError::Io { file: file.clone(), source })?;
        Robot::parse(&text, &file)
    }

    fn parse(text: &str, file: &str) -> Result<Robot, RobotError> {
        let robot: Robot = toml::from_str(text).map_err(|e| RobotError::Toml {
            file: file.into(),
            message: e.to_string().trim_end().replace('\n', " "),
        })?;
        robot.check().map_err(|what| RobotError::Figure { file: file.into(), what })?;
        Ok(robot)
    }

    fn check(&self) -> Result<(), String> {
        let lengths: Vec<(&str, f64)> = match (&self.opw, &self.ur) {
            (Some(opw), None) => opw.lengths().to_vec(),
            (None, Some(ur)) => ur.lengths().to_vec(),
            _ => return Err("give the kinematics once, as [opw] or as [ur]".into()),
        };
        if let Some((name, mm)) = lengths.iter().find(|(_, mm)| !mm.is_finite() || mm.abs() > 5000.0) {
            return Err(format!("{name} = {mm}: give mm, within ±5000"));
        }
        if let Some(opw) = &self.opw {
            for (name, mm) in [("c2_mm", opw.c2_mm), ("c3_mm", opw.c3_mm)] {
                if mm < 10.0 {
                    return Err(format!(
                        "{name} = {mm}: an arm and a forearm are at least 10 mm long; metres instead of mm?"
                    ));
                }
            }
            if let Some(sign) = opw.signs.iter().find(|s| s.abs() != 1.0) {
                return Err(format!("signs has {sign}: give 1 or -1"));
            }
            if let Some(deg) = opw.offsets_deg.iter().find(|d| !(-360.0..=360.0).contains(*d)) {
                return Err(format!("offsets_deg has {deg}: give degrees within ±360"));
            }
        }
        if let Some(ur) = &self.ur
            && (ur.a2_mm.abs() < 10.0 || ur.a3_mm.abs() < 10.0 || ur.d6_mm.abs() < 1.0)
        {
            return Err("a2_mm, a3_mm and d6_mm are an arm's, mm; metres instead of mm?".into());
        }
        for (i, (limits, speed)) in self.limits_deg.iter().zip(&self.speeds_deg_s).enumerate() {
            let [low, high] = *limits;
            if !(low < high && low >= -3600.0 && high <= 3600.0) {
                return Err(format!("limits_deg of J{}: {low} to {high} is no range of degrees", i + 1));
            }
            if !(1.0..=5000.0).contains(speed) {
                return Err(format!("speeds_deg_s of J{} = {speed}: give 1 to 5000", i + 1));
            }
        }
        if !(0.01..=10.0).contains(&self.acceleration_s) {
            return Err(format!("acceleration_s = {}: give 0.01 to 10", self.acceleration_s));
        }
        let l = &self.links;
        for (name, mm) in [
            ("base_mm", l.base_mm),
            ("shoulder_mm", l.shoulder_mm),
            ("upper_arm_mm", l.upper_arm_mm),
            ("forearm_mm", l.forearm_mm),
            ("wrist_mm", l.wrist_mm),
        ] {
            if !(0.0..=1000.0).contains(&mm) {
                return Err(format!("links.{name} = {mm}: give a radius of 0 to 1000"));
            }
        }
        Ok(())
    }

    /// Flange in the base, mm.
    pub fn forward(&self, joints_deg: &Joints) -> Isometry3<f64> {
        match (&self.opw, &self.ur) {
            (Some(opw), _) => opw.forward(joints_deg),
            (None, Some(ur)) => ur.forward(joints_deg),
            (None, None) => Isometry3::identity(),
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
    pub fn near(&self, base_from_flange: &Isometry3<f64>, joints_deg: &Joints) -> Option<Joints> {
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

    /// The arm as capsules in the base, from the base to the flange.
    pub fn capsules(&self, joints_deg: &Joints) -> [LinkCapsule; 5] {
        let [shoulder, elbow, wrist, flange] = match (&self.opw, &self.ur) {
            (Some(opw), _) => opw.points(joints_deg),
            (None, Some(ur)) => ur.points(joints_deg),
            (None, None) => [Point3::origin(); 4],
        };
        let column = Point3::new(0.0, 0.0, shoulder.z);
        let l = &self.links;
        let link = |name, from, to, radius_mm| LinkCapsule { name, from, to, radius_mm };
        [
            link("base", Point3::origin(), column, l.base_mm),
            link("shoulder", column, shoulder, l.shoulder_mm),
            link("upper arm", shoulder, elbow, l.upper_arm_mm),
            link("forearm", elbow, wrist, l.forearm_mm),
            link("wrist", wrist, flange, l.wrist_mm),
        ]
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
            let robot = robot(SHIPPED[which].0);
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
            let robot = robot(SHIPPED[which].0);
            let joints: Joints = std::array::from_fn(|i| {
                let [low, high] = robot.limits_deg[i];
                low + (high - low) * u[i]
            });
            let mut turned = joints;
            turned[joint] += turn;
            let reach = robot.levers_mm()[joint] * turn.to_radians();
            for (before, after) in robot.capsules(&joints).iter().zip(&robot.capsules(&turned)) {
                let moved = (after.from - before.from).norm().max((after.to - before.to).norm());
                prop_assert!(moved <= reach + 1e-9, "{} moves {moved} of {reach}", before.name);
            }
        }
    }

    #[test]
    fn absurd_and_missing_figures_are_named() {
        let (_, text) = SHIPPED[0];
        let said =
            |from: &str, to: &str| Robot::parse(&text.replace(from, to), "my.toml").expect_err("refused").to_string();
        assert!(said("c2_mm = 260.0\n", "").contains("c2_mm"), "{}", said("c2_mm = 260.0\n", ""));
        assert!(said("c2_mm = 260.0", "c2_mm = 0.26").contains("metres instead of mm"));
        assert!(said("[-170.0, 170.0]", "[170.0, -170.0]").contains("J1"));
        assert!(said("900.0]", "0.0]").contains("J6"));
        assert!(said("wrist_mm = ", "wrist_mm = -").contains("links.wrist_mm"));
        let unknown = Robot::load("puma560", None).expect_err("none").to_string();
        assert!(unknown.contains("mz04") && unknown.contains("puma560"));
    }
}
