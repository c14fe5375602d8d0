//! Which of the arm's shapes joint angles stand for, as ABB and Yaskawa name them in positions.
//!
//! For arms of those makes: at 0 axis 1 faces along x and turns about z.

use crate::cell::{Joints, Robot};

/// A shape of the arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArmShape {
    /// The wrist is behind axis 1.
    pub over_the_back: bool,
    /// The wrist is behind the line of the lower arm: the elbow hangs.
    pub elbow_down: bool,
}

impl ArmShape {
    /// The shape at joint angles, degrees.
    pub fn of(robot: &Robot, joints_deg: &Joints) -> ArmShape {
        let (sin, cos) = libm::sincos(joints_deg[0].to_radians());
        let [_, _, upper_arm, forearm, _] = robot.capsules(joints_deg);
        let ahead = |v: nalgebra::Vector3<f64>| v.x * cos + v.y * sin;
        let arm = upper_arm.to - upper_arm.from;
        let reach = forearm.to - upper_arm.from;
        ArmShape {
            over_the_back: ahead(forearm.to.coords) < 0.0,
            elbow_down: arm.z * ahead(reach) - ahead(arm) * reach.z < 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_of_the_irb120() {
        let robot = Robot::load("irb120", None).expect("shipped");
        let shape = |j: Joints| {
            let s = ArmShape::of(&robot, &j);
            (s.over_the_back, s.elbow_down)
        };
        assert_eq!(shape([0.0; 6]), (false, false));
        assert_eq!(shape([120.0, 20.0, 10.0, 0.0, 0.0, 0.0]), (false, false), "whatever axis 1 does");
        assert_eq!(shape([0.0, -80.0, -20.0, 0.0, 0.0, 0.0]), (true, false), "leaning back");
        // Lower arm 60 degrees from upright, elbow to wrist atan2(145, 274) = 28: above the lower arm.
        assert_eq!(shape([0.0, 60.0, -109.0, 0.0, 0.0, 0.0]), (false, true));
    }
}
