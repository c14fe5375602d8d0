//! Why the arm cannot do a target, in the words of the report.

use super::choice::{MOST_SPEED, MOST_STEP_DEG, most_deg};
use super::states::{Arm, Lack, State};
use crate::pose::{Blocker, Obstruction, ToolBody};
use nalgebra::Isometry3;

/// What kind of thing is in the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Cause {
    /// The beam hits the part on the way between two targets, as the controller goes.
    Beam,
    /// The arm touches the part, or no way leads there.
    Robot,
    /// The head is touched.
    Head,
    /// The table or an obstacle is touched.
    Obstacle,
    /// Too far away, or too near.
    Reach,
    /// A joint would go beyond its limits.
    Limit,
    /// A joint would go faster than it can.
    Speed,
    /// A pose in which a direction of motion is lost, or the wrist would have to flip.
    Singularity,
}

impl Cause {
    /// The word in `report.json`.
    pub fn word(self) -> &'static str {
        match self {
            Cause::Beam => "beam",
            Cause::Robot => "robot",
            Cause::Head => "head",
            Cause::Obstacle => "obstacle",
            Cause::Reach => "reach",
            Cause::Limit => "limit",
            Cause::Speed => "speed",
            Cause::Singularity => "singularity",
        }
    }

    /// The cause of something in the way of beam or head.
    pub fn of_blocker(b: &Blocker) -> Cause {
        match (b.tool_body, b.obstruction) {
            (_, Obstruction::Clamp(_)) => Cause::Obstacle,
            (ToolBody::Head, _) => Cause::Head,
            (ToolBody::Beam, _) => Cause::Beam,
        }
    }

    /// The cause of a contact, by what is named in it.
    pub fn of_contact(contact: &str) -> Cause {
        if contact.contains("head") {
            Cause::Head
        } else if contact.contains("table") || contact.contains("obstacle") {
            Cause::Obstacle
        } else {
            Cause::Robot
        }
    }
}

/// A target that the arm does not do.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Pass.
    pub pass: usize,
    /// Point of the pass.
    pub point: usize,
    /// Kind of reason.
    pub cause: Cause,
    /// The joint, or the pair that collides, with its figures.
    pub detail: String,
}

/// Why a target has no state.
pub(super) fn of_lack(arm: &Arm<'_>, lack: &Lack) -> (Cause, String) {
    match *lack {
        Lack::Reach => (Cause::Reach, format!("out of reach of the {} at any spin", arm.robot.name)),
        Lack::Limit { joint, needs_deg } => (Cause::Limit, beyond(arm, joint, needs_deg)),
        Lack::Singularity => {
            (Cause::Singularity, "every pose of the arm is next to a singularity, where joints would race".into())
        }
    }
}

fn beyond(arm: &Arm<'_>, joint: usize, needs_deg: f64) -> String {
    let [low, high] = arm.robot.limits_deg[joint];
    format!("J{} would need {needs_deg:.1}\u{b0}, its range is {low:.0} to {high:.0}\u{b0}", joint + 1)
}

/// Why no move leads to a target that has states, from the state before it.
pub(super) fn of_move(
    arm: &Arm<'_>,
    part_from_focus: &Isometry3<f64>,
    before: Option<&State>,
    lit_s: Option<f64>,
) -> (Cause, String) {
    let (Some(before), Some(seconds)) = (before, lit_s) else {
        return (Cause::Singularity, "no continuous motion of the arm leads on from here".into());
    };
    let speeds = &arm.robot.speeds_deg_s;
    let most = most_deg(speeds, seconds);
    // The pose that carries on most nearly, limits not looked at.
    let mut nearest: Option<(f64, [f64; 6])> = None;
    for k in 0..arm.spins() {
        let solutions = arm.robot.inverse(&arm.flange_for(&arm.turned(part_from_focus, k as u8)));
        if let Some(joints) = solutions[usize::from(before.branch)] {
            let on = std::array::from_fn(|j| {
                let d: f64 = joints[j] - before.joints_deg[j];
                before.joints_deg[j] + d - 360.0 * (d / 360.0).round()
            });
            let excess = (0..6).map(|j| (on[j] - before.joints_deg[j]).abs() / most[j]).fold(0.0, f64::max);
            if nearest.is_none_or(|n| excess < n.0) {
                nearest = Some((excess, on));
            }
        }
    }
    let Some((_, on)) = nearest else {
        return (Cause::Reach, "the arm would have to change its branch in the middle of a pass".into());
    };
    let worst = (0..6)
        .map(|j| ((on[j] - before.joints_deg[j]).abs() / most[j], j))
        .fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a });
    let j = worst.1;
    let moved = (on[j] - before.joints_deg[j]).abs();
    if worst.0 > 1.0 && moved <= MOST_STEP_DEG {
        let detail = format!(
            "J{} would turn at {:.0}\u{b0}/s, it can {:.0}\u{b0}/s",
            j + 1,
            moved / seconds,
            MOST_SPEED * speeds[j]
        );
        return (Cause::Speed, detail);
    }
    if worst.0 > 1.0 {
        return (Cause::Singularity, format!("J{} would jump by {moved:.0}\u{b0} in one step: the wrist flips", j + 1));
    }
    match arm.robot.beyond(&on) {
        Some(j) => (Cause::Limit, beyond(arm, j, on[j])),
        None => (Cause::Singularity, "no continuous motion of the arm leads on from here".into()),
    }
}
