//! Which area of the model has no points of the scan.
//!
//! The model is sampled evenly, one sample for each square of a voxel's side. A sample is covered where a point lies
//! within 1.5 voxels of it with a normal within 60° of the facet's (so that a thin wall's other side does not count);
//! without normals the distance alone decides. It says nothing of how far the point lies off: that is the deviation.

use super::super::cloud::Cloud;
use super::super::neighbours::{Neighbour, Neighbours};
use crate::part::Mesh;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// A point covers what is so many voxels away: the diagonal of a voxel's face and a little.
const REACH_VOXELS: f64 = 1.5;

/// Cosine of the greatest angle between the normals of a point and of what it covers.
const LEAST_COSINE: f64 = 0.5;

/// Samples at most; a finer voxel is looked for with coarser samples.
const MOST_SAMPLES: f64 = 1e6;

/// Samples that are one piece of work.
const PIECE: u64 = 1024;

/// How much of a model was scanned.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Coverage {
    /// Area of the model, mm².
    pub area_mm2: f64,
    /// Area without points, mm².
    pub uncovered_mm2: f64,
    /// The same of each surface, by number.
    pub surfaces: Vec<SurfaceCoverage>,
    /// The samples without points, in the model's frame: to be shown grey.
    pub uncovered: Vec<Point3<f64>>,
}

/// How much of a surface was scanned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceCoverage {
    /// The surface.
    pub number: u32,
    /// Its area, mm².
    pub area_mm2: f64,
    /// Area without points, mm², by the share of its samples; `None` where it is too small to have any.
    pub uncovered_mm2: Option<f64>,
}

impl Coverage {
    /// Share of the area that has points, 0 to 1; 0 without area.
    pub fn covered_share(&self) -> f64 {
        if self.area_mm2 > 0.0 { 1.0 - self.uncovered_mm2 / self.area_mm2 } else { 0.0 }
    }
}

/// Looks for points at samples of the model. The cloud is in the model's frame; `surface_of_facet` tells the number of
/// each facet's surface. A voxel that is no length gives no samples, and none of the area is covered.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub fn coverage(
    mesh: &Mesh,
    surface_of_facet: &[u32],
    cloud: &Cloud,
    neighbours: &Neighbours,
    voxel_mm: f64,
    progress: &Progress,
) -> Result<Coverage, Cancelled> {
    let mut ends = Vec::with_capacity(mesh.areas.len());
    let area_mm2 = mesh.areas.iter().fold(0.0, |sum, area| {
        ends.push(sum + area);
        sum + area
    });
    let sample_mm2 = (voxel_mm * voxel_mm).max(area_mm2 / MOST_SAMPLES);
    let is_length = voxel_mm > 0.0 && voxel_mm.is_finite() && area_mm2 > 0.0 && area_mm2.is_finite();
    let count = if is_length { (area_mm2 / sample_mm2).ceil() as u64 } else { 0 };
    let step = area_mm2 / count as f64;
    let reach_mm = REACH_VOXELS * voxel_mm;
    let samples: Vec<Vec<Sample>> = (0..count.div_ceil(PIECE))
        .into_par_iter()
        .map_init(Vec::new, |near, piece| {
            let mut seen = Vec::new();
            for k in piece * PIECE..count.min((piece + 1) * PIECE) {
                if k % 64 == 0 {
                    progress.check()?;
                }
                let at = (k as f64 + 0.5) * step;
                let facet = ends.partition_point(|&end| end <= at).min(ends.len() - 1);
                let place = place_on(&mesh.corners(facet), k);
                let is_covered = is_covered(cloud, neighbours, &place, &mesh.normals[facet], reach_mm, near);
                seen.push(Sample { facet, place, is_covered });
            }
            Ok(seen)
        })
        .collect::<Result<_, Cancelled>>()?;
    Ok(summed(&samples.concat(), &mesh.areas, surface_of_facet))
}

#[derive(Clone, Copy)]
struct Sample {
    facet: usize,
    place: Point3<f64>,
    is_covered: bool,
}

/// Area of a surface, its samples, and how many of them have no points.
#[derive(Clone, Copy, Default)]
struct Sum {
    area_mm2: f64,
    seen: u32,
    missed: u32,
}

fn summed(samples: &[Sample], areas: &[f64], surface_of_facet: &[u32]) -> Coverage {
    let mut sums: BTreeMap<u32, Sum> = BTreeMap::new();
    for (&surface, area) in surface_of_facet.iter().zip(areas) {
        sums.entry(surface).or_default().area_mm2 += area;
    }
    for sample in samples {
        let Some(sum) = surface_of_facet.get(sample.facet).and_then(|s| sums.get_mut(s)) else { continue };
        sum.seen += 1;
        sum.missed += u32::from(!sample.is_covered);
    }
    let of = |(&number, s): (&u32, &Sum)| SurfaceCoverage {
        number,
        area_mm2: s.area_mm2,
        uncovered_mm2: (s.seen > 0).then(|| s.area_mm2 * f64::from(s.missed) / f64::from(s.seen)),
    };
    let uncovered: Vec<_> = samples.iter().filter(|s| !s.is_covered).map(|s| s.place).collect();
    let area_mm2 = areas.iter().sum::<f64>();
    let share = if samples.is_empty() { 1.0 } else { uncovered.len() as f64 / samples.len() as f64 };
    Coverage { area_mm2, uncovered_mm2: area_mm2 * share, surfaces: sums.iter().map(of).collect(), uncovered }
}

/// The k-th place of a sequence that fills triangles evenly: Roberts' R2 (fractions of the plastic number's inverse
/// powers), the unit square folded along its diagonal.
fn place_on([a, b, c]: &[Point3<f64>; 3], k: u64) -> Point3<f64> {
    let part = |alpha: f64| (0.5 + alpha * k as f64).fract();
    let (u, v) = (part(0.754_877_666_246_692_7), part(0.569_840_290_998_053_2));
    let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
    a + (b - a) * u + (c - a) * v
}

fn is_covered(
    cloud: &Cloud,
    neighbours: &Neighbours,
    place: &Point3<f64>,
    outward: &Vector3<f64>,
    reach_mm: f64,
    near: &mut Vec<Neighbour>,
) -> bool {
    let faces = |n: &Neighbour| {
        let normal = cloud.normal(n.index as usize).unwrap_or_default();
        // A point without a normal may face anywhere.
        normal == Vector3::zeros() || normal.dot(outward) >= LEAST_COSINE
    };
    // The nearest one decides nearly always, and costs less than all.
    match neighbours.nearest_one(place, reach_mm) {
        None => false,
        Some(nearest) if faces(&nearest) => true,
        Some(_) => {
            neighbours.within(place, reach_mm, near);
            near.iter().any(faces)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plate of 40 mm × 20 mm × 1 mm; surfaces: 1 top, 2 bottom, 3 the four sides.
    fn plate() -> (Mesh, Vec<u32>) {
        let corner = |i: usize| Point3::new([0.0, 40.0][i & 1], [0.0, 20.0][i >> 1 & 1], [0.0, 1.0][i >> 2]);
        let quads = [[4, 5, 7, 6], [0, 2, 3, 1], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let facets = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        let surfaces = vec![1, 1, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3];
        (Mesh::from_indexed((0..8).map(corner).collect(), facets), surfaces)
    }

    /// Points on a grid of 0.2 mm over part of the top.
    fn top(x_to: f64, normal: Option<[f32; 3]>) -> Cloud {
        let across = (x_to / 0.2) as usize;
        let at = |i: usize| Point3::new((i % across) as f64 * 0.2 + 0.1, (i / across) as f64 * 0.2 + 0.1, 1.0);
        let points: Vec<Point3<f64>> = (0..across * 100).map(at).collect();
        Cloud { normals: normal.map(|n| vec![n; points.len()]), ..Cloud::of_points(&points) }
    }

    fn found(cloud: &Cloud, voxel_mm: f64) -> Coverage {
        let ((mesh, surfaces), progress) = (plate(), Progress::default());
        let neighbours = Neighbours::new(cloud, &progress).expect("nobody cancels");
        coverage(&mesh, &surfaces, cloud, &neighbours, voxel_mm, &progress).expect("nobody cancels")
    }

    #[test]
    fn the_area_without_points_is_told_for_each_surface() {
        let coverage = found(&top(20.0, Some([0.0, 0.0, 1.0])), 0.4);
        let of =
            |n: usize| (coverage.surfaces[n].area_mm2, coverage.surfaces[n].uncovered_mm2.expect("it has samples"));
        assert!((coverage.area_mm2 - 1720.0).abs() < 1e-9);
        // A strip of 1.5 voxels beside the last point counts as covered: 20 mm × 0.6 mm, less 0.1 mm.
        let expected = 20.0 * (40.0 - 20.0 - 0.5);
        assert!((of(0).1 - expected).abs() < 0.01 * expected, "{:?}", of(0));
        // The thin wall's other side has no points of its own, nor have the sides.
        assert_eq!(of(1), (800.0, 800.0));
        assert_eq!(of(2).0, of(2).1);
        let sum: f64 = (0..3).map(|n| of(n).1).sum();
        assert!((coverage.uncovered_mm2 - sum).abs() < 0.01 * sum);
        assert!((coverage.covered_share() - (1.0 - sum / 1720.0)).abs() < 0.01);
        assert!(coverage.uncovered.iter().all(|p| p.z < 1.0 || p.x > 20.4));
    }

    #[test]
    fn without_normals_the_other_side_counts_where_it_is_near() {
        let bottom = |cloud: &Cloud, voxel| found(cloud, voxel).surfaces[1].uncovered_mm2.expect("it has samples");
        assert_eq!(bottom(&top(40.0, None), 0.4), 800.0);
        assert_eq!(bottom(&top(40.0, None), 1.0), 0.0);
        assert_eq!(bottom(&top(40.0, Some([0.0; 3])), 1.0), 0.0);
    }

    #[test]
    fn a_scan_without_points_and_a_voxel_without_size_cover_nothing() {
        for coverage in [found(&Cloud::default(), 0.5), found(&top(40.0, None), 0.0), found(&top(40.0, None), f64::NAN)]
        {
            assert_eq!(coverage.covered_share(), 0.0);
            assert!((coverage.uncovered_mm2 - 1720.0).abs() < 1e-9);
        }
        assert!(found(&top(40.0, None), 0.0).surfaces.iter().all(|s| s.uncovered_mm2.is_none()));
    }

    #[test]
    fn samples_fill_a_triangle_evenly() {
        let corners = [Point3::origin(), Point3::new(1.0, 0.0, 0.0), Point3::new(0.0, 1.0, 0.0)];
        let mean = (0..1000).fold(Vector3::zeros(), |s, k| s + place_on(&corners, k).coords) / 1000.0;
        assert!((mean - Vector3::new(1.0, 1.0, 0.0) / 3.0).norm() < 3e-3, "{mean}");
    }
}
