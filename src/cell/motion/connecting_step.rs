//! The cheapest predecessor of each state over a connecting move, which may lead from any state to any.

use super::clusters::{StateBounds, StateGroup, groups};
use super::rules::{CHANGED_BRANCH, OUT, Rules, SIDE_BY_SIDE, TargetStates};
use super::states::ArmState;
use rayon::prelude::*;

impl Rules<'_> {
    /// Sets the costs of a target that a connecting move leads to, from any state to any; gives the predecessors.
    pub fn after_connecting_move(&self, before: &TargetStates, current: &mut TargetStates) -> Vec<u32> {
        let groups = groups(&before.states, &before.cost);
        let reach_all = |(states, state_cost): (&[ArmState], &[f64])| -> Vec<(f64, u32)> {
            // What was best for the state before is good for this one, and shows what need not be looked at.
            let mut guess = OUT;
            let reach = |(state, state_cost): (&ArmState, &f64)| {
                let best = self.cheapest_way(before, &groups, state, guess);
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
    fn cheapest_way(&self, before: &TargetStates, groups: &[StateGroup], state: &ArmState, guess: u32) -> (f64, u32) {
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
        for group in groups {
            // Travel costs something at least: none behind this one can be cheaper.
            if group.bounds.cost >= best.0 {
                break;
            }
            let more = changed(group.branch);
            let least = |b: &StateBounds| b.cost + more + self.travel(&b.nearest(&state.joints_deg), &state.joints_deg);
            if least(&group.bounds) >= best.0 {
                continue;
            }
            for cluster in &group.clusters {
                if cluster.bounds.cost >= best.0 {
                    break;
                }
                if least(&cluster.bounds) < best.0 {
                    cluster.states.iter().for_each(|k| look(&mut best, *k));
                }
            }
        }
        best
    }
}
