//! Where a line's aim is blocked, and how far around that it is searched.

use super::site_tilts::SiteTilts;
use super::track::{TiltVector, Track};
use super::window::Window;
use crate::part::Part;
use crate::pose::{BeamInterference, motion};
use nalgebra::Vector3;

/// A line, and the points at which its aim is free.
pub struct Windows<'a> {
    part: &'a Part,
    beam: &'a BeamInterference<'a>,
    track: &'a Track<'a>,
    /// Whether the beam may have its aim.
    pub ok: Vec<bool>,
}

impl<'a> Windows<'a> {
    /// Looks at the aims. `free[i]`: the beam along the normal is free.
    pub fn new(part: &'a Part, beam: &'a BeamInterference<'a>, track: &'a Track<'a>, free: &[bool]) -> Windows<'a> {
        let sites = &track.sites;
        let plain = |i: usize| sites[i].aim == TiltVector::zeros();
        let mut ok: Vec<bool> = (0..sites.len())
            .map(|i| {
                let s = &sites[i];
                track.allows(s, &s.aim) && if plain(i) { free[i] } else { beam.is_free(&s.q.p, &s.axis(&s.aim)) }
            })
            .collect();
        for i in 0..sites.len().saturating_sub(1) {
            let (from, to) = (&sites[i], &sites[i + 1]);
            // The detection has already tested motions between normals.
            let stays = plain(i) && plain(i + 1)
                || track.may_turn((from, &from.aim), (to, &to.aim))
                    && motion::is_free(beam, &from.pose(&from.aim), &to.pose(&to.aim), 0.0);
            if ok[i] && ok[i + 1] && !stays {
                (ok[i], ok[i + 1]) = (false, false);
            }
        }
        Windows { part, beam, track, ok }
    }

    /// The tilts at every point. `held`: the axis at both ends of a closed line that was opened.
    pub fn corrected(&self, held: Option<Vector3<f64>>) -> Vec<SiteTilts> {
        let sites = &self.track.sites;
        let aim = |i: usize| SiteTilts { arrive: Some(sites[i].aim), leave: Some(sites[i].aim) };
        let mut out: Vec<SiteTilts> = (0..sites.len()).map(aim).collect();
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
                part: self.part,
                beam: self.beam,
                track: self.track,
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
