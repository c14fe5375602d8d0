//! A centre line on the parent surface, and where points lie along it and beside it.
//!
//! Stations stand at even steps of arc length on the surface. Beside the line is across its tangent, within the surface:
//! to the left as one looks along it from outside.

use crate::scan::upper_median;
use crate::weld::parent::ParentSurface;
use nalgebra::{Point3, Vector2, Vector3};
use rayon::prelude::*;

/// Distance of stations, mm.
pub(super) const STEP_MM: f64 = 1.0;
/// No side of a way is longer, mm: a foot that went off to nowhere.
const MOST_MM: f64 = 1e4;
/// Every so many stations are looked at first, to find the nearest of all.
const STRIDE: usize = 4;

/// A station of the line, camera frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Station {
    pub(super) local: Vector2<f64>,
    pub(super) at: Point3<f64>,
    pub(super) tangent: Vector3<f64>,
    pub(super) normal: Vector3<f64>,
    pub(super) left: Vector3<f64>,
    pub(super) along_mm: f64,
}

/// A point by the line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub(super) along_mm: f64,
    pub(super) left_mm: f64,
    pub(super) height_mm: f64,
}

/// Stations at even steps along a polyline of local places; the last may stand short of its end by less than a step.
pub(super) fn stations(surface: &ParentSurface, way: &[Vector2<f64>]) -> Vec<Station> {
    let spatial: Vec<Point3<f64>> = way.iter().map(|p| surface.point_at([p.x, p.y])).collect();
    let mut places = Vec::new();
    let (mut walked, mut next) = (0.0, 0.0);
    for (flat, solid) in way.windows(2).zip(spatial.windows(2)) {
        let length = (solid[1] - solid[0]).norm();
        if !(0.0..MOST_MM).contains(&length) {
            continue;
        }
        while next <= walked + length && length > 0.0 {
            places.push(flat[0] + (flat[1] - flat[0]) * ((next - walked) / length));
            next += STEP_MM;
        }
        walked += length;
    }
    let solid: Vec<Point3<f64>> = places.iter().map(|p| surface.point_at([p.x, p.y])).collect();
    let last = solid.len().saturating_sub(1);
    let mut along_mm = 0.0;
    let mut all = Vec::with_capacity(places.len());
    for (k, local) in places.iter().enumerate() {
        let at = solid[k];
        if k > 0 {
            along_mm += (at - solid[k - 1]).norm();
        }
        let normal = surface.normal_at([local.x, local.y]);
        let chord = solid[(k + 1).min(last)] - solid[k.saturating_sub(1)];
        let tangent = (chord - normal * normal.dot(&chord)).try_normalize(0.0).unwrap_or_else(Vector3::x);
        all.push(Station { local: *local, at, tangent, normal, left: normal.cross(&tangent), along_mm });
    }
    all
}

/// Points by the line, in order along it; those further off than `reach_mm` are left out. `feet`: the foot of each point
/// in the camera's frame, its local place, and its height.
pub(super) fn placed(stations: &[Station], feet: &[(Point3<f64>, [f64; 2], f64)], reach_mm: f64) -> Vec<Placed> {
    let last = stations.len().saturating_sub(1);
    let find = |&(foot, [x, y], height_mm): &(Point3<f64>, [f64; 2], f64)| {
        let square = |k: &usize| (stations[*k].local - Vector2::new(x, y)).norm_squared();
        let nearer = |a: &usize, b: &usize| square(a).total_cmp(&square(b));
        let about = (0..stations.len()).step_by(STRIDE).min_by(nearer)?;
        let nearest = (about.saturating_sub(STRIDE)..=(about + STRIDE).min(last)).min_by(nearer)?;
        let station = &stations[nearest];
        let off = foot - station.at;
        let (along, left_mm) = (off.dot(&station.tangent), off.dot(&station.left));
        let is_near = left_mm.abs() <= reach_mm && along.abs() <= 2.0 * STEP_MM;
        is_near.then_some(Placed { along_mm: station.along_mm + along, left_mm, height_mm })
    };
    let mut all: Vec<Placed> = feet.par_iter().filter_map(find).collect();
    all.sort_by(|a, b| a.along_mm.total_cmp(&b.along_mm));
    all
}

/// Those of sorted points that lie within a stretch.
pub(super) fn between(placed: &[Placed], from_mm: f64, to_mm: f64) -> &[Placed] {
    let first = placed.partition_point(|p| p.along_mm < from_mm);
    let end = placed.partition_point(|p| p.along_mm <= to_mm);
    placed.get(first..end).unwrap_or_default()
}

/// Each value by a parabola through its neighbours, weighted by a bell of the given width (1 σ, in places); gaps and
/// values that lie off by more than four times the usual are bridged. Empty where fewer than three values are left.
pub(super) fn smoothed(values: &[Option<f64>], bell: f64) -> Vec<f64> {
    let mut kept = values.to_vec();
    let mut all = parabolas(&kept, bell);
    for _ in 0..2 {
        let off = |(v, s): (&Option<f64>, &f64)| v.map(|v| (v - s).abs());
        let mut offs: Vec<f64> = values.iter().zip(&all).filter_map(off).collect();
        let Some(usual) = upper_median(&mut offs) else { return Vec::new() };
        let limit = 4.0 * 1.5 * usual.max(1e-3);
        for ((kept, value), smooth) in kept.iter_mut().zip(values).zip(&all) {
            *kept = value.filter(|v| (v - smooth).abs() <= limit);
        }
        all = parabolas(&kept, bell);
    }
    all
}

fn parabolas(values: &[Option<f64>], bell: f64) -> Vec<f64> {
    if values.iter().flatten().count() < 3 {
        return Vec::new();
    }
    let reach = (3.0 * bell).ceil() as usize;
    let at = |k: usize| {
        // Where there is a gap the bell grows until it holds enough.
        let mut wide = reach;
        loop {
            let near = k.saturating_sub(wide)..(k + wide + 1).min(values.len());
            let (mut left, mut right) = (nalgebra::Matrix3::zeros(), Vector3::zeros());
            let mut count = 0;
            let scale = wide as f64;
            for j in near {
                let Some(value) = values[j] else { continue };
                let x = (j as f64 - k as f64) / scale;
                let weight = libm::exp(-4.5 * x * x);
                let row = Vector3::new(1.0, x, x * x);
                left += row * row.transpose() * weight;
                right += row * (value * weight);
                count += 1;
            }
            if count >= 3.max(reach / 2) || wide > values.len() {
                left += nalgebra::Matrix3::identity() * 1e-9;
                return left.cholesky().map_or(0.0, |c| c.solve(&right).x);
            }
            wide *= 2;
        }
    };
    (0..values.len()).map(at).collect()
}
