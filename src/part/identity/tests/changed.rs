//! The part itself changed: another tessellation, features moved, removed, added.

use super::*;

const SIZE: [f64; 3] = [100.0, 80.0, 12.0];

fn lost(found: &FoundAgain) -> Vec<(u32, LostReason)> {
    found.lost.iter().map(|l| (l.number, l.why)).collect()
}

#[test]
fn another_tessellation_is_the_same_part() {
    for (old, new) in [(32, 48), (32, 96), (96, 32), (20, 200), (48, 47)] {
        // Surfaces' facets stand together, so that backwards the numbers run backwards.
        let backwards: Triangles = bracket(new).into_iter().rev().collect();
        let found = sought_all(&bracket(old), &backwards, &[]);
        assert!(found.is_complete(), "{old} to {new}: {:?}", found.lost);
        assert_eq!(found.motion, None);
        assert_eq!(found.numbers, (1..=12).map(|n| (n, 13 - n)).collect());
    }
}

#[test]
fn a_hole_that_moved_is_lost_alone() {
    for by in [[2.0, 0.0], [0.0, -2.0], [1.5, 1.5]] {
        for moved in 0..4 {
            let mut features = bracket_features(48);
            features[moved].centre = [0, 1].map(|k| features[moved].centre[k] + by[k]);
            let found = sought_all(&bracket(48), &plate(SIZE, &features), &[]);
            let number = 7 + moved as u32;
            assert_eq!(lost(&found), [(number, LostReason::NothingAlike)]);
            assert_eq!(found.numbers, (1..=12).filter(|n| *n != number).map(|n| (n, n)).collect());
            assert_eq!((found.motion, found.scale), (None, None));
        }
    }
}

#[test]
fn a_hole_that_is_gone_is_lost_alone() {
    let mut features = bracket_features(48).to_vec();
    features.remove(0);
    let found = sought_all(&bracket(48), &plate(SIZE, &features), &[]);
    assert_eq!(lost(&found), [(7, LostReason::NothingAlike)]);
    assert_eq!(found.numbers, (1..=12).filter(|n| *n != 7).map(|n| (n, if n > 7 { n - 1 } else { n })).collect());
}

#[test]
fn a_new_boss_takes_nothing() {
    let mut features = vec![boss([80.0, 34.0], 12.0, 48, 5.0)];
    features.extend(bracket_features(48));
    let found = sought_all(&bracket(48), &plate(SIZE, &features), &[]);
    assert!(found.is_complete(), "{:?}", found.lost);
    assert_eq!(found.numbers, (1..=12).map(|n| (n, if n > 6 { n + 2 } else { n })).collect());
}

#[test]
fn a_hole_made_larger_is_another_hole() {
    for (diameter, kept) in [(20.0, true), (20.3, true), (20.5, false), (22.0, false)] {
        let mut features = bracket_features(48);
        features[3].diameter = diameter;
        let found = sought_all(&bracket(48), &plate(SIZE, &features), &[]);
        assert_eq!(found.numbers.contains_key(&10), kept, "{diameter}");
        assert_eq!(found.numbers.len(), 11 + usize::from(kept));
    }
}

#[test]
fn another_part_has_nothing_of_it() {
    let other = crate::sample::solids::cone(20.0, 30.0, 64);
    let found = sought_all(&bracket(48), &other, &[]);
    assert!(found.numbers.is_empty());
    assert!(found.lost.iter().all(|l| l.why == LostReason::NothingAlike));
    assert_eq!((found.motion, found.scale), (None, None));
}
