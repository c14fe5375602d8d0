//! Lines through points of solids whose sections are known.

use super::{MeasuredRules, measured_lines};
use crate::document::{Job, segmented};
use crate::part::measured::MeasuredPoints;
use crate::part::{Part, Placement, Surfaces, Units};
use crate::path::{SurfacePlanes, TransversalLine};
use crate::progress::Progress;
use crate::sample::{Triangles, solids, stl_bytes};
use nalgebra::{Point3, Vector3};
use std::f64::consts::TAU;

const RULES: MeasuredRules = MeasuredRules { step_mm: 0.5, chord_mm: 0.01 };

fn made(triangles: &Triangles) -> (Part, Surfaces) {
    let part = Part::from_bytes(&stl_bytes(triangles), Units::Mm, &Placement::default(), &[]).expect("a part");
    let surfaces = segmented(&part, &Job::default());
    (part, surfaces)
}

fn measured(points: &[(Point3<f64>, Vector3<f64>)]) -> MeasuredPoints {
    let f = |v: Vector3<f64>| [v.x as f32, v.y as f32, v.z as f32];
    let offsets = points.iter().map(|(p, _)| f(p.coords)).collect();
    MeasuredPoints::new(Point3::origin(), offsets, points.iter().map(|(_, n)| f(*n)).collect())
}

fn facing(part: &Part, surfaces: &Surfaces, n: Vector3<f64>) -> u32 {
    let is = |f: &u32| (part.mesh.normals[*f as usize] - n).norm() < 1e-9;
    surfaces.list.iter().find(|s| s.facets.iter().all(is)).expect("a face").number
}

fn lines(
    (part, surfaces, number): (&Part, &Surfaces, u32),
    points: &MeasuredPoints,
    normal: Vector3<f64>,
    heights_mm: &[f64],
) -> Vec<TransversalLine> {
    let surface = surfaces.get(number).expect("there");
    let planes = SurfacePlanes { surface: number, normal, heights_mm: heights_mm.to_vec() };
    let of = (part, surfaces, surface);
    measured_lines(of, points, (&planes, 3), &RULES, &Progress::default()).expect("nobody cancels")
}

/// Points on a plane z = height over more than the face, every 0.2 mm, but for a hole about (7, 5) of radius 1.5 mm.
fn sheet(height: f64) -> Vec<(Point3<f64>, Vector3<f64>)> {
    let at = |i: i32| 0.2 * f64::from(i) - 0.93;
    let all = (0..60).flat_map(|i| (0..60).map(move |j| Point3::new(at(i), at(j), height)));
    all.filter(|p| (p - Point3::new(7.0, 5.0, height)).norm() > 1.5).map(|p| (p, Vector3::z())).collect()
}

#[test]
fn lines_of_a_face_follow_the_points_and_end_at_its_rim_and_where_nothing_was_scanned() {
    let (part, surfaces) = made(&solids::cube(10.0));
    let top = facing(&part, &surfaces, Vector3::z());
    // 0.15 mm below the model, as worn.
    let found = lines((&part, &surfaces, top), &measured(&sheet(9.85)), Vector3::y(), &[2.0, 5.0]);
    assert_eq!(found.iter().map(|l| l.plane).collect::<Vec<_>>(), [3, 4, 4], "planes count on");
    for line in &found {
        assert!(!line.closed);
        for q in &line.points {
            assert!((q.p.z - 9.85).abs() < 1e-4 && (q.n - Vector3::z()).norm() < 1e-3, "{q:?}");
        }
        // In the sense of (normal × plane's normal).
        let along = line.points[line.points.len() - 1].p - line.points[0].p;
        assert!(along.dot(&Vector3::z().cross(&Vector3::y())) > 0.0);
    }
    let ends = |line: &TransversalLine| {
        let x = line.points.iter().map(|q| q.p.x);
        (x.clone().fold(f64::INFINITY, f64::min), x.fold(f64::NEG_INFINITY, f64::max))
    };
    let (from, to) = ends(&found[0]);
    // At the rim the nearest facet changes over to the side's: 0.15 mm inwards.
    assert!((from - 0.15).abs() < 0.01 && (to - 9.85).abs() < 0.01, "{from} {to}");
    let mut pieces = [ends(&found[1]), ends(&found[2])];
    pieces.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert!((pieces[0].1 - 5.5).abs() < 0.25 && (pieces[1].0 - 8.5).abs() < 0.25, "{pieces:?}");
}

#[test]
fn a_section_round_a_cylinder_is_one_closed_line() {
    let (part, surfaces) = made(&solids::cylinder(8.0, 6.0, 96));
    let round = surfaces.list.iter().max_by_key(|s| s.facets.len()).expect("one").number;
    let on = |i: i32, k: i32| {
        let turn = TAU * (f64::from(i) + 0.5 * f64::from(k % 2)) / 250.0;
        let n = Vector3::new(libm::cos(turn), libm::sin(turn), 0.0);
        (Point3::from(n * 8.1) + Vector3::z() * (0.2 * f64::from(k)), n)
    };
    let points: Vec<_> = (0..31).flat_map(|k| (0..250).map(move |i| on(i, k))).collect();
    let found = lines((&part, &surfaces, round), &measured(&points), Vector3::z(), &[3.0]);
    let [line] = &found[..] else { panic!("{} lines", found.len()) };
    assert!(line.closed);
    for q in &line.points {
        assert!(((q.p.coords.xy()).norm() - 8.1).abs() < 0.005, "{}", q.p);
        assert!((q.n - Vector3::new(q.p.x, q.p.y, 0.0).normalize()).norm() < 0.02);
    }
}

#[test]
fn a_surface_that_is_worked_from_its_other_side_has_normals_there_and_no_points_no_lines() {
    let (part, mut surfaces) = made(&solids::cube(10.0));
    let top = facing(&part, &surfaces, Vector3::z());
    surfaces.normals.iter_mut().for_each(|n| *n = -*n);
    let found = lines((&part, &surfaces, top), &measured(&sheet(10.0)), Vector3::y(), &[2.0]);
    assert!(found[0].points.iter().all(|q| q.n.z < -0.99));
    assert!(lines((&part, &surfaces, top), &measured(&[]), Vector3::y(), &[2.0]).is_empty());
    // Points of a sheet far above are not the face's.
    assert!(lines((&part, &surfaces, top), &measured(&sheet(12.5)), Vector3::y(), &[2.0]).is_empty());
}
