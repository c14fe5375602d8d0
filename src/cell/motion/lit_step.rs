//! The cheapest predecessor of each state over a lit move, which keeps its branch and turns no joint far.
//!
//! From one branch and spin to another every joint goes the same way, whatever turns it is read at: the way is worked
//! out once, and a state has one predecessor there at most, the one that is read at the same turns.

use super::rules::{OUT, Rules, SIDE_BY_SIDE, STARTED_ANEW, TargetStates, most_deg, packed, whole_turns};
use crate::cell::Joints;
use rayon::prelude::*;
use std::ops::Range;

/// More than the rounding of a joint's way, degrees.
const ROUNDING_DEG: f64 = 1e-6;

/// The states of one branch and spin of the target before, and by how many turns more those are read that lead on.
struct Way {
    states: Range<usize>,
    turns: i32,
}

impl Rules<'_> {
    /// Sets the costs of a target that a lit move leads to; gives the predecessors.
    pub fn after_lit_move(&self, before: &TargetStates, current: &mut TargetStates, seconds: f64) -> Vec<u32> {
        let most = most_deg(&self.arm.robot.speeds_deg_s, seconds);
        let branches_at_once = (8 * SIDE_BY_SIDE).div_ceil(current.states.len().max(1));
        let of_branch = |branch: usize| self.reached_in_branch(before, current, &most, branch);
        let reached: Vec<(f64, u32)> =
            (0..8_usize).into_par_iter().with_min_len(branches_at_once).flat_map_iter(of_branch).collect();
        current.cost = reached.iter().map(|r| r.0).collect();
        reached.into_iter().map(|r| r.1).collect()
    }

    /// Costs and predecessors of all states of a branch.
    fn reached_in_branch(
        &self,
        before: &TargetStates,
        current: &TargetStates,
        most: &Joints,
        branch: usize,
    ) -> Vec<(f64, u32)> {
        let spins = self.arm.spins();
        let mut out = Vec::new();
        for spin in 0..spins {
            let states = current.range(branch, spin, spins);
            let Some(first) = current.states.get(states.clone()).and_then(|s| s.first()) else { continue };
            let way =
                |step: &usize| way(before, before.range(branch, (spin + step) % spins, spins), &first.joints_deg, most);
            let ways: Vec<Way> = self.spin_steps.iter().filter_map(way).collect();
            out.extend(states.map(|i| self.cheapest_of(&ways, before, current, i, most)));
        }
        out
    }

    /// Cost and predecessor of a state.
    fn cheapest_of(
        &self,
        ways: &[Way],
        before: &TargetStates,
        current: &TargetStates,
        i: usize,
        most: &Joints,
    ) -> (f64, u32) {
        // Without its predecessor the piece starts here, after another connecting move.
        let mut best = (before.left_out + STARTED_ANEW, OUT);
        for way in ways {
            let turns = current.turns[i] + way.turns;
            let Some(at) = before.turns[way.states.clone()].iter().position(|t| *t == turns) else { continue };
            let k = way.states.start + at;
            let so_far = before.cost[k];
            if so_far >= best.0 {
                continue;
            }
            let cost = self.lit_cost(so_far, &before.states[k].joints_deg, &current.states[i].joints_deg, most);
            if let Some(cost) = cost.filter(|c| *c < best.0) {
                best = (cost, k as u32);
            }
        }
        (best.0 + current.state_costs[i], best.1)
    }

    /// The cost of a chain with one more move; `None`: a joint would go too far.
    fn lit_cost(&self, so_far: f64, from: &Joints, to: &Joints, most: &Joints) -> Option<f64> {
        (0..6).try_fold(so_far, |cost, j| {
            let moved = (to[j] - from[j]).abs();
            (moved <= most[j]).then_some(cost + self.weights[j] * moved)
        })
    }
}

/// The way from states of one branch and spin to a state of another; `None`: there are none, or a joint would go too
/// far.
fn way(before: &TargetStates, states: Range<usize>, to: &Joints, most: &Joints) -> Option<Way> {
    let from = &before.states.get(states.clone())?.first()?.joints_deg;
    let mut turns = [0; 6];
    // The last joint turns most.
    for j in (0..6).rev() {
        let moved = to[j] - from[j];
        turns[j] = whole_turns(moved);
        if (moved - 360.0 * f64::from(turns[j])).abs() > most[j] + ROUNDING_DEG {
            return None;
        }
    }
    Some(Way { states, turns: packed(&turns) })
}
