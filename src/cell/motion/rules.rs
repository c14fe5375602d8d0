//! The rules of the chain: what states and moves cost, and the states of a target with the cheapest chain to each.

use super::states::{Arm, ArmState, SPIN_STEP_DEG};
use crate::cell::Joints;

/// A joint moves no further between two targets of a pass.
pub const MOST_STEP_DEG: f64 = 30.0;
/// A joint moves at this share of its speed at most: between two targets it is not quite even.
pub const MOST_SPEED: f64 = 0.95;
/// The spin turns no further between two targets of a pass.
pub const MOST_SPIN_STEP_DEG: f64 = 30.0;
/// Leaving a target out costs more than any motion.
pub const LEFT_OUT: f64 = 1e9;
/// Cost of a change of branch between pieces: the arm has to turn over, which is worth a long way by joints.
pub const CHANGED_BRANCH: f64 = 200.0;
/// Cost of starting a piece anew inside a pass, which takes another connecting move.
pub const STARTED_ANEW: f64 = 100.0;
/// From here on nearness to a limit costs, degrees.
pub const NEAR_LIMIT_DEG: f64 = 20.0;
/// From here on nearness to a singularity costs.
pub const NEAR_SINGULAR: f64 = 0.25;
/// What a target at the very limit costs: as much as 6 degrees of travel.
pub const AT_LIMIT: f64 = 6.0;
/// What a target at a singularity costs.
pub const AT_SINGULARITY: f64 = 12.0;
/// Costs that differ by less are alike: a millionth of a degree.
const ALIKE: f64 = 1e-6;
/// More than what adding up a chain rounds, as a share of its cost.
const ROUNDING: f64 = 1e-12;
/// So many states of a target are worked out by one thread.
pub(super) const SIDE_BY_SIDE: usize = 256;

/// A joint's share of the cost, per degree: fast joints are cheap.
pub(super) fn weights(speeds_deg_s: &[f64; 6]) -> [f64; 6] {
    let mean = speeds_deg_s.iter().fold(0.0, |a, b| a + b) / 6.0;
    speeds_deg_s.map(|s| mean / s)
}

/// How far each joint may go in a move of so many seconds, degrees.
pub(super) fn most_deg(speeds_deg_s: &[f64; 6], seconds: f64) -> [f64; 6] {
    speeds_deg_s.map(|s| (MOST_SPEED * s * seconds).min(MOST_STEP_DEG))
}

/// Number of the node that leaves a target out.
pub(super) const OUT: u32 = u32::MAX;

/// The states of one target, each with the cost of the cheapest chain that ends in it.
#[derive(Clone)]
pub(super) struct TargetStates {
    pub states: Vec<ArmState>,
    pub cost: Vec<f64>,
    /// What each state costs by itself.
    pub state_costs: Vec<f64>,
    /// Cost with this target left out.
    pub left_out: f64,
    /// Where the states of each branch and spin begin.
    begin: Vec<u32>,
    /// By how many turns each state's joints differ from those of the first of its branch and spin, by [`packed`].
    pub turns: Vec<i32>,
}

impl TargetStates {
    /// The start of the chain, before the first target: no states and no cost.
    pub fn start() -> TargetStates {
        let (states, cost, state_costs) = (Vec::new(), Vec::new(), Vec::new());
        TargetStates { states, cost, state_costs, left_out: 0.0, begin: Vec::new(), turns: Vec::new() }
    }

    /// `states` in the order of branch and spin.
    pub fn new(states: Vec<ArmState>, rules: &Rules<'_>) -> TargetStates {
        let spins = rules.arm.spins();
        let mut begin = vec![0_u32; 8 * spins + 1];
        for s in &states {
            begin[usize::from(s.branch) * spins + usize::from(s.spin) + 1] += 1;
        }
        for i in 1..begin.len() {
            begin[i] += begin[i - 1];
        }
        let state_costs = states.iter().map(|s| rules.state_cost(s)).collect();
        let turns = states
            .chunk_by(|a, b| (a.branch, a.spin) == (b.branch, b.spin))
            .flat_map(|alike| alike.iter().map(|s| packed(&turns_from(&alike[0], s))))
            .collect();
        let cost = vec![f64::INFINITY; states.len()];
        TargetStates { cost, states, state_costs, left_out: f64::INFINITY, begin, turns }
    }

    /// The states of a branch and spin.
    pub fn range(&self, branch: usize, spin: usize, spins: usize) -> std::ops::Range<usize> {
        let at = branch * spins + spin;
        match (self.begin.get(at), self.begin.get(at + 1)) {
            (Some(&a), Some(&b)) => a as usize..b as usize,
            _ => 0..0,
        }
    }

    /// By how much the same states cost more elsewhere, all of them and the one that leaves the target out; `None`: not all by
    /// the same.
    pub fn costs_less_by(&self, dearer: &TargetStates) -> Option<f64> {
        let more = dearer.left_out - self.left_out;
        let is_alike = |(a, b): (&f64, &f64)| (b - a - more).abs() <= ALIKE + ROUNDING * b.abs();
        let pairs = self.cost.iter().zip(&dearer.cost);
        (self.cost.len() == dearer.cost.len() && pairs.into_iter().all(is_alike)).then_some(more)
    }

    /// These states, each dearer by `more`.
    pub fn dearer_by(&self, more: f64) -> TargetStates {
        let mut states = self.clone();
        states.cost.iter_mut().for_each(|cost| *cost += more);
        states.left_out += more;
        states
    }

    /// The cheapest node and its cost.
    pub fn cheapest(&self) -> (u32, f64) {
        let mut best = (OUT, self.left_out);
        for (i, &cost) in self.cost.iter().enumerate() {
            if cost < best.1 {
                best = (i as u32, cost);
            }
        }
        best
    }
}

/// By how many turns the joints of a state differ from those of another reading of the same solution.
fn turns_from(first: &ArmState, other: &ArmState) -> [i32; 6] {
    std::array::from_fn(|j| whole_turns(other.joints_deg[j] - first.joints_deg[j]))
}

/// Whole turns in a way, to the nearest. Most ways have none, and rounding is dear.
pub(super) fn whole_turns(deg: f64) -> i32 {
    if deg.abs() <= 180.0 { 0 } else { (deg / 360.0).round() as i32 }
}

/// Turns of all joints as one number; those of a way are the sum of those of its pieces. No joint is read at more than
/// three turns, so each has five bits to spare.
pub(super) fn packed(turns: &[i32; 6]) -> i32 {
    turns.iter().rev().fold(0, |sum, turn| sum * 32 + turn)
}

/// What a state and a move cost.
pub(super) struct Rules<'a> {
    pub arm: &'a Arm<'a>,
    pub weights: [f64; 6],
    /// Changes of the spin's number that are allowed, the least first.
    pub spin_steps: Vec<usize>,
}

impl<'a> Rules<'a> {
    pub fn new(arm: &'a Arm<'a>) -> Rules<'a> {
        let spins = arm.spins();
        let most = (MOST_SPIN_STEP_DEG / SPIN_STEP_DEG) as usize;
        let mut spin_steps = vec![0];
        for step in 1..=if spins > 2 { most.min(spins / 2) } else { 0 } {
            spin_steps.extend([step, spins - step]);
        }
        Rules { arm, weights: weights(&arm.robot.speeds_deg_s), spin_steps }
    }

    /// What a state costs by itself: nearness to limits and to singularities.
    fn state_cost(&self, state: &ArmState) -> f64 {
        let robot = self.arm.robot;
        let share = |x: f64, from: f64| ((from - x) / from).max(0.0);
        let limit = share(robot.limit_margin_deg(&state.joints_deg), NEAR_LIMIT_DEG);
        let singular = share(state.singularity, NEAR_SINGULAR);
        AT_LIMIT * limit * limit + AT_SINGULARITY * singular * singular
    }

    pub fn travel(&self, from: &Joints, to: &Joints) -> f64 {
        (0..6).map(|j| self.weights[j] * (to[j] - from[j]).abs()).fold(0.0, |a, b| a + b)
    }
}
