//! From the tilts at the sites of a line to its corrected points: a split becomes two points at one place, and a
//! blocked stretch ends where the beam is no longer free.

use super::CorrectedPoint;
use super::site_tilts::SiteTilts;
use super::track::{Site, TiltVector, Track};
use crate::path::DensePoint;
use crate::pose::{BeamInterference, motion};
use nalgebra::Vector3;

/// Precision of the ends of a blocked stretch, mm.
const END_MM: f64 = 0.05;

/// The corrected points of a line.
pub fn corrected_points(
    beam: &BeamInterference<'_>,
    track: &Track<'_>,
    site_tilts: &[SiteTilts],
) -> Vec<CorrectedPoint> {
    // Tested once more, whatever step a tilt came from.
    let is_free = |q: &DensePoint, a: &Vector3<f64>| beam.is_free(&q.p, a);
    let row = |site: &Site, tilt: Option<TiltVector>, is_split: bool| CorrectedPoint {
        q: site.q,
        axis: tilt.map(|t| site.axis(&t)).filter(|a| is_free(&site.q, a)),
        aim: site.axis(&site.aim),
        is_split,
    };
    let mut out = Vec::with_capacity(site_tilts.len());
    for (i, (site, tilts)) in track.sites.iter().zip(site_tilts).enumerate() {
        out.push(row(site, tilts.arrive.or(tilts.leave), false));
        if let (Some(from), Some(to)) = (tilts.arrive, tilts.leave)
            && from != to
        {
            out.push(row(site, Some(to), true));
        }
        let (Some(next), Some(after)) = (track.sites.get(i + 1), site_tilts.get(i + 1)) else { break };
        if tilts.leave.is_some() && after.arrive.is_some() {
            continue;
        }
        // Dark from here to the next point: each side goes on as far as its beam is free.
        let (low, high) = (tilts.leave.or(tilts.arrive), after.arrive.or(after.leave));
        let (mut from, mut to) = (site.midway(next, 0.0), site.midway(next, 1.0));
        if let Some(tilt) = low {
            from = last_free_site(beam, track, site, next, tilt, 0.0);
        }
        if let Some(tilt) = high {
            to = last_free_site(beam, track, site, next, tilt, 1.0);
        }
        if low.is_some() && from.arc_mm > site.arc_mm && from.arc_mm < next.arc_mm {
            out.push(row(&from, low, false));
        }
        if low.is_some() && high.is_some() {
            // A blocked point between them says that the laser is off there.
            let way_mm = (next.arc_mm - site.arc_mm).max(1e-12);
            let t = (0.5 * (from.arc_mm + to.arc_mm) - site.arc_mm) / way_mm;
            out.push(row(&site.midway(next, t.clamp(0.0, 1.0)), None, false));
        }
        if high.is_some() && to.arc_mm < next.arc_mm && to.arc_mm > from.arc_mm {
            out.push(row(&to, high, false));
        }
    }
    out
}

/// The last site, going from one end of a gap, at which a constant tilt is free.
fn last_free_site(
    beam: &BeamInterference<'_>,
    track: &Track<'_>,
    site: &Site,
    next: &Site,
    tilt: TiltVector,
    from: f64,
) -> Site {
    let start = site.midway(next, from);
    let good = |t: f64| {
        let there = site.midway(next, t);
        track.allows(&there, &tilt)
            && beam.is_free(&there.q.p, &there.axis(&tilt))
            && motion::is_free(beam, &start.pose(&tilt), &there.pose(&tilt), 0.0)
    };
    let (mut free, mut blocked) = (from, 1.0 - from);
    while (blocked - free).abs() * (next.arc_mm - site.arc_mm) > END_MM {
        let middle = 0.5 * (free + blocked);
        if good(middle) { free = middle } else { blocked = middle }
    }
    site.midway(next, free)
}

/// Rotates the points of a closed line that was opened elsewhere so that they begin and end at `start`.
pub fn from_start(mut rows: Vec<CorrectedPoint>, start: &DensePoint) -> Vec<CorrectedPoint> {
    rows.pop();
    let Some(at) = rows.iter().position(|r| r.q == *start) else { return rows };
    rows.rotate_left(at);
    rows.extend(rows.first().copied());
    rows
}
