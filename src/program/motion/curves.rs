//! Joints, their speeds and what limits them over the time of a program, sampled for curves; and how
//! far everything keeps from everything else.

use super::timeline::Timeline;
use crate::cell::{Collision, Contact, Joints};
use crate::part::rpy;
use crate::progress::{Activity, Cancelled, Progress};
use rayon::prelude::*;

/// One moment of the curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveSample {
    /// From the program's start, s.
    pub time_s: f64,
    /// Joints.
    pub joints_deg: Joints,
    /// Mean speed since the sample before, degrees per second.
    pub speeds_deg_s: Joints,
    /// Least distance of any joint from its limits.
    pub limit_margin_deg: f64,
    /// Distance from a singular pose, 0 to 1.
    pub singularity: f64,
    /// Flange about Z, Y and X in the base.
    pub rz_ry_rx_deg: [f64; 3],
}

/// One moment of the curve of clearance.
#[derive(Clone, Debug, PartialEq)]
pub struct Clearance {
    /// From the program's start, s.
    pub time_s: f64,
    /// Distance of the two bodies that are nearest each other, and which they are; `None`: all keep
    /// farther apart than is looked at.
    pub nearest: Option<(f64, Contact)>,
}

/// Clearance is looked at so often over a program: more than a screen shows, and soon done.
const MOST_CLEARANCES: usize = 2000;

/// Long moves are sampled so many times over the whole program.
const EVEN_SAMPLES: f64 = 2000.0;

/// The curves of a program: every stop, and long moves between.
pub fn curves(timeline: &Timeline) -> Vec<CurveSample> {
    let step_s = timeline.total_s() / EVEN_SAMPLES;
    let mut out: Vec<CurveSample> = Vec::with_capacity(timeline.stops().len() + EVEN_SAMPLES as usize);
    for stop in timeline.stops() {
        let begun_s = stop.at_s - stop.seconds;
        if stop.waiting_s > 0.0 {
            push(&mut out, timeline, begun_s);
        }
        let pieces = if step_s > 0.0 { (stop.seconds / step_s).ceil().max(1.0) } else { 1.0 };
        for k in 1..=pieces as usize {
            // The last one is the stop itself, to the last bit.
            let share = k as f64 / pieces;
            push(&mut out, timeline, if share < 1.0 { begun_s + stop.seconds * share } else { stop.at_s });
        }
    }
    out
}

/// The clearance at evenly chosen moments of the curves, the first and the last among them.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn clearances(
    samples: &[CurveSample],
    collision: &Collision<'_>,
    progress: &Progress,
) -> Result<Vec<Clearance>, Cancelled> {
    let count = samples.len().min(MOST_CLEARANCES);
    let look = |k: usize| {
        progress.step()?;
        let s = &samples[k * (samples.len() - 1) / (count - 1).max(1)];
        Ok(Clearance { time_s: s.time_s, nearest: collision.clearance(&s.joints_deg) })
    };
    progress.begin(Activity::MeasuringClearances, count);
    (0..count).into_par_iter().map(look).collect()
}

fn push(out: &mut Vec<CurveSample>, timeline: &Timeline, time_s: f64) {
    let moment = timeline.moment(time_s);
    let (robot, last) = (timeline.robot(), out.last());
    let joints_deg = moment.joints_deg;
    let rz_ry_rx_deg = rpy::from_rotation(&moment.base_from_flange.rotation.to_rotation_matrix());
    let mut speeds_deg_s = [0.0; 6];
    if let Some(last) = last {
        let since_s = time_s - last.time_s;
        if since_s > 0.0 {
            speeds_deg_s = std::array::from_fn(|i| (joints_deg[i] - last.joints_deg[i]) / since_s);
        }
    }
    out.push(CurveSample {
        time_s,
        joints_deg,
        speeds_deg_s,
        limit_margin_deg: robot.limit_margin_deg(&joints_deg),
        singularity: robot.singularity(&joints_deg),
        rz_ry_rx_deg,
    });
}
