//! What the planes miss, and the spacing that lines really have on a surface.
//!
//! Planes at distance d give lines d/sin∠(n, m) apart on a surface with normal n: 2 d at 30°,
//! 5.8 d at 10°, nothing at all on a facet parallel to the planes. P1 and P2 ignore this.

use super::live_facets::{PARALLEL_DEG, live};
use super::planes::SurfacePlanes;
use super::section::TransversalLine;
use crate::part::{Mesh, surfaces::Surface};
use crate::progress::{Cancelled, Progress};
use nalgebra::Point3;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// Coverage of one surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Coverage {
    /// Area of the facets that no line reaches, mm².
    pub missed_area_mm2: f64,
    /// Those facets.
    pub missed_facets: Vec<u32>,
    /// Least distance of neighbouring lines on the surface, mm; `None` where all is missed.
    pub spacing_min_mm: Option<f64>,
    /// Greatest.
    pub spacing_max_mm: Option<f64>,
}

/// Looks for missed facets: parallel within 10° to the planes (of two families: to both), or crossed by no line
/// of the surface and further than one spacing from any. Without planes distance alone decides; without lines all of
/// the surface is missed.
///
/// The spacing is that of planes at equal distances; other strategies measure it.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn coverage(
    mesh: &Mesh,
    surface: &Surface,
    planes: &[SurfacePlanes],
    spacing_mm: f64,
    lines: &[TransversalLine],
    progress: &Progress,
) -> Result<Coverage, Cancelled> {
    let parallel_sine = libm::sin(PARALLEL_DEG.to_radians());
    let grid: OnceLock<PointGrid> = OnceLock::new();
    let mut out = Coverage::default();
    if lines.is_empty() {
        // Planes that cross it have no line on it.
        let missed_facets = live(mesh, surface).map(|f| f as u32).collect();
        return Ok(Coverage { missed_area_mm2: surface.area_mm2, missed_facets, ..out });
    }
    let sine = |f: usize, planes: &SurfacePlanes| mesh.normals[f].cross(&planes.normal).norm();
    let looked_at = |f: usize| {
        progress.check()?;
        let crosses = |planes: &SurfacePlanes| {
            let heights = mesh.corners(f).map(|p| p.coords.dot(&planes.normal));
            let (lo, hi) = (heights[0].min(heights[1]).min(heights[2]), heights[0].max(heights[1]).max(heights[2]));
            let from = planes.heights_mm.partition_point(|&c| c <= lo);
            planes.heights_mm.get(from).is_some_and(|&c| c <= hi)
        };
        let steepest = planes.iter().map(|p| sine(f, p)).reduce(f64::max);
        let crossed = planes.iter().any(|p| sine(f, p) >= parallel_sine && crosses(p));
        let missed = steepest.is_some_and(|sine| sine < parallel_sine)
            || (!crossed && {
                let grid = grid.get_or_init(|| PointGrid::new(lines, spacing_mm));
                !grid.has_within(&mesh.corners(f), spacing_mm)
            });
        Ok((f, steepest, missed))
    };
    let facets: Vec<usize> = live(mesh, surface).collect();
    let looked_at: Vec<_> =
        facets.into_par_iter().with_min_len(256).map(looked_at).collect::<Result<_, Cancelled>>()?;
    for (f, steepest, missed) in looked_at {
        if missed {
            out.missed_area_mm2 += mesh.areas[f];
            out.missed_facets.push(f as u32);
        } else {
            let on_surface = spacing_mm / steepest.unwrap_or(1.0);
            out.spacing_min_mm = Some(out.spacing_min_mm.map_or(on_surface, |s| s.min(on_surface)));
            out.spacing_max_mm = Some(out.spacing_max_mm.map_or(on_surface, |s| s.max(on_surface)));
        }
    }
    Ok(out)
}

/// Pieces of lines by the cell they pass, cells of one spacing.
struct PointGrid {
    cell_mm: f64,
    /// Steps to the cells around one, the nearest first.
    around: Vec<[i64; 3]>,
    cells: BTreeMap<[i64; 3], Vec<LinePiece>>,
}

type LinePiece = (Point3<f64>, Point3<f64>);

impl PointGrid {
    fn new(lines: &[TransversalLine], cell_mm: f64) -> PointGrid {
        let mut cells: BTreeMap<[i64; 3], Vec<LinePiece>> = BTreeMap::new();
        for line in lines {
            for (from, to) in line.sides() {
                let pieces = ((to.p - from.p).norm() / cell_mm).ceil().max(1.0);
                for i in 0..pieces as usize {
                    let at = |k: usize| from.p + (to.p - from.p) * (k as f64 / pieces);
                    cells.entry(key(&at(i), cell_mm)).or_default().push((at(i), at(i + 1)));
                }
            }
        }
        let mut around: Vec<[i64; 3]> = (0..27).map(|i| [i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1]).collect();
        around.sort_by_key(|d| d.iter().map(|k| k * k).sum::<i64>());
        PointGrid { cell_mm, around, cells }
    }

    fn has_within(&self, corners: &[Point3<f64>; 3], distance_mm: f64) -> bool {
        // A piece is at most one cell long and filed under its start: two cells around hold all.
        let lo = key(&corners[0].inf(&corners[1]).inf(&corners[2]), self.cell_mm).map(|k| k - 2);
        let hi = key(&corners[0].sup(&corners[1]).sup(&corners[2]), self.cell_mm).map(|k| k + 2);
        let near = |cell: &[i64; 3]| (0..3).all(|k| (lo[k]..=hi[k]).contains(&cell[k]));
        // Mostly a line passes near the middle, which the nearest cells show at little cost.
        let middle = corners[0] + ((corners[1] - corners[0]) + (corners[2] - corners[0])) / 3.0;
        // What is within reach of the facet is within this of its middle: the distance to a point costs a tenth.
        let radius_mm = corners.iter().map(|corner| (corner - middle).norm()).fold(0.0, f64::max);
        let from_middle_mm = (distance_mm + radius_mm) * (1.0 + 1e-9);
        let reaches = |(a, b): &LinePiece| {
            crate::part::distance::point_segment(&middle, a, b) <= from_middle_mm
                && crate::part::distance::segment_triangle(a, b, corners) <= distance_mm
        };
        let here = key(&middle, self.cell_mm);
        let passes = |(a, b): &LinePiece| crate::part::distance::point_segment(&middle, a, b) <= distance_mm;
        let around =
            self.around.iter().filter_map(|d| self.cells.get(&[here[0] + d[0], here[1] + d[1], here[2] + d[2]]));
        if around.flatten().any(passes) {
            return true;
        }
        let cells = (0..3).map(|k| (hi[k] - lo[k] + 1) as f64).product::<f64>();
        if cells < 1000.0 {
            let span = |k: usize| lo[k]..=hi[k];
            return span(0)
                .flat_map(|x| span(1).flat_map(move |y| span(2).map(move |z| [x, y, z])))
                .filter_map(|cell| self.cells.get(&cell))
                .any(|pieces| pieces.iter().any(reaches));
        }
        // A long facet: cells in order of x, so those of other slices are never looked at.
        self.cells
            .range([lo[0], i64::MIN, i64::MIN]..=[hi[0], i64::MAX, i64::MAX])
            .any(|(cell, pieces)| near(cell) && pieces.iter().any(reaches))
    }
}

fn key(p: &Point3<f64>, cell_mm: f64) -> [i64; 3] {
    [0, 1, 2].map(|k| (p[k] / cell_mm).floor() as i64)
}
