//! Each step on clouds whose right answer is known.

use super::*;
use crate::scan::made_up::Sequence;
use nalgebra::{Point3, Vector3};
use proptest::prelude::*;

fn cleaned(cloud: &Cloud, steps: &[Step]) -> Cleaned {
    clean(cloud, steps, &Progress::default()).expect("nobody cancels")
}

/// A plate of 60 × 60 points, 0.5 mm apart.
fn plate() -> Vec<Point3<f64>> {
    (0..3600).map(|i| Point3::new(f64::from(i % 60) * 0.5, f64::from(i / 60) * 0.5, 0.0)).collect()
}

#[test]
fn points_in_the_air_are_outliers_and_those_of_the_plate_are_not() {
    let mut points = plate();
    let in_the_air: Vec<u32> = (0..36).map(|i| i * 97).collect();
    for (i, &at) in in_the_air.iter().enumerate() {
        points[at as usize] = Point3::new((i % 6) as f64 * 5.0, (i / 6) as f64 * 5.0, 8.0);
    }
    let found = cleaned(&Cloud::of_points(&points), &[Step::OUTLIERS]);
    let kept: Vec<u32> = (0..3600).filter(|i| !in_the_air.contains(i)).collect();
    assert_eq!(found.source, kept);
    assert_eq!(found.counts, [StepCount { before: 3600, after: 3564 }]);
    assert_eq!(found.cloud, Cloud::of_points(&points).picked(&kept));
}

/// On a line of equal steps all mean distances but those at the ends are the same: the limit is computed by hand.
#[test]
fn the_limit_is_the_mean_and_sigma_deviations() {
    let mut points: Vec<Point3<f64>> = (0..9).map(|i| Point3::new(f64::from(i), 0.0, 0.0)).collect();
    points.push(Point3::new(12.0, 0.0, 0.0));
    // One neighbour: nine distances of 1 and one of 4; mean 1.3, deviation √((9·0.09 + 7.29) / 9) = 0.9487.
    let cloud = Cloud::of_points(&points);
    let left = |sigma: f64| cleaned(&cloud, &[Step::Outliers { neighbours: 1, sigma }]).cloud.len();
    assert_eq!((left(2.84), left(2.85)), (9, 10));
    assert_eq!(left(f64::NAN), 10);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    /// One point for each voxel that has some, the mean of those in it; nothing gained or lost.
    #[test]
    fn thinning_keeps_the_mean_of_each_voxel(
        points in prop::collection::vec(prop::array::uniform3(0.0..4.0f64), 1..200),
        voxel_mm in 0.3..5.0f64,
    ) {
        let points: Vec<Point3<f64>> = points.into_iter().map(Point3::from).collect();
        let cloud = Cloud {
            intensities: Some((0..points.len()).map(|i| i as f32).collect()),
            ..Cloud::of_points(&points)
        };
        let side = |k: usize| cloud.offsets.iter().map(move |o| f64::from(o[k]));
        let lo = [0, 1, 2].map(|k| side(k).fold(f64::INFINITY, f64::min));
        let voxel = |i: usize| [0, 1, 2].map(|k| ((f64::from(cloud.offsets[i][k]) - lo[k]) / voxel_mm).floor() as i64);
        let mut groups: Vec<([i64; 3], Vec<usize>)> = Vec::new();
        for i in 0..points.len() {
            match groups.iter_mut().find(|g| g.0 == voxel(i)) {
                Some(g) => g.1.push(i),
                None => groups.push((voxel(i), vec![i])),
            }
        }
        let found = cleaned(&cloud, &[Step::Thin { voxel_mm }]);
        prop_assert_eq!(found.cloud.len(), groups.len());
        for (j, (_, members)) in groups.iter().enumerate() {
            let mean = members.iter().fold(Vector3::zeros(), |s, &i| s + cloud.point(i).coords) / members.len() as f64;
            prop_assert!((found.cloud.point(j).coords - mean).norm() < 1e-5);
            prop_assert_eq!(found.source[j] as usize, members[0]);
            let bright = members.iter().sum::<usize>() as f32 / members.len() as f32;
            prop_assert!((found.cloud.intensities.as_ref().expect("kept")[j] - bright).abs() < 1e-3);
        }
    }
}

#[test]
fn normals_and_colours_are_thinned_too() {
    let cloud = Cloud {
        normals: Some(vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]),
        colours: Some(vec![[0, 10, 255], [1, 20, 255], [7, 7, 7], [9, 9, 9]]),
        ..Cloud::of_points(&[[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [5.0, 0.0, 0.0], [5.1, 0.0, 0.0]].map(Point3::from))
    };
    let thin = cleaned(&cloud, &[Step::Thin { voxel_mm: 1.0 }]).cloud;
    let normals = thin.normals.expect("kept");
    let half = 0.5f32.sqrt();
    assert!((Vector3::from(normals[0]) - Vector3::new(half, half, 0.0)).norm() < 1e-6);
    assert_eq!(normals[1], [0.0, 0.0, 1.0]);
    assert_eq!(thin.colours.expect("kept"), [[1, 15, 255], [8, 8, 8]]);
}

#[test]
fn steps_without_sense_change_nothing() {
    let cloud = Cloud::of_points(&plate());
    for step in [
        Step::Thin { voxel_mm: 0.0 },
        Step::Thin { voxel_mm: f64::NAN },
        Step::Thin { voxel_mm: 1e-9 },
        Step::Smooth { radius_mm: -1.0, noise_mm: Some(0.1) },
        Step::Smooth { radius_mm: 1.0, noise_mm: Some(f64::NAN) },
        Step::Smooth { radius_mm: 1.0, noise_mm: None },
        Step::CutPlane { point: [0.0; 3], normal: [0.0; 3] },
        Step::Erase { centres: vec![], radius_mm: 1.0 },
        Step::Erase { centres: vec![[0.0; 3]], radius_mm: f64::NAN },
    ] {
        let found = cleaned(&cloud, std::slice::from_ref(&step));
        assert_eq!(found.cloud, cloud, "{step:?}");
    }
    let all = [Step::OUTLIERS, Step::Thin { voxel_mm: 1.0 }, Step::Smooth { radius_mm: 1.0, noise_mm: None }];
    assert_eq!(cleaned(&Cloud::default(), &all).cloud, Cloud::default());
}

#[test]
fn cuts_keep_their_side_and_survive_other_steps() {
    let cloud = Cloud::of_points(&plate());
    let half = Step::CutPlane { point: [10.2, 0.0, 0.0], normal: [-3.0, 0.0, 0.0] };
    let window = |keep| Step::CutBox { min: [0.0, 0.0, -1.0], max: [4.5, 4.5, 1.0], keep };
    let brush = Step::Erase { centres: vec![[0.0, 0.0, 0.0], [29.5, 29.5, 0.0]], radius_mm: 0.6 };
    let left = |steps: &[Step]| cleaned(&cloud, steps).source.len();
    assert_eq!(left(std::slice::from_ref(&half)), 21 * 60);
    assert_eq!(left(&[window(Keep::Inside)]), 100);
    assert_eq!(left(&[window(Keep::Outside)]), 3500);
    // Three points at each of two corners.
    assert_eq!(left(std::slice::from_ref(&brush)), 3594);
    let found = cleaned(&cloud, &[half, window(Keep::Outside), brush]);
    assert_eq!(found.counts.iter().map(|c| c.after).collect::<Vec<_>>(), [1260, 1160, 1160]);
    for (j, &i) in found.source.iter().enumerate() {
        assert_eq!(found.cloud.point(j), cloud.point(i as usize));
    }
}

/// Two faces that meet in a right angle along y: z = 0 for x < 0, x = 0 for z < 0; 20 points a mm².
fn right_angle(noise_mm: f64) -> Cloud {
    let mut sequence = Sequence::new(11);
    let mut place = |i: usize| {
        let (a, y, off) = (-10.0 * sequence.uniform(), 10.0 * sequence.uniform(), noise_mm * sequence.normal());
        if i.is_multiple_of(2) { Point3::new(a, y, off) } else { Point3::new(off, y, a) }
    };
    Cloud::of_points(&(0..4000).map(&mut place).collect::<Vec<_>>())
}

/// Distance of a point to the nearer one of the two faces.
fn off_faces(p: &Point3<f64>) -> f64 {
    let to = |along: f64, across: f64| libm::hypot(along.max(0.0), across);
    to(p.x, p.z).min(to(p.z, p.x))
}

/// Without noise an edge has nothing to be smoothed. No point moves more than 3 σ; a plane of least squares across the
/// edge would move those at the edge by radius · 4 / (3π√2) = 0.24 mm.
#[test]
fn smoothing_keeps_a_right_angle() {
    let sharp = right_angle(0.0);
    let moved = cleaned(&sharp, &[Step::Smooth { radius_mm: 0.8, noise_mm: Some(0.03) }]).cloud;
    let moves: Vec<f64> = sharp.points().zip(moved.points()).map(|(a, b)| (a - b).norm()).collect();
    assert!(moves.iter().all(|&m| m < 0.06), "{:?}", moves.iter().copied().fold(0.0, f64::max));
    assert!(moves.iter().sum::<f64>() / (moves.len() as f64) < 0.002);
}

/// The mean of n neighbours has a noise of σ/√n: 40 points lie within 0.8 mm on a face, 0.16 σ; at the edge less is
/// won.
#[test]
fn smoothing_takes_noise_off_both_faces_up_to_the_edge() {
    let (sharp, noisy) = (right_angle(0.0), right_angle(0.03));
    for noise_mm in [Some(0.03), None] {
        let moved = cleaned(&noisy, &[Step::Smooth { radius_mm: 0.8, noise_mm }]).cloud;
        for (from_mm, to_mm, left) in [(0.0, 0.3, 0.65), (0.3, 0.8, 0.4), (0.8, 3.0, 0.3), (3.0, 8.0, 0.25)] {
            let within = |i: &usize| (from_mm..to_mm).contains(&sharp.point(*i).coords.xz().norm());
            let squares = |cloud: &Cloud| -> f64 {
                (0..sharp.len()).filter(within).map(|i| off_faces(&cloud.point(i))).map(|d| d * d).sum()
            };
            let share = (squares(&moved) / squares(&noisy)).sqrt();
            assert!(share < left, "{from_mm} to {to_mm} mm from the edge {share} of the noise is left");
        }
    }
}

/// On a cylinder of radius R a plane's middle lies r²/8R inside: 0.008 mm at r = 0.8 mm, R = 10 mm. Put there by the
/// planes of all neighbours, points go in by less than a fifth of that.
#[test]
fn smoothing_does_not_shrink_a_cylinder() {
    let mut sequence = Sequence::new(3);
    let points: Vec<Point3<f64>> = (0..12_000)
        .map(|_| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * sequence.uniform());
            let r = 10.0 + 0.03 * sequence.normal();
            Point3::new(r * cos, r * sin, 10.0 * sequence.uniform())
        })
        .collect();
    let smooth = [Step::Smooth { radius_mm: 0.8, noise_mm: Some(0.03) }];
    let moved = cleaned(&Cloud::of_points(&points), &smooth).cloud;
    let off: Vec<f64> =
        moved.points().filter(|p| (1.0..9.0).contains(&p.z)).map(|p| p.coords.xy().norm() - 10.0).collect();
    let mean = off.iter().sum::<f64>() / off.len() as f64;
    assert!(mean.abs() < 0.2 * 0.8 * 0.8 / 80.0, "{mean}");
}

#[test]
fn steps_are_written_and_read_and_unknown_ones_refused() {
    let steps = vec![
        Step::OUTLIERS,
        Step::Thin { voxel_mm: 0.2 },
        Step::Smooth { radius_mm: 0.8, noise_mm: None },
        Step::CutBox { min: [0.0; 3], max: [1.0; 3], keep: Keep::Outside },
        Step::CutPlane { point: [0.0; 3], normal: [0.0, 0.0, 1.0] },
        Step::Erase { centres: vec![[1.0, 2.0, 3.0]], radius_mm: 2.0 },
    ];
    let text = serde_json::to_string(&steps).expect("plain data");
    assert!(text.contains(r#"{"step":"cut-box","min""#), "{text}");
    assert_eq!(serde_json::from_str::<Vec<Step>>(&text).expect("as written"), steps);
    for wrong in [r#"{"step":"thin","voxel_mm":1.0,"x":1}"#, r#"{"step":"thin"}"#, r#"{"step":"polish"}"#] {
        assert!(serde_json::from_str::<Step>(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let cloud = right_angle(0.03);
    let steps = [Step::OUTLIERS, Step::Thin { voxel_mm: 0.3 }, Step::Smooth { radius_mm: 0.8, noise_mm: None }];
    let digest = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| cleaned(&cloud, &steps).cloud.digest())
    };
    assert_eq!(digest(1), digest(3));
}

#[test]
fn the_work_ends_when_it_should() {
    let cloud = Cloud::of_points(&plate());
    for step in [Step::OUTLIERS, Step::Thin { voxel_mm: 1.0 }, Step::Smooth { radius_mm: 1.0, noise_mm: Some(0.1) }] {
        assert_eq!(clean(&cloud, &[step], &Progress::ending_after(3)).err(), Some(Cancelled));
    }
}
