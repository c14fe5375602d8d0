//! Whole set-ups with which most can be done: a coarse grid, single steps from its best, and the best small changes.
//!
//! Single targets are looked at; the way from one to the next is the planner's.

use super::{SPINS_DEG, count, fixed_frame, move_frame, part_frame, possible, turn_frame, variants};
use crate::cell::{Frame, Mount, Robot, Setup};
use crate::part::Part;
use crate::progress::{Activity, Cancelled, Progress};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use rayon::prelude::*;

/// Small changes that are planned as better set-ups.
const SMALL_CHANGES: usize = 3;

/// A whole set-up that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct BetterSetup {
    /// Share of the sample that is possible now.
    pub share_before: f64,
    /// Share of the sample that is possible with these frames.
    pub share_after: f64,
    /// Part on the flange, or part in the base.
    pub part: Frame,
    /// Laser in the base; as it was where the tool is in hand.
    pub base_from_laser: Frame,
    /// The sample: path frames in the part.
    pub sample: Vec<Isometry3<f64>>,
    /// Which of the sample are possible with these frames.
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
        let score_and_step = |s: &Setup| {
            let score = score(s)?;
            progress.step().map(|()| score)
        };
        let scores = list.par_iter().map(score_and_step).collect::<Result<Vec<usize>, Cancelled>>()?;
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
                turn_frame(part_frame(&mut s), &turn);
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
            move_frame(fixed_frame(&mut s), axis, sign * step_mm);
            out.push(s);
            let turn = UnitQuaternion::from_axis_angle(
                &nalgebra::Unit::new_unchecked(Vector3::ith(axis, 1.0)),
                (sign * 0.5 * step_mm).to_radians(),
            );
            let mut s = setup.clone();
            if setup.mount == Mount::PartInHand || axis == 2 {
                turn_frame(part_frame(&mut s), &turn);
                out.push(s);
            }
        }
        if setup.mount == Mount::PartInHand {
            let mut s = setup.clone();
            move_frame(part_frame(&mut s), 2, sign * step_mm);
            if part_frame(&mut s).position_mm[2] >= 0.0 {
                out.push(s);
            }
        }
    }
    out
}
