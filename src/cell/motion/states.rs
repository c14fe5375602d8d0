//! The states of the arm at one target: every spin, branch and turn by which it can bring the beam there.

use crate::cell::mounting::Mounted;
use crate::cell::{Joints, Robot, Setup, Spin};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};

/// Spins are this far apart: 72 of them. Finer ones cost time and gain a fraction of a degree.
pub const SPIN_STEP_DEG: f64 = 5.0;
/// Poses nearer to a singularity are not taken: there 1 degree of the part is 30 of a joint.
pub const LEAST_SINGULARITY: f64 = 0.03;
/// A joint beyond half a turn is looked at up to here on either side of its other reading, degrees:
/// farther than any single move.
const PAST_HALF_TURN_DEG: f64 = 225.0;

/// A robot in its cell, and the spins it may take.
#[derive(Clone, Debug)]
pub struct Arm<'a> {
    /// The robot.
    pub robot: &'a Robot,
    mounted: Mounted,
    /// Rotation by each spin about the beam axis.
    spins: Vec<(f64, UnitQuaternion<f64>)>,
}

/// A state of the arm at a target: its joints, the spin, and the branch of the inverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmState {
    /// Within their limits.
    pub joints_deg: Joints,
    /// Number of the spin.
    pub spin: u8,
    /// Branch of the inverse.
    pub branch: u8,
    /// Number of the reading of its turns, as [`turns`] counts them.
    pub turn: u8,
    /// Distance from a singular pose, 0 to 1.
    pub singularity: f64,
}

/// The solutions of the arm at a path frame, by spin and branch, each with its distance from a singular pose.
pub struct ArmSolutions(Vec<[Option<(Joints, f64)>; 8]>);

/// Why a path frame has no state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoState {
    /// No solution at any spin.
    Reach,
    /// Solutions, but in each a joint is beyond its limits; the least overrun that was found.
    Limit {
        /// Joint, from 0.
        joint: usize,
        /// Angle it would need, degrees.
        needs_deg: f64,
    },
    /// Only poses next to a singularity.
    Singularity,
}

impl ArmSolutions {
    /// How many solutions it has room for.
    pub fn room(&self) -> usize {
        8 * self.0.len()
    }
}

impl<'a> Arm<'a> {
    /// The arm of a setup, with the spins that are wanted; `None` without a robot.
    pub fn new(setup: &'a Setup, spin: Spin) -> Option<Arm<'a>> {
        let step = match setup.spin(spin) {
            Spin::Free => SPIN_STEP_DEG,
            // Along the travel, or against it.
            Spin::Travel => 180.0,
        };
        Some(Arm::with_step(setup.robot.as_ref()?, setup, step))
    }

    /// The arm of a setup with spins so far apart: searches over many poses look at fewer.
    pub fn with_step(robot: &'a Robot, setup: &'a Setup, step_deg: f64) -> Arm<'a> {
        let count = (360.0 / step_deg).round() as usize;
        let spins = (0..count).map(|k| (k as f64 * step_deg, about_beam(k as f64 * step_deg))).collect();
        Arm { robot, mounted: setup.mounted(), spins }
    }

    /// How many spins there are.
    pub fn spins(&self) -> usize {
        self.spins.len()
    }

    /// A spin in degrees, in (−180, 180].
    pub fn spin_deg(&self, spin: u8) -> f64 {
        let deg = self.spins[usize::from(spin)].0;
        if deg > 180.0 { deg - 360.0 } else { deg }
    }

    /// A path frame turned by a spin.
    pub fn with_spin(&self, part_from_focus: &Isometry3<f64>, spin: u8) -> Isometry3<f64> {
        Isometry3::from_parts(part_from_focus.translation, part_from_focus.rotation * self.spins[usize::from(spin)].1)
    }

    /// Pose of the flange for a path frame.
    pub fn flange_for(&self, part_from_focus: &Isometry3<f64>) -> Isometry3<f64> {
        self.mounted.flange_for(part_from_focus)
    }

    /// All states at a path frame, by branch, then by spin.
    ///
    /// # Errors
    /// There is none, and why.
    pub fn states(&self, part_from_focus: &Isometry3<f64>) -> Result<Vec<ArmState>, NoState> {
        self.readings(&self.solutions(part_from_focus))
    }

    /// All solutions at a path frame.
    pub fn solutions(&self, part_from_focus: &Isometry3<f64>) -> ArmSolutions {
        let of_spin = |spin: usize| {
            let solved = self.robot.inverse(&self.flange_for(&self.with_spin(part_from_focus, spin as u8)));
            solved.map(|joints| joints.map(|joints| (joints, self.robot.singularity(&joints))))
        };
        ArmSolutions((0..self.spins.len()).map(of_spin).collect())
    }

    /// The states that solutions are read as, by branch, then by spin.
    ///
    /// # Errors
    /// There is none, and why.
    pub fn readings(&self, of: &ArmSolutions) -> Result<Vec<ArmState>, NoState> {
        let mut out = Vec::new();
        let (mut reached, mut least): (bool, Option<(f64, usize, f64)>) = (false, None);
        let mut singular = false;
        for branch in 0..8 {
            for (spin, solutions) in of.0.iter().enumerate() {
                let Some((joints, singularity)) = solutions[branch] else { continue };
                reached = true;
                let before = out.len();
                let is_singular = singularity < LEAST_SINGULARITY;
                for (turn, joints_deg) in turns(&joints, &self.robot.limits_deg).take(256).enumerate() {
                    if is_singular {
                        singular = true;
                    } else {
                        let (spin, branch, turn) = (spin as u8, branch as u8, turn as u8);
                        out.push(ArmState { joints_deg, spin, branch, turn, singularity });
                    }
                }
                if out.len() == before && !is_singular {
                    let worst = worst_overrun(&joints, &self.robot.limits_deg);
                    least = Some(least.filter(|l| l.0 <= worst.0).unwrap_or(worst));
                }
            }
        }
        if !out.is_empty() {
            return Ok(out);
        }
        Err(match least {
            _ if !reached => NoState::Reach,
            _ if singular => NoState::Singularity,
            Some((_, joint, needs_deg)) => NoState::Limit { joint, needs_deg },
            None => NoState::Singularity,
        })
    }
}

impl Arm<'_> {
    /// The state of that spin, branch and reading, as [`Arm::states`] made it.
    pub fn state(&self, part_from_focus: &Isometry3<f64>, spin: u8, branch: u8, turn: u8) -> Option<ArmState> {
        let solutions = self.robot.inverse(&self.flange_for(&self.with_spin(part_from_focus, spin)));
        let joints = solutions[usize::from(branch)]?;
        let joints_deg = turns(&joints, &self.robot.limits_deg).nth(usize::from(turn))?;
        Some(ArmState { joints_deg, spin, branch, turn, singularity: self.robot.singularity(&joints) })
    }
}

/// Rotation about the beam axis (z of a path frame).
pub fn about_beam(deg: f64) -> UnitQuaternion<f64> {
    let (s, c) = libm::sincos(0.5 * deg.to_radians());
    UnitQuaternion::new_unchecked(nalgebra::Quaternion::from_parts(c, Vector3::new(0.0, 0.0, s)))
}

/// Every reading of a solution within the limits: a joint may stand a whole turn further.
///
/// All but the last joint are read twice only next to half a turn, where a motion may carry on.
pub fn turns(joints_deg: &Joints, limits_deg: &[[f64; 2]; 6]) -> impl Iterator<Item = Joints> {
    let mut readings = [[0.0; 3]; 6];
    let mut counts = [0; 6];
    for j in 0..6 {
        let most = if j == 5 { f64::INFINITY } else { PAST_HALF_TURN_DEG };
        for turn in [0.0, -360.0, 360.0] {
            let deg = joints_deg[j] + turn;
            if (limits_deg[j][0]..=limits_deg[j][1]).contains(&deg) && deg.abs() <= most {
                readings[j][counts[j]] = deg;
                counts[j] += 1;
            }
        }
    }
    (0..counts.iter().product()).map(move |mut code: usize| {
        std::array::from_fn(|j| {
            let reading = readings[j][code % counts[j]];
            code /= counts[j];
            reading
        })
    })
}

/// The joint that is farthest beyond its limits: by how much, which, and where it would stand; each
/// joint read at the turn that suits it best.
fn worst_overrun(joints_deg: &Joints, limits_deg: &[[f64; 2]; 6]) -> (f64, usize, f64) {
    let mut worst = (0.0, 0, joints_deg[0]);
    for j in 0..6 {
        let over = |deg: f64| (limits_deg[j][0] - deg).max(deg - limits_deg[j][1]);
        let best = [0.0, -360.0, 360.0]
            .into_iter()
            .map(|turn| joints_deg[j] + turn)
            .map(|deg| (over(deg), deg))
            .fold((f64::INFINITY, 0.0), |a, b| if b.0 < a.0 { b } else { a });
        if best.0 > worst.0 {
            worst = (best.0, j, best.1);
        }
    }
    worst
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every range of an MZ04: J4 ±190 and J6 ±360 are wider than a turn.
    const LIMITS: [[f64; 2]; 6] =
        [[-170.0, 170.0], [-55.0, 170.0], [-125.0, 280.0], [-190.0, 190.0], [-120.0, 120.0], [-360.0, 360.0]];

    #[test]
    fn a_joint_is_read_at_every_turn_within_its_range() {
        let all = |joints: Joints| turns(&joints, &LIMITS).collect::<Vec<_>>();
        let j6: Vec<f64> = all([0.0, 0.0, 0.0, 0.0, 90.0, 50.0]).iter().map(|j| j[5]).collect();
        assert_eq!(j6, [50.0, -310.0]);
        let j4: Vec<f64> = all([0.0, 0.0, 0.0, 175.0, 90.0, 0.0]).iter().map(|j| j[3]).collect();
        assert_eq!(j4.iter().filter(|d| **d == 175.0).count(), 3, "J6 = 0, -360, 360");
        assert_eq!(j4.iter().filter(|d| **d == -185.0).count(), 3);
        // J3 = 250 is read from -110 too, but lies farther than a move may carry on.
        assert!(all([0.0, 0.0, -110.0, 0.0, 90.0, 10.0]).iter().all(|j| j[2] == -110.0));
        let j3: Vec<f64> = all([0.0, 0.0, -150.0, 0.0, 90.0, 10.0]).iter().map(|j| j[2]).collect();
        assert_eq!(j3, [210.0, 210.0], "-150 is beyond the range, its other reading is not");
        assert_eq!(all([175.0, 0.0, 0.0, 0.0, 90.0, 0.0]), [] as [Joints; 0], "J1 ends at 170");
    }

    #[test]
    fn the_joint_that_is_farthest_beyond_is_named() {
        let (over, joint, needs) = worst_overrun(&[172.0, 0.0, 0.0, 0.0, -131.0, 0.0], &LIMITS);
        assert_eq!((over, joint, needs), (11.0, 4, -131.0));
    }
}
