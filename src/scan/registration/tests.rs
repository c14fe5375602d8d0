//! Scans of parts with known poses, laid on them again; what slides, what fits as well, what is refused.

use super::parts_for_tests::{off_mm, part_of, scan};
use super::*;
use crate::fit::PlacedPair;
use crate::sample::scan_maker::{ScanRecipe, SkinPoint};
use crate::sample::solids::{PlateFeature, cube, cylinder, plate};
use crate::scan::Cloud;
use nalgebra::Vector3;

fn feature(x: f64, y: f64, diameter: f64, height: f64) -> PlateFeature {
    PlateFeature { centre: [x, y], diameter, sides: 48, height }
}

/// A plate with a boss and a hole: nothing of it is symmetric.
fn bracket() -> Part {
    part_of(&plate([80.0, 50.0, 12.0], &[feature(20.0, 18.0, 24.0, 25.0), feature(60.0, 30.0, 10.0, 0.0)]))
}

fn laid(part: &Part, cloud: &Cloud, options: &RegistrationOptions) -> Result<Registration, RegistrationError> {
    register(part, &SurfaceNormals::at_usual_creases(part), cloud, options, &Progress::default())
}

/// A start that is off by a few degrees and millimetres.
fn near(part: &Part, truth: &Isometry3<f64>) -> Isometry3<f64> {
    let middle = part.mesh.bounds().0.coords;
    let off = Isometry3::new(Vector3::new(1.0, -0.8, 0.6), Vector3::new(0.03, -0.02, 0.02));
    Isometry3::translation(middle.x, middle.y, middle.z)
        * off
        * Isometry3::translation(-middle.x, -middle.y, -middle.z)
        * truth
}

#[test]
fn a_bracket_is_found_from_anywhere_and_any_number_of_threads_gives_the_same_bytes() {
    let part = bracket();
    let on = |threads: usize, cloud: &Cloud| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| laid(&part, cloud, &RegistrationOptions::default())).expect("found")
    };
    let (cloud, truth) = scan(&part, &ScanRecipe { missing_share: 0.4, ..ScanRecipe::of(20_000, 1) });
    let found = on(4, &cloud);
    let off = off_mm(&part, &found.model_from_scan, &truth);
    assert!(off < 0.01, "{off}");
    assert!(found.rivals.is_empty() && found.sliding.iter().all(|s| s.kind != SlidingKind::Slides));
    assert!(found.overlap > 0.98 && found.coverage > 0.45 && found.coverage < 0.8, "{}", found.coverage);
    assert!((found.sigma_mm / 0.03 - 1.0).abs() < 0.1, "{}", found.sigma_mm);
    assert_eq!(format!("{:?}", on(1, &cloud)), format!("{found:?}"));
}

#[test]
fn worn_material_does_not_pull_and_both_fits_are_kept() {
    let part = bracket();
    let worn = |at: &SkinPoint| {
        let off = (at.place - Point3::new(48.0, 25.0, 12.0)).norm() / 18.0;
        if at.normal.z > 0.9 && off < 1.0 { 0.4 * (1.0 - off * off) * (1.0 - off * off) } else { 0.0 }
    };
    let recipe = ScanRecipe { wear_mm: Some(&worn), missing_share: 0.0, ..ScanRecipe::of(60_000, 4) };
    let (cloud, truth) = scan(&part, &recipe);
    let options = RegistrationOptions { start: Start::From(near(&part, &truth)), ..RegistrationOptions::default() };
    let found = laid(&part, &cloud, &options).expect("found");
    let with = found.with_worn.expect("worn");
    let off = off_mm(&part, &found.model_from_scan, &truth);
    assert!(off < 0.005 && off < off_mm(&part, &with.model_from_scan, &truth), "{off} {with:?}");
    // The disc on which it is deeper than 3 σ: (1 − q²)² > 0.09 / 0.4, q < 0.725.
    let area: f64 = part.mesh.areas.iter().sum();
    let expected = std::f64::consts::PI * (18.0 * 0.725f64).powi(2) / area;
    assert!((with.share / expected - 1.0).abs() < 0.2, "{} {expected}", with.share);
}

#[test]
fn pairs_and_a_near_pose_lead_there_and_pairs_on_a_line_are_refused() {
    let part = bracket();
    let (cloud, truth) = scan(&part, &ScanRecipe::of(20_000, 9));
    let picked = |at: [f64; 3]| {
        let onto = Point3::from(at);
        PlacedPair { from: truth.inverse() * (onto + Vector3::new(0.7, -0.6, 0.5)), onto, weight: 1.0 }
    };
    let corners = [[0.0, 0.0, 0.0], [80.0, 0.0, 0.0], [80.0, 50.0, 12.0]].map(picked);
    for start in [Start::Pairs(corners.to_vec()), Start::From(near(&part, &truth))] {
        let found = laid(&part, &cloud, &RegistrationOptions { start, ..Default::default() }).expect("found");
        assert!(off_mm(&part, &found.model_from_scan, &truth) < 0.01);
    }
    for pairs in [corners[..2].to_vec(), [0.0, 30.0, 80.0].map(|x| picked([x, 0.3, 0.0])).to_vec()] {
        let count = pairs.len();
        let refused = laid(&part, &cloud, &RegistrationOptions { start: Start::Pairs(pairs), ..Default::default() });
        assert_eq!(refused, Err(RegistrationError::PairsTellNoMotion { pairs: count }));
    }
}

/// A part of which only some facets are scanned; what slides at the true pose.
fn sliding_on(part: &Part, scanned: impl Fn(&Vector3<f64>) -> bool) -> Vec<Sliding> {
    let of = |f: usize| part.mesh.corners(f).map(|p| [p.x, p.y, p.z]);
    let facets: Vec<[[f64; 3]; 3]> =
        (0..part.mesh.facets.len()).filter(|&f| scanned(&part.mesh.normals[f])).map(of).collect();
    let recipe = ScanRecipe { missing_share: 0.0, outlier_share: 0.0, ..ScanRecipe::of(20_000, 2) };
    let made = crate::sample::scan_maker::made_scan(&facets, &recipe);
    let options = RegistrationOptions { start: Start::From(made.model_from_scan), ..Default::default() };
    let found = laid(part, &Cloud::of_points(&made.points), &options).expect("found");
    // What slides stays where it was, and nothing else was off.
    let off = off_mm(part, &found.model_from_scan, &made.model_from_scan);
    assert!(off < 0.01, "{off} {found:?}");
    found.sliding.into_iter().filter(|s| s.kind == SlidingKind::Slides).collect()
}

#[test]
fn a_plane_slides_three_ways_a_cylinder_two_and_an_extrusion_one() {
    let is_along = |s: &Sliding, axis: Vector3<f64>| s.direction.cross(&axis).norm() < 1e-3;
    let plane = sliding_on(&part_of(&cube(40.0)), |n| n.z > 0.9);
    assert_eq!(plane.iter().filter(|s| s.motion == SlidingMotion::Shift).count(), 2);
    let turns: Vec<&Sliding> = plane.iter().filter(|s| s.motion == SlidingMotion::Turn).collect();
    assert!(plane.len() == 3 && turns.len() == 1 && is_along(turns[0], Vector3::z()), "{plane:?}");
    let round = sliding_on(&part_of(&cylinder(10.0, 50.0, 48)), |n| n.z.abs() < 0.1);
    assert!(round.len() == 2 && round.iter().all(|s| is_along(s, Vector3::z()) && s.slack_mm.is_none()), "{round:?}");
    assert!(round.iter().any(|s| s.motion == SlidingMotion::Shift));
    let turn = round.iter().find(|s| s.motion == SlidingMotion::Turn).expect("it turns");
    assert!(libm::hypot(turn.point.x, turn.point.y) < 0.05, "{turn:?}");
    let extruded =
        sliding_on(&part_of(&plate([40.0, 25.0, 30.0], &[feature(12.0, 11.0, 9.0, 0.0)])), |n| n.z.abs() < 0.1);
    assert!(extruded.len() == 1 && extruded[0].motion == SlidingMotion::Shift, "{extruded:?}");
    assert!(is_along(&extruded[0], Vector3::z()));
}

/// Two slots make a plate the same after three half turns; a hole on the middle line leaves one of them.
#[test]
fn what_fits_as_well_is_told_whether_it_is_the_same_and_if_not_by_which_patch() {
    let mark = Point3::new(40.0, 40.0, 6.0);
    let holes = [feature(15.0, 25.0, 12.0, 0.0), feature(65.0, 25.0, 12.0, 0.0), feature(mark.x, mark.y, 3.0, 0.0)];
    let part = part_of(&plate([80.0, 50.0, 12.0], &holes));
    let (cloud, truth) = scan(&part, &ScanRecipe { missing_share: 0.0, ..ScanRecipe::of(30_000, 6) });
    let found = laid(&part, &cloud, &RegistrationOptions::default()).expect("found");
    let (same, others): (Vec<&Rival>, Vec<&Rival>) = found.rivals.iter().partition(|r| r.same_by_symmetry);
    assert_eq!((same.len(), others.len()), (1, 2), "{found:?}");
    let right = [&found.model_from_scan, &same[0].model_from_scan];
    let off = right.iter().map(|pose| off_mm(&part, pose, &truth)).fold(f64::INFINITY, f64::min);
    assert!(off < 0.01 && same[0].telling.is_none(), "{off}");
    for rival in others {
        let patch = rival.telling.expect("the hole tells");
        assert!(patch.difference_mm > 0.0 && (patch.centre - mark).norm() < 5.0, "{patch:?}");
    }
}

#[test]
fn another_part_too_few_points_and_a_wish_to_end_are_told() {
    let part = bracket();
    let other = part_of(&plate([70.0, 60.0, 20.0], &[feature(40.0, 30.0, 30.0, 15.0)]));
    let (cloud, truth) = scan(&other, &ScanRecipe::of(20_000, 1));
    let refused = laid(&part, &cloud, &RegistrationOptions { start: Start::From(truth), ..Default::default() });
    assert!(matches!(refused, Err(RegistrationError::NotSamePart { .. })), "{refused:?}");
    let few = laid(&part, &cloud.picked(&[1, 2, 3]), &RegistrationOptions::default());
    assert_eq!(few, Err(RegistrationError::TooFewPoints { found: 3, needed: 100 }));
    let none = laid(&Part::default(), &cloud, &RegistrationOptions::default());
    assert_eq!(none, Err(RegistrationError::NoModel));
    for looks in [1, 3, 40] {
        let progress = Progress::ending_after(looks);
        let ended = register(&part, &SurfaceNormals::at_usual_creases(&part), &cloud, &Default::default(), &progress);
        assert_eq!(ended, Err(RegistrationError::Cancelled));
    }
}

#[test]
fn what_is_left_out_does_not_take_part() {
    let part = bracket();
    let (mut cloud, truth) = scan(&part, &ScanRecipe { missing_share: 0.0, ..ScanRecipe::of(20_000, 8) });
    // A clamp across the plate: a sheet of points 4 mm above it.
    let clamp: Vec<Point3<f64>> = (0..8000)
        .map(|i| truth.inverse() * Point3::new(40.0 + 0.2 * f64::from(i % 80), 0.5 * f64::from(i / 80), 16.0))
        .collect();
    let all: Vec<Point3<f64>> = cloud.points().chain(clamp).collect();
    cloud = Cloud::of_points(&all);
    let points: Vec<bool> = (0..all.len()).map(|i| i >= 20_000).collect();
    let facets = part.mesh.normals.iter().map(|n| n.x > 0.9).collect();
    let options = RegistrationOptions { start: Start::From(near(&part, &truth)), left_out: LeftOut { points, facets } };
    let found = laid(&part, &cloud, &options).expect("found");
    assert!(found.overlap > 0.98, "{}", found.overlap);
    assert!(off_mm(&part, &found.model_from_scan, &truth) < 0.01);
}
