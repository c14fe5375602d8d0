//! A weld bead, measured: its outline, its centre line, and width and height along it (P4 4).
//!
//! The grey image finds the bead, depth outlines it: what stands above the parent surface. The centre line is the middle
//! of both edges across it; each round finds the edges anew from the line of the last. A bead is one open line; of a
//! cross of two the longer way is taken, and a ring is cut open. What leaves the image is refused: no one knows where it
//! ends.

mod crest;
mod edges;
mod histogram;
mod line;
mod outline;
mod rough;

use super::camera::DepthCamera;
use super::parent::{Foot, ParentError, ParentSurface, median, mm_per_px};
use super::pixel_distance::dilated;
use super::points::PixelPoint;
use super::raster::{Mask, Raster};
use line::{Placed, Station};
use nalgebra::{Point3, Vector2, Vector3};
use rayon::prelude::*;
use serde::Serialize;
use thiserror::Error;

pub use histogram::HeightHistogram;

/// What the grey mask may be off, px, when the parent is first fitted; and what the outline may be.
const MARGIN_PX: f64 = 7.0;
const OUTLINED_MARGIN_PX: f64 = 2.0;
/// Heights are looked at so far around the mask, mm: a mask that missed half of a bead still finds the rest.
const AROUND_MM: f64 = 14.0;
/// Rounds that move the centre line: three with the first parent surface, three with the second. The last moves it by
/// less than 0.02 mm.
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
const HISTOGRAM_BIN_MM: f64 = 0.5;

/// A bead.
#[derive(Clone, Debug, PartialEq)]
pub struct WeldBead {
    /// The surface that it stands on.
    pub parent: ParentSurface,
    /// Its pixels.
    pub outline: Mask,
    /// Sections at even steps along its centre line, from end to end.
    pub sections: Vec<WeldSection>,
    /// Length of its centre line on the parent surface, mm.
    pub length_mm: f64,
    /// Median of the widths of its sections, mm.
    pub width_mm: f64,
    /// The greatest height of its sections, mm.
    pub max_height_mm: f64,
    /// The heights of its points.
    pub heights: HeightHistogram,
    /// Its points.
    pub points: Vec<BeadPoint>,
}

/// A section of a bead.
#[derive(Clone, Debug, PartialEq)]
pub struct WeldSection {
    /// Way along the centre line, mm.
    pub along_mm: f64,
    /// Where the centre line is, on the parent surface, camera frame, mm.
    pub centre: Point3<f64>,
    /// Of the parent surface, towards the camera.
    pub normal: Vector3<f64>,
    /// Along the centre line.
    pub tangent: Vector3<f64>,
    /// From edge to edge, mm.
    pub width_mm: f64,
    /// Of its crest above the parent surface, mm; not smoothed further along than noise asks for.
    pub height_mm: f64,
    /// Heights across: distance from the centre to the left of the tangent (normal × tangent), and height, mm.
    pub profile_mm: Vec<[f64; 2]>,
}

/// A point of a bead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeadPoint {
    /// Its pixel.
    pub pixel: [u32; 2],
    /// Camera frame, mm.
    pub point: Point3<f64>,
    /// Its foot on the parent surface, camera frame, mm.
    pub foot: Point3<f64>,
    /// Above the parent surface, mm.
    pub height_mm: f64,
}

/// What a masked area is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum AreaKind {
    /// It stands above the parent surface.
    #[serde(rename = "bead")]
    Bead,
    /// It does not: a ground or scratched area.
    #[serde(rename = "defect")]
    Flat,
}

/// Why a bead cannot be measured.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum WeldBeadError {
    /// It has no parent surface.
    #[error(transparent)]
    Parent(#[from] ParentError),
    /// Nothing under the mask stands above the parent surface.
    #[error("nothing stands {threshold_mm} mm above the parent surface")]
    NothingStands {
        /// What it would have to be, mm.
        threshold_mm: f64,
    },
    /// It reaches the rim of the image, or of what was measured.
    #[error("the bead leaves the image")]
    LeavesImage,
    /// It is too short to have a centre line.
    #[error("{length_mm} mm long")]
    Short {
        /// Its length, mm.
        length_mm: f64,
    },
    /// Its edges were not found: it runs into something beside it, or has none.
    #[error("no edges")]
    NoEdges,
}

/// Whether an area stands above the metal around it. `covered`: all masked areas, none of which counts as parent.
///
/// # Errors
/// It has no parent surface.
pub fn kind_of_area(points: &[PixelPoint], area: &Mask, covered: &Mask) -> Result<AreaKind, ParentError> {
    let surface = ParentSurface::fit(points, area, covered, MARGIN_PX)?;
    let inside: Vec<&PixelPoint> = points.iter().filter(|p| is_in(area, p)).collect();
    let medians = rough::medians(&height_raster(area, &feet(&surface, &inside)));
    let all = medians.values.iter().filter(|h| h.is_finite());
    let threshold = rough::threshold_mm(surface.noise_mm);
    let (above, count) = all.fold((0, 0), |(a, n), h| (a + usize::from(f64::from(*h) > threshold), n + 1));
    // A mask of a bead has a rim of bare metal: half of its pixels would be too much to ask.
    Ok(if 4 * above > count { AreaKind::Bead } else { AreaKind::Flat })
}

/// Measures the bead under a mask. `points`: all of the depth image, row by row; `covered`: all masked areas.
///
/// # Errors
/// There is no bead there, or not all of it.
pub fn measure(
    points: &[PixelPoint],
    area: &Mask,
    covered: &Mask,
    camera: &DepthCamera,
) -> Result<WeldBead, WeldBeadError> {
    let first = ParentSurface::fit(points, area, covered, MARGIN_PX)?;
    let around_px = AROUND_MM / mm_per_px(points).ok_or(ParentError::NothingCovered)?;
    let around = dilated(area, around_px);
    let near: Vec<&PixelPoint> = points.iter().filter(|p| is_in(&around, p)).collect();
    let found = feet(&first, &near);
    let threshold_mm = rough::threshold_mm(first.noise_mm);
    let standing = rough::standing_area(&rough::medians(&height_raster(area, &found)), area, threshold_mm)
        .ok_or(WeldBeadError::NothingStands { threshold_mm })?;
    // Medians reach to the rim, however few points they have there.
    if outline::touches_rim(&standing) {
        return Err(WeldBeadError::LeavesImage);
    }
    let on_surface = |[u, v]: &[usize; 2]| {
        let ray = camera.ray(*u as f64, *v as f64)?;
        let depth = first.camera_from_local.translation.vector.z / ray.z;
        Some(Vector2::from(first.foot(&Point3::from(ray * depth)).local))
    };
    let way: Vec<Vector2<f64>> = rough::way_along(&standing).iter().filter_map(on_surface).collect();
    let rough = Traced::along(&first, &way, &found)?;
    let outlined = rough.outline(camera, area);
    // The other areas stay covered; of this one the outline knows better than its mask.
    let mut no_parent = outlined.clone();
    for ((into, on), of_this) in no_parent.values.iter_mut().zip(&covered.values).zip(&area.values) {
        *into |= *on && !*of_this;
    }
    let parent = ParentSurface::fit(points, &outlined, &no_parent, OUTLINED_MARGIN_PX)?;
    let found = feet(&parent, &near);
    let way: Vec<Vector2<f64>> = rough.stations.iter().map(|s| s.local).collect();
    let traced = Traced::along(&parent, &way, &found)?;
    let outline = traced.outline(camera, area);
    if outline::touches_rim(&outline) {
        return Err(WeldBeadError::LeavesImage);
    }
    Ok(traced.bead(parent, outline, &found))
}

fn is_in(mask: &Mask, p: &PixelPoint) -> bool {
    let [u, v] = p.pixel.map(|c| c as usize);
    mask.at(u, v) == Some(&true)
}

type Found<'p> = (&'p PixelPoint, Foot);

fn feet<'p>(surface: &ParentSurface, points: &[&'p PixelPoint]) -> Vec<Found<'p>> {
    points.par_iter().map(|p| (*p, surface.foot(&p.point))).collect()
}

fn height_raster(like: &Mask, found: &[Found<'_>]) -> Raster<f32> {
    let mut values = vec![f32::NAN; like.values.len()];
    for (p, foot) in found {
        let [u, v] = p.pixel.map(|c| c as usize);
        if let Some(into) = values.get_mut(v * like.width + u) {
            *into = foot.height_mm as f32;
        }
    }
    Raster { width: like.width, height: like.height, values }
}

/// A centre line with its edges.
struct Traced {
    /// The stations of the bead, from its first end to its last.
    stations: Vec<Station>,
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
    fn along(surface: &ParentSurface, way: &[Vector2<f64>], found: &[Found<'_>]) -> Result<Traced, WeldBeadError> {
        let feet: Vec<(Point3<f64>, [f64; 2], f64)> =
            found.iter().filter(|(_, f)| f.is_converged).map(|(_, f)| (f.foot, f.local, f.height_mm)).collect();
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
            let widths = halves.iter().filter_map(|[l, r]| Some((*l)? + (*r)?));
            let width_mm = median(widths.clone().collect()).ok_or(WeldBeadError::NoEdges)?;
            if 2 * widths.count() < halves.len() {
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

    fn outline(&self, camera: &DepthCamera, like: &Mask) -> Mask {
        outline::filled(&self.corners, camera, like.width, like.height)
    }

    fn bead(&self, parent: ParentSurface, outline: Mask, found: &[Found<'_>]) -> WeldBead {
        let ends = self.ends_mm;
        let measured = |(s, [left, right]): (&Station, &[f64; 2])| {
            let (width_mm, middle) = (left + right, 0.5 * (left - right));
            let height_mm = crest::height_mm(&self.placed, s.along_mm, middle, width_mm, self.noise_mm);
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
        let is_inside = |p: &PixelPoint| is_in(&outline, p);
        let points: Vec<BeadPoint> = found
            .iter()
            .filter(|(p, f)| f.is_converged && is_inside(p))
            .map(|(p, f)| BeadPoint { pixel: p.pixel, point: p.point, foot: f.foot, height_mm: f.height_mm })
            .collect();
        WeldBead {
            parent,
            outline,
            length_mm: ends[1] - ends[0],
            width_mm: median(sections.iter().map(|s| s.width_mm).collect()).unwrap_or(0.0),
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

#[cfg(test)]
mod tests;
