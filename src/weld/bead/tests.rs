//! Beads on a scene by formula, over seeds and noises: outline, centre line, heights; and what is refused.

use super::*;
use crate::weld::camera::DepthCamera;
use crate::weld::made_up::{self, Noise, Scene};
use crate::weld::parent::ParentError;
use crate::weld::passes::area_above_mm2;
use crate::weld::pixel_distance::dilated;
use crate::weld::points::PixelPoint;
use crate::weld::raster::Mask;

fn measure(
    points: &[PixelPoint],
    area: &Mask,
    covered: &Mask,
    camera: &DepthCamera,
) -> Result<WeldBead, WeldBeadError> {
    SeenArea::new(points, area, covered)?.measure(camera)
}

fn kind_of_area(points: &[PixelPoint], area: &Mask, covered: &Mask) -> Result<AreaKind, ParentError> {
    SeenArea::new(points, area, covered).map(|seen| seen.kind())
}

struct Errors {
    iou: f64,
    centre_rms_mm: f64,
    height_mm: f64,
    parent_rms_mm: f64,
    length_mm: f64,
}

/// A mask as grey gives it: off by some pixels.
fn grey_mask(scene: &Scene) -> Mask {
    dilated(&scene.mask, 2.0)
}

fn errors(scene: &Scene, bead: &WeldBead) -> Errors {
    let pairs = || bead.outline.values.iter().zip(&scene.mask.values);
    let iou = pairs().filter(|(a, b)| **a && **b).count() as f64 / pairs().filter(|(a, b)| **a || **b).count() as f64;
    let off = |s: &WeldSection| {
        let (x, y) = (s.centre.x, s.centre.y);
        let mut t = x;
        for _ in 0..8 {
            let (f, g) = (made_up::line_y(t), 0.2 * libm::cos(t / 60.0));
            t -= ((t - x) + (f - y) * g) / (1.0 + g * g);
        }
        (x - t) * (x - t) + (y - made_up::line_y(t)) * (y - made_up::line_y(t))
    };
    let centre_rms_mm = (bead.sections.iter().map(off).sum::<f64>() / bead.sections.len() as f64).sqrt();
    let highest = (-1300..1300).map(|i| made_up::profile(f64::from(i) * 0.1)).fold(0.0, f64::max);
    let length: f64 = (-1300..1300)
        .map(|i| {
            let (a, b) = (f64::from(i) * 0.1, f64::from(i + 1) * 0.1);
            let at = |t: f64| scene.in_camera(t, made_up::line_y(t), 0.0);
            (at(b) - at(a)).norm()
        })
        .sum();
    Errors {
        iou,
        centre_rms_mm,
        height_mm: bead.max_height_mm - highest,
        parent_rms_mm: scene.rms_under_bead_mm(&bead.parent),
        length_mm: bead.length_mm - length,
    }
}

/// Ten seeds at 0.3 and at 1 mm of noise. A bead of 29 pixels is held to what it has to be; one of 14 is narrower than
/// any that is asked for, and its centre line follows the noise at its ends.
#[test]
fn a_bead_is_found_as_it_was_made() {
    for (scene, centre_mm, seeds) in [(Scene::fine(), 0.15, 10), (Scene::coarse(), 0.25, 3)] {
        let mask = grey_mask(&scene);
        for noise_mm in [0.3, 1.0] {
            for seed in 0..seeds {
                let points = scene.points(&Noise { seed, depth_mm: noise_mm });
                let bead = measure(&points, &mask, &mask, &scene.camera).expect("a bead");
                let Errors { iou, centre_rms_mm, height_mm, parent_rms_mm, length_mm } = errors(&scene, &bead);
                println!(
                    "{noise_mm} mm, seed {seed}: IoU {iou:.4}, centre {centre_rms_mm:.3}, height {height_mm:+.3}, \
                     parent {parent_rms_mm:.3}, length {length_mm:+.2}, width {:.3}",
                    bead.width_mm
                );
                assert!(iou > 0.93 && centre_rms_mm < centre_mm && height_mm.abs() < 0.2 && parent_rms_mm < 0.05);
                assert!(length_mm.abs() < 0.01 * bead.length_mm && (bead.width_mm - made_up::BEAD_MM).abs() < 0.2);
            }
        }
    }
}

/// The same bytes on any number of threads.
#[test]
fn threads_change_nothing() {
    let scene = Scene::coarse();
    let (mask, points) = (grey_mask(&scene), scene.points(&Noise { seed: 5, depth_mm: 1.0 }));
    let by = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| measure(&points, &mask, &mask, &scene.camera)).expect("a bead")
    };
    assert!(by(1) == by(3));
}

#[test]
fn what_is_no_bead_or_not_all_of_one_is_told() {
    let scene = Scene::coarse();
    let points = scene.points(&Noise { seed: 1, depth_mm: 0.3 });
    let bead = grey_mask(&scene);
    let disc = |u: f64, v: f64, radius: f64| {
        let inside = |i: usize| {
            let (du, dv) = ((i % bead.width) as f64 - u, (i / bead.width) as f64 - v);
            du * du + dv * dv < radius * radius
        };
        Mask { values: (0..bead.values.len()).map(inside).collect(), ..bead.clone() }
    };
    let flat = disc(320.0, 330.0, 24.0);
    let both = Mask { values: bead.values.iter().zip(&flat.values).map(|(a, b)| *a || *b).collect(), ..bead.clone() };
    assert_eq!(kind_of_area(&points, &bead, &both), Ok(AreaKind::Bead));
    assert_eq!(kind_of_area(&points, &flat, &both), Ok(AreaKind::Flat));
    let none = measure(&points, &flat, &both, &scene.camera);
    assert!(matches!(none, Err(WeldBeadError::NothingStands { .. })), "{:?}", none.err());
    let torn = Mask { values: vec![true; 7], ..bead.clone() };
    let sizes = measure(&points, &torn, &torn, &scene.camera);
    assert!(matches!(sizes, Err(WeldBeadError::Parent(ParentError::Sizes { .. }))), "{:?}", sizes.err());
    // Depth may end before the image does.
    let cut: Vec<PixelPoint> = points.into_iter().filter(|p| p.pixel[0] < 400).collect();
    assert_eq!(measure(&cut, &bead, &bead, &scene.camera).err(), Some(WeldBeadError::LeavesImage));

    let leaving = Scene::leaving();
    let points = leaving.points(&Noise { seed: 1, depth_mm: 0.3 });
    let mask = grey_mask(&leaving);
    assert_eq!(measure(&points, &mask, &mask, &leaving.camera).err(), Some(WeldBeadError::LeavesImage));
}

/// Ground to a level, to the panel, and into it.
#[test]
fn what_is_left_is_measured_where_the_bead_was() {
    let fine = Scene::fine();
    let mask = grey_mask(&fine);
    let bead = measure(&fine.points(&Noise { seed: 2, depth_mm: 0.3 }), &mask, &mask, &fine.camera).expect("a bead");
    let left = |level_mm: f64| {
        let points = Scene::ground(level_mm).points(&Noise { seed: 3, depth_mm: 0.3 });
        bead.remaining(&points, &bead.outline).expect("a parent surface")
    };
    let same = left(f64::INFINITY);
    assert!((same.state.height_mm - bead.max_height_mm).abs() < 0.2 && same.sections.len() == bead.sections.len());
    let [five, none, into] = [5.0, 0.0, -0.5].map(|level| left(level).state);
    println!("{five:?} {none:?} {into:?}");
    assert!((five.height_mm - 5.0).abs() < 0.2 && five.below_mm < 0.1);
    assert!(none.height_mm < 0.2 && none.below_mm < 0.1);
    assert!(into.height_mm < 0.1 && (0.3..0.6).contains(&into.below_mm));
    // A cap's width above a level is w·√(1 − level / height); the line is a little longer than x.
    for level in [0.0f64, 2.0, 6.0] {
        let chord = |t: f64| made_up::BEAD_MM * (1.0 - level / made_up::profile(t)).max(0.0).sqrt();
        let along = |t: f64| libm::hypot(1.0, 0.2 * libm::cos(t / 60.0));
        let truth: f64 =
            (0..2600).map(|i| -130.0 + 0.1 * (f64::from(i) + 0.5)).map(|t| 0.1 * chord(t) * along(t)).sum();
        let found = area_above_mm2(&bead.sections, bead.length_mm, level);
        println!("{level}: {found:.0} mm² for {truth:.0}");
        assert!((found / truth - 1.0).abs() < 0.03);
    }
}

#[test]
fn heights_are_counted_in_bins() {
    let histogram = HeightHistogram::new([-0.2, 0.0, 0.4, 0.5, 1.2, f64::NAN, 1e9].into_iter(), 0.5);
    assert_eq!((histogram.from_mm, histogram.counts), (-0.5, vec![1, 2, 1, 1]));
    assert!(HeightHistogram::new(std::iter::empty(), 0.5).counts.is_empty());
}
