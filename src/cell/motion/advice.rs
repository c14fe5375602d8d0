//! What would help where the arm cannot do a target: changes of the set-up, tried one by one.
//!
//! Small changes first (another spin, the part turned, the laser or the part moved); then a search over
//! whole mountings that maximises what can be done. Reach, limits and singularities of single targets
//! are looked at; the chain between them is the planner's.

use super::states::Arm;
use crate::cell::collision::Collision;
use crate::cell::{Frame, Mount, Robot, Setup, Spin};
use crate::part::{Part, rpy};
use crate::progress::{Activity, Cancelled, Progress};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Spins looked at, degrees apart.
const SPINS_DEG: f64 = 15.0;
/// Targets looked at, of those that are done and of those that are not.
pub const SAMPLE: usize = 60;
/// A target counts as done only with so much to spare of every range, degrees: a plan has to move on.
const SPARE_DEG: f64 = 3.0;
/// Small changes that are planned as better set-ups.
const SMALL_CHANGES: usize = 3;
/// Turns of the part that are tried, degrees.
const TURNS_DEG: [f64; 12] = [10.0, -10.0, 20.0, -20.0, 30.0, -30.0, 45.0, -45.0, 90.0, -90.0, 135.0, 180.0];
/// Moves of laser or part that are tried, mm.
const MOVES_MM: [f64; 12] = [20.0, -20.0, 50.0, -50.0, 100.0, -100.0, 150.0, -150.0, 200.0, -200.0, 300.0, -300.0];

/// A change that helps.
#[derive(Clone, Debug, PartialEq)]
pub struct Advice {
    /// What to do.
    pub text: String,
    /// Refused targets of the sample that become possible.
    pub gained: usize,
    /// Refused targets of the sample.
    pub of: usize,
    /// Targets of the sample that were possible and are not any more.
    pub lost: usize,
}

impl std::fmt::Display for Advice {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {} of {} refused targets become possible", self.text, self.gained, self.of)?;
        if self.lost > 0 { write!(f, ", {} others are lost", self.lost) } else { Ok(()) }
    }
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
    let free = |s: &super::State| {
        robot.limit_margin_deg(&s.joints_deg) >= SPARE_DEG
            && collision.as_ref().is_none_or(|c| c.first(&s.joints_deg).is_none())
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
) -> Result<Vec<Advice>, Cancelled> {
    if refused.is_empty() {
        return Ok(Vec::new());
    }
    let now_deg = if spin == Spin::Travel { 180.0 } else { SPINS_DEG };
    let before = possible(setup, part, done, now_deg, progress)?;
    // What is possible by itself was refused for the way to it: no change of place is known to help.
    let stuck: Vec<Isometry3<f64>> = refused
        .iter()
        .zip(possible(setup, part, refused, now_deg, progress)?)
        .filter(|(_, possible)| !possible)
        .map(|(f, _)| *f)
        .collect();
    let mut tried: Vec<(String, Setup, f64)> = Vec::new();
    if spin == Spin::Travel {
        tried.push(("leave the spin free".into(), setup.clone(), SPINS_DEG));
    }
    for (text, changed) in variants(setup) {
        tried.push((text, changed, now_deg));
    }
    progress.begin(Activity::TryingChanges, tried.len());
    let found = tried
        .into_par_iter()
        .enumerate()
        .map(|(rank, (text, changed, step_deg))| {
            let gained = count(&possible(&changed, part, &stuck, step_deg, progress)?);
            let mut lost = 0;
            if gained > 0 {
                let after = possible(&changed, part, done, step_deg, progress)?;
                lost = before.iter().zip(&after).filter(|(b, a)| **b && !**a).count();
            }
            progress.step()?;
            Ok((rank, Advice { text, gained, of: refused.len(), lost }))
        })
        .collect::<Result<Vec<(usize, Advice)>, Cancelled>>();
    let mut found = found?;
    let worth = |a: &Advice| a.gained as i64 - 2 * a.lost as i64;
    found.retain(|(_, a)| worth(a) > 0);
    found.sort_by(|(i, a), (j, b)| worth(b).cmp(&worth(a)).then(i.cmp(j)));
    // The same by another number says nothing new.
    let kind = |a: &Advice| a.text.chars().filter(|c| !c.is_ascii_digit()).collect::<String>();
    let mut kinds = BTreeSet::new();
    Ok(found.into_iter().map(|(_, a)| a).filter(|a| kinds.insert(kind(a))).take(3).collect())
}

/// One thing changed, the smallest changes first.
fn variants(setup: &Setup) -> Vec<(String, Setup)> {
    let mut out = Vec::new();
    let change = |edit: &dyn Fn(&mut Setup)| {
        let mut changed = setup.clone();
        edit(&mut changed);
        changed
    };
    let (part, what) = match setup.mount {
        Mount::PartInHand => ("on the flange", "the laser"),
        Mount::ToolInHand => ("on the table", "the part"),
    };
    for k in 0..TURNS_DEG.len() {
        let deg = TURNS_DEG[k];
        for (axis, name) in [(Vector3::z_axis(), "z"), (Vector3::x_axis(), "x"), (Vector3::y_axis(), "y")] {
            let turn = UnitQuaternion::from_axis_angle(&axis, deg.to_radians());
            let text = format!("turn the part {part} about its {name} by {deg:.0}\u{b0}");
            out.push((text, change(&|s| turned(part_frame(s), &turn))));
        }
        let mm = MOVES_MM[k];
        let way = |i: usize| match (i, mm > 0.0) {
            (2, true) => "higher",
            (2, false) => "lower",
            (0, true) => "further from the robot",
            (0, false) => "nearer to the robot",
            (_, true) => "to the left (+y)",
            (_, false) => "to the right (\u{2212}y)",
        };
        for i in [2, 0, 1] {
            let text = format!("put {what} {:.0} mm {}", mm.abs(), way(i));
            out.push((text, change(&|s| moved(fixed_frame(s), i, mm))));
        }
        if setup.mount == Mount::PartInHand && mm > 0.0 {
            let text = format!("hold the part {mm:.0} mm further from the flange");
            out.push((text, change(&|s| moved(part_frame(s), 2, mm))));
        }
    }
    out
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

fn moved(frame: &mut Frame, axis: usize, mm: f64) {
    let mut position = frame.position_mm;
    position[axis] += mm;
    *frame = Frame::new(position, frame.rz_ry_rx_deg);
}

fn turned(frame: &mut Frame, turn: &UnitQuaternion<f64>) {
    let rotation = frame.isometry().rotation * turn;
    *frame = Frame::new(frame.position_mm, angles(&rotation));
}

/// Angles of a frame, rounded to what a person would set.
fn angles(rotation: &UnitQuaternion<f64>) -> [f64; 3] {
    rpy::from_rotation(&rotation.to_rotation_matrix()).map(|deg| libm::round(deg * 1000.0) / 1000.0 + 0.0)
}

/// A whole set-up that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct BetterSetup {
    /// Share of the sample that is possible now.
    pub share_before: f64,
    /// And with these frames.
    pub share_after: f64,
    /// Part on the flange, or part in the base.
    pub part: Frame,
    /// Laser in the base; as it was where the tool is in hand.
    pub base_from_laser: Frame,
    /// The sample: path frames in the part.
    pub sample: Vec<Isometry3<f64>>,
    /// Which of the sample are possible with them.
    pub possible: Vec<bool>,
}

/// Mountings (turn, tilt, position) with which most of the targets are possible, to be planned and
/// compared: single targets say nothing of the ways between them.
///
/// The first is found on a coarse grid over how the part is held and where laser or part stands, then by
/// single steps from the best, ever smaller; the others are the best small changes of what there is.
/// `frames`: a sample of path frames, evenly over the work.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn better_setups(
    setup: &Setup,
    part: &Part,
    frames: &[Isometry3<f64>],
    progress: &Progress,
) -> Result<Vec<BetterSetup>, Cancelled> {
    if frames.is_empty() || setup.robot.is_none() {
        return Ok(Vec::new());
    }
    let score = |s: &Setup| Ok(count(&possible(s, part, frames, 2.0 * SPINS_DEG, progress)?));
    let start = score(setup)?;
    let scored = |stage, list: Vec<Setup>| -> Result<Vec<(usize, Setup)>, Cancelled> {
        progress.begin(stage, list.len());
        let one = |s: &Setup| {
            let score = score(s)?;
            progress.step().map(|()| score)
        };
        let scores = list.par_iter().map(one).collect::<Result<Vec<usize>, Cancelled>>()?;
        let mut out: Vec<(usize, Setup)> = scores.into_iter().zip(list).collect();
        out.sort_by_key(|s| std::cmp::Reverse(s.0));
        Ok(out)
    };
    let mut found = Vec::new();
    if let Some(mut best) = scored(Activity::TryingSetups, grid(setup))?.into_iter().next() {
        for step_mm in [60.0, 30.0, 10.0] {
            let next = |best: &(usize, Setup)| -> Result<_, Cancelled> {
                let list = scored(Activity::ImprovingSetup, around(&best.1, step_mm))?;
                Ok(list.into_iter().next().filter(|n| n.0 > best.0))
            };
            while let Some(next) = next(&best)? {
                best = next;
            }
        }
        found.push(best);
    }
    let small = scored(Activity::TryingSmallChanges, variants(setup).into_iter().map(|(_, s)| s).collect())?;
    found.extend(small.into_iter().take(SMALL_CHANGES));
    let share = |n: usize| n as f64 / frames.len() as f64;
    let better = |(n, mut s): (usize, Setup)| {
        Ok(BetterSetup {
            share_before: share(start),
            share_after: share(n),
            part: part_frame(&mut s).clone(),
            base_from_laser: s.cell.base_from_laser.clone(),
            sample: frames.to_vec(),
            possible: possible(&s, part, frames, SPINS_DEG, progress)?,
        })
    };
    found.into_iter().filter(|f| f.0 >= start).map(better).collect()
}

/// Quarter turns of the part, at places of the laser (or the part) over the arm's reach.
fn grid(setup: &Setup) -> Vec<Setup> {
    let reach = setup.robot.as_ref().map_or(500.0, Robot::reach_mm);
    let mut out = Vec::new();
    for turn in quarter_turns(setup.mount) {
        for x in [0.45, 0.6, 0.75] {
            for z in [0.0, 0.2, 0.4, 0.6] {
                let mut s = setup.clone();
                let here = fixed_frame(&mut s).clone();
                *fixed_frame(&mut s) = Frame::new(
                    [libm::round(x * reach), here.position_mm[1], libm::round(z * reach)],
                    here.rz_ry_rx_deg,
                );
                turned(part_frame(&mut s), &turn);
                out.push(s);
            }
        }
    }
    out
}

/// How a part may be held: any face to the flange; on a table it stands as it is and is turned.
fn quarter_turns(mount: Mount) -> Vec<UnitQuaternion<f64>> {
    let about = |axis, quarters: i32| UnitQuaternion::from_axis_angle(&axis, f64::from(quarters * 90).to_radians());
    let z = (0..4).map(|k| about(Vector3::z_axis(), k));
    match mount {
        Mount::ToolInHand => z.collect(),
        Mount::PartInHand => {
            let tilts = [
                UnitQuaternion::identity(),
                about(Vector3::x_axis(), 1),
                about(Vector3::x_axis(), -1),
                about(Vector3::x_axis(), 2),
                about(Vector3::y_axis(), 1),
                about(Vector3::y_axis(), -1),
            ];
            // With the spin free a turn about the flange changes little but the last joint.
            tilts.to_vec()
        }
    }
}

/// One step along each axis, of what stands and of what is held, and small turns.
fn around(setup: &Setup, step_mm: f64) -> Vec<Setup> {
    let mut out = Vec::new();
    for sign in [1.0, -1.0] {
        for axis in 0..3 {
            let mut s = setup.clone();
            moved(fixed_frame(&mut s), axis, sign * step_mm);
            out.push(s);
            let turn = UnitQuaternion::from_axis_angle(
                &nalgebra::Unit::new_unchecked(Vector3::ith(axis, 1.0)),
                (sign * 0.5 * step_mm).to_radians(),
            );
            let mut s = setup.clone();
            if setup.mount == Mount::PartInHand || axis == 2 {
                turned(part_frame(&mut s), &turn);
                out.push(s);
            }
        }
        if setup.mount == Mount::PartInHand {
            let mut s = setup.clone();
            moved(part_frame(&mut s), 2, sign * step_mm);
            if part_frame(&mut s).position_mm[2] >= 0.0 {
                out.push(s);
            }
        }
    }
    out
}

/// A frame as it stands in a job file: mm and degrees.
pub fn said(frame: &Frame) -> String {
    let list = |v: &[f64; 3]| v.map(|x| format!("{:?}", x + 0.0)).join(", ");
    format!("position_mm = [{}], rz_ry_rx_deg = [{}]", list(&frame.position_mm), list(&frame.rz_ry_rx_deg))
}
