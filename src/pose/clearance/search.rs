//! Dynamic programming along the line: the best sequence of tilts through layers of candidates.
//!
//! A candidate is free if the beam is, held so, over the stretch of the line that is nearer to its layer
//! than to others. Candidates of neighbouring layers connect where the rate allows it. What connects
//! is tested exactly only on the chain that was chosen; what fails there is struck out, and the chain
//! is made again from that layer on. The laser may be off between layers. A chain's cost is its blocked length; of
//! equals the number of splits decides, and of equals again tilt, turns and nearness to what is in the way.

use super::bins::Bins;
use super::track::{TiltVector, Track};
use crate::pose::BeamInterference;
use std::collections::BTreeMap;

/// Each degree that the tilt turns costs as much as a degree of tilt over this length, mm: of equal
/// ways the steadier one.
const TURN_MM: f64 = 0.05;
/// Rounds after which a motion that still fails is given up, the laser off.
const MOST_ROUNDS: usize = 80;

/// The candidate tilts at one point of the line.
#[derive(Clone, Debug)]
pub struct TiltLayer {
    /// Index of the point.
    pub site: usize,
    /// Its candidates.
    pub tilts: Vec<TiltVector>,
    /// Whether they are fixed from outside; then they are not tested.
    pub given: bool,
    /// Spacing of a coarser grid that is tested first: candidates among its free cells count as free until the chain
    /// uses them, candidates among blocked cells as blocked.
    pub coarser_deg: Option<f64>,
}

/// What a sequence costs: blocked length, then splits, then tilt; compared in this order.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Cost {
    /// Length with the laser off, µm.
    pub blocked_um: u64,
    /// Number of times the laser is switched on again.
    pub splits: u32,
    /// Tilt, dose, nearness, mm·degrees.
    pub other: f64,
}

impl Cost {
    fn plus(self, other: f64) -> Cost {
        Cost { other: self.other + other, ..self }
    }
}

/// The tilts by which a sequence comes to each layer and leaves it; `None`: the laser is off.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// Arriving.
    pub arrive: Vec<Option<TiltVector>>,
    /// Leaving.
    pub leave: Vec<Option<TiltVector>>,
    /// Its cost.
    pub cost: Cost,
}

/// The best chain through the layers, none of which is empty.
pub fn best_chain(beam: &BeamInterference<'_>, track: &Track<'_>, layers: &[TiltLayer]) -> Chain {
    if beam.check().is_err() {
        return Chain { arrive: vec![None; layers.len()], leave: vec![None; layers.len()], cost: Cost::default() };
    }
    let mut dp =
        ChainSearch { beam, track, layers, layer_costs: Vec::new(), known: BTreeMap::new(), only_known: false };
    dp.layer_costs = (0..layers.len()).map(|k| dp.costs_of(k)).collect();
    let mut from = 0;
    for _ in 0..MOST_ROUNDS {
        if beam.check().is_err() {
            break;
        }
        dp.forward(from);
        let chain = dp.traced_back();
        match dp.first_failing(&chain) {
            None => return dp.to_tilts(&chain),
            Some(first) => from = first,
        }
    }
    // From here on only motions that were tested may be used.
    dp.only_known = true;
    dp.forward(0);
    let chain = dp.traced_back();
    dp.to_tilts(&chain)
}

/// Indices of the candidates by which a chain comes to each layer and leaves it.
pub(super) type ChainSteps = Vec<(Option<usize>, Option<usize>)>;

/// Costs of the candidates of a layer, and the best ways to them.
pub(super) struct LayerCosts {
    /// Cost per mm of each candidate; `None`: not free.
    pub(super) weight: Vec<Option<f64>>,
    /// Whether a candidate's freedom was only inferred from a coarser grid.
    pub(super) assumed: Vec<bool>,
    /// The free candidates.
    pub(super) bins: Bins,
    /// Best way to come to each candidate, and from which of the layer before.
    pub(super) arrive: Vec<Option<(Cost, usize)>>,
    /// Best way to be off here, and from which candidate of this layer; none: off before.
    pub(super) off: (Cost, Option<usize>),
    /// Best way to leave from each candidate, and whether that is by switching on here.
    pub(super) leave: Vec<Option<(Cost, bool)>>,
}

pub(super) struct ChainSearch<'a> {
    pub(super) beam: &'a BeamInterference<'a>,
    pub(super) track: &'a Track<'a>,
    pub(super) layers: &'a [TiltLayer],
    pub(super) layer_costs: Vec<LayerCosts>,
    /// Whether the way between two candidates, from the layer of that number on, is free.
    pub(super) known: BTreeMap<(usize, usize, usize), bool>,
    pub(super) only_known: bool,
}

impl ChainSearch<'_> {
    fn arc_mm(&self, k: usize) -> f64 {
        self.track.sites[self.layers[k].site].arc_mm
    }

    /// How far the tilt may turn on the way to the next layer, degrees.
    pub(super) fn reach_deg(&self, k: usize) -> f64 {
        self.track.rate_deg_mm * (self.arc_mm(k + 1) - self.arc_mm(k)) + 1e-9
    }

    /// Computes the best ways to all candidates, from one layer on.
    fn forward(&mut self, from: usize) {
        for k in from..self.layers.len() {
            let count = self.layers[k].tilts.len();
            let mut arrive = vec![None; count];
            let mut off = (Cost::default(), None);
            match k.checked_sub(1) {
                None => {
                    for (slot, w) in arrive.iter_mut().zip(&self.layer_costs[k].weight) {
                        *slot = w.map(|_| (Cost::default(), 0));
                    }
                }
                Some(b) => {
                    if self.beam.check().is_ok() {
                        for (v, slot) in arrive.iter_mut().enumerate() {
                            *slot = self.best_arrival(b, v);
                        }
                    }
                    let before = self.layer_costs[b].off.0;
                    let dark_um = ((self.arc_mm(k) - self.arc_mm(b)) * 1000.0).round() as u64;
                    off.0 = Cost { blocked_um: before.blocked_um + dark_um, ..before };
                }
            }
            for (u, (cost, _)) in arrive.iter().enumerate().filter_map(|(u, a)| a.map(|a| (u, a))) {
                if k > 0 && cost < off.0 {
                    off = (cost, Some(u));
                }
            }
            let on = Cost { splits: off.0.splits + 1, ..off.0 };
            let leave = arrive.iter().zip(&self.layer_costs[k].weight).map(|(a, w)| match a {
                Some((cost, _)) if k == 0 || *cost <= on => Some((*cost, false)),
                _ => w.map(|_| (on, true)),
            });
            let leave = leave.collect();
            let costs = &mut self.layer_costs[k];
            (costs.arrive, costs.off, costs.leave) = (arrive, off, leave);
        }
    }

    /// The best way to a candidate of the layer behind `b`.
    fn best_arrival(&self, b: usize, v: usize) -> Option<(Cost, usize)> {
        let (from, to) = (&self.layer_costs[b], &self.layer_costs[b + 1]);
        let (tilt, weight) = (&self.layers[b + 1].tilts[v], to.weight[v]?);
        let way_mm = self.arc_mm(b + 1) - self.arc_mm(b);
        let reach = self.reach_deg(b);
        let mut best: Option<(Cost, usize)> = None;
        from.bins.for_each_near(tilt, |u| {
            let turn = (tilt - self.layers[b].tilts[u]).norm();
            if turn > reach {
                return;
            }
            let (Some((cost, _)), Some(w)) = (from.leave.get(u).copied().flatten(), from.weight[u]) else { return };
            let cost = cost.plus(0.5 * way_mm * (w + weight) + TURN_MM * turn);
            if best.is_none_or(|x| (cost, u) < x) && self.known.get(&(b, u, v)).copied().unwrap_or(!self.only_known) {
                best = Some((cost, u));
            }
        });
        best
    }

    fn traced_back(&self) -> ChainSteps {
        let mut out = vec![(None, None); self.layers.len()];
        let Some(end) = self.layer_costs.last() else { return out };
        let lit = end.arrive.iter().enumerate().filter_map(|(u, a)| a.map(|a| (a.0, u)));
        let best = lit.fold(None, |x: Option<(Cost, usize)>, y| if x.is_some_and(|x| x <= y) { x } else { Some(y) });
        let mut here = best.filter(|b| b.0 <= end.off.0).map(|b| b.1);
        for k in (0..self.layers.len()).rev() {
            let costs = &self.layer_costs[k];
            // `here`: the candidate by which the chain comes to layer k, or off.
            let arrive = here.or(costs.off.1);
            out[k].0 = arrive;
            let Some(b) = k.checked_sub(1) else { break };
            let Some(u) = arrive.and_then(|u| costs.arrive[u]).map(|a| a.1) else {
                here = None;
                continue;
            };
            out[b].1 = Some(u);
            here = self.layer_costs[b].leave[u].and_then(|l| (!l.1).then_some(u));
        }
        out
    }

    fn to_tilts(&self, chain: &ChainSteps) -> Chain {
        let tilt = |k: usize, u: Option<usize>| u.map(|u| self.layers[k].tilts[u]);
        let arrive = chain.iter().enumerate().map(|(k, s)| tilt(k, s.0)).collect();
        let leave = chain.iter().enumerate().map(|(k, s)| tilt(k, s.1)).collect();
        let cost = self.layer_costs.last().map_or(Cost::default(), |end| {
            end.arrive.iter().flatten().map(|a| a.0).fold(end.off.0, |x, y| if y <= x { y } else { x })
        });
        Chain { arrive, leave, cost }
    }
}
