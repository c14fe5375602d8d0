//! The parent surface on scenes by formula, and points that tell none.

use super::*;
use crate::weld::made_up::{Noise, Scene};
use proptest::prelude::*;

#[test]
fn the_surface_under_a_bead_is_found_from_both_sides() {
    for (scene, noise_mm) in
        [(Scene::coarse(), 0.3), (Scene::coarse(), 1.0), (Scene::fine(), 0.3), (Scene::fine(), 1.0)]
    {
        for seed in 0..3 {
            let points = scene.points(&Noise { seed, depth_mm: noise_mm });
            let surface = ParentSurface::fit(&points, &scene.mask, &scene.mask, 4.0).expect("a surface");
            let rms = scene.rms_under_bead_mm(&surface);
            assert!(rms < 0.05, "{rms} mm at {noise_mm}");
        }
    }
}

#[test]
fn what_cannot_be_fitted_is_told() {
    let scene = Scene::coarse();
    let points = scene.points(&Noise { seed: 1, depth_mm: 0.3 });
    let (width, height) = (scene.mask.width, scene.mask.height);
    let empty = Mask { width, height, values: vec![false; width * height] };
    assert_eq!(ParentSurface::fit(&points, &empty, &empty, 7.0), Err(ParentError::NothingCovered));
    assert_eq!(ParentSurface::fit(&[], &scene.mask, &scene.mask, 7.0), Err(ParentError::NothingCovered));
    let few: Vec<PixelPoint> = points.iter().filter(|p| p.pixel[1] % 40 == 0 && p.pixel[0] % 20 < 2).copied().collect();
    assert!(matches!(ParentSurface::fit(&few, &scene.mask, &scene.mask, 7.0), Err(ParentError::FewPoints { .. })));
    let above: Vec<PixelPoint> = points.iter().filter(|p| p.pixel[1] < 240).copied().collect();
    let one_side = ParentSurface::fit(&above, &scene.mask, &scene.mask, 7.0);
    assert!(matches!(one_side, Err(ParentError::OneSide { .. })), "{one_side:?}");
}

proptest! {
    /// A point put up along the normal comes back to where it was put up.
    #[test]
    fn a_foot_is_found_again(bends in prop::array::uniform10(-2.0..2.0f64), at in prop::array::uniform2(-40.0..40.0f64),
                             height in -5.0..15.0f64, turn in prop::array::uniform3(-1.0..1.0f64)) {
        let surface = ParentSurface {
            camera_from_local: Isometry3::new(Vector3::new(3.0, 8.0, 500.0), Vector3::from(turn)),
            rms_mm: 0.0, noise_mm: 0.0, points: 0, region_mm: [[-150.0, 150.0], [-60.0, 60.0]], cubic: Cubic::from(bends),
        };
        let up = surface.point_at(at) + surface.normal_at(at) * height;
        let foot = surface.foot(&up);
        prop_assert!(foot.is_converged);
        prop_assert!((foot.height_mm - height).abs() < 1e-7);
        prop_assert!((foot.foot - surface.point_at(at)).norm() < 1e-7);
        prop_assert!(libm::hypot(foot.local[0] - at[0], foot.local[1] - at[1]) < 1e-7);
    }
}
