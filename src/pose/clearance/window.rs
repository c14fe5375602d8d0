//! Which stretches of a line are searched, and how: coarse, finer, and in tubes around what was found.

use super::free_set::openings;
use super::grid;
use super::polish;
use super::search::{self, Chain, Layer};
use super::track::{Lean, Track};
use crate::part::Part;
use crate::pose::{Beam, motion};
use nalgebra::Vector3;
use std::collections::BTreeSet;

/// Spacing of the finest grid, degrees.
const FINEST_DEG: f64 = 0.5;
/// A tube reaches so many spacings of the grid before to each side: what is best may lie beside the
/// cell that was found, not farther.
const TUBE: f64 = 1.2;
/// Where the laser is off, beams found up to this far away are tried, mm.
const HOLD_MM: f64 = 2.0;
/// Openings are looked for in blocked stretches at points this far apart, mm, and at their ends.
const LOOK_MM: f64 = 1.0;

/// How the beam stands at a point: coming and leaving. They differ where the line is split.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stand {
    /// Coming; `None`: the laser is off before.
    pub arrive: Option<Lean>,
    /// Leaving; `None`: it is off behind.
    pub leave: Option<Lean>,
}

/// A line, and where its aim is free.
pub struct Windows<'a> {
    part: &'a Part,
    beam: &'a Beam<'a>,
    track: &'a Track<'a>,
    /// Whether the beam may have its aim.
    pub ok: Vec<bool>,
}

impl<'a> Windows<'a> {
    /// Looks at the aims. `free[i]`: the beam along the normal is free.
    pub fn new(part: &'a Part, beam: &'a Beam<'a>, track: &'a Track<'a>, free: &[bool]) -> Windows<'a> {
        let sites = &track.sites;
        let plain = |i: usize| sites[i].aim == Lean::zeros();
        let mut ok: Vec<bool> = (0..sites.len())
            .map(|i| {
                let s = &sites[i];
                track.allows(s, &s.aim) && if plain(i) { free[i] } else { beam.is_free(&s.q.p, &s.axis(&s.aim)) }
            })
            .collect();
        for i in 0..sites.len().saturating_sub(1) {
            let (from, to) = (&sites[i], &sites[i + 1]);
            // Between normals the detection has looked.
            let stays = plain(i) && plain(i + 1)
                || track.may_turn((from, &from.aim), (to, &to.aim))
                    && motion::is_free(beam, &from.pose(&from.aim), &to.pose(&to.aim), 0.0);
            if ok[i] && ok[i + 1] && !stays {
                (ok[i], ok[i + 1]) = (false, false);
            }
        }
        Windows { part, beam, track, ok }
    }

    /// How the beam stands at every point. `held`: the axis at both ends of an opened closed line.
    pub fn corrected(&self, held: Option<Vector3<f64>>) -> Vec<Stand> {
        let sites = &self.track.sites;
        let aim = |i: usize| Stand { arrive: Some(sites[i].aim), leave: Some(sites[i].aim) };
        let mut out: Vec<Stand> = (0..sites.len()).map(aim).collect();
        let last = sites.len() - 1;
        let margin_mm = self.track.max_tilt_deg / self.track.rate_deg_mm;
        let mut at = 0;
        while let Some(core) = (at..=last).find(|&i| !self.ok[i]) {
            // Windows that would overlap are one.
            let mut end = core;
            while let Some(next) = (end + 1..=last)
                .take_while(|&i| sites[i].arc_mm <= sites[end].arc_mm + 2.0 * margin_mm)
                .find(|&i| !self.ok[i])
            {
                end = next;
            }
            let first = (0..core)
                .rev()
                .take_while(|&i| sites[i].arc_mm >= sites[core].arc_mm - margin_mm)
                .last()
                .unwrap_or(core);
            let behind = (end + 1..=last)
                .take_while(|&i| sites[i].arc_mm <= sites[end].arc_mm + margin_mm)
                .last()
                .unwrap_or(end);
            let fixed = |i: usize, rim: usize| match held {
                Some(axis) if i == rim => Some(sites[i].tilt_of(&axis)),
                _ => (i != rim && self.ok[i]).then(|| sites[i].aim),
            };
            let window = Window {
                all: self,
                first: first.max(at.saturating_sub(1)),
                core,
                end,
                last: behind,
                start: fixed(first, 0),
                finish: fixed(behind, last),
            };
            window.solve(&mut out);
            at = behind + 1;
        }
        out
    }
}

/// The middle of the longest stretch of a ring.
pub fn middle_of_longest(ok: &[bool]) -> Option<usize> {
    let count = ok.len();
    let (mut best, mut length, mut run) = (None, 0, 0);
    // Twice round, so that a stretch over the seam is seen whole.
    for i in 0..2 * count {
        run = if ok[i % count] { (run + 1).min(count) } else { 0 };
        if run > length {
            (length, best) = (run, Some((i + count - (run - 1) / 2) % count));
        }
    }
    best
}

struct Window<'a> {
    all: &'a Windows<'a>,
    /// Its first point.
    first: usize,
    /// The first whose aim is blocked.
    core: usize,
    /// The last of those.
    end: usize,
    /// Its last point.
    last: usize,
    /// The tilt at the first point, where it is given.
    start: Option<Lean>,
    /// The tilt at the last.
    finish: Option<Lean>,
}

impl Window<'_> {
    fn solve(&self, out: &mut [Stand]) {
        let track = self.all.track;
        let coarse_deg = grid::coarse_spacing_deg(track.max_tilt_deg);
        let (mut layers, mut chain) = self.on_grid(coarse_deg);
        let mut found_deg = coarse_deg;
        if chain.cost.blocked_um > 0 || chain.cost.splits > 0 {
            let finer = self.on_grid(0.5 * coarse_deg);
            if finer.1.cost < chain.cost {
                (layers, chain) = finer;
                found_deg = 0.5 * coarse_deg;
            }
        }
        self.put(&layers, &chain, out);
        let none = vec![Vec::new(); track.sites.len()];
        let step_deg = track.rate_deg_mm * 0.9 * self.widest_gap_mm();
        let middle_deg = step_deg.clamp(FINEST_DEG, 0.25 * coarse_deg);
        self.in_tube(middle_deg, TUBE * found_deg, &none, out);
        self.in_tube(FINEST_DEG.min(middle_deg), TUBE * middle_deg, &none, out);
        let openings = self.openings(out);
        if openings.iter().any(|o| !o.is_empty()) {
            self.in_tube(FINEST_DEG, 2.0, &openings, out);
        }
        polish::polish(self.all.beam, track, (self.first, self.last), out);
    }

    fn widest_gap_mm(&self) -> f64 {
        let sites = &self.all.track.sites[self.first..=self.last];
        sites.windows(2).map(|w| w[1].arc_mm - w[0].arc_mm).fold(0.0, f64::max)
    }

    /// Points of the window far enough apart for a step of a grid.
    fn knots(&self, step_deg: f64) -> Vec<usize> {
        let sites = &self.all.track.sites;
        let step_mm = step_deg / self.all.track.rate_deg_mm - 1e-9;
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

    fn layer(&self, site: usize, tilts: impl FnOnce() -> Vec<Lean>) -> Layer {
        let given = if site == self.first {
            self.start
        } else if site == self.last {
            self.finish
        } else {
            None
        };
        Layer { site, given: given.is_some(), tilts: given.map_or_else(tilts, |t| vec![t]) }
    }

    /// Whether a tilt can be reached from a given end; beside the core nothing asks for more.
    fn is_within_reach(&self, site: usize, tilt: &Lean) -> bool {
        let track = self.all.track;
        let arc_mm = |i: usize| track.sites[i].arc_mm;
        let reaches =
            |end: Option<Lean>, mm: f64| end.is_none_or(|e| (tilt - e).norm() <= track.rate_deg_mm * mm + 1e-9);
        (site >= self.core || reaches(self.start, arc_mm(site) - arc_mm(self.first)))
            && (site <= self.end || reaches(self.finish, arc_mm(self.last) - arc_mm(site)))
    }

    /// The best chain on a grid over all tilts.
    fn on_grid(&self, spacing_deg: f64) -> (Vec<Layer>, Chain) {
        let track = self.all.track;
        let cells = grid::disc(track.max_tilt_deg, spacing_deg);
        let layer = |site: usize| {
            self.layer(site, || {
                let s = &track.sites[site];
                let mut tilts: Vec<Lean> = cells.iter().map(|c| s.base + c).collect();
                tilts.extend((s.aim != s.base).then_some(s.aim));
                tilts.retain(|t| t.norm() <= track.max_tilt_deg + 1e-6 && self.is_within_reach(site, t));
                tilts
            })
        };
        let layers: Vec<Layer> = self.knots(spacing_deg).into_iter().map(layer).collect();
        let chain = search::best(self.all.beam, track, &layers);
        (layers, chain)
    }

    /// Improves what is there, within a radius of it.
    fn in_tube(&self, spacing_deg: f64, radius_deg: f64, openings: &[Vec<Lean>], out: &mut [Stand]) {
        let track = self.all.track;
        let before = out.to_vec();
        let layer = |site: usize| {
            self.layer(site, || {
                let s = &track.sites[site];
                let mut middles: Vec<Lean> = [before[site].arrive, before[site].leave].into_iter().flatten().collect();
                if middles.is_empty() {
                    middles.extend(self.held(site, &before));
                }
                middles.extend(&openings[site]);
                let mut cells = BTreeSet::new();
                for m in &middles {
                    grid::add_disc(&mut cells, &(m - s.base), radius_deg, spacing_deg);
                }
                let mut tilts: Vec<Lean> = cells.into_iter().map(|c| s.base + grid::middle(c, spacing_deg)).collect();
                let near = middles.iter().any(|m| (m - s.aim).norm() <= radius_deg);
                tilts.extend(near.then_some(s.aim));
                tilts.extend(middles);
                tilts.dedup();
                tilts
            })
        };
        let layers: Vec<Layer> = self.knots(spacing_deg).into_iter().map(layer).collect();
        let chain = search::best(self.all.beam, track, &layers);
        self.put(&layers, &chain, out);
    }

    /// Beams of the nearest points on both sides where the laser is on.
    fn held(&self, site: usize, stands: &[Stand]) -> Vec<Lean> {
        let sites = &self.all.track.sites;
        let near = |i: &usize| (sites[*i].arc_mm - sites[site].arc_mm).abs() <= HOLD_MM;
        let before = (self.first..site).rev().take_while(near).find_map(|i| stands[i].leave.or(stands[i].arrive));
        let behind = (site + 1..=self.last).take_while(near).find_map(|i| stands[i].arrive.or(stands[i].leave));
        before.into_iter().chain(behind).collect()
    }

    /// Takes over a chain.
    fn put(&self, layers: &[Layer], chain: &Chain, out: &mut [Stand]) {
        let sites = &self.all.track.sites;
        for k in 0..layers.len() {
            let here = layers[k].site;
            // What was given holds, whatever became of the way from it.
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
                out[i] = Stand { arrive: tilt, leave: tilt };
            }
        }
    }

    /// Openings at points that are still blocked.
    fn openings(&self, stands: &[Stand]) -> Vec<Vec<Lean>> {
        let (track, sites) = (self.all.track, &self.all.track.sites);
        let mut out = vec![Vec::new(); sites.len()];
        let is_dark = |i: usize| stands[i].arrive.is_none() && stands[i].leave.is_none();
        let mut looked_mm = f64::NEG_INFINITY;
        for i in self.first..=self.last {
            let is_rim = is_dark(i) && (i == self.first || i == self.last || !is_dark(i - 1) || !is_dark(i + 1));
            if !is_dark(i) || !is_rim && sites[i].arc_mm < looked_mm + LOOK_MM {
                continue;
            }
            looked_mm = sites[i].arc_mm;
            let found = openings(self.all.part, self.all.beam, track, &sites[i]);
            for (j, slot) in out.iter_mut().enumerate().take(self.last + 1).skip(self.first) {
                if (sites[j].arc_mm - looked_mm).abs() <= LOOK_MM {
                    slot.extend(&found);
                }
            }
        }
        out
    }
}
