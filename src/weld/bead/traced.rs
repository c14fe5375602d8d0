//! The centre line of a bead with its edges, found in rounds: from the line of the last one sections are taken across, and
//! the middle of their edges is the next line.

use super::feet::{Found, bead_points, local_feet};
use super::histogram::HeightHistogram;
use super::line::{Placed, Station};
use super::model::{WeldBead, WeldBeadError, WeldSection};
use super::{crest, edges, line, outline};
use crate::scan::upper_median;
use crate::weld::camera::DepthCamera;
use crate::weld::parent::ParentSurface;
use crate::weld::raster::Mask;
use nalgebra::{Point3, Vector2};
use rayon::prelude::*;

/// Heights are looked at so far around the mask, mm: a mask that missed half of a bead still finds the rest.
pub(super) const AROUND_MM: f64 = 14.0;
/// Rounds that move the centre line: three with the first parent surface, three with the second.
const ROUNDS: usize = 3;
/// Bells of smoothing, 1 σ, in stations: the rough way, the middle, the edges.
const ROUGH_BELL: f64 = 8.0;
const MIDDLE_BELL: f64 = 9.0;
const EDGE_BELL: f64 = 3.0;
/// The line is continued so far beyond its ends, mm, for the ends to be found.
const CONTINUED_MM: f64 = 12.0;
/// Over so many stations the direction of a continuation is taken.
const DIRECTION: usize = 12;
/// A bead shorter than this has no line, mm.
const LEAST_LENGTH_MM: f64 = 10.0;
/// Width of the bins of its histogram, mm.
pub(super) const HISTOGRAM_BIN_MM: f64 = 0.5;

/// A centre line with its edges.
pub(super) struct Traced {
    /// The stations of the bead, from its first end to its last.
    pub(super) stations: Vec<Station>,
    /// Distances of both edges from it, left and right, mm.
    half_mm: Vec<[f64; 2]>,
    /// The points by the line.
    placed: Vec<Placed>,
    /// Where the bead begins and ends along the line of the stations, mm.
    ends_mm: [f64; 2],
    /// Local places of the corners of its outline, along the left edge and back along the right one.
    corners: Vec<Point3<f64>>,
    noise_mm: f64,
}

impl Traced {
    /// Follows a bead from a rough way along it.
    pub(super) fn along(
        surface: &ParentSurface,
        way: &[Vector2<f64>],
        found: &[Found<'_>],
    ) -> Result<Traced, WeldBeadError> {
        let feet = local_feet(found);
        let mut way = smooth_way(&line::stations(surface, way), &[], ROUGH_BELL);
        let mut most_half_mm = AROUND_MM;
        for round in 0.. {
            let (way_on, reach_mm) = (continued(&way), most_half_mm + 4.0);
            let stations = line::stations(surface, &way_on);
            let placed = line::placed(&stations, &feet, reach_mm);
            let last_mm = stations.last().map_or(0.0, |s| s.along_mm);
            let about = [CONTINUED_MM, last_mm - CONTINUED_MM];
            let [begin, end] = edges::ends_mm(&placed, most_half_mm.min(8.0) * 0.3, about);
            let ends_mm = [begin.unwrap_or(about[0]).max(0.0), end.unwrap_or(about[1]).min(last_mm)];
            if ends_mm[1] - ends_mm[0] < LEAST_LENGTH_MM {
                return Err(WeldBeadError::Short { length_mm: ends_mm[1] - ends_mm[0] });
            }
            let is_on = |s: &&Station| (ends_mm[0] + 0.5..=ends_mm[1] - 0.5).contains(&s.along_mm);
            let on: Vec<Station> = stations.iter().filter(is_on).copied().collect();
            let edges_of = |s: &Station| {
                let section = edges::section(&placed, s, ends_mm);
                [1.0, -1.0].map(|side| edges::flank_mm(&section, side, most_half_mm))
            };
            let halves: Vec<[Option<f64>; 2]> = on.par_iter().map(edges_of).collect();
            let mut widths: Vec<f64> = halves.iter().filter_map(|[l, r]| Some((*l)? + (*r)?)).collect();
            let width_mm = upper_median(&mut widths).ok_or(WeldBeadError::NoEdges)?;
            if 2 * widths.len() < halves.len() {
                return Err(WeldBeadError::NoEdges);
            }
            most_half_mm = (0.8 * width_mm + 2.0).min(AROUND_MM);
            if round < ROUNDS {
                let middles: Vec<Option<f64>> = halves.iter().map(|[l, r]| Some(0.5 * ((*l)? - (*r)?))).collect();
                let shifts = line::smoothed(&middles, MIDDLE_BELL);
                way = smooth_way(&on, &local_shifts(surface, &on, &shifts), MIDDLE_BELL);
                continue;
            }
            if !edges::is_measured_beyond(&placed, ends_mm[0], -1.0)
                || !edges::is_measured_beyond(&placed, ends_mm[1], 1.0)
            {
                return Err(WeldBeadError::LeavesImage);
            }
            let side = |k: usize| line::smoothed(&halves.iter().map(|h| h[k]).collect::<Vec<_>>(), EDGE_BELL);
            let (left, right) = (side(0), side(1));
            if left.len() != on.len() || right.len() != on.len() {
                return Err(WeldBeadError::NoEdges);
            }
            let half_mm: Vec<[f64; 2]> = left.into_iter().zip(right).map(|(l, r)| [l.max(0.0), r.max(0.0)]).collect();
            let corners = corners(&on, &half_mm, ends_mm);
            return Ok(Traced { stations: on, half_mm, placed, ends_mm, corners, noise_mm: surface.noise_mm });
        }
        Err(WeldBeadError::NoEdges)
    }

    pub(super) fn outline(&self, camera: &DepthCamera, like: &Mask) -> Mask {
        outline::filled(&self.corners, camera, like.width, like.height)
    }

    pub(super) fn bead(&self, parent: ParentSurface, outline: Mask, found: &[Found<'_>]) -> WeldBead {
        let ends = self.ends_mm;
        let measured = |(s, [left, right]): (&Station, &[f64; 2])| {
            let (width_mm, middle) = (left + right, 0.5 * (left - right));
            let height_mm = crest::height_mm(&self.placed, s.along_mm, ends, [middle, width_mm], self.noise_mm);
            let section = edges::section(&self.placed, s, ends);
            let inside = section.iter().filter(|b| (-right..=*left).contains(&b.at_mm));
            WeldSection {
                along_mm: s.along_mm - ends[0],
                centre: s.at + s.left * middle,
                normal: s.normal,
                tangent: s.tangent,
                width_mm,
                height_mm: height_mm.unwrap_or(0.0),
                profile_mm: inside.map(|b| [b.at_mm - middle, b.height_mm]).collect(),
            }
        };
        let sections: Vec<WeldSection> = self.stations.par_iter().zip(&self.half_mm).map(measured).collect();
        let points = bead_points(found, &outline);
        WeldBead {
            parent,
            outline,
            length_mm: ends[1] - ends[0],
            width_mm: upper_median(&mut sections.iter().map(|s| s.width_mm).collect::<Vec<_>>()).unwrap_or(0.0),
            max_height_mm: sections.iter().map(|s| s.height_mm).fold(0.0, f64::max),
            heights: HeightHistogram::new(points.iter().map(|p| p.height_mm), HISTOGRAM_BIN_MM),
            sections,
            points,
        }
    }
}

/// Shifts to the left in the surface as shifts of local places.
fn local_shifts(surface: &ParentSurface, on: &[Station], shifts_mm: &[f64]) -> Vec<Vector2<f64>> {
    let flat =
        |(s, shift): (&Station, &f64)| surface.camera_from_local.inverse_transform_vector(&(s.left * *shift)).xy();
    on.iter().zip(shifts_mm).map(flat).collect()
}

/// The local places of stations, shifted and smoothed.
fn smooth_way(on: &[Station], shifts: &[Vector2<f64>], bell: f64) -> Vec<Vector2<f64>> {
    let moved = |(k, s): (usize, &Station)| s.local + shifts.get(k).copied().unwrap_or_default();
    let all: Vec<Vector2<f64>> = on.iter().enumerate().map(moved).collect();
    let of = |k: usize| line::smoothed(&all.iter().map(|p| Some(p[k])).collect::<Vec<_>>(), bell);
    of(0).into_iter().zip(of(1)).map(|(x, y)| Vector2::new(x, y)).collect()
}

/// A way that goes on straight beyond both its ends.
fn continued(way: &[Vector2<f64>]) -> Vec<Vector2<f64>> {
    let beyond = |end: usize, inner: usize| {
        let (end, inner) = (way.get(end)?, way.get(inner)?);
        Some(end + (end - inner).try_normalize(0.0)? * CONTINUED_MM)
    };
    let last = way.len().saturating_sub(1);
    let (before, after) = (beyond(0, DIRECTION.min(last)), beyond(last, last.saturating_sub(DIRECTION)));
    before.into_iter().chain(way.iter().copied()).chain(after).collect()
}

/// The corners of an outline on the parent surface: the left edge from end to end, and the right one back.
fn corners(on: &[Station], half_mm: &[[f64; 2]], ends_mm: [f64; 2]) -> Vec<Point3<f64>> {
    let mut left = Vec::new();
    let mut right = Vec::new();
    for (k, (s, [l, r])) in on.iter().zip(half_mm).enumerate() {
        let out = |along: f64| s.tangent * along;
        if k == 0 {
            left.push(s.at + out(ends_mm[0] - s.along_mm) + s.left * *l);
            right.push(s.at + out(ends_mm[0] - s.along_mm) - s.left * *r);
        }
        left.push(s.at + s.left * *l);
        right.push(s.at - s.left * *r);
        if k + 1 == on.len() {
            left.push(s.at + out(ends_mm[1] - s.along_mm) + s.left * *l);
            right.push(s.at + out(ends_mm[1] - s.along_mm) - s.left * *r);
        }
    }
    left.into_iter().chain(right.into_iter().rev()).collect()
}
