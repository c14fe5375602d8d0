//! Lines through the points that were measured on a surface (P3 4.1): its points are sliced by its planes, and of the
//! curves what lies on the surface becomes its lines. What the points do not show has no line.

use super::planes::SurfacePlanes;
use super::section::{SectionPoint, TransversalLine};
use crate::part::measured::MeasuredPoints;
use crate::part::surfaces::Surface;
use crate::part::{Part, Surfaces};
use crate::progress::{Cancelled, Progress};
use crate::scan::Cloud;
use crate::scan::neighbours::Neighbours;
use crate::scan::slices::{OutwardSide, SliceCurve, SlicePlane, SlicePoint, SliceRules, slices};
use nalgebra::{Point3, Unit, Vector3};
use rayon::prelude::*;

/// Points so far beside a surface's box are looked at as well, mm: what a slice at the rim is fitted to.
const BESIDE_MM: f64 = 3.0;
/// A curve may lie so far off the surface's facets, mm: what a part is worn, and no other sheet.
const OFF_MM: f64 = 2.0;
/// A point that lies less than this below the facets is put onto them, mm, or the beam would be taken to go through the
/// part: so far facets stand off the points where the part was not shaped by its scan (patches begin at 0.05 mm by
/// default), with the noise on top. What lies deeper is not the part's surface as it is known, and stays to be refused.
const SUNK_MM: f64 = 0.1;
/// So often a side is halved that crosses the rim: its end is found to a 256th of a step.
const HALVED: usize = 8;

/// How curves are sampled, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredRules {
    /// Greatest distance of two points of a line.
    pub step_mm: f64,
    /// Greatest distance of a curve from its chords, and from the middle of the points.
    pub chord_mm: f64,
}

/// The lines of a surface for one family of its planes, by ascending rank; `first_rank`: that of the lowest plane.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn measured_lines(
    (part, surfaces, surface): (&Part, &Surfaces, &Surface),
    measured: &MeasuredPoints,
    (planes, first_rank): (&SurfacePlanes, usize),
    rules: &MeasuredRules,
    progress: &Progress,
) -> Result<Vec<TransversalLine>, Cancelled> {
    let (cloud, normals) = around(part, surface, measured);
    if cloud.is_empty() {
        return Ok(Vec::new());
    }
    let neighbours = Neighbours::new(&cloud, progress)?;
    let normal = Unit::new_unchecked(planes.normal);
    let all: Vec<SlicePlane> = planes.heights_mm.iter().map(|h| SlicePlane { normal, offset_mm: *h }).collect();
    let by = SliceRules {
        step_mm: rules.step_mm,
        chord_mm: rules.chord_mm,
        tolerance_mm: rules.chord_mm,
        outward: OutwardSide::OfNormals,
    };
    let cut = slices(&cloud, &neighbours, &normals, &all, &by, progress)?;
    let on = OnSurface { part, surfaces, number: surface.number };
    let lines: Vec<Vec<TransversalLine>> = cut
        .par_iter()
        .enumerate()
        .map(|(plane, slice)| {
            progress.check()?;
            let pieces = slice.curves.iter().flat_map(|curve| on.pieces(curve));
            let lines = pieces.map(|(points, closed)| TransversalLine {
                plane: first_rank + plane,
                points,
                closed,
                dark: Vec::new(),
            });
            Ok(lines.collect())
        })
        .collect::<Result<_, Cancelled>>()?;
    Ok(lines.into_iter().flatten().collect())
}

/// The points about a surface, with their normals.
fn around(part: &Part, surface: &Surface, measured: &MeasuredPoints) -> (Cloud, Vec<[f32; 3]>) {
    let corners = surface.facets.iter().flat_map(|&f| part.mesh.corners(f as usize));
    let (mut lo, mut hi) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
    for p in corners {
        (lo, hi) = (lo.inf(&(p - measured.origin)), hi.sup(&(p - measured.origin)));
    }
    let is_near = |o: &[f32; 3]| (0..3).all(|k| (lo[k] - BESIDE_MM..=hi[k] + BESIDE_MM).contains(&f64::from(o[k])));
    let (offsets, normals) = measured.offsets.iter().zip(&measured.normals).filter(|(o, _)| is_near(o)).unzip();
    (Cloud { origin: measured.origin, offsets, ..Cloud::default() }, normals)
}

/// Tells which places lie on a surface.
struct OnSurface<'a> {
    part: &'a Part,
    surfaces: &'a Surfaces,
    number: u32,
}

impl OnSurface<'_> {
    /// The point of a line, with the normal on the side to be worked on, where a point of a curve lies on the surface.
    fn point(&self, at: &Point3<f64>, outward: &Vector3<f64>) -> Option<SectionPoint> {
        let closest = self.part.bvh.closest(at, OFF_MM)?;
        let f = closest.facet as usize;
        if self.surfaces.of_facet[f] != self.number {
            return None;
        }
        let of_facet = self.surfaces.normals[f];
        // The far side of a thin sheet is another surface's.
        if outward.dot(&self.part.mesh.normals[f]) <= 0.0 {
            return None;
        }
        let n = if outward.dot(&of_facet) < 0.0 { -outward } else { *outward };
        let above_mm = (at - closest.foot).dot(&of_facet);
        let is_sunk = above_mm < 0.0 && closest.distance_mm < SUNK_MM;
        Some(SectionPoint { p: if is_sunk { closest.foot } else { *at }, n })
    }

    /// What of a curve lies on the surface, and whether that is all of a closed one.
    fn pieces(&self, curve: &SliceCurve) -> Vec<(Vec<SectionPoint>, bool)> {
        let found: Vec<Option<SectionPoint>> = curve.points.iter().map(|p| self.point(&p.place, &p.outward)).collect();
        let count = found.len();
        if found.iter().all(Option::is_some) {
            return vec![(found.into_iter().flatten().collect(), curve.closed)];
        }
        // A closed curve begins where it enters the surface, so that no piece of it falls in two.
        let first = match curve.closed {
            true => (0..count).find(|&i| found[i].is_some() && found[(i + count - 1) % count].is_none()).unwrap_or(0),
            false => 0,
        };
        let sides = |i: usize| curve.closed || i + 1 < count;
        let mut pieces: Vec<Vec<SectionPoint>> = vec![Vec::new()];
        for i in (0..count).map(|i| (first + i) % count) {
            let next = (i + 1) % count;
            pieces.last_mut().into_iter().for_each(|piece| piece.extend(found[i]));
            match (found[i].is_some(), found[next].is_some()) {
                _ if !sides(i) => {}
                (true, false) => {
                    let end = self.rim(&curve.points[i], &curve.points[next]);
                    pieces.last_mut().into_iter().for_each(|piece| piece.extend(end));
                    pieces.push(Vec::new());
                }
                (false, true) => {
                    let begin = self.rim(&curve.points[next], &curve.points[i]);
                    pieces.last_mut().into_iter().for_each(|piece| piece.extend(begin));
                }
                _ => {}
            }
        }
        pieces.into_iter().filter(|piece| piece.len() > 1).map(|piece| (piece, false)).collect()
    }

    /// The last point that lies on the surface on the way from one that does to one that does not.
    fn rim(&self, on: &SlicePoint, off: &SlicePoint) -> Option<SectionPoint> {
        let (mut last, mut low, mut high) = (None, 0.0, 1.0);
        for _ in 0..HALVED {
            let t = 0.5 * (low + high);
            let at = on.place + (off.place - on.place) * t;
            let outward = (on.outward * (1.0 - t) + off.outward * t).normalize();
            match self.point(&at, &outward) {
                Some(on) => (last, low) = (Some(on), t),
                None => high = t,
            }
        }
        last
    }
}

#[cfg(test)]
mod tests;
