//! The reason for which a target has no state, or no motion leads to one that it has.

use super::refusal::{RefusalCause, RefusalReason};
use super::rules::{MOST_SPEED, MOST_STEP_DEG, most_deg};
use super::states::{Arm, ArmState, NoState};
use crate::cell::Joints;
use nalgebra::Isometry3;

/// Why a target has no state.
pub(super) fn of_no_state(arm: &Arm<'_>, reason: &NoState) -> (RefusalCause, RefusalReason) {
    match *reason {
        NoState::Reach => (RefusalCause::Reach, RefusalReason::OutOfReach { robot: arm.robot.name.clone() }),
        NoState::Limit { joint, needs_deg } => (RefusalCause::Limit, beyond(arm, joint, needs_deg)),
        NoState::Singularity => (RefusalCause::Singularity, RefusalReason::Singular),
    }
}

/// `joint` from 0.
fn beyond(arm: &Arm<'_>, joint: usize, needs_deg: f64) -> RefusalReason {
    RefusalReason::JointLimit { joint: joint + 1, needs_deg, range_deg: arm.robot.limits_deg[joint] }
}

/// Why no move leads to a target that has states, from the state before it.
pub(super) fn of_move(
    arm: &Arm<'_>,
    part_from_focus: &Isometry3<f64>,
    before: Option<&ArmState>,
    lit_s: Option<f64>,
) -> (RefusalCause, RefusalReason) {
    let (Some(before), Some(seconds)) = (before, lit_s) else {
        return (RefusalCause::Singularity, RefusalReason::NoMotion);
    };
    let speeds = &arm.robot.speeds_deg_s;
    let most = most_deg(speeds, seconds);
    let Some(on) = nearest_continuation(arm, part_from_focus, before, &most) else {
        return (RefusalCause::Reach, RefusalReason::BranchChange);
    };
    let (excess, j) = (0..6)
        .map(|j| ((on[j] - before.joints_deg[j]).abs() / most[j], j))
        .fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a });
    let moved_deg = (on[j] - before.joints_deg[j]).abs();
    let joint = j + 1;
    if excess > 1.0 && moved_deg <= MOST_STEP_DEG {
        let (needs_deg_s, can_deg_s) = (moved_deg / seconds, MOST_SPEED * speeds[j]);
        return (RefusalCause::Speed, RefusalReason::JointSpeed { joint, needs_deg_s, can_deg_s });
    }
    if excess > 1.0 {
        return (RefusalCause::Singularity, RefusalReason::WristFlip { joint, jump_deg: moved_deg });
    }
    match arm.robot.beyond(&on) {
        Some(j) => (RefusalCause::Limit, beyond(arm, j, on[j])),
        None => (RefusalCause::Singularity, RefusalReason::NoMotion),
    }
}

/// The solution in the same branch, at any spin, that needs the least of the motion allowed by `most_deg` for each joint.
/// Limits are not looked at.
fn nearest_continuation(
    arm: &Arm<'_>,
    part_from_focus: &Isometry3<f64>,
    before: &ArmState,
    most_deg: &[f64; 6],
) -> Option<Joints> {
    let mut nearest: Option<(f64, Joints)> = None;
    for k in 0..arm.spins() {
        let solutions = arm.robot.inverse(&arm.flange_for(&arm.with_spin(part_from_focus, k as u8)));
        if let Some(joints) = solutions[usize::from(before.branch)] {
            let on = std::array::from_fn(|j| {
                let d: f64 = joints[j] - before.joints_deg[j];
                before.joints_deg[j] + d - 360.0 * (d / 360.0).round()
            });
            let excess = (0..6).map(|j| (on[j] - before.joints_deg[j]).abs() / most_deg[j]).fold(0.0, f64::max);
            if nearest.is_none_or(|n| excess < n.0) {
                nearest = Some((excess, on));
            }
        }
    }
    nearest.map(|(_, on)| on)
}
