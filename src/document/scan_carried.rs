//! What a scan says of places on its part, carried along when the part is put elsewhere: they are in the part frame.

use super::model::{JobScan, PatchChoice, ScanRegion};
use crate::part::Placement;
use crate::scan::transform_file::{rigid, rows};
use nalgebra::Point3;

/// Carries transform, pairs, regions and chosen patches from one placement of the part to another. A part that is made
/// larger or smaller is another model: the scan is laid on it anew.
pub(super) fn carry(scan: &mut JobScan, from: &Placement, to: &Placement) {
    if from == to {
        return;
    }
    let motion = to.isometry() * from.isometry().inverse();
    let is_rigid = from.scale == to.scale;
    let of_transform = scan.transform.filter(|_| is_rigid).and_then(|t| rigid(&t).ok());
    scan.transform = of_transform.map(|model_from_scan| rows(&(motion * model_from_scan)));
    let moved = |place: &mut [f64; 3]| {
        let on_file = from.isometry().inverse() * Point3::from(*place);
        *place = (to.isometry() * (on_file * (to.scale / from.scale))).coords.into();
    };
    scan.pairs.iter_mut().for_each(|pair| moved(&mut pair.model_mm));
    if let PatchChoice::At(places) = &mut scan.patches {
        places.iter_mut().for_each(&moved);
    }
    let of_damage = scan.continued.iter_mut().flat_map(|d| d.damaged.iter_mut().chain(&mut d.sound));
    for region in scan.left_out.iter_mut().chain(of_damage) {
        match region {
            ScanRegion::Sphere { centre_mm, radius_mm } => {
                moved(centre_mm);
                *radius_mm *= to.scale / from.scale;
            }
            ScanRegion::Box { min_mm, max_mm } => (*min_mm, *max_mm) = around(min_mm, max_mm, &moved),
        }
    }
}

/// The box around a box that was moved.
fn around(min_mm: &[f64; 3], max_mm: &[f64; 3], moved: &dyn Fn(&mut [f64; 3])) -> ([f64; 3], [f64; 3]) {
    let (mut lo, mut hi) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for corner in 0..8 {
        let mut at = [0, 1, 2].map(|k| if corner >> k & 1 == 0 { min_mm[k] } else { max_mm[k] });
        moved(&mut at);
        (lo, hi) = ([0, 1, 2].map(|k| lo[k].min(at[k])), [0, 1, 2].map(|k| hi[k].max(at[k])));
    }
    (lo, hi)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::model::PickedPair;

    fn placed(rotation_deg: [f64; 3], translation_mm: [f64; 3], scale: f64) -> Placement {
        Placement { scale, rotation_deg, translation_mm }
    }

    fn near(a: [f64; 3], b: [f64; 3]) -> bool {
        a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-9)
    }

    fn scan() -> JobScan {
        JobScan {
            transform: Some([1.0, 0.0, 0.0, 5.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]),
            pairs: vec![PickedPair { model_mm: [1.0, 2.0, 3.0], scan_mm: [4.0; 3] }],
            patches: PatchChoice::At(vec![[1.0, 2.0, 3.0]]),
            left_out: vec![
                ScanRegion::Sphere { centre_mm: [1.0, 2.0, 3.0], radius_mm: 2.0 },
                ScanRegion::Box { min_mm: [0.0; 3], max_mm: [1.0, 2.0, 3.0] },
            ],
            ..JobScan::default()
        }
    }

    #[test]
    fn places_go_with_the_part_and_so_does_the_scan() {
        let mut of = scan();
        carry(&mut of, &Placement::default(), &placed([0.0, 0.0, 90.0], [10.0, 0.0, 0.0], 1.0));
        let t = of.transform.expect("kept");
        assert!(near([t[3], t[7], t[11]], [10.0, 5.0, 0.0]) && near([t[0], t[1], t[4]], [0.0, -1.0, 1.0]), "{t:?}");
        assert!(near(of.pairs[0].model_mm, [8.0, 1.0, 3.0]) && of.pairs[0].scan_mm == [4.0; 3]);
        let ScanRegion::Sphere { centre_mm, radius_mm } = of.left_out[0] else { panic!("a ball") };
        assert!(near(centre_mm, [8.0, 1.0, 3.0]) && radius_mm == 2.0);
        let ScanRegion::Box { min_mm, max_mm } = of.left_out[1] else { panic!("a box") };
        assert!(near(min_mm, [8.0, 0.0, 0.0]) && near(max_mm, [10.0, 1.0, 3.0]), "{min_mm:?} {max_mm:?}");
        let back = placed([0.0, 0.0, 90.0], [10.0, 0.0, 0.0], 1.0);
        carry(&mut of, &back, &Placement::default());
        let PatchChoice::At(places) = &of.patches else { panic!("places") };
        assert!(near(places[0], [1.0, 2.0, 3.0]));
    }

    #[test]
    fn another_size_is_another_model() {
        let mut of = scan();
        carry(&mut of, &Placement::default(), &placed([0.0; 3], [0.0; 3], 2.0));
        assert_eq!(of.transform, None);
        assert!(near(of.pairs[0].model_mm, [2.0, 4.0, 6.0]));
        let ScanRegion::Sphere { radius_mm, .. } = of.left_out[0] else { panic!("a ball") };
        assert_eq!(radius_mm, 4.0);
    }
}
