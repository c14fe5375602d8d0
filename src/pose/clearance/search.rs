//! Dynamic programming along the line: the best sequence of tilts through layers of candidates.
//!
//! A candidate is free if the beam is, held so, over the stretch of the line that is nearer to its layer
//! than to others. Candidates of neighbouring layers connect where the rate allows it. What connects
//! is tested exactly only on the chain that was chosen; what fails there is struck out, and the chain
//! is made again from that layer on. The laser may be off between layers: blocked length counts before
//! splits, and splits before all else.

use super::track::{Lean, Track};
use crate::pose::Beam;
use crate::pose::motion;
use std::collections::BTreeMap;

/// Energy lost to a tilt, 1 − cos, in degrees of tilt: at 45° it doubles what the tilt itself costs.
const DOSE_DEG: f64 = 150.0;
/// A beam one degree beside a blocked one costs as much as so many degrees of tilt. With it alone a
/// beam would keep √4 = 2° from what is in the way.
pub const NEARNESS_DEG2: f64 = 4.0;
/// Each degree that the tilt turns costs as much as a degree of tilt over this length, mm: of equal
/// ways the steadier one.
const TURN_MM: f64 = 0.05;
/// So often the chain is made again before what still fails is switched off.
const MOST_ROUNDS: usize = 80;

/// What stands in for the cost of a tilt, per mm.
pub fn cost_of(track: &Track<'_>, site: usize, tilt: &Lean) -> f64 {
    let s = &track.sites[site];
    s.pull * (tilt - s.aim).norm() + DOSE_DEG * (1.0 - libm::cos(tilt.norm().to_radians()))
}

/// Candidates at one point of the line.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Index of the point.
    pub site: usize,
    /// Its candidates.
    pub tilts: Vec<Lean>,
    /// Whether they are given: not asked whether they are free.
    pub given: bool,
}

/// What a sequence costs.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Cost {
    /// Length with the laser off, µm.
    pub blocked_um: u64,
    /// Times that it is switched on again.
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
    /// Coming.
    pub arrive: Vec<Option<Lean>>,
    /// Leaving.
    pub leave: Vec<Option<Lean>>,
    /// Its cost.
    pub cost: Cost,
}

/// The best chain through the layers, none of which is empty.
pub fn best(beam: &Beam<'_>, track: &Track<'_>, layers: &[Layer]) -> Chain {
    let mut dp = Dp { beam, track, layers, stages: Vec::new(), known: BTreeMap::new(), only_known: false };
    dp.stages = (0..layers.len()).map(|k| dp.stage(k)).collect();
    let mut from = 0;
    for _ in 0..MOST_ROUNDS {
        dp.forward(from);
        let chain = dp.back();
        match dp.first_failing(&chain) {
            None => return dp.told(&chain),
            Some(first) => from = first,
        }
    }
    // What is still untested may not be gone.
    dp.only_known = true;
    dp.forward(0);
    let chain = dp.back();
    dp.told(&chain)
}

/// Indices of the candidates by which a chain comes to each layer and leaves it.
type Steps = Vec<(Option<usize>, Option<usize>)>;

/// A layer as it is worked on.
struct Stage {
    /// Cost per mm of each candidate; `None`: not free.
    weight: Vec<Option<f64>>,
    /// The free ones.
    bins: Bins,
    /// Best way to come to each candidate, and from which of the layer before.
    arrive: Vec<Option<(Cost, usize)>>,
    /// Best way to be off here, and from which candidate of this layer; none: off before.
    off: (Cost, Option<usize>),
    /// Best way to leave from each candidate, and whether that is by switching on here.
    leave: Vec<Option<(Cost, bool)>>,
}

struct Dp<'a> {
    beam: &'a Beam<'a>,
    track: &'a Track<'a>,
    layers: &'a [Layer],
    stages: Vec<Stage>,
    /// Whether the way between two candidates, from the layer of that number on, is free.
    known: BTreeMap<(usize, usize, usize), bool>,
    only_known: bool,
}

impl Dp<'_> {
    fn arc_mm(&self, k: usize) -> f64 {
        self.track.sites[self.layers[k].site].arc_mm
    }

    /// How far the tilt may turn on the way to the next layer, degrees.
    fn reach_deg(&self, k: usize) -> f64 {
        self.track.rate_deg_mm * (self.arc_mm(k + 1) - self.arc_mm(k)) + 1e-9
    }

    fn stage(&self, k: usize) -> Stage {
        let layer = &self.layers[k];
        let free: Vec<Option<bool>> = layer.tilts.iter().map(|t| self.is_free(k, t)).collect();
        let blocked: Vec<&Lean> =
            layer.tilts.iter().zip(&free).filter(|(_, f)| **f == Some(false)).map(|x| x.0).collect();
        let weight: Vec<Option<f64>> = layer
            .tilts
            .iter()
            .zip(&free)
            .map(|(t, f)| {
                let nearest = blocked.iter().map(|b| (*b - t).norm_squared()).fold(f64::INFINITY, f64::min).sqrt();
                (*f == Some(true)).then(|| cost_of(self.track, layer.site, t) + NEARNESS_DEG2 / nearest)
            })
            .collect();
        let reach_deg = if k + 1 < self.layers.len() { self.reach_deg(k) } else { 1.0 };
        let bins = Bins::new(&layer.tilts, &weight, reach_deg);
        Stage { weight, bins, arrive: Vec::new(), off: (Cost::default(), None), leave: Vec::new() }
    }

    /// Whether the beam is free over the layer's stretch of the line; `None`: not allowed at all.
    fn is_free(&self, k: usize, tilt: &Lean) -> Option<bool> {
        let layer = &self.layers[k];
        let sites = &self.track.sites;
        let here = layer.site;
        if !self.track.allows(&sites[here], tilt) {
            return layer.given.then_some(true);
        }
        if layer.given {
            return Some(true);
        }
        let middle = |other: usize| 0.5 * (sites[other].arc_mm + sites[here].arc_mm);
        let low = k.checked_sub(1).map_or(0.0, |b| middle(self.layers[b].site));
        let high = self.layers.get(k + 1).map_or(f64::INFINITY, |b| middle(b.site));
        let before = (0..here).rev().take_while(|&i| sites[i].arc_mm > low);
        let behind = (here + 1..sites.len()).take_while(|&i| sites[i].arc_mm < high);
        let first = k.checked_sub(1).map_or(here, |b| self.layers[b].site);
        let last = self.layers.get(k + 1).map_or(here, |b| b.site);
        let free = |i: usize| self.beam.is_free(&sites[i].q.p, &sites[i].axis(tilt));
        Some(free(here) && before.take_while(|&i| i > first).all(free) && behind.take_while(|&i| i < last).all(free))
    }

    /// Makes the stages anew from one on.
    fn forward(&mut self, from: usize) {
        for k in from..self.layers.len() {
            let count = self.layers[k].tilts.len();
            let mut arrive = vec![None; count];
            let mut off = (Cost::default(), None);
            match k.checked_sub(1) {
                None => {
                    for (slot, w) in arrive.iter_mut().zip(&self.stages[k].weight) {
                        *slot = w.map(|_| (Cost::default(), 0));
                    }
                }
                Some(b) => {
                    for (v, slot) in arrive.iter_mut().enumerate() {
                        *slot = self.come(b, v);
                    }
                    let before = self.stages[b].off.0;
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
            let leave = arrive.iter().zip(&self.stages[k].weight).map(|(a, w)| match a {
                Some((cost, _)) if k == 0 || *cost <= on => Some((*cost, false)),
                _ => w.map(|_| (on, true)),
            });
            let leave = leave.collect();
            let stage = &mut self.stages[k];
            (stage.arrive, stage.off, stage.leave) = (arrive, off, leave);
        }
    }

    /// The best way to a candidate of the layer behind `b`.
    fn come(&self, b: usize, v: usize) -> Option<(Cost, usize)> {
        let (from, to) = (&self.stages[b], &self.stages[b + 1]);
        let (tilt, weight) = (&self.layers[b + 1].tilts[v], to.weight[v]?);
        let way_mm = self.arc_mm(b + 1) - self.arc_mm(b);
        let reach = self.reach_deg(b);
        let mut best: Option<(Cost, usize)> = None;
        from.bins.near(tilt, |u| {
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

    fn back(&self) -> Steps {
        let mut out = vec![(None, None); self.layers.len()];
        let Some(end) = self.stages.last() else { return out };
        let lit = end.arrive.iter().enumerate().filter_map(|(u, a)| a.map(|a| (a.0, u)));
        let best = lit.fold(None, |x: Option<(Cost, usize)>, y| if x.is_some_and(|x| x <= y) { x } else { Some(y) });
        let mut here = best.filter(|b| b.0 <= end.off.0).map(|b| b.1);
        for k in (0..self.layers.len()).rev() {
            let stage = &self.stages[k];
            // `here`: the candidate by which the chain comes to layer k, or off.
            let arrive = here.or(stage.off.1);
            out[k].0 = arrive;
            let Some(b) = k.checked_sub(1) else { break };
            let Some(u) = arrive.and_then(|u| stage.arrive[u]).map(|a| a.1) else {
                here = None;
                continue;
            };
            out[b].1 = Some(u);
            here = self.stages[b].leave[u].and_then(|l| (!l.1).then_some(u));
        }
        out
    }

    /// Tests the ways of a chain; the layer behind the first that fails.
    fn first_failing(&mut self, chain: &Steps) -> Option<usize> {
        let mut first = None;
        for k in 0..chain.len().saturating_sub(1) {
            let (Some(u), Some(v)) = (chain[k].1, chain[k + 1].0) else { continue };
            let is = match self.known.get(&(k, u, v)) {
                Some(is) => *is,
                None => self.is_way(k, &self.layers[k].tilts[u], &self.layers[k + 1].tilts[v]),
            };
            self.known.insert((k, u, v), is);
            if !is && first.is_none() {
                first = Some(k + 1);
            }
        }
        first
    }

    /// Whether the beam is free from one candidate to one of the next layer, at the points between and
    /// on the motions.
    fn is_way(&self, k: usize, from: &Lean, to: &Lean) -> bool {
        let (a, b) = (self.layers[k].site, self.layers[k + 1].site);
        let sites = &self.track.sites;
        let whole = (sites[b].arc_mm - sites[a].arc_mm).max(1e-12);
        let tilt = |i: usize| from.lerp(to, (sites[i].arc_mm - sites[a].arc_mm) / whole);
        (a + 1..b).all(|i| {
            self.track.allows(&sites[i], &tilt(i)) && self.beam.is_free(&sites[i].q.p, &sites[i].axis(&tilt(i)))
        }) && (a..b)
            .all(|i| motion::is_free(self.beam, &sites[i].pose(&tilt(i)), &sites[i + 1].pose(&tilt(i + 1)), 0.0))
    }

    fn told(&self, chain: &Steps) -> Chain {
        let tilts = |which: fn(&(Option<usize>, Option<usize>)) -> Option<usize>| {
            chain.iter().zip(self.layers).map(|(s, l)| which(s).map(|u| l.tilts[u])).collect()
        };
        let cost = self.stages.last().map_or(Cost::default(), |end| {
            end.arrive.iter().flatten().map(|a| a.0).fold(end.off.0, |x, y| if y <= x { y } else { x })
        });
        Chain { arrive: tilts(|s| s.0), leave: tilts(|s| s.1), cost }
    }
}

/// Candidates by place, so that those within reach are found without looking at all.
struct Bins {
    width_deg: f64,
    /// Row, column and index, in order.
    list: Vec<(i32, i32, usize)>,
}

impl Bins {
    fn new(tilts: &[Lean], weight: &[Option<f64>], width_deg: f64) -> Bins {
        let mut bins = Bins { width_deg: width_deg.max(0.05), list: Vec::new() };
        for (i, t) in tilts.iter().enumerate().filter(|(i, _)| weight[*i].is_some()) {
            let (row, column) = bins.place(t);
            bins.list.push((row, column, i));
        }
        bins.list.sort_unstable();
        bins
    }

    fn place(&self, t: &Lean) -> (i32, i32) {
        ((t.y / self.width_deg).floor() as i32, (t.x / self.width_deg).floor() as i32)
    }

    fn near(&self, t: &Lean, mut with: impl FnMut(usize)) {
        let (row, column) = self.place(t);
        for r in row - 1..=row + 1 {
            let from = self.list.partition_point(|x| (x.0, x.1) < (r, column - 1));
            for x in self.list[from..].iter().take_while(|x| (x.0, x.1) <= (r, column + 1)) {
                with(x.2);
            }
        }
    }
}
