//! Masking as a whole, on the sample's images of known truth.

use super::*;
use crate::sample::weld_panel::{HEIGHT, NOISE_MM, WIDTH, WeldScene};
use crate::weld::raster::Raster;

fn raster<T>(values: Vec<T>) -> Raster<T> {
    Raster::new(WIDTH, HEIGHT, values).expect("whole")
}

fn grey(scene: &WeldScene, seed: u64) -> GreyImage {
    raster(scene.images(NOISE_MM, seed).0.into_iter().map(f32::from).collect())
}

/// From light alone, over ten seeds: the bead is a long area, the ground place a round one, and both are where they are.
#[test]
fn bead_and_ground_place_are_found_in_the_grey_image() {
    let scene = WeldScene::shared();
    let truths = [raster(scene.bead_mask()), raster(scene.ground_mask())];
    for seed in 0..10 {
        let masked = masked(&grey(scene, seed), &MaskRules::default(), &Progress::default()).expect("an image");
        let best = |truth: &Mask| {
            let overlaps = (0..masked.areas.list.len()).map(|k| (masked.areas.mask(&[k]).overlap(truth), k));
            overlaps.max_by(|a, b| a.0.total_cmp(&b.0)).expect("areas")
        };
        let [(bead, b), (ground, g)] = [0, 1].map(|k| best(&truths[k]));
        println!("{seed}: bead {bead:.3}, ground {ground:.3}, areas {:?}", masked.areas.list);
        assert!(bead >= 0.85 && ground >= 0.85, "{seed}: {bead} {ground}");
        assert!(b.max(g) == 1, "they are the first two of {:?}", masked.areas.list);
        let [bead, ground] = [b, g].map(|k| &masked.areas.list[k]);
        assert!(bead.aspect > 3.0 && ground.aspect < 1.5 && !bead.is_cut_off, "{bead:?} {ground:?}");
    }
}

#[test]
fn each_step_is_what_the_next_one_is_made_of() {
    let image = grey(WeldScene::shared(), 3);
    let progress = Progress::default();
    let stroke = BrushStroke { way_px: vec![[20.0, 20.0], [60.0, 30.0]], radius_px: 9.0, adds: true };
    let rules = MaskRules { painted: vec![stroke], threshold: Some(112.0), ..MaskRules::default() };
    let all = masked(&image, &rules, &progress).expect("an image");
    assert_eq!((all.threshold, &all.above_threshold), (112.0, &all.smoothed.map(|x| *x > 112.0)));
    assert_eq!(morphology::opened(&all.above_threshold, 5, &progress).as_ref(), Ok(&all.opened));
    assert_eq!(morphology::closed(&all.opened, 9, &progress).as_ref(), Ok(&all.closed));
    assert!(all.painted.at(40, 25) == Some(&true) && all.closed.at(40, 25) == Some(&false));
    let around = morphology::dilated(&all.areas.mask_of_all(), 9, &progress).expect("nobody cancels");
    assert!(all.edges.count() > 300);
    assert!(all.edges.values.iter().zip(&around.values).all(|(edge, near)| *near || !edge));
}

#[test]
fn images_without_sense_are_errors_or_have_no_areas() {
    let rules = MaskRules::default();
    let none = masked(&GreyImage::default(), &rules, &Progress::default());
    assert_eq!(none, Err(MaskError::NoImage { size: [0, 0], values: 0 }));
    let torn = GreyImage { width: 5, height: 5, values: vec![0.0; 24] };
    assert!(matches!(masked(&torn, &rules, &Progress::default()), Err(MaskError::NoImage { values: 24, .. })));
    for (width, height) in [(1, 1), (2, 700), (33, 9)] {
        for level in [0.0, 255.0, f32::NAN, f32::INFINITY] {
            let flat =
                masked(&GreyImage::filled(width, height, level), &rules, &Progress::default()).expect("an image");
            assert!(flat.areas.list.is_empty(), "{level}");
        }
    }
    let odd = MaskRules {
        even_light_px: u32::MAX,
        smoothing_px: 1e9,
        sigmas: f64::NAN,
        opening_px: 4000,
        closing_px: 4000,
        ..rules
    };
    assert!(masked(&GreyImage::filled(40, 30, 9.0), &odd, &Progress::default()).is_ok());
    let cancelled = Progress::default();
    cancelled.cancel();
    assert_eq!(masked(&GreyImage::filled(4, 4, 1.0), &MaskRules::default(), &cancelled), Err(MaskError::Cancelled));
}
