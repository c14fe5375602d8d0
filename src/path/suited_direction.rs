//! The direction of section planes that suits a surface, where the operator leaves it to the program.
//!
//! No facet may lie along the planes, where that can be helped: it would be missed. Of directions that are alike in
//! that, those are looked at that keep the spacing on the surface nearly as true as any does, and of them the one with
//! the fewest planes wins, which makes few long lines; of those alike in that as well the first: an axis of the file
//! before others. Axes of rotation and extrusion, and the narrowest way across a flat surface, are looked at always;
//! a grid of directions only where none of these does without missing facets or wide spacing.
//!
//! All is found from the surface and the axes of the file, so a part that its placement turns keeps its lines.

use super::live_facets::{PARALLEL_DEG, extent, live};
use super::narrowest::narrowest;
use crate::part::{Mesh, angle, surfaces::Surface};
use nalgebra::{Matrix3, Point3, Rotation3, SymmetricEigen, Vector3};
use std::collections::BTreeMap;

/// Beyond [`PARALLEL_DEG`]: facets of round bodies stand at whole degrees, and rounding must not decide which count.
const BESIDE_DEG: f64 = 0.1;
/// A share of the area that is none.
const NO_SHARE: f64 = 1e-9;
/// Where facets are missed whichever way planes run, so much more of the area counts as alike: the halves of a sphere
/// miss 1.5 % along every axis, but for the steps of their facets.
const ALIKE_SHARE: f64 = 0.01;
/// So many times the spacing on the truest are alike: 1.05 for lines along a trough of ±30° in place of arcs across
/// it, 1.19 for rings on a chamfer of 45° in place of a comb of short pieces; not 1.9 on a cone of 30°.
const ALIKE_STRETCH: f64 = 1.25;
/// So many times the planes of the fewest are alike: a polygon of 32 sides is 1.005 times as wide over corners as over
/// sides; a rectangle of 4 : 3 that is turned by 0.25° comes to 1.006.
const ALIKE_WIDTH: f64 = 1.005;
/// Normals that cancel out to less than this share of the area have no mean.
const MEAN_SHARE: f64 = 1e-3;
/// Eigenvalues nearer than this share of their sum have no axes of their own.
const EQUAL_SHARE: f64 = 1e-6;

/// How planes of one direction suit a surface.
struct Candidate {
    normal: Vector3<f64>,
    /// Share of the area that lies along the planes.
    missed: f64,
    /// Mean spacing on the surface, in spacings of the planes.
    stretch: f64,
    width_mm: f64,
}

/// The unit normal of the planes that suit a surface; `axes`: those of the file, in the frame of the mesh. `None`:
/// the surface has no proper facet.
pub(super) fn suited_direction(mesh: &Mesh, s: &Surface, axes: &Rotation3<f64>) -> Option<Vector3<f64>> {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| axes * axis);
    let mut directions = vec![z, x, y];
    directions.extend(own_axes(mesh, s));
    directions.extend(across(mesh, s, axes));
    let measure = |m: Vector3<f64>| measured(mesh, s, angle::unit(signed(m, axes))?);
    let candidates: Vec<Candidate> = directions.into_iter().filter_map(measure).collect();
    let own = best(&candidates)?;
    if own.missed > NO_SHARE || own.stretch > ALIKE_STRETCH {
        let odd = from_grid(mesh, s, axes).and_then(measure).filter(|odd| odd.is_clearly_better_than(own));
        return Some(odd.map_or(own.normal, |odd| odd.normal));
    }
    Some(own.normal)
}

impl Candidate {
    /// Whether it misses less, or keeps the spacing truer, by more than counts as alike.
    fn is_clearly_better_than(&self, other: &Candidate) -> bool {
        let is_truer = self.missed <= alike_missed(other.missed) && ALIKE_STRETCH * self.stretch < other.stretch;
        is_truer || alike_missed(self.missed) < other.missed
    }
}

fn best(all: &[Candidate]) -> Option<&Candidate> {
    let least =
        |of: &[&Candidate], value: fn(&Candidate) -> f64| of.iter().map(|c| value(c)).fold(f64::INFINITY, f64::min);
    let mut kept: Vec<&Candidate> = all.iter().collect();
    let missed = alike_missed(least(&kept, |c| c.missed));
    kept.retain(|c| c.missed <= missed);
    let stretch = ALIKE_STRETCH * least(&kept, |c| c.stretch);
    kept.retain(|c| c.stretch <= stretch);
    let width_mm = ALIKE_WIDTH * least(&kept, |c| c.width_mm);
    kept.into_iter().find(|c| c.width_mm <= width_mm)
}

/// Up to what share of the area directions miss as little as the one that misses least.
fn alike_missed(least: f64) -> f64 {
    if least <= NO_SHARE { NO_SHARE } else { least + ALIKE_SHARE }
}

fn measured(mesh: &Mesh, s: &Surface, normal: Vector3<f64>) -> Option<Candidate> {
    let facets = live(mesh, s).map(|f| (mesh.normals[f], mesh.areas[f]));
    let (missed, stretch) = shares(facets, &normal, PARALLEL_DEG + BESIDE_DEG);
    let (low, high) = extent(mesh, s, &normal)?;
    Some(Candidate { normal, missed, stretch, width_mm: high - low })
}

/// Of facets (normal and area) the share that lies within an angle along planes, and the mean spacing on them.
fn shares(facets: impl Iterator<Item = (Vector3<f64>, f64)>, m: &Vector3<f64>, within_deg: f64) -> (f64, f64) {
    let parallel_sine = libm::sin(within_deg.to_radians());
    let (mut missed, mut spacing, mut whole) = (0.0, 0.0, 0.0);
    for (normal, area) in facets {
        let sine = normal.cross(m).norm();
        whole += area;
        missed += if sine < parallel_sine { area } else { 0.0 };
        spacing += area / sine.max(parallel_sine);
    }
    let whole = f64::max(whole, 1e-300);
    (missed / whole, spacing / whole)
}

/// Axes that a surface has by its normals: of its rotation or extrusion, where there is one.
fn own_axes(mesh: &Mesh, s: &Surface) -> Vec<Vector3<f64>> {
    let spread = live(mesh, s).fold(Matrix3::zeros(), |sum: Matrix3<f64>, f| {
        sum + mesh.normals[f] * mesh.normals[f].transpose() * mesh.areas[f]
    });
    let eigen = SymmetricEigen::new(spread);
    let value = |k: usize| eigen.eigenvalues[k];
    let apart = EQUAL_SHARE * (value(0) + value(1) + value(2));
    let is_single = |k: &usize| (0..3).all(|other| other == *k || (value(other) - value(*k)).abs() > apart);
    let mut single: Vec<usize> = (0..3).filter(is_single).collect();
    single.sort_by(|a, b| value(*a).total_cmp(&value(*b)));
    single.into_iter().map(|k| eigen.eigenvectors.column(k).into_owned()).collect()
}

/// The narrowest way across a surface that has a mean normal.
fn across(mesh: &Mesh, s: &Surface, axes: &Rotation3<f64>) -> Option<Vector3<f64>> {
    let (sum, area) = live(mesh, s).fold((Vector3::zeros(), 0.0), |(n, area): (Vector3<f64>, f64), f| {
        (n + mesh.normals[f] * mesh.areas[f], area + mesh.areas[f])
    });
    let normal = angle::unit(axes.inverse() * sum).filter(|_| sum.norm() > MEAN_SHARE * area)?;
    let (u, v) = (angle::any_square_to(&normal), normal.cross(&angle::any_square_to(&normal)));
    let (u, v) = (axes * u, axes * v);
    let is_of_surface = |f: &&u32| s.facets.binary_search(f).is_ok();
    let mut rim: Vec<u32> = live(mesh, s)
        .flat_map(|f| mesh.facet_edges[f])
        .filter(|&e| mesh.edge_facets(e).iter().filter(is_of_surface).count() == 1)
        .flat_map(|e| mesh.edges[e as usize])
        .collect();
    rim.sort_unstable();
    rim.dedup();
    let flat = |&v_: &u32| {
        let p = mesh.vertices[v_ as usize].coords;
        [p.dot(&u), p.dot(&v)]
    };
    let [x, y] = narrowest(rim.iter().map(flat).collect())?;
    Some(u * x + v * y)
}

/// Directions of the grid, over half a sphere: some 7° apart.
const GRID: usize = 400;
/// A direction of the grid keeps so much more away from facets as normals of one bin differ.
const BIN_DEG: f64 = 2.5;
/// Steps of a bin in each coordinate of the normal.
const BINS: f64 = 16.0;
/// Corners by which the width of an odd surface is estimated, at most.
const CORNERS: usize = 2000;

/// The best direction of a grid that stands in the file's frame.
fn from_grid(mesh: &Mesh, s: &Surface, axes: &Rotation3<f64>) -> Option<Vector3<f64>> {
    let to_file = axes.inverse();
    let mut bins: BTreeMap<[i8; 3], (Vector3<f64>, f64)> = BTreeMap::new();
    for f in live(mesh, s) {
        let normal = to_file * mesh.normals[f];
        let bin = bins.entry([0, 1, 2].map(|k| (normal[k] * BINS).round() as i8)).or_default();
        *bin = (bin.0 + normal * mesh.areas[f], bin.1 + mesh.areas[f]);
    }
    let facets: Vec<(Vector3<f64>, f64)> =
        bins.into_values().filter_map(|(sum, area)| Some((angle::unit(sum)?, area))).collect();
    let count = live(mesh, s).count();
    let corners: Vec<Point3<f64>> =
        live(mesh, s).step_by(count.div_ceil(CORNERS).max(1)).map(|f| to_file * mesh.corners(f)[0]).collect();
    let measure = |normal: Vector3<f64>| {
        let (missed, stretch) = shares(facets.iter().copied(), &normal, PARALLEL_DEG + BIN_DEG);
        let heights = || corners.iter().map(|p| p.coords.dot(&normal));
        let width_mm = heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
        Candidate { normal, missed, stretch, width_mm }
    };
    let all: Vec<Candidate> = (0..GRID).map(|i| measure(on_half_sphere(i))).collect();
    best(&all).map(|c| axes * c.normal)
}

/// A direction of the Fibonacci grid over the half of the sphere above z = 0.
fn on_half_sphere(i: usize) -> Vector3<f64> {
    let golden = std::f64::consts::PI * (3.0 - f64::sqrt(5.0));
    let z = (i as f64 + 0.5) / GRID as f64;
    let (r, turn) = (f64::sqrt(1.0 - z * z), golden * i as f64);
    Vector3::new(r * libm::cos(turn), r * libm::sin(turn), z)
}

/// Of the two opposite directions the one whose largest component along the file's axes is positive; of components
/// alike the first.
fn signed(v: Vector3<f64>, axes: &Rotation3<f64>) -> Vector3<f64> {
    let in_file = axes.inverse() * v;
    let largest = in_file.amax() - 1e-6;
    let leading = in_file.iter().find(|c| c.abs() >= largest).copied().unwrap_or(1.0);
    if leading < 0.0 { -v } else { v }
}

#[cfg(test)]
#[path = "suited_direction_tests.rs"]
mod tests;
