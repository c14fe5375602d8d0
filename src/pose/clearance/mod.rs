//! The correction in two degrees of freedom: tilts along a whole line at once.
//!
//! Where the aim (the normal, or what the surface's rule and the pins ask for) is blocked, a window is
//! laid around it, wide enough to turn away and back. In it a chain of tilts is searched on the coarse
//! grid, on one half as wide where that leaves anything dark, and then in ever narrower tubes around
//! what was found. A point is called blocked only when no direction half a degree apart is free. The
//! result is drawn to the aim as far as it stays free; the caller tests it again.

mod bins;
mod corrected_line;
pub mod free_set;
mod freedom;
mod grid;
mod polish;
mod search;
mod site_tilts;
mod track;
mod window;
mod windows;

pub use free_set::{TestedDirection, free_set};

use super::interference::BeamInterference;
use super::line_rules::LineRules;
use super::tilt::Pin;
use crate::part::Part;
use crate::path::{DensePoint, dense};
use nalgebra::Vector3;
use track::Track;
use windows::Windows;

/// A point of the corrected line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CorrectedPoint {
    /// Point and normal.
    pub q: DensePoint,
    /// The beam; `None`: blocked.
    pub axis: Option<Vector3<f64>>,
    /// The beam axis that is aimed for here.
    pub aim: Vector3<f64>,
    /// Whether it lies where the point before it does, with another beam; the laser is off between the two.
    pub is_split: bool,
}

/// Corrects a line. `free[i]`: the beam along the normal is free. `number`: which line of its surface
/// this is. `closed`: the last point is the first again, and gets the same beam.
pub fn correct(
    part: &Part,
    beam: &BeamInterference<'_>,
    points: &[DensePoint],
    free: &[bool],
    closed: bool,
    number: u32,
    rules: &LineRules,
) -> Vec<CorrectedPoint> {
    let pins: Vec<Pin> = rules.pins.iter().filter(|p| p.line == number).copied().collect();
    let mut places_mm = vec![0.0];
    for w in points.windows(2) {
        places_mm.push(places_mm[places_mm.len() - 1] + (w[1].p - w[0].p).norm());
    }
    let round_mm = places_mm.last().copied().filter(|_| closed);
    let tangents = dense::tangents(points, closed);
    let track = Track::new(points, &tangents, &places_mm, round_mm, rules, &pins);
    let windows = Windows::new(part, beam, &track, free);
    let has_search = !windows.ok.iter().all(|ok| *ok);
    if !closed || !has_search {
        return corrected_line::corrected_points(beam, &track, &windows.corrected(None));
    }
    // A closed line is opened where its aim is free. If that is nowhere, it is solved as an open line first, then
    // opened again half way round with the beam that was found there.
    let count = points.len() - 1;
    let opened = |seam: usize| -> (Track<'_>, Vec<bool>) {
        let at: Vec<usize> = (0..=count).map(|i| (i + seam) % count).collect();
        let pick = |i: &usize| points[*i];
        let points: Vec<DensePoint> = at.iter().map(pick).collect();
        let tangents: Vec<Vector3<f64>> = at.iter().map(|&i| tangents[i]).collect();
        let places: Vec<f64> = at.iter().map(|&i| places_mm[i]).collect();
        let free = at.iter().map(|&i| free[i]).collect();
        (Track::new(&points, &tangents, &places, round_mm, rules, &pins), free)
    };
    let ok = &windows.ok[..count];
    let (seam, held) = match windows::middle_of_longest(ok) {
        Some(seam) => (seam, None),
        None => {
            let site_tilts = windows.corrected(None);
            let half = count / 2;
            (half, site_tilts[half].arrive.map(|t| track.sites[half].axis(&t)))
        }
    };
    let (track, free) = opened(seam);
    let windows = Windows::new(part, beam, &track, &free);
    let out = corrected_line::corrected_points(beam, &track, &windows.corrected(held));
    corrected_line::from_start(out, &points[0])
}
