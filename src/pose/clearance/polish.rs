//! The last step of the search: tilts leave the grid and come as near to their aims as the motion stays free.

use super::freedom::NEARNESS_DEG2;
use super::site_tilts::SiteTilts;
use super::track::{TiltVector, Track};
use crate::pose::{BeamInterference, motion};

/// Steps in which a tilt is drawn towards its aim, degrees.
const STEP_DEG: f64 = 1.0;
/// Precision of the last free tilt, degrees.
const EXACT_DEG: f64 = 0.05;
/// A millimetre of clearance costs as much as so many degrees of tilt, half a millimetre twice as much: a beam
/// that clears a wall 20 mm above the spot by half a millimetre turns away by another degree or two.
const NEARNESS_DEG_MM: f64 = 1.0;
/// Clearance beyond this is not worth any tilt, mm.
const FAR_MM: f64 = 4.0;
/// A better tilt is looked for up to this far beyond the best one found, degrees.
const FARTHER_DEG: f64 = 1.0;
/// Number of smoothing sweeps.
const SWEEPS: usize = 6;

/// Draws the tilts of points `first` to `last` to their aims.
pub fn polish(beam: &BeamInterference<'_>, track: &Track<'_>, first: usize, last: usize, site_tilts: &mut [SiteTilts]) {
    let mut at = first;
    while at < last {
        // A piece: lit from point to point, without a split inside.
        let (Some(start), Some(_)) = (site_tilts[at].leave, site_tilts[at + 1].arrive) else {
            at += 1;
            continue;
        };
        let mut tilts = vec![start];
        let from = at;
        while at < last {
            let (Some(_), Some(tilt)) = (site_tilts[at].leave, site_tilts[at + 1].arrive) else { break };
            at += 1;
            tilts.push(tilt);
            if site_tilts[at].leave != site_tilts[at].arrive {
                break;
            }
        }
        // At the window's own ends the beam joins what is outside.
        let held = (from == first && first > 0, at == last && last + 1 < track.sites.len());
        let piece = LitRun { beam, track, from };
        let better = piece.polished(&tilts, held);
        for (k, tilt) in better.into_iter().enumerate() {
            let i = from + k;
            if k > 0 || site_tilts[i].arrive == site_tilts[i].leave {
                site_tilts[i].arrive = Some(tilt);
            }
            if i < at || site_tilts[i].leave == Some(tilts[k]) {
                site_tilts[i].leave = Some(tilt);
            }
        }
    }
}

struct LitRun<'a> {
    beam: &'a BeamInterference<'a>,
    track: &'a Track<'a>,
    from: usize,
}

impl LitRun<'_> {
    fn is_free(&self, k: usize, tilt: &TiltVector) -> bool {
        let site = &self.track.sites[self.from + k];
        self.track.allows(site, tilt) && self.beam.is_free(&site.q.p, &site.axis(tilt))
    }

    fn aim(&self, k: usize) -> TiltVector {
        self.track.sites[self.from + k].aim
    }

    fn may_turn(&self, k: usize, from: &TiltVector, to: &TiltVector) -> bool {
        let sites = &self.track.sites;
        self.track.may_turn((&sites[self.from + k], from), (&sites[self.from + k + 1], to))
    }

    fn polished(&self, tilts: &[TiltVector], held: (bool, bool)) -> Vec<TiltVector> {
        let drawn = self.drawn_to_aim(tilts, held);
        let smooth = self.smoothed(&drawn, held);
        [smooth, drawn].into_iter().find(|t| self.is_good(t)).unwrap_or_else(|| tilts.to_vec())
    }

    /// Whether the beam can follow these tilts: no turn too fast, and every motion free.
    fn is_good(&self, tilts: &[TiltVector]) -> bool {
        let sites = &self.track.sites[self.from..];
        tilts.windows(2).enumerate().all(|(k, w)| {
            self.may_turn(k, &w[0], &w[1])
                && motion::is_free(self.beam, &sites[k].pose(&w[0]), &sites[k + 1].pose(&w[1]), 0.0)
        })
    }

    /// The tilts drawn straight towards their aims, each as far as it is free with something to spare, and no farther
    /// than the tilt rate allows beside its neighbours.
    fn drawn_to_aim(&self, tilts: &[TiltVector], held: (bool, bool)) -> Vec<TiltVector> {
        let last = tilts.len() - 1;
        let whole: Vec<f64> = tilts.iter().enumerate().map(|(k, t)| (t - self.aim(k)).norm()).collect();
        let at = |k: usize, size: f64| match whole[k] {
            0.0 => tilts[k],
            w if size >= w => tilts[k],
            w => self.aim(k) + (tilts[k] - self.aim(k)) * (size / w),
        };
        let mut size: Vec<f64> = (0..=last)
            .map(|k| {
                if k == 0 && held.0 || k == last && held.1 { whole[k] } else { self.least_free_size(k, whole[k], &at) }
            })
            .collect();
        let sites = &self.track.sites[self.from..];
        let way_deg = |k: usize| self.track.rate_deg_mm * (sites[k + 1].arc_mm - sites[k].arc_mm);
        for k in 0..last {
            size[k + 1] = size[k + 1].max((size[k] - way_deg(k)).min(whole[k + 1]));
        }
        for k in (0..last).rev() {
            size[k] = size[k].max((size[k + 1] - way_deg(k)).min(whole[k]));
        }
        // Turning about the aim uses up some of the rate: enlarge tilts until all fits.
        for _ in 0..last.min(200) {
            let mut fits = true;
            for k in 0..last {
                if !self.may_turn(k, &at(k, size[k]), &at(k + 1, size[k + 1])) {
                    fits = false;
                    for i in [k, k + 1] {
                        size[i] = (size[i] + 0.3 * way_deg(k)).min(whole[i]);
                    }
                }
            }
            if fits || self.beam.check().is_err() {
                break;
            }
        }
        (0..=last).map(|k| at(k, size[k])).collect()
    }

    /// The least size to which a tilt can shrink without being blocked on the way, enlarged by what it keeps to spare.
    fn least_free_size(&self, k: usize, whole: f64, at: &impl Fn(usize, f64) -> TiltVector) -> f64 {
        let good = |size: f64| self.is_free(k, &at(k, size));
        let mut low = whole;
        loop {
            if low <= 0.0 {
                return 0.0;
            }
            let next = (low - STEP_DEG).max(0.0);
            if !good(next) {
                let mut blocked = next;
                while low - blocked > EXACT_DEG {
                    let middle = 0.5 * (low + blocked);
                    if good(middle) { low = middle } else { blocked = middle }
                }
                return self.size_with_clearance(k, low, whole, at);
            }
            low = next;
        }
    }

    /// The size, from the least free one on, at which the cost of tilt and nearness is least. Nearness is 1/clearance
    /// for beam and head; a ray keeps a fixed angle from what is blocked.
    fn size_with_clearance(&self, k: usize, low: f64, whole: f64, at: &impl Fn(usize, f64) -> TiltVector) -> f64 {
        let site = &self.track.sites[self.from + k];
        let cost = |size: f64| {
            let clearance_mm = self.beam.clearance_within_mm(&site.q.p, &site.axis(&at(k, size)), FAR_MM)?;
            Some(size + NEARNESS_DEG_MM / clearance_mm.max(1e-3))
        };
        let Some(first) = cost(low) else { return (low + NEARNESS_DEG2.sqrt()).min(whole) };
        let mut best = (first, low);
        let mut size = low;
        while size < whole && size < best.1 + FARTHER_DEG {
            size = (size + 0.5 * STEP_DEG).min(whole);
            best = cost(size).map_or(best, |c| if c < best.0 { (c, size) } else { best });
        }
        best.1
    }

    /// Each tilt moved between those of its neighbours, where it stays free with a step to spare.
    fn smoothed(&self, tilts: &[TiltVector], held: (bool, bool)) -> Vec<TiltVector> {
        let mut out = tilts.to_vec();
        let last = tilts.len() - 1;
        let sites = &self.track.sites[self.from..];
        for _ in 0..SWEEPS {
            for k in 1..last {
                let aim = self.aim(k);
                if out[k] == aim || k == 0 && held.0 || k == last && held.1 {
                    continue;
                }
                let share =
                    (sites[k].arc_mm - sites[k - 1].arc_mm) / (sites[k + 1].arc_mm - sites[k - 1].arc_mm).max(1e-12);
                let middle = out[k - 1].lerp(&out[k + 1], share);
                if (middle - out[k]).norm() < 1e-3 {
                    continue;
                }
                let inwards = (aim - middle)
                    .try_normalize(1e-9)
                    .map_or(middle, |d| middle + d * STEP_DEG.min((aim - middle).norm()));
                if self.may_turn(k - 1, &out[k - 1], &middle)
                    && self.may_turn(k, &middle, &out[k + 1])
                    && self.is_free(k, &middle)
                    && self.is_free(k, &inwards)
                {
                    out[k] = middle;
                }
            }
        }
        out
    }
}
