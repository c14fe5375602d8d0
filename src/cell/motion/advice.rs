//! What would help where the arm cannot do a target: small changes of the set-up (another spin, the part turned, the
//! laser or the part moved), tried one by one. Whole set-ups are looked for in `better_setups`.
//!
//! Reach, limits and singularities of single targets are looked at; the chain between them is the planner's.

mod better_setups;

pub use better_setups::{BetterSetup, better_setups};

use super::states::Arm;
use crate::cell::collision::Collision;
use crate::cell::{Frame, Mount, Setup, Spin};
use crate::part::{Part, rpy};
use crate::progress::{Activity, Cancelled, Progress};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use rayon::prelude::*;

/// Spins looked at, degrees apart.
const SPINS_DEG: f64 = 15.0;
/// Targets looked at, of those that are done and of those that are not.
pub const SAMPLE: usize = 60;
/// A target counts as done only with so much to spare of every range, degrees: a plan has to move on.
const SPARE_DEG: f64 = 3.0;
/// Changes that are offered.
const OFFERED: usize = 3;
/// Turns of the part that are tried, degrees.
const TURNS_DEG: [f64; 12] = [10.0, -10.0, 20.0, -20.0, 30.0, -30.0, 45.0, -45.0, 90.0, -90.0, 135.0, 180.0];
/// Moves of laser or part that are tried, mm.
const MOVES_MM: [f64; 12] = [20.0, -20.0, 50.0, -50.0, 100.0, -100.0, 150.0, -150.0, 200.0, -200.0, 300.0, -300.0];

/// A direction of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameAxis {
    /// x.
    X,
    /// y.
    Y,
    /// z.
    Z,
}

/// One change of a set-up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SetupChange {
    /// The spin is left free.
    FreeSpin,
    /// The part is turned about an axis of its own.
    TurnPart {
        /// Where it is: on the flange or on the table.
        mount: Mount,
        /// The axis.
        axis: FrameAxis,
        /// By so much.
        deg: f64,
    },
    /// What stands is moved: the laser where the robot holds the part, else the part.
    Move {
        /// What the robot carries.
        mount: Mount,
        /// Along this axis of the base.
        axis: FrameAxis,
        /// By so much.
        mm: f64,
    },
    /// The part is held further from the flange.
    HoldFurther {
        /// By so much.
        mm: f64,
    },
}

impl SetupChange {
    /// Whether another change is the same thing in the same direction, by another amount.
    pub fn is_like(&self, other: &SetupChange) -> bool {
        let alike = |a: f64, b: f64| (a > 0.0) == (b > 0.0);
        match (*self, *other) {
            (SetupChange::TurnPart { axis: a, deg: x, .. }, SetupChange::TurnPart { axis: b, deg: y, .. }) => {
                a == b && alike(x, y)
            }
            (SetupChange::Move { axis: a, mm: x, .. }, SetupChange::Move { axis: b, mm: y, .. }) => {
                a == b && alike(x, y)
            }
            (SetupChange::FreeSpin, SetupChange::FreeSpin)
            | (SetupChange::HoldFurther { .. }, SetupChange::HoldFurther { .. }) => true,
            _ => false,
        }
    }
}

/// A change that helps.
#[derive(Clone, Debug, PartialEq)]
pub struct SuggestedChange {
    /// What to do.
    pub change: SetupChange,
    /// Refused targets of the sample that become possible.
    pub gained: usize,
    /// Refused targets of the sample.
    pub of: usize,
    /// Targets of the sample that were possible and are not any more.
    pub lost: usize,
}

/// Evenly every k-th, at most `most`.
pub fn sampled<T: Copy>(all: &[T], most: usize) -> Vec<T> {
    let every = all.len().div_ceil(most.max(1)).max(1);
    all.iter().step_by(every).copied().collect()
}

/// Whether the arm can stand at each path frame with something to spare, touching nothing.
fn possible(
    setup: &Setup,
    part: &Part,
    frames: &[Isometry3<f64>],
    step_deg: f64,
    progress: &Progress,
) -> Result<Vec<bool>, Cancelled> {
    let Some(robot) = &setup.robot else { return Ok(vec![false; frames.len()]) };
    let arm = Arm::with_step(robot, setup, step_deg);
    let collision = Collision::new(setup, part);
    let free = |s: &super::ArmState| {
        robot.limit_margin_deg(&s.joints_deg) >= SPARE_DEG
            && collision.as_ref().is_none_or(|c| c.first_contact(&s.joints_deg).is_none())
    };
    let look = |f: &Isometry3<f64>| {
        progress.check()?;
        Ok(arm.states(f).is_ok_and(|states| states.iter().any(free)))
    };
    frames.iter().map(look).collect()
}

fn count(all: &[bool]) -> usize {
    all.iter().filter(|b| **b).count()
}

/// Changes that make refused targets possible, the best first: more gained, less lost, then the smaller
/// change. `done` and `refused` are samples of path frames in the part.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn changes(
    setup: &Setup,
    part: &Part,
    spin: Spin,
    done: &[Isometry3<f64>],
    refused: &[Isometry3<f64>],
    progress: &Progress,
) -> Result<Vec<SuggestedChange>, Cancelled> {
    if refused.is_empty() {
        return Ok(Vec::new());
    }
    let now_deg = if spin == Spin::Travel { 180.0 } else { SPINS_DEG };
    let before = possible(setup, part, done, now_deg, progress)?;
    // What is possible by itself was refused for the way to it: no change of place is known to help.
    let impossible: Vec<Isometry3<f64>> = refused
        .iter()
        .zip(possible(setup, part, refused, now_deg, progress)?)
        .filter(|(_, possible)| !possible)
        .map(|(f, _)| *f)
        .collect();
    let mut tried: Vec<(SetupChange, Setup, f64)> = Vec::new();
    if spin == Spin::Travel {
        tried.push((SetupChange::FreeSpin, setup.clone(), SPINS_DEG));
    }
    tried.extend(variants(setup).into_iter().map(|(change, changed)| (change, changed, now_deg)));
    progress.begin(Activity::TryingChanges, tried.len());
    let found = tried
        .into_par_iter()
        .enumerate()
        .map(|(rank, (change, changed, step_deg))| {
            let gained = count(&possible(&changed, part, &impossible, step_deg, progress)?);
            let mut lost = 0;
            if gained > 0 {
                let after = possible(&changed, part, done, step_deg, progress)?;
                lost = before.iter().zip(&after).filter(|(b, a)| **b && !**a).count();
            }
            progress.step()?;
            Ok((rank, SuggestedChange { change, gained, of: refused.len(), lost }))
        })
        .collect::<Result<Vec<(usize, SuggestedChange)>, Cancelled>>();
    let mut found = found?;
    let worth = |a: &SuggestedChange| a.gained as i64 - 2 * a.lost as i64;
    found.retain(|(_, a)| worth(a) > 0);
    found.sort_by(|(i, a), (j, b)| worth(b).cmp(&worth(a)).then(i.cmp(j)));
    let mut offered: Vec<SuggestedChange> = Vec::new();
    for (_, suggested) in found {
        // Another amount of what is offered already says nothing new.
        if offered.len() < OFFERED && !offered.iter().any(|o| o.change.is_like(&suggested.change)) {
            offered.push(suggested);
        }
    }
    Ok(offered)
}

/// One thing changed, the smallest changes first.
fn variants(setup: &Setup) -> Vec<(SetupChange, Setup)> {
    use FrameAxis::{X, Y, Z};
    let mount = setup.mount;
    let mut changes = Vec::new();
    for (deg, mm) in TURNS_DEG.into_iter().zip(MOVES_MM) {
        changes.extend([Z, X, Y].map(|axis| SetupChange::TurnPart { mount, axis, deg }));
        changes.extend([Z, X, Y].map(|axis| SetupChange::Move { mount, axis, mm }));
        if mount == Mount::PartInHand && mm > 0.0 {
            changes.push(SetupChange::HoldFurther { mm });
        }
    }
    changes.into_iter().map(|change| (change, change.applied(setup))).collect()
}

impl SetupChange {
    /// The set-up with the change; a spin is no part of it.
    pub fn applied(&self, setup: &Setup) -> Setup {
        let mut changed = setup.clone();
        match *self {
            SetupChange::FreeSpin => {}
            SetupChange::TurnPart { axis, deg, .. } => {
                let direction = [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()][axis as usize];
                let turn = UnitQuaternion::from_axis_angle(&direction, deg.to_radians());
                turn_frame(part_frame(&mut changed), &turn);
            }
            SetupChange::Move { axis, mm, .. } => move_frame(fixed_frame(&mut changed), axis as usize, mm),
            SetupChange::HoldFurther { mm } => move_frame(part_frame(&mut changed), 2, mm),
        }
        changed
    }
}

fn part_frame(s: &mut Setup) -> &mut Frame {
    match s.mount {
        Mount::PartInHand => &mut s.cell.flange_from_part,
        Mount::ToolInHand => &mut s.cell.base_from_part,
    }
}

/// What stands: the laser, or the part.
fn fixed_frame(s: &mut Setup) -> &mut Frame {
    match s.mount {
        Mount::PartInHand => &mut s.cell.base_from_laser,
        Mount::ToolInHand => &mut s.cell.base_from_part,
    }
}

fn move_frame(frame: &mut Frame, axis: usize, mm: f64) {
    let mut position = frame.position_mm;
    position[axis] += mm;
    *frame = Frame::new(position, frame.rz_ry_rx_deg);
}

fn turn_frame(frame: &mut Frame, turn: &UnitQuaternion<f64>) {
    let rotation = frame.isometry().rotation * turn;
    *frame = Frame::new(frame.position_mm, angles(&rotation));
}

/// Angles of a frame, rounded to what a person would set.
fn angles(rotation: &UnitQuaternion<f64>) -> [f64; 3] {
    rpy::from_rotation(&rotation.to_rotation_matrix()).map(|deg| libm::round(deg * 1000.0) / 1000.0 + 0.0)
}

/// The keys of a frame as they stand in a job file: mm and degrees.
pub fn as_toml(frame: &Frame) -> String {
    let list = |v: &[f64; 3]| v.map(|x| format!("{:?}", x + 0.0)).join(", ");
    format!("position_mm = [{}], rz_ry_rx_deg = [{}]", list(&frame.position_mm), list(&frame.rz_ry_rx_deg))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every change is itself again by another amount, and nothing else, or it would be offered in vain.
    #[test]
    fn changes_differ_by_more_than_their_amount() {
        let setup = Setup::shipped().expect("shipped");
        let all: Vec<SetupChange> = variants(&setup).into_iter().map(|(change, _)| change).collect();
        let kinds = all.iter().enumerate().filter(|(i, c)| !all[..*i].iter().any(|before| before.is_like(c)));
        // Three turns and three moves, each to either side, and further from the flange.
        assert_eq!(kinds.count(), 13);
        assert!(all.iter().all(|c| c.is_like(c) && !c.is_like(&SetupChange::FreeSpin)));
    }
}
