//! Which candidates are free, what they cost, and whether the beam can move freely from one to the next.

use super::bins::Bins;
use super::grid::{self, GridCell};
use super::search::{ChainSearch, ChainSteps, LayerCosts};
use super::track::{TiltVector, Track};
use crate::pose::motion;
use std::collections::{BTreeMap, BTreeSet};

/// Energy lost to a tilt, 1 − cos, in degrees of tilt: at 45° it doubles what the tilt itself costs.
const DOSE_DEG: f64 = 150.0;
/// Cost of a beam one degree beside a blocked one, in degrees of tilt. On its own it makes a beam keep
/// √4 = 2° from what is in the way.
pub const NEARNESS_DEG2: f64 = 4.0;
/// Blocked directions farther away than this cost nothing, degrees.
const NEAR_DEG: f64 = 6.0;

/// Cost of a tilt itself, per mm of line.
fn cost_of(track: &Track<'_>, site: usize, tilt: &TiltVector) -> f64 {
    let s = &track.sites[site];
    s.pull * (tilt - s.aim).norm() + DOSE_DEG * (1.0 - libm::cos(tilt.norm().to_radians()))
}

impl ChainSearch<'_> {
    /// Tests a layer's candidates, and gives the free ones their costs.
    pub(super) fn costs_of(&self, k: usize) -> LayerCosts {
        let layer = &self.layers[k];
        let mut coarse = BTreeMap::new();
        let is_cancelled = self.beam.check().is_err();
        let mut ask = |t: &TiltVector| if is_cancelled { (None, false) } else { self.freedom_of(k, t, &mut coarse) };
        let asked: Vec<(Option<bool>, bool)> = layer.tilts.iter().map(&mut ask).collect();
        let weights = |which: Option<bool>| -> Vec<Option<f64>> {
            asked.iter().map(|(f, _)| (*f == which).then_some(0.0)).collect()
        };
        let blocked = Bins::new(&layer.tilts, &weights(Some(false)), NEAR_DEG);
        let mut weight = weights(Some(true));
        for (t, w) in layer.tilts.iter().zip(&mut weight).filter(|(_, w)| w.is_some()) {
            let mut nearest = NEAR_DEG * NEAR_DEG;
            blocked.for_each_near(t, |b| nearest = nearest.min((layer.tilts[b] - t).norm_squared()));
            let near = NEARNESS_DEG2 / nearest.sqrt().max(1e-6) - NEARNESS_DEG2 / NEAR_DEG;
            *w = Some(cost_of(self.track, layer.site, t) + near);
        }
        let reach_deg = if k + 1 < self.layers.len() { self.reach_deg(k) } else { 1.0 };
        let bins = Bins::new(&layer.tilts, &weight, reach_deg);
        let assumed = asked.into_iter().map(|a| a.1).collect();
        LayerCosts { weight, assumed, bins, arrive: Vec::new(), off: (Default::default(), None), leave: Vec::new() }
    }

    /// Whether a candidate is free (`None`: not allowed at all), and whether a coarser grid was trusted for it.
    fn freedom_of(
        &self,
        k: usize,
        tilt: &TiltVector,
        coarse: &mut BTreeMap<GridCell, Option<bool>>,
    ) -> (Option<bool>, bool) {
        let layer = &self.layers[k];
        let site = &self.track.sites[layer.site];
        let Some(spacing_deg) = layer.coarser_deg.filter(|_| !layer.given && self.track.allows(site, tilt)) else {
            return (self.is_free(k, tilt), false);
        };
        let mut cells = BTreeSet::new();
        grid::add_disc(&mut cells, &(tilt - site.base), 1.05 * spacing_deg, spacing_deg);
        let mut all = [true, true];
        for c in cells {
            let free = coarse.entry(c).or_insert_with(|| self.is_free(k, &(site.base + grid::middle(c, spacing_deg))));
            for (all, is) in all.iter_mut().zip([Some(true), Some(false)]) {
                *all &= free.is_none() || *free == is;
            }
        }
        match all {
            [true, false] => (Some(true), true),
            [false, true] => (Some(false), true),
            _ => (self.is_free(k, tilt), false),
        }
    }

    /// Whether the beam is free over the layer's stretch of the line; `None`: not allowed at all.
    fn is_free(&self, k: usize, tilt: &TiltVector) -> Option<bool> {
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

    /// Tests the motions of a chain; returns the first layer that has to be computed again.
    pub(super) fn first_failing(&mut self, chain: &ChainSteps) -> Option<usize> {
        let mut first: Option<usize> = None;
        let mut fails = |k: usize| first = Some(first.map_or(k, |f| f.min(k)));
        for k in 0..chain.len().saturating_sub(1) {
            let (Some(u), Some(v)) = (chain[k].1, chain[k + 1].0) else { continue };
            let ends = [(k, u), (k + 1, v)].map(|(k, u)| self.is_sure(k, u));
            if !ends[0] || !ends[1] {
                fails(if ends[0] { k + 1 } else { k });
                continue;
            }
            let is = match self.known.get(&(k, u, v)) {
                Some(is) => *is,
                None => self.is_way(k, &self.layers[k].tilts[u], &self.layers[k + 1].tilts[v]),
            };
            self.known.insert((k, u, v), is);
            if !is {
                fails(k + 1);
            }
        }
        first
    }

    /// Tests a candidate whose freedom was only inferred.
    fn is_sure(&mut self, k: usize, u: usize) -> bool {
        if self.layer_costs[k].assumed[u] {
            let is = self.is_free(k, &self.layers[k].tilts[u]) == Some(true);
            let costs = &mut self.layer_costs[k];
            costs.assumed[u] = false;
            costs.weight[u] = costs.weight[u].filter(|_| is);
        }
        self.layer_costs[k].weight[u].is_some()
    }

    /// Whether the beam is free from one candidate to one of the next layer, at the points between and
    /// on the motions.
    fn is_way(&self, k: usize, from: &TiltVector, to: &TiltVector) -> bool {
        let (a, b) = (self.layers[k].site, self.layers[k + 1].site);
        let sites = &self.track.sites;
        let whole = (sites[b].arc_mm - sites[a].arc_mm).max(1e-12);
        let tilt = |i: usize| from.lerp(to, (sites[i].arc_mm - sites[a].arc_mm) / whole);
        (a + 1..b).all(|i| {
            self.track.allows(&sites[i], &tilt(i)) && self.beam.is_free(&sites[i].q.p, &sites[i].axis(&tilt(i)))
        }) && (a..b)
            .all(|i| motion::is_free(self.beam, &sites[i].pose(&tilt(i)), &sites[i + 1].pose(&tilt(i + 1)), 0.0))
    }
}
