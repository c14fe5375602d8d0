//! Cameras that are found from made-up poses with noise as it is measured, and poses that are refused.

use super::file::{self, HandEyeFileError};
use super::turns::rotation_of;
use super::*;
use crate::scan::made_up::Sequence;
use crate::scan::transform_file::rows;
use nalgebra::{Translation3, Unit, UnitQuaternion, Vector3};

/// Noise of target and robot: degrees and mm.
const TARGET: [f64; 2] = [0.1, 0.3];
const ROBOT: [f64; 2] = [0.02, 0.06];

fn any_turn(random: &mut Sequence) -> UnitQuaternion<f64> {
    UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(
        random.normal(),
        random.normal(),
        random.normal(),
        random.normal(),
    ))
}

fn any_vector(random: &mut Sequence, reach: f64) -> Vector3<f64> {
    Vector3::from_fn(|_, _| reach * (2.0 * random.uniform() - 1.0))
}

fn shaken(pose: Isometry3<f64>, [deg, mm]: [f64; 2], random: &mut Sequence) -> Isometry3<f64> {
    let turn = rotation_of(&(Vector3::from_fn(|_, _| random.normal()) * deg.to_radians()));
    let shift = pose.translation.vector + Vector3::from_fn(|_, _| random.normal()) * mm;
    Isometry3::from_parts(Translation3::from(shift), pose.rotation * turn)
}

/// Poses turned by up to `tilt_deg` about axes at will, or within `cone_deg` of one; and the camera behind them.
fn poses(
    place: CameraPlace,
    count: usize,
    tilt_deg: f64,
    cone_deg: Option<f64>,
    noise: f64,
    seed: u64,
) -> (Isometry3<f64>, Vec<HandEyePose>) {
    let random = &mut Sequence::new(seed);
    let frame = |reach: f64, random: &mut Sequence| {
        Isometry3::from_parts(Translation3::from(any_vector(random, reach)), any_turn(random))
    };
    let (x, y) = (frame(80.0, random), frame(600.0, random));
    let mut all = Vec::new();
    for _ in 0..count {
        let axis = match cone_deg {
            None => Vector3::from_fn(|_, _| random.normal()),
            Some(cone) => Vector3::z() + any_vector(random, 0.7 * libm::tan(cone.to_radians())),
        };
        let angle = (tilt_deg * (2.0 * random.uniform() - 1.0)).to_radians();
        let at = any_vector(random, 150.0) + Vector3::new(0.0, 0.0, 600.0);
        let turn = UnitQuaternion::from_axis_angle(&Unit::new_normalize(axis), angle);
        let g = Isometry3::from_parts(Translation3::from(at), turn);
        let c = x.inverse() * g.inverse() * y;
        let g = shaken(g, ROBOT.map(|n| n * noise), random);
        let camera_from_target = shaken(c, TARGET.map(|n| n * noise), random);
        let base_from_flange = if place == CameraPlace::Hand { g } else { g.inverse() };
        all.push(HandEyePose { base_from_flange, camera_from_target });
    }
    (x, all)
}

fn off_mm(found: &HandEye, camera: &Isometry3<f64>) -> f64 {
    (camera.inverse() * found.mount_from_camera).translation.vector.norm()
}

#[test]
fn poses_without_noise_tell_the_camera_exactly() {
    for place in [CameraPlace::Hand, CameraPlace::Fixed] {
        for seed in 0..10 {
            let (camera, poses) = poses(place, 4, 40.0, None, 0.0, seed);
            let found = solve(place, &poses).expect("a camera");
            assert!(off_mm(&found, &camera) < 1e-7 && found.is_of_few_poses());
            assert!(camera.rotation.angle_to(&found.mount_from_camera.rotation) < 1e-9);
            assert!(found.residuals.iter().all(|r| r.off_mm < 1e-7 && r.turned_deg < 1e-7));
        }
    }
}

#[test]
fn ten_poses_come_within_the_bound() {
    for place in [CameraPlace::Hand, CameraPlace::Fixed] {
        let mut offs: Vec<f64> = (0..200)
            .map(|seed| {
                let (camera, poses) = poses(place, 10, 40.0, None, 1.0, seed);
                off_mm(&solve(place, &poses).expect("a camera"), &camera)
            })
            .collect();
        offs.sort_by(f64::total_cmp);
        println!("{place:?}: median {:.3} mm, 90 % {:.3} mm, worst {:.3} mm", offs[100], offs[180], offs[199]);
        assert!(offs[179] < 1.6);
    }
}

/// The guess it begins with, and Park and Martin's alone, for comparison.
#[test]
fn all_poses_at_once_are_better_than_the_guess() {
    let (mut guess, mut refined) = (0.0, 0.0);
    for seed in 0..50 {
        let (camera, poses) = poses(CameraPlace::Hand, 10, 40.0, None, 1.0, seed);
        let pairs: Vec<_> = poses.iter().map(|p| [p.base_from_flange, p.camera_from_target]).collect();
        let begun = start::park_martin(&start::motions(&pairs)).expect("a guess");
        guess += (camera.inverse() * begun).translation.vector.norm() / 50.0;
        refined += off_mm(&solve(CameraPlace::Hand, &poses).expect("a camera"), &camera) / 50.0;
    }
    println!("guess {guess:.3} mm, refined {refined:.3} mm");
    assert!(refined < 0.8 * guess);
}

#[test]
fn poses_that_cannot_tell_are_refused() {
    for seed in 0..50 {
        let place = CameraPlace::Hand;
        for cone_deg in [0.0, 1.0, 2.0] {
            let (_, poses) = poses(place, 10, 40.0, Some(cone_deg), 1.0, seed);
            let refused = solve(place, &poses).expect_err("one axis");
            assert!(matches!(refused, HandEyeError::OneAxis { axis } if axis[2].abs() > 0.99), "{refused:?}");
        }
        let (_, poses) = poses(place, 10, 5.0, None, 1.0, seed);
        assert!(matches!(solve(place, &poses), Err(HandEyeError::SmallTurns { most_deg }) if most_deg < 15.0));
        assert_eq!(solve(place, &poses[..2]), Err(HandEyeError::FewPoses { count: 2 }));
    }
    let (_, mut poses) = poses(CameraPlace::Hand, 5, 40.0, None, 0.0, 1);
    poses[3].camera_from_target.translation.vector.x = f64::NAN;
    assert_eq!(solve(CameraPlace::Hand, &poses), Err(HandEyeError::NoFit));
}

#[test]
fn a_file_tells_poses_or_what_came_of_them() {
    let (camera, poses) = poses(CameraPlace::Hand, 6, 40.0, None, 0.0, 3);
    let flange = Isometry3::new(Vector3::new(400.0, 0.0, 700.0), Vector3::new(0.0, 3.0, 0.0));
    let at = format!("base_from_flange = {:?}\n", rows(&flange));
    let of_poses: String = poses
        .iter()
        .map(|p| {
            let (g, c) = (rows(&p.base_from_flange), rows(&p.camera_from_target));
            format!("[[pose]]\nbase_from_flange = {g:?}\ncamera_from_target = {c:?}\n")
        })
        .collect();
    let found = file::parse(&format!("camera = \"hand\"\n{at}{of_poses}"), "a.toml").expect("a camera");
    let base = found.base_from_camera.expect("the flange is known");
    assert!((base.to_homogeneous() - (flange * camera).to_homogeneous()).amax() < 1e-6);
    assert_eq!(found.calibration.expect("by poses").residuals.len(), 6);
    let nowhere = file::parse(&format!("camera = \"hand\"\n{of_poses}"), "a.toml").expect("a camera");
    assert_eq!(nowhere.base_from_camera, None);

    let stated = format!("flange_from_camera = {:?}\n", rows(&camera));
    let found = file::parse(&format!("{stated}{at}"), "a.toml").expect("a camera");
    assert!((found.base_from_camera.expect("stated").to_homogeneous() - base.to_homogeneous()).amax() < 1e-6);
    assert!(matches!(file::parse(&stated, "a.toml"), Err(HandEyeFileError::NoFlange { .. })));
    let fixed = format!("base_from_camera = {:?}\n", rows(&base));
    assert!(file::parse(&fixed, "a.toml").expect("a camera").base_from_camera.is_some());
    for text in ["", "camera = \"hand\"\n", &format!("{fixed}{stated}"), &format!("camera = \"hand\"\n{fixed}")] {
        assert!(matches!(file::parse(text, "a.toml"), Err(HandEyeFileError::Keys { .. })), "{text}");
    }
    let bent = fixed.replacen("base_from_camera = [", "base_from_camera = [2.0, 0.0, 0.0, 0.0, ", 1);
    assert!(matches!(file::parse(&bent, "a.toml"), Err(HandEyeFileError::Count { count: 20, .. })));
    let scaled = format!("base_from_camera = {:?}", rows(&base).map(|x| 2.0 * x));
    assert!(matches!(file::parse(&scaled, "a.toml"), Err(HandEyeFileError::Matrix { pose: None, .. })));
    let torn = file::parse("camera = \"head\"\n", "a.toml");
    assert!(matches!(torn, Err(HandEyeFileError::File(_))));
}
