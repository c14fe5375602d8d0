//! Flange poses as six printed numbers, and the speed that gives a move its duration, for controllers
//! that take a speed of the flange and no time. Both ways: what is written is read by the same rule.

use crate::cell::controllers::templates::{fixed, number};
use crate::cell::{Joints, Setup};
use crate::part::rpy;
use crate::program::neutral::lines::ProgramLine;
use crate::program::neutral::steps::Interpolation;
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};

/// Decimals of millimetres in a program: half a micrometre.
const MM: usize = 3;
/// Decimals of degrees: 2 would cost 0.16 mm at 650 mm.
const DEG: usize = 4;

/// X, Y, Z in mm, then the angles about Z, Y and X in degrees.
pub fn printed(base_from_flange: &Isometry3<f64>) -> [String; 6] {
    let [x, y, z]: [f64; 3] = base_from_flange.translation.vector.into();
    let [rz, ry, rx] = rpy::from_rotation(&base_from_flange.rotation.to_rotation_matrix());
    [fixed(x, MM), fixed(y, MM), fixed(z, MM), fixed(rz, DEG), fixed(ry, DEG), fixed(rx, DEG)]
}

/// The pose of X, Y, Z in mm and the angles about Z, Y and X in degrees.
pub fn pose([x, y, z, rz, ry, rx]: [f64; 6]) -> Isometry3<f64> {
    let turn = UnitQuaternion::from_rotation_matrix(&rpy::to_rotation([rz, ry, rx]));
    Isometry3::from_parts(Translation3::new(x, y, z), turn)
}

/// The pose that a reader makes of the printed one.
pub fn as_read(base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
    pose(printed(base_from_flange).map(|n| number(&n).unwrap_or(0.0)))
}

/// Joint angles as the controller counts them, printed.
pub fn printed_joints(setup: &Setup, joints_deg: &Joints) -> [String; 6] {
    coupled(setup, joints_deg, -1.0).map(|j| fixed(j, DEG))
}

/// Joint angles as the robot file counts them.
pub fn joints(setup: &Setup, pendant_deg: &Joints) -> Joints {
    coupled(setup, pendant_deg, 1.0)
}

/// With `sign` times joint 2 added to joint 3, where the controller couples them: −1 makes the
/// controller's angles of the robot file's, 1 the other way.
pub fn coupled(setup: &Setup, joints_deg: &Joints, sign: f64) -> Joints {
    let couples = setup.robot.as_ref().is_some_and(|r| r.couples_j2_j3);
    let [j1, j2, j3, j4, j5, j6] = *joints_deg;
    [j1, j2, if couples { j3 + sign * j2 } else { j3 }, j4, j5, j6]
}

/// Where the flange is at joint angles as printed; `None` without a robot.
pub fn printed_flange_at(setup: &Setup, joints_deg: &Joints) -> Option<Isometry3<f64>> {
    let as_printed = printed_joints(setup, joints_deg).map(|n| number(&n).unwrap_or(0.0));
    setup.robot.as_ref().map(|r| r.forward(&joints(setup, &as_printed)))
}

/// How far a move takes the flange.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Travel {
    /// Way of its origin, mm.
    pub mm: f64,
    /// Angle that it turns by, degrees.
    pub deg: f64,
}

impl Travel {
    /// From one pose to another.
    pub fn between(from: &Isometry3<f64>, to: &Isometry3<f64>) -> Travel {
        let way: Vector3<f64> = to.translation.vector - from.translation.vector;
        let q = from.rotation.rotation_to(&to.rotation);
        Travel { mm: way.norm(), deg: 2.0 * libm::atan2(q.imag().norm(), q.w.abs()).to_degrees() }
    }

    /// Whether the flange turns on the spot: then its way is too short to set a speed by.
    pub fn is_turn(&self) -> bool {
        self.mm < 0.01 * self.deg
    }

    /// The speeds of way and angle that take so many seconds, for a controller that keeps to both:
    /// the one that does not count is left at its greatest. Neither is faster than that, and then
    /// the move takes longer.
    pub fn speeds(&self, seconds: f64, most: Speeds) -> Speeds {
        let seconds = seconds.max(SHORTEST_S);
        if self.is_turn() {
            Speeds { deg_s: (self.deg / seconds).clamp(1e-4, most.deg_s), ..most }
        } else {
            Speeds { mm_s: (self.mm / seconds).clamp(1e-4, most.mm_s), ..most }
        }
    }

    /// How long the controller takes, s.
    pub fn seconds(&self, speeds: Speeds) -> f64 {
        (self.mm / speeds.mm_s).max(self.deg / speeds.deg_s)
    }
}

/// Speeds of the flange.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speeds {
    /// Speed of the flange's origin, mm/s.
    pub mm_s: f64,
    /// Speed of its rotation, degrees per second.
    pub deg_s: f64,
}

/// Whether the move at `index` is followed by another straight one, so that the controller need not
/// stop at its end. Where an output changes it has to.
pub fn flows_on(lines: &[ProgramLine], index: usize) -> bool {
    let next = lines.iter().skip(index + 1).find(|l| !matches!(l, ProgramLine::Comment(_)));
    matches!(next, Some(ProgramLine::Move(m)) if m.interpolation == Interpolation::Linear)
}

/// Shortest duration, s: none would ask for infinite speed.
pub const SHORTEST_S: f64 = 0.001;

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// 3 decimals of a mm, 4 of a degree: 0.01 mm at a lever of 700 mm.
        #[test]
        fn printed_poses_are_near(p in prop::array::uniform3(-1500.0..1500.0f64), a in prop::array::uniform3(-180.0..180.0f64)) {
            let at = pose([p[0], p[1], p[2], a[0], a[1], a[2]]);
            let back = as_read(&at);
            let lever = nalgebra::Point3::new(0.0, 420.0, 560.0);
            prop_assert!((at * lever - back * lever).norm() < 0.01);
            prop_assert!(Travel::between(&at, &back).deg < 0.01);
        }
    }

    #[test]
    fn travel_is_way_and_angle() {
        let travel = Travel::between(&pose([1.0, 2.0, 3.0, 10.0, 0.0, 0.0]), &pose([4.0, 6.0, 3.0, -20.0, 0.0, 0.0]));
        assert!((travel.mm - 5.0).abs() < 1e-12 && (travel.deg - 30.0).abs() < 1e-9, "{travel:?}");
        let most = Speeds { mm_s: 100.0, deg_s: 90.0 };
        assert_eq!(travel.speeds(2.0, most), Speeds { mm_s: 2.5, deg_s: 90.0 });
        assert!((travel.seconds(travel.speeds(2.0, most)) - 2.0).abs() < 1e-12);
        assert!((travel.seconds(travel.speeds(0.01, most)) - travel.deg / 90.0).abs() < 1e-12, "no faster than that");
        let turn = Travel { mm: 0.001, deg: 30.0 };
        assert_eq!(turn.speeds(2.0, most), Speeds { mm_s: 100.0, deg_s: 15.0 });
    }
}
