use super::*;
use crate::weld::made_up::{self, Noise, Scene};

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

#[test]
fn a_bead_is_found_as_it_was_made() {
    for (name, scene) in [("coarse", Scene::coarse()), ("fine", Scene::fine())] {
        for noise_mm in [0.3, 1.0] {
            for seed in 0..10 {
                let points = scene.points(&Noise { seed, depth_mm: noise_mm });
                let mask = grey_mask(&scene);
                let begun = std::time::Instant::now();
                let bead = measure(&points, &mask, &mask, &scene.camera).expect("a bead");
                let took = begun.elapsed().as_secs_f64() * 1e3;
                let Errors { iou, centre_rms_mm, height_mm, parent_rms_mm, length_mm } = errors(&scene, &bead);
                println!(
                    "{name} {noise_mm} {seed}: iou {iou:.4} centre {centre_rms_mm:.3} height {height_mm:+.3} parent {parent_rms_mm:.3} length {length_mm:+.2} width {:.3} {took:.0} ms",
                    bead.width_mm
                );
            }
        }
    }
}
