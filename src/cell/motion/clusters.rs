//! Clusters of states that lie near each other, to bound the cost of a connecting move from any of them: most are too
//! far away for the cheapest, and their states need not be tried one by one.

use super::states::ArmState;
use crate::cell::Joints;

/// Neighbouring spins whose states are looked at as one cluster.
const CLUSTER_SPINS: u8 = 4;

/// States of one branch that lie near each other, and the box around their joints.
pub(super) struct StateCluster {
    pub states: Vec<u32>,
    pub branch: u8,
    least: Joints,
    most: Joints,
    /// Cost of its cheapest state.
    pub cost: f64,
}

impl StateCluster {
    /// The joints of the box that are nearest to others.
    pub fn nearest(&self, to: &Joints) -> Joints {
        std::array::from_fn(|j| to[j].clamp(self.least[j], self.most[j]))
    }
}

/// All states with their costs in clusters, the cheapest first.
pub(super) fn clusters(all: &[ArmState], cost: &[f64]) -> Vec<StateCluster> {
    let readings = |s: &ArmState| s.joints_deg.map(|deg| (deg / 360.0).round() as i8);
    let mut order: Vec<u32> = (0..all.len() as u32).collect();
    let key = |k: u32| {
        let s = &all[k as usize];
        (s.branch, readings(s), s.spin)
    };
    order.sort_by_cached_key(|k| key(*k));
    let like = |a: &u32, b: &u32| {
        let (a, b) = (key(*a), key(*b));
        (a.0, a.1, a.2 / CLUSTER_SPINS) == (b.0, b.1, b.2 / CLUSTER_SPINS)
    };
    let cluster = |states: &[u32]| {
        let of = |k: &u32| &all[*k as usize];
        let edge = |pick: fn(f64, f64) -> f64, start: f64| -> Joints {
            std::array::from_fn(|j| states.iter().map(|k| of(k).joints_deg[j]).fold(start, pick))
        };
        StateCluster {
            branch: states.first().map_or(0, |k| of(k).branch),
            least: edge(f64::min, f64::INFINITY),
            most: edge(f64::max, f64::NEG_INFINITY),
            cost: states.iter().map(|k| cost[*k as usize]).fold(f64::INFINITY, f64::min),
            states: states.to_vec(),
        }
    };
    let mut out: Vec<StateCluster> = order.chunk_by(like).map(cluster).collect();
    out.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Every state is in one cluster, within its box and no cheaper than it; clusters are of one branch.
        #[test]
        fn a_cluster_bounds_its_states(joints in prop::collection::vec(prop::array::uniform6(-360.0..360.0f64), 0..200),
                                     to in prop::array::uniform6(-400.0..400.0f64)) {
            let state = |(i, joints_deg): (usize, &Joints)| ArmState {
                joints_deg: *joints_deg, spin: (i / 3 % 72) as u8, branch: (i % 8) as u8, turn: 0, singularity: 1.0,
            };
            let all: Vec<ArmState> = joints.iter().enumerate().map(state).collect();
            let cost: Vec<f64> = joints.iter().map(|j| j[0].abs()).collect();
            let found = clusters(&all, &cost);
            let mut seen: Vec<u32> = found.iter().flat_map(|c| c.states.clone()).collect();
            seen.sort_unstable();
            prop_assert_eq!(seen, (0..all.len() as u32).collect::<Vec<_>>());
            prop_assert!(found.windows(2).all(|w| w[0].cost <= w[1].cost));
            for c in &found {
                let nearest = c.nearest(&to);
                for k in &c.states {
                    let s = &all[*k as usize];
                    prop_assert!(s.branch == c.branch && cost[*k as usize] >= c.cost);
                    prop_assert!((0..6).all(|j| (nearest[j] - to[j]).abs() <= (s.joints_deg[j] - to[j]).abs()));
                }
            }
        }
    }
}
