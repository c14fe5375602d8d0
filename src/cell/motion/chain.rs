//! The cheapest chain of states over all targets, by dynamic programming.
//!
//! Within a lit piece a move keeps its branch, turns no joint by more than 30°, the spin by no more
//! than 30°, and no joint faster than it can go at the programmed speed of the spot. The cost is joint
//! travel, nearness to limits and nearness to singularities. Where no chain exists, the fewest targets
//! possible are left out. All spins are looked at; nothing is sampled or refined, so the chain is the
//! optimum of these rules.

use super::clusters::{StateCluster, clusters};
use super::states::{Arm, ArmState, NoState, SPIN_STEP_DEG};
use crate::cell::{Contact, Joints};
use nalgebra::Isometry3;
use rayon::prelude::*;

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
/// Targets whose states are made at once.
const CHUNK: usize = 256;
/// So many states of a target are worked out by one thread.
const SIDE_BY_SIDE: usize = 256;

/// A target of the chain: where the focus has to be, and how fast it is come to.
pub(super) struct ChainTarget {
    pub pass: usize,
    pub point: usize,
    pub part_from_focus: Isometry3<f64>,
    /// Time of the lit move that ends here, s; `None`: none does.
    pub lit_s: Option<f64>,
}

/// The states of a target, or why it has none.
pub(super) type SolvedTarget = Result<Vec<ArmState>, NoPoseReason>;

/// Why a target has no state.
pub(super) enum NoPoseReason {
    /// The arm cannot stand there.
    NoState(NoState),
    /// All its states touch something; the contact of the first.
    Contact(Contact),
    /// No way leads there in any branch.
    NoWay,
}

/// A joint's share of the cost, per degree: fast joints are cheap.
pub(super) fn weights(speeds_deg_s: &[f64; 6]) -> [f64; 6] {
    let mean = speeds_deg_s.iter().fold(0.0, |a, b| a + b) / 6.0;
    speeds_deg_s.map(|s| mean / s)
}

/// How far each joint may go in a move of so many seconds, degrees.
pub(super) fn most_deg(speeds_deg_s: &[f64; 6], seconds: f64) -> [f64; 6] {
    speeds_deg_s.map(|s| (MOST_SPEED * s * seconds).min(MOST_STEP_DEG))
}

/// A chain over all stops: the state of each, or why there is none (`None`: it has states, but the
/// cheapest chain leaves it out).
pub(super) fn chain(
    arm: &Arm<'_>,
    targets: &[ChainTarget],
    go_on: &(dyn Fn() -> bool + Sync),
    solve: impl Fn(&ChainTarget) -> SolvedTarget + Sync,
) -> Option<Vec<Result<ArmState, Option<NoPoseReason>>>> {
    let rules = Rules::new(arm);
    let mut trace: Vec<Trace> = Vec::with_capacity(targets.len());
    let mut before = TargetStates::start();
    for chunk in targets.chunks(CHUNK) {
        if !go_on() {
            return None;
        }
        let made: Vec<(TargetStates, Option<NoPoseReason>)> = chunk
            .par_iter()
            .map(|target| match solve(target) {
                Ok(states) => (TargetStates::new(states, &rules), None),
                Err(reason) => (TargetStates::new(Vec::new(), &rules), Some(reason)),
            })
            .collect();
        for (target, (mut current, reason)) in chunk.iter().zip(made) {
            let from = match target.lit_s {
                Some(seconds) => rules.after_lit_move(&before, &mut current, seconds),
                None => rules.after_connecting_move(&before, &mut current),
            };
            let (left_out_from, cheapest) = before.cheapest();
            current.left_out = cheapest + LEFT_OUT;
            let keys = current.states.iter().map(|s| [s.spin, s.branch, s.turn]).collect();
            trace.push(Trace { from, left_out_from, keys, reason });
            before = current;
        }
    }
    let mut at = before.cheapest().0;
    let mut picked = vec![OUT; targets.len()];
    for (pick, t) in picked.iter_mut().zip(&trace).rev() {
        *pick = at;
        at = if at == OUT { t.left_out_from } else { t.from[at as usize] };
    }
    let state = |(target, t, pick): (&ChainTarget, Trace, u32)| {
        let key = t.keys.get(pick as usize);
        key.and_then(|[spin, branch, turn]| arm.state(&target.part_from_focus, *spin, *branch, *turn)).ok_or(t.reason)
    };
    Some(targets.iter().zip(trace).zip(picked).map(|((target, t), pick)| state((target, t, pick))).collect())
}

/// Number of the node that leaves a target out.
const OUT: u32 = u32::MAX;

/// What is kept of a target for tracing the chain back: predecessors, and what each state can be made again from.
struct Trace {
    from: Vec<u32>,
    left_out_from: u32,
    keys: Vec<[u8; 3]>,
    reason: Option<NoPoseReason>,
}

/// The states of one target, each with the cost of the cheapest chain that ends in it.
struct TargetStates {
    states: Vec<ArmState>,
    cost: Vec<f64>,
    /// What each state costs by itself.
    state_costs: Vec<f64>,
    /// Cost with this target left out.
    left_out: f64,
    /// Where the states of each branch and spin begin.
    begin: Vec<u32>,
}

impl TargetStates {
    /// The start of the chain, before the first target: no states and no cost.
    fn start() -> TargetStates {
        TargetStates { states: Vec::new(), cost: Vec::new(), state_costs: Vec::new(), left_out: 0.0, begin: Vec::new() }
    }

    /// `states` in the order of branch and spin.
    fn new(states: Vec<ArmState>, rules: &Rules<'_>) -> TargetStates {
        let spins = rules.arm.spins();
        let mut begin = vec![0_u32; 8 * spins + 1];
        for s in &states {
            begin[usize::from(s.branch) * spins + usize::from(s.spin) + 1] += 1;
        }
        for i in 1..begin.len() {
            begin[i] += begin[i - 1];
        }
        let state_costs = states.iter().map(|s| rules.state_cost(s)).collect();
        TargetStates { cost: vec![f64::INFINITY; states.len()], states, state_costs, left_out: f64::INFINITY, begin }
    }

    /// The states of a branch and spin.
    fn range(&self, branch: usize, spin: usize, spins: usize) -> std::ops::Range<usize> {
        let at = branch * spins + spin;
        match (self.begin.get(at), self.begin.get(at + 1)) {
            (Some(&a), Some(&b)) => a as usize..b as usize,
            _ => 0..0,
        }
    }

    /// The cheapest node and its cost.
    fn cheapest(&self) -> (u32, f64) {
        let mut best = (OUT, self.left_out);
        for (i, &cost) in self.cost.iter().enumerate() {
            if cost < best.1 {
                best = (i as u32, cost);
            }
        }
        best
    }
}

/// What a state and a move cost.
struct Rules<'a> {
    arm: &'a Arm<'a>,
    weights: [f64; 6],
    /// Changes of the spin's number that are allowed, the least first.
    spin_steps: Vec<usize>,
}

impl<'a> Rules<'a> {
    fn new(arm: &'a Arm<'a>) -> Rules<'a> {
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

    fn travel(&self, from: &Joints, to: &Joints) -> f64 {
        (0..6).map(|j| self.weights[j] * (to[j] - from[j]).abs()).fold(0.0, |a, b| a + b)
    }

    /// Sets the costs of a target that a lit move leads to; gives the predecessors.
    fn after_lit_move(&self, before: &TargetStates, current: &mut TargetStates, seconds: f64) -> Vec<u32> {
        let most = most_deg(&self.arm.robot.speeds_deg_s, seconds);
        let spins = self.arm.spins();
        let reach = |(state, state_cost): (&ArmState, &f64)| {
            let to = &state.joints_deg;
            // Without its predecessor the piece starts here, after another connecting move.
            let mut best = (before.left_out + STARTED_ANEW, OUT);
            for step in &self.spin_steps {
                let spin = (usize::from(state.spin) + step) % spins;
                'candidates: for k in before.range(usize::from(state.branch), spin, spins) {
                    let mut cost = before.cost[k];
                    let here = &before.states[k].joints_deg;
                    // The last joint has the most readings.
                    if cost >= best.0 || (to[5] - here[5]).abs() > most[5] {
                        continue;
                    }
                    for j in 0..6 {
                        let moved = (to[j] - here[j]).abs();
                        if moved > most[j] {
                            continue 'candidates;
                        }
                        cost += self.weights[j] * moved;
                    }
                    if cost < best.0 {
                        best = (cost, k as u32);
                    }
                }
            }
            (best.0 + state_cost, best.1)
        };
        let reached: Vec<(f64, u32)> =
            current.states.par_iter().zip(&current.state_costs).with_min_len(SIDE_BY_SIDE).map(reach).collect();
        current.cost = reached.iter().map(|r| r.0).collect();
        reached.into_iter().map(|r| r.1).collect()
    }

    /// Sets the costs of a target that a connecting move leads to, from any state to any; gives the predecessors.
    fn after_connecting_move(&self, before: &TargetStates, current: &mut TargetStates) -> Vec<u32> {
        let clusters = clusters(&before.states, &before.cost);
        let reach_all = |(states, state_cost): (&[ArmState], &[f64])| -> Vec<(f64, u32)> {
            // What was best for the state before is good for this one, and shows what need not be looked at.
            let mut guess = OUT;
            let reach = |(state, state_cost): (&ArmState, &f64)| {
                let best = self.cheapest_way(before, &clusters, state, guess);
                guess = best.1;
                (best.0 + state_cost, best.1)
            };
            states.iter().zip(state_cost).map(reach).collect()
        };
        let reached: Vec<(f64, u32)> = current
            .states
            .par_chunks(SIDE_BY_SIDE)
            .zip(current.state_costs.par_chunks(SIDE_BY_SIDE))
            .flat_map_iter(reach_all)
            .collect();
        current.cost = reached.iter().map(|r| r.0).collect();
        reached.into_iter().map(|r| r.1).collect()
    }

    /// Cost and predecessor of a state after a connecting move; `guess` may be a good predecessor.
    fn cheapest_way(
        &self,
        before: &TargetStates,
        clusters: &[StateCluster],
        state: &ArmState,
        guess: u32,
    ) -> (f64, u32) {
        let changed = |branch: u8| if branch == state.branch { 0.0 } else { CHANGED_BRANCH };
        let mut best = (before.left_out, OUT);
        let look = |best: &mut (f64, u32), k: u32| {
            let here = &before.states[k as usize];
            let so_far = before.cost[k as usize] + changed(here.branch);
            if so_far < best.0 {
                let cost = so_far + self.travel(&here.joints_deg, &state.joints_deg);
                if cost < best.0 {
                    *best = (cost, k);
                }
            }
        };
        if guess != OUT {
            look(&mut best, guess);
        }
        for cluster in clusters {
            // Travel costs something at least: none behind this one can be cheaper.
            if cluster.cost >= best.0 {
                break;
            }
            let nearest = cluster.nearest(&state.joints_deg);
            if cluster.cost + changed(cluster.branch) + self.travel(&nearest, &state.joints_deg) < best.0 {
                cluster.states.iter().for_each(|k| look(&mut best, *k));
            }
        }
        best
    }
}
