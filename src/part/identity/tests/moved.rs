//! The file about another origin, turned, or in another unit.

use super::*;
use crate::sample::{SAMPLES, solids};
use proptest::prelude::*;

fn assert_moved(found: &FoundAgain, motion: &Isometry3<f64>, within_mm: f64) {
    assert!(found.is_complete(), "{found:?}");
    let told = found.motion.expect("it has moved");
    for corner in [[0.0; 3], [100.0, 0.0, 0.0], [0.0, 80.0, 12.0]].map(Point3::from) {
        let off = (told * corner - motion * corner).norm();
        assert!(off < within_mm, "{off} mm off");
    }
    assert!(found.numbers.iter().all(|(old, new)| old == new), "{:?}", found.numbers);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn a_shift_is_told(shift in prop::array::uniform3(-300.0..300.0f64)) {
        prop_assume!(shift.iter().any(|s| s.abs() > 5.0));
        let motion = Isometry3::translation(shift[0], shift[1], shift[2]);
        assert_moved(&sought_all(&bracket(48), &moved(&bracket(48), &motion), &[]), &motion, 1e-3);
    }

    #[test]
    fn a_turn_is_told(shift in prop::array::uniform3(-300.0..300.0f64), turn in prop::array::uniform3(-1.8..1.8f64)) {
        prop_assume!(turn.iter().any(|s| s.abs() > 0.2));
        let motion = Isometry3::new(shift.into(), turn.into());
        assert_moved(&sought_all(&bracket(48), &moved(&bracket(48), &motion), &[]), &motion, 1e-3);
    }
}

#[test]
fn a_move_in_another_tessellation_is_told_less_exactly() {
    let shift = Isometry3::translation(0.0, -120.0, 55.0);
    assert_moved(&sought_all(&bracket(32), &moved(&bracket(96), &shift), &[]), &shift, 0.05);
    let turn = Isometry3::new([10.0, 20.0, 30.0].into(), [0.0, 2.0, 1.0].into());
    assert_moved(&sought_all(&bracket(32), &moved(&bracket(96), &turn), &[]), &turn, 0.05);
}

#[test]
fn of_the_samples_only_the_one_without_symmetry_is_found_turned() {
    let motion = Isometry3::new([31.0, -8.0, 90.0].into(), [0.5, 1.2, -0.3].into());
    for sample in SAMPLES {
        let old = (sample.triangles)();
        let found = sought_all(&old, &moved(&old, &motion), &[]);
        if found.is_complete() {
            assert!(found.numbers.iter().all(|(old, new)| old == new), "{}", sample.name);
        }
        assert_eq!(found.is_complete(), found.motion.is_some());
        assert_eq!(sample.name == "workpiece", found.is_complete(), "the others are symmetric");
    }
}

#[test]
fn a_symmetric_part_that_was_turned_is_not_guessed() {
    // Turned by half about its middle it is the same.
    let features = [hole([20.0, 15.0], 8.0, 48), hole([80.0, 45.0], 8.0, 48)];
    let part = plate([100.0, 60.0, 10.0], &features);
    let turned = moved(&part, &Isometry3::new([5.0, 5.0, 0.0].into(), [0.0, 0.0, 0.6].into()));
    let found = sought_all(&part, &turned, &[]);
    assert!(found.numbers.is_empty() && found.motion.is_none());
    assert!(found.lost.iter().all(|l| l.why == LostReason::SeveralMotions), "{:?}", found.lost);
    // Neither is a single face of it, nor a cube.
    let found = sought(&part, &turned, &[], &BTreeSet::from([2]));
    assert_eq!(found.lost.iter().map(|l| l.why).collect::<Vec<_>>(), [LostReason::SeveralMotions]);
    let cube = solids::cube(30.0);
    let found = sought_all(&cube, &moved(&cube, &Isometry3::rotation([0.3, 0.4, 0.5].into())), &[]);
    assert!(found.numbers.is_empty() && found.motion.is_none());
    assert!(found.lost.iter().all(|l| l.why == LostReason::SeveralMotions), "{:?}", found.lost);
}

#[test]
fn a_symmetric_part_that_was_shifted_is_asked_about_as_shifted() {
    let cube = solids::cube(30.0);
    let motion = Isometry3::translation(100.0, 0.0, 0.0);
    assert_moved(&sought_all(&cube, &moved(&cube, &motion), &[]), &motion, 1e-4);
}

#[test]
fn one_odd_hole_tells_the_ends_of_a_part_apart() {
    let features = [hole([20.0, 30.0], 8.0, 48), hole([80.0, 30.0], 9.0, 48), hole([50.0, 20.0], 5.0, 48)];
    let part = plate([100.0, 60.0, 10.0], &features);
    let motion = Isometry3::new([5.0, 5.0, 0.0].into(), [0.0, 0.0, 3.0].into());
    assert_moved(&sought(&part, &moved(&part, &motion), &[], &BTreeSet::from([2])), &motion, 1e-3);
}

#[test]
fn a_row_of_holes_moved_by_one_pitch_is_not_found_in_place() {
    let features = [1.0, 2.0, 3.0, 4.0].map(|k| hole([20.0 * k, 15.0], 8.0, 48));
    let part = plate([100.0, 30.0, 10.0], &features);
    let motion = Isometry3::translation(20.0, 0.0, 0.0);
    // Where hole 8 was, there is hole 7 now.
    assert_moved(&sought(&part, &moved(&part, &motion), &[], &BTreeSet::from([8])), &motion, 1e-3);
}

#[test]
fn a_moved_part_with_something_missing_is_lost_whole() {
    let features = bracket_features(48);
    let new = moved(&plate([100.0, 80.0, 12.0], &features[1..]), &Isometry3::translation(67.0, 2.0, 0.0));
    let found = sought_all(&bracket(48), &new, &[]);
    assert!(found.numbers.is_empty() && found.motion.is_none());
    assert!(found.lost.iter().all(|l| l.why == LostReason::PartMoved));
}

#[test]
fn another_unit_is_told_as_a_scale() {
    for factor in [25.4, 0.001, 1.3] {
        let new: Triangles = bracket(48).iter().map(|t| t.map(|p| p.map(|x| x * factor))).collect();
        let found = sought_all(&bracket(32), &new, &[]);
        let scale = found.scale.expect("a scale");
        assert!((scale / factor - 1.0).abs() < 2e-3, "{scale} for {factor}");
        assert_eq!(scale == factor, factor != 1.3, "units are told exactly");
        assert_eq!((found.lost.len(), found.numbers.len(), found.motion), (12, 0, None));
    }
}
