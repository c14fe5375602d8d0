//! Smoothing that keeps edges, in two passes over the neighbours of all points.
//!
//! First each point gets a plane that belongs to one side of an edge only: iterated least squares, points further off
//! it counting less and less (robust moving least squares: Fleishman, Cohen-Or and Silva 2005). Then each point goes
//! where the planes of its neighbours put it, as far as they agree with it (Jones, Durand and Desbrun, "Non-iterative,
//! feature-preserving mesh smoothing", 2003): where two faces meet the planes of both are at home, and an edge stays.
//! A plane through points of a curved face lies inside of it, and beside its middle outside: the mean of all planes
//! around a point is off by less than a single one.
//!
//! It knows no shape finer than the radius; a fillet of a radius below that is taken for noise or an edge.

use super::Outcome;
use crate::progress::{Cancelled, Progress};
use crate::scan::assessment::point_figures::point_figures;
use crate::scan::cloud::Cloud;
use crate::scan::neighbours::{Neighbour, Neighbours};
use crate::scan::normals::{FittedPlane, plane_weighted};

/// Points that are so many standard deviations of the noise off a plane are none of it.
const WIDTH_OF_NOISE: f64 = 3.0;

/// The width in which points count starts at so much of the radius: an edge's other side lies up to a whole radius off.
const FIRST_WIDTH: f64 = 0.5;

/// Each step of the plane narrows the width so much. With 0.4 a third more of the noise is left beside an edge; 0.8
/// wins little and takes longer.
const NARROWER: f64 = 0.7;

/// Least share of the neighbours, by weight, that a plane must hold. A face under noise holds 0.8 of its points; with
/// 0.2 planes across an edge pass, and half as much noise more is left beside it.
const LEAST_HELD: f64 = 0.5;

pub(super) fn smoothed(
    cloud: &Cloud,
    radius_mm: f64,
    noise_mm: Option<f64>,
    progress: &Progress,
) -> Result<Outcome, Cancelled> {
    let tree = Neighbours::new(cloud, progress)?;
    let noise_mm = match noise_mm {
        Some(given) => given,
        None => point_figures(cloud, &tree, progress)?.map_or(0.0, |f| f.noise_mm),
    };
    let width = WIDTH_OF_NOISE * noise_mm;
    if !(width > 0.0 && radius_mm > 0.0 && width.is_finite() && radius_mm.is_finite()) {
        return Ok(Outcome::Unchanged);
    }
    let faces = tree.map_within(radius_mm, progress, |i, near| face_of(cloud, i, near, radius_mm, width))?;
    let moved = tree.map_within(radius_mm, progress, |index, near| {
        let place = cloud.offsets[index as usize];
        let (mut sum, mut whole) = ([0.0f32; 3], 0.0);
        for other in near.iter().map(|n| n.index).chain([index]) {
            let (face, from) = (&faces[other as usize], cloud.offsets[other as usize]);
            let across = |k: usize| face.normal[k] * (from[k] - place[k]);
            let off = face.off_mm + (across(0) + across(1) + across(2));
            let weight = biweight(f64::from(off), width) as f32 * face.counts;
            sum = std::array::from_fn(|k| sum[k] + face.normal[k] * (off * weight));
            whole += weight;
        }
        if whole > 0.0 { std::array::from_fn(|k| place[k] + sum[k] / whole) } else { place }
    })?;
    Ok(Outcome::Moved(moved))
}

/// The face on which a point lies, as a plane. In f32: millions of them are read in no order.
#[derive(Clone, Copy, Default)]
struct Face {
    normal: [f32; 3],
    /// How far the plane is from the point along the normal.
    off_mm: f32,
    /// 1; 0 where there is none.
    counts: f32,
}

fn face_of(cloud: &Cloud, index: u32, near: &[Neighbour], radius_mm: f64, least: f64) -> Face {
    let Some(plane) = one_sided(cloud, index, near, radius_mm, least) else { return Face::default() };
    let off = (plane.middle - cloud.point(index as usize)).dot(&plane.normal);
    Face { normal: plane.normal.map(|c| c as f32).into(), off_mm: off as f32, counts: 1.0 }
}

/// The plane of the face on which the point lies; `None` where no plane holds enough of its neighbours.
fn one_sided(cloud: &Cloud, index: u32, near: &[Neighbour], radius_mm: f64, least: f64) -> Option<FittedPlane> {
    let point = cloud.point(index as usize);
    let places = || std::iter::once(point).chain(near.iter().map(|n| cloud.point(n.index as usize)));
    let off = |plane: &FittedPlane, p: &nalgebra::Point3<f64>| (p - plane.middle).dot(&plane.normal);
    let mut plane = plane_weighted(places().map(|p| (p, 1.0)))?;
    if places().all(|p| off(&plane, &p).abs() < least) {
        return Some(plane);
    }
    let mut width = (FIRST_WIDTH * radius_mm).max(least);
    loop {
        plane = plane_weighted(places().map(|p| (p, biweight(off(&plane, &p), width))))?;
        if width <= least {
            break;
        }
        width = (width * NARROWER).max(least);
    }
    let held: f64 = places().map(|p| biweight(off(&plane, &p), least)).sum();
    (held > LEAST_HELD * (near.len() + 1) as f64).then_some(plane)
}

/// Tukey's weight: 1 at nought, 0 from the width on.
fn biweight(off: f64, width: f64) -> f64 {
    let left = (1.0 - (off / width) * (off / width)).max(0.0);
    left * left
}
