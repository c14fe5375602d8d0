//! The cheapest chain by looking at every pair of states, as open planners do it (descartes). Shares
//! the states and the constants with the program, and no code of the search.
#![allow(dead_code, reason = "each test file uses its own share")]

use clearbeam::cell::Joints;
use clearbeam::cell::motion::rules::{
    AT_LIMIT, AT_SINGULARITY, MOST_SPEED, MOST_SPIN_STEP_DEG, MOST_STEP_DEG, NEAR_LIMIT_DEG, NEAR_SINGULAR,
};
use clearbeam::cell::motion::{Arm, ArmState, Choice};
use clearbeam::pose::Pass;

/// What it costs to stand somewhere.
pub fn standing(arm: &Arm<'_>, joints: &Joints) -> f64 {
    let margin = arm.robot.limit_margin_deg(joints);
    let singular = arm.robot.singularity(joints);
    let near = |x: f64, from: f64| if x < from { (1.0 - x / from).powi(2) } else { 0.0 };
    AT_LIMIT * near(margin, NEAR_LIMIT_DEG) + AT_SINGULARITY * near(singular, NEAR_SINGULAR)
}

/// What a lit move costs; `None`: it is not allowed.
pub fn moving(arm: &Arm<'_>, from: (&Joints, f64), to: (&Joints, f64), seconds: f64) -> Option<f64> {
    let speeds = &arm.robot.speeds_deg_s;
    let mean = speeds.iter().sum::<f64>() / 6.0;
    let turned = (from.1 - to.1).abs() % 360.0;
    if turned.min(360.0 - turned) > MOST_SPIN_STEP_DEG + 1e-9 {
        return None;
    }
    let mut cost = 0.0;
    for (j, speed) in speeds.iter().enumerate() {
        let d = (to.0[j] - from.0[j]).abs();
        if d > MOST_STEP_DEG || d > MOST_SPEED * speed * seconds {
            return None;
        }
        cost += d * mean / speed;
    }
    Some(cost)
}

/// Seconds of the lit move to each target of a pass.
pub fn seconds(pass: &Pass, speed_mm_s: f64) -> Vec<f64> {
    let steps = pass.targets.windows(2).map(|w| (w[1].p - w[0].p).norm() / speed_mm_s);
    std::iter::once(0.0).chain(steps).collect()
}

/// Cost of the cheapest chain through all targets of a pass; infinite where there is none.
pub fn cheapest(arm: &Arm<'_>, pass: &Pass, defocus_mm: f64, speed_mm_s: f64) -> f64 {
    let states: Vec<Vec<ArmState>> =
        pass.targets.iter().map(|t| arm.states(&t.frame(defocus_mm)).unwrap_or_default()).collect();
    cheapest_of(arm, &states, &seconds(pass, speed_mm_s))
}

/// The same over states that are there already.
pub fn cheapest_of(arm: &Arm<'_>, states: &[Vec<ArmState>], seconds: &[f64]) -> f64 {
    let stand = |s: &ArmState| standing(arm, &s.joints_deg);
    let mut cost: Vec<f64> = states[0].iter().map(stand).collect();
    for i in 1..states.len() {
        let next = states[i].iter().map(|to| {
            let mut best = f64::INFINITY;
            for (from, so_far) in states[i - 1].iter().zip(&cost) {
                if from.branch == to.branch
                    && let Some(c) = moving(
                        arm,
                        (&from.joints_deg, arm.spin_deg(from.spin)),
                        (&to.joints_deg, arm.spin_deg(to.spin)),
                        seconds[i],
                    )
                {
                    best = best.min(so_far + c);
                }
            }
            best + stand(to)
        });
        cost = next.collect();
    }
    cost.into_iter().fold(f64::INFINITY, f64::min)
}

/// Cost of a chain that was chosen; infinite where a rule is broken or a target left out.
pub fn cost_of(arm: &Arm<'_>, choice: &Choice, number: usize, seconds: &[f64]) -> f64 {
    let mut total = 0.0;
    for (i, row) in choice.rows[number].iter().enumerate() {
        let Some(to) = row else { return f64::INFINITY };
        if i > 0 {
            let Some(from) = &choice.rows[number][i - 1] else { return f64::INFINITY };
            let step = moving(arm, (&from.joints_deg, from.spin_deg), (&to.joints_deg, to.spin_deg), seconds[i]);
            total += step.unwrap_or(f64::INFINITY);
        }
        total += standing(arm, &to.joints_deg);
    }
    total
}
