//! Clusters of states that lie near each other, in groups that are read at the same turns, to bound the cost of a
//! connecting move from any of them: most are too far away for the cheapest, and need not be tried one by one.

use super::states::ArmState;
use crate::cell::Joints;

/// Neighbouring spins whose states are looked at as one cluster.
const CLUSTER_SPINS: u8 = 4;

/// The box around the joints of some states, and the cost of the cheapest.
pub(super) struct StateBounds {
    least: Joints,
    most: Joints,
    pub cost: f64,
}

impl StateBounds {
    /// The joints of the box that are nearest to others.
    pub fn nearest(&self, to: &Joints) -> Joints {
        std::array::from_fn(|j| to[j].clamp(self.least[j], self.most[j]))
    }

    /// The bounds of two sets together.
    fn with(&self, other: &StateBounds) -> StateBounds {
        StateBounds {
            least: std::array::from_fn(|j| self.least[j].min(other.least[j])),
            most: std::array::from_fn(|j| self.most[j].max(other.most[j])),
            cost: self.cost.min(other.cost),
        }
    }
}

/// States of neighbouring spins.
pub(super) struct StateCluster {
    pub states: Vec<u32>,
    pub bounds: StateBounds,
}

/// All states of one branch that are read at the same turns.
pub(super) struct StateGroup {
    pub branch: u8,
    /// The cheapest first.
    pub clusters: Vec<StateCluster>,
    pub bounds: StateBounds,
}

/// Branch, turns and spin of a state, and its number.
type KeyedState = ((u8, [i8; 6], u8), u32);

/// All states with their costs in groups, the cheapest first.
pub(super) fn groups(all: &[ArmState], cost: &[f64]) -> Vec<StateGroup> {
    let readings = |s: &ArmState| s.joints_deg.map(|deg| (deg / 360.0).round() as i8);
    let mut order: Vec<KeyedState> = all.iter().zip(0..).map(|(s, k)| ((s.branch, readings(s), s.spin), k)).collect();
    order.sort_unstable();
    let bounds = |k: u32| {
        let joints_deg = all[k as usize].joints_deg;
        StateBounds { least: joints_deg, most: joints_deg, cost: cost[k as usize] }
    };
    let cluster = |states: &[KeyedState]| {
        let states: Vec<u32> = states.iter().map(|(_, k)| *k).collect();
        let together = states.iter().map(|k| bounds(*k)).reduce(|a, b| a.with(&b))?;
        Some(StateCluster { states, bounds: together })
    };
    let group = |states: &[KeyedState]| {
        let near = states.chunk_by(|(a, _), (b, _)| a.2 / CLUSTER_SPINS == b.2 / CLUSTER_SPINS);
        let mut clusters: Vec<StateCluster> = near.filter_map(cluster).collect();
        clusters.sort_by(|a, b| a.bounds.cost.total_cmp(&b.bounds.cost));
        let first = clusters.first()?;
        let together = clusters.iter().skip(1).fold(first.bounds.with(&first.bounds), |a, b| a.with(&b.bounds));
        Some(StateGroup { branch: states.first()?.0.0, clusters, bounds: together })
    };
    let mut out: Vec<StateGroup> =
        order.chunk_by(|(a, _), (b, _)| (a.0, a.1) == (b.0, b.1)).filter_map(group).collect();
    out.sort_by(|a, b| a.bounds.cost.total_cmp(&b.bounds.cost));
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Every state is in one cluster of one group, within the boxes of both and no cheaper than they are.
        #[test]
        fn groups_and_clusters_bound_their_states(joints in prop::collection::vec(prop::array::uniform6(-360.0..360.0f64), 0..200),
                                                  to in prop::array::uniform6(-400.0..400.0f64)) {
            let state = |(i, joints_deg): (usize, &Joints)| ArmState {
                joints_deg: *joints_deg, spin: (i / 3 % 72) as u8, branch: (i % 8) as u8, turn: 0, singularity: 1.0,
            };
            let all: Vec<ArmState> = joints.iter().enumerate().map(state).collect();
            let cost: Vec<f64> = joints.iter().map(|j| j[0].abs()).collect();
            let found = groups(&all, &cost);
            let mut seen: Vec<u32> = found.iter().flat_map(|g| &g.clusters).flat_map(|c| c.states.clone()).collect();
            seen.sort_unstable();
            prop_assert_eq!(seen, (0..all.len() as u32).collect::<Vec<_>>());
            prop_assert!(found.windows(2).all(|w| w[0].bounds.cost <= w[1].bounds.cost));
            for g in &found {
                prop_assert!(g.clusters.windows(2).all(|w| w[0].bounds.cost <= w[1].bounds.cost));
                for c in &g.clusters {
                    for k in &c.states {
                        let s = &all[*k as usize];
                        prop_assert!(s.branch == g.branch);
                        for bounds in [&g.bounds, &c.bounds] {
                            let nearest = bounds.nearest(&to);
                            prop_assert!(cost[*k as usize] >= bounds.cost);
                            prop_assert!((0..6).all(|j| (nearest[j] - to[j]).abs() <= (s.joints_deg[j] - to[j]).abs()));
                        }
                    }
                }
            }
        }
    }
}
