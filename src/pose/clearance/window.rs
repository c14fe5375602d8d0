//! How a stretch of a line is searched: coarse, finer, and in tubes around what was found.

use super::free_set::openings;
use super::search::{self, Chain, TiltLayer};
use super::site_tilts::SiteTilts;
use super::track::{TiltVector, Track};
use super::{grid, polish};
use crate::part::Part;
use crate::pose::BeamInterference;
use std::collections::BTreeSet;

/// Spacing of the finest grid, degrees.
const FINEST_DEG: f64 = 0.5;
/// A tube reaches so many spacings of the grid before to each side: what is best may lie beside the
/// cell that was found, not farther.
const TUBE: f64 = 1.0;
/// Where the laser is off, beams found up to this far away are tried, mm.
const HOLD_MM: f64 = 2.0;
/// Openings are looked for in blocked stretches at points this far apart, mm, and at their ends.
const LOOK_MM: f64 = 1.0;

/// A stretch of a line that is searched.
pub(super) struct Window<'a> {
    pub(super) part: &'a Part,
    pub(super) beam: &'a BeamInterference<'a>,
    pub(super) track: &'a Track<'a>,
    /// Its first point.
    pub(super) first: usize,
    /// The first whose aim is blocked.
    pub(super) core: usize,
    /// The last of those.
    pub(super) end: usize,
    /// Its last point.
    pub(super) last: usize,
    /// The tilt at the first point, where it is given.
    pub(super) start: Option<TiltVector>,
    /// The tilt at the last.
    pub(super) finish: Option<TiltVector>,
}

impl Window<'_> {
    /// Searches the window, and puts the tilts that it finds into `out`.
    pub(super) fn solve(&self, out: &mut [SiteTilts]) {
        let track = self.track;
        for (end, given) in [(self.first, self.start), (self.last, self.finish)] {
            if given.is_some() {
                out[end] = SiteTilts { arrive: given, leave: given };
            }
        }
        let coarse_deg = grid::coarse_spacing_deg(track.max_tilt_deg);
        let (mut layers, mut chain) = self.on_grid(coarse_deg, None);
        let mut found_deg = coarse_deg;
        if chain.cost.blocked_um > 0 || chain.cost.splits > 0 {
            let finer = self.on_grid(0.5 * coarse_deg, Some(coarse_deg));
            if finer.1.cost < chain.cost {
                (layers, chain) = finer;
                found_deg = 0.5 * coarse_deg;
            }
        }
        self.take_over(&layers, &chain, out);
        let none = vec![Vec::new(); track.sites.len()];
        let step_deg = track.rate_deg_mm * 0.9 * self.widest_gap_mm();
        let middle_deg = step_deg.clamp(FINEST_DEG, 0.25 * coarse_deg);
        self.in_tube(middle_deg, TUBE * found_deg, &none, out);
        self.in_tube(FINEST_DEG.min(middle_deg), TUBE * middle_deg, &none, out);
        let openings = self.openings(out);
        if openings.iter().any(|o| !o.is_empty()) {
            self.in_tube(FINEST_DEG, 2.0, &openings, out);
        }
        polish::polish(self.beam, track, self.first, self.last, out);
    }

    fn widest_gap_mm(&self) -> f64 {
        let sites = &self.track.sites[self.first..=self.last];
        sites.windows(2).map(|w| w[1].arc_mm - w[0].arc_mm).fold(0.0, f64::max)
    }

    /// Points of the window far enough apart for a step of a grid.
    fn knots(&self, step_deg: f64) -> Vec<usize> {
        let sites = &self.track.sites;
        let step_mm = step_deg / self.track.rate_deg_mm - 1e-9;
        let mut out = vec![self.first];
        for i in self.first + 1..=self.last {
            if sites[i].arc_mm >= sites[out[out.len() - 1]].arc_mm + step_mm {
                out.push(i);
            }
        }
        if out[out.len() - 1] != self.last {
            if out.len() > 1 {
                out.pop();
            }
            out.push(self.last);
        }
        out
    }

    fn layer(&self, site: usize, coarser_deg: Option<f64>, tilts: impl FnOnce() -> Vec<TiltVector>) -> TiltLayer {
        let given = if site == self.first {
            self.start
        } else if site == self.last {
            self.finish
        } else {
            None
        };
        TiltLayer { site, given: given.is_some(), tilts: given.map_or_else(tilts, |t| vec![t]), coarser_deg }
    }

    /// Whether a tilt can be reached from the given ends. Only tilts beside the core are limited by this.
    fn is_within_reach(&self, site: usize, tilt: &TiltVector) -> bool {
        let track = self.track;
        let arc_mm = |i: usize| track.sites[i].arc_mm;
        let reaches =
            |end: Option<TiltVector>, mm: f64| end.is_none_or(|e| (tilt - e).norm() <= track.rate_deg_mm * mm + 1e-9);
        (site >= self.core || reaches(self.start, arc_mm(site) - arc_mm(self.first)))
            && (site <= self.end || reaches(self.finish, arc_mm(self.last) - arc_mm(site)))
    }

    /// The best chain on a grid over all tilts.
    fn on_grid(&self, spacing_deg: f64, coarser_deg: Option<f64>) -> (Vec<TiltLayer>, Chain) {
        let track = self.track;
        let cells = grid::disc(track.max_tilt_deg + 0.5 * spacing_deg, spacing_deg);
        let at_rim = |t: TiltVector| grid::at_rim(t, track.max_tilt_deg, spacing_deg);
        let layer = |site: usize| {
            self.layer(site, coarser_deg, || {
                let s = &track.sites[site];
                let mut tilts: Vec<TiltVector> = cells.iter().filter_map(|c| at_rim(s.base + c)).collect();
                tilts.extend((s.aim != s.base).then_some(s.aim));
                tilts.retain(|t| self.is_within_reach(site, t));
                tilts
            })
        };
        let layers: Vec<TiltLayer> = self.knots(spacing_deg).into_iter().map(layer).collect();
        let chain = search::best_chain(self.beam, track, &layers);
        (layers, chain)
    }

    /// Improves what is there, within a radius of it.
    fn in_tube(&self, spacing_deg: f64, radius_deg: f64, openings: &[Vec<TiltVector>], out: &mut [SiteTilts]) {
        let track = self.track;
        let before = out.to_vec();
        let layer = |site: usize| {
            self.layer(site, None, || {
                let s = &track.sites[site];
                let mut middles: Vec<TiltVector> =
                    [before[site].arrive, before[site].leave].into_iter().flatten().collect();
                if middles.is_empty() {
                    middles.extend(self.tilts_beside(site, &before));
                }
                middles.extend(&openings[site]);
                let mut cells = BTreeSet::new();
                for m in &middles {
                    grid::add_disc(&mut cells, &(m - s.base), radius_deg, spacing_deg);
                }
                let tilt = |c| grid::at_rim(s.base + grid::middle(c, spacing_deg), track.max_tilt_deg, spacing_deg);
                let mut tilts: Vec<TiltVector> = cells.into_iter().filter_map(tilt).collect();
                let near = middles.iter().any(|m| (m - s.aim).norm() <= radius_deg);
                tilts.extend(near.then_some(s.aim));
                tilts.extend(middles);
                tilts.dedup();
                tilts
            })
        };
        let layers: Vec<TiltLayer> = self.knots(spacing_deg).into_iter().map(layer).collect();
        let chain = search::best_chain(self.beam, track, &layers);
        self.take_over(&layers, &chain, out);
    }

    /// Beams of the nearest points on both sides where the laser is on.
    fn tilts_beside(&self, site: usize, site_tilts: &[SiteTilts]) -> Vec<TiltVector> {
        let sites = &self.track.sites;
        let near = |i: &usize| (sites[*i].arc_mm - sites[site].arc_mm).abs() <= HOLD_MM;
        let before =
            (self.first..site).rev().take_while(near).find_map(|i| site_tilts[i].leave.or(site_tilts[i].arrive));
        let behind = (site + 1..=self.last).take_while(near).find_map(|i| site_tilts[i].arrive.or(site_tilts[i].leave));
        before.into_iter().chain(behind).collect()
    }

    /// Puts the tilts of a chain into `out`, interpolated between its layers.
    fn take_over(&self, layers: &[TiltLayer], chain: &Chain, out: &mut [SiteTilts]) {
        let sites = &self.track.sites;
        for k in 0..layers.len() {
            let here = layers[k].site;
            // A given tilt stays, whatever became of the motion from it.
            if k > 0 || !layers[k].given {
                out[here].arrive = chain.arrive[k];
            }
            if k + 1 == layers.len() {
                out[here].leave = if layers[k].given { out[here].leave } else { chain.arrive[k] };
                break;
            }
            out[here].leave = chain.leave[k];
            if k == 0 && !layers[k].given {
                out[here].arrive = chain.leave[k];
            }
            let next = layers[k + 1].site;
            let whole = (sites[next].arc_mm - sites[here].arc_mm).max(1e-12);
            for i in here + 1..next {
                let tilt = chain.leave[k]
                    .zip(chain.arrive[k + 1])
                    .map(|(from, to)| from.lerp(&to, (sites[i].arc_mm - sites[here].arc_mm) / whole));
                out[i] = SiteTilts { arrive: tilt, leave: tilt };
            }
        }
    }

    /// Openings at points that are still blocked.
    fn openings(&self, site_tilts: &[SiteTilts]) -> Vec<Vec<TiltVector>> {
        let (track, sites) = (self.track, &self.track.sites);
        let mut out = vec![Vec::new(); sites.len()];
        let is_dark = |i: usize| site_tilts[i].arrive.is_none() && site_tilts[i].leave.is_none();
        let mut looked_mm = f64::NEG_INFINITY;
        for i in self.first..=self.last {
            let is_rim = is_dark(i) && (i == self.first || i == self.last || !is_dark(i - 1) || !is_dark(i + 1));
            if !is_dark(i) || !is_rim && sites[i].arc_mm < looked_mm + LOOK_MM {
                continue;
            }
            looked_mm = sites[i].arc_mm;
            let found = openings(self.part, self.beam, track, &sites[i]);
            for (j, slot) in out.iter_mut().enumerate().take(self.last + 1).skip(self.first) {
                if (sites[j].arc_mm - looked_mm).abs() <= LOOK_MM {
                    slot.extend(&found);
                }
            }
        }
        out
    }
}
