//! Slices of surfaces whose sections are closed forms, with noise and without; what is told of them, and how they end.

mod curves;
mod laws;

use super::*;
use crate::scan::made_up::Sequence;
use crate::scan::normals::fitted_normals;
use nalgebra::{Unit, Vector3};
use std::f64::consts::TAU;

pub(super) const RULES: SliceRules =
    SliceRules { step_mm: 1.0, chord_mm: 0.02, tolerance_mm: 0.01, outward: OutwardSide::OfNormals };

pub(super) fn plane(normal: [f64; 3], offset_mm: f64) -> SlicePlane {
    SlicePlane { normal: Unit::new_normalize(Vector3::from(normal)), offset_mm }
}

/// A cloud with its true normals for their sides alone.
pub(super) fn cloud(points: &[(Point3<f64>, Vector3<f64>)], noise_mm: f64) -> Cloud {
    let mut numbers = Sequence::new(7);
    let mut noise = || Vector3::from_fn(|_, _| numbers.normal()) * noise_mm;
    let places: Vec<Point3<f64>> = points.iter().map(|p| p.0 + noise()).collect();
    let normals = points.iter().map(|p| [p.1.x as f32, p.1.y as f32, p.1.z as f32]).collect();
    Cloud { normals: Some(normals), ..Cloud::of_points(&places) }
}

pub(super) fn cut(cloud: &Cloud, planes: &[SlicePlane], rules: &SliceRules) -> Vec<CloudSlice> {
    let progress = Progress::default();
    let neighbours = Neighbours::new(cloud, &progress).expect("nobody cancels");
    let normals = fitted_normals(cloud, &neighbours, 20, &progress).expect("nobody cancels");
    slices(cloud, &neighbours, &normals, planes, rules, &progress).expect("nobody cancels")
}

/// Points at random in a rectangle, brought onto a surface.
pub(super) fn made(
    count: usize,
    sides: [f64; 2],
    on: impl Fn(f64, f64) -> (Point3<f64>, Vector3<f64>),
) -> Vec<(Point3<f64>, Vector3<f64>)> {
    let mut numbers = Sequence::new(3);
    let mut at = |side: f64| side * numbers.uniform();
    (0..count).map(|_| (at(sides[0]), at(sides[1]))).map(|(u, v)| on(u, v)).collect()
}

/// A sphere about nought, evenly: equal heights have equal areas.
pub(super) fn sphere(radius_mm: f64, per_mm2: f64) -> Vec<(Point3<f64>, Vector3<f64>)> {
    let count = (2.0 * TAU * radius_mm * radius_mm * per_mm2) as usize;
    made(count, [TAU, 2.0], |turn, height| {
        let z = height - 1.0;
        let r = (1.0 - z * z).sqrt();
        let out = Vector3::new(r * libm::cos(turn), r * libm::sin(turn), z);
        (Point3::from(out * radius_mm), out)
    })
}

/// A cylinder about z, 40 mm long.
pub(super) fn cylinder(radius_mm: f64, per_mm2: f64) -> Vec<(Point3<f64>, Vector3<f64>)> {
    made((TAU * radius_mm * 40.0 * per_mm2) as usize, [TAU, 40.0], |turn, z| {
        let out = Vector3::new(libm::cos(turn), libm::sin(turn), 0.0);
        (Point3::from(out * radius_mm + Vector3::z() * z), out)
    })
}

/// Root of the mean square of what is told of each point of a curve.
pub(super) fn rms(curve: &SliceCurve, of: impl Fn(&SlicePoint) -> f64) -> f64 {
    (curve.points.iter().map(|p| of(p) * of(p)).sum::<f64>() / curve.points.len() as f64).sqrt()
}
