//! The order of facets does not matter, nor unit, placement, flipped shells, or a stay in a file.

use super::super::segmentation::Segmentation;
use super::*;
use crate::sample::{SAMPLES, solids};
use proptest::prelude::*;

/// Every surface is found, in place, and holds the same triangles.
fn assert_same(old: &Triangles, new: &Triangles, edits: &[SurfaceEdit], found: &FoundAgain) {
    assert!(found.is_complete(), "{found:?}");
    assert_eq!((found.motion, found.scale), (None, None));
    let (old, new) = (facet_sets(&loaded(old, &AS_IS), edits), facet_sets(&loaded(new, &AS_IS), &found.edits));
    assert_eq!(found.numbers.len(), old.len());
    assert_eq!(old.len(), new.len());
    for (number, facets) in &old {
        assert_eq!(&new[&found.numbers[number]], facets, "surface {number}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_order_of_facets_gives_the_same_surfaces(seed in any::<u64>()) {
        let old = bracket(48);
        let new = shuffled(&old, seed);
        assert_same(&old, &new, &[], &sought_all(&old, &new, &[]));
    }

    #[test]
    fn fingerprints_do_not_depend_on_the_order(seed in any::<u64>()) {
        let old = solids::helical_gear(8, 4, 2, 1);
        let new = shuffled(&old, seed);
        let numbers = sought_all(&old, &new, &[]).numbers;
        let (old, new) = (loaded(&old, &AS_IS), loaded(&new, &AS_IS));
        let progress = Progress::default();
        let now = |p| Segmentation::new(p, &AS_IS, &RULE, &progress).expect("nobody ends it");
        let [old, new] = [now(&old), now(&new)];
        for (was, is) in &numbers {
            let (a, b) = (old.landmark(*was).expect("it exists").print, new.landmark(*is).expect("it exists").print);
            prop_assert_eq!((a.form, a.neighbours), (b.form, b.neighbours));
            let off = [a.area - b.area, a.size - b.size, a.neighbour_area - b.neighbour_area,
                       (a.centroid - b.centroid).norm(), (a.mean_normal - b.mean_normal).norm()];
            prop_assert!(off.iter().all(|d| d.abs() < 1e-6), "{:?}", off);
        }
        prop_assert_eq!(numbers.len(), old.largest_first().len());
    }
}

#[test]
fn every_sample_is_found_again_in_another_order() {
    for sample in SAMPLES {
        let old = (sample.triangles)();
        let new = shuffled(&old, 7);
        assert_same(&old, &new, &[], &sought_all(&old, &new, &[]));
    }
}

#[test]
fn unit_placement_and_a_stay_in_a_job_file_do_not_matter() {
    let old = bracket(48);
    let placement = Placement { scale: 1.7, rotation_deg: [20.0, -70.0, 110.0], translation_mm: [500.0, -20.0, 3.0] };
    let how = LoadedAs { units: Units::Inch, placement: &placement, flipped_shells: &[1] };
    let edits = [
        SurfaceEdit::Merge { merge: vec![3, 4] },
        SurfaceEdit::Cut { cut: 11, facets: facet_numbers(&old, 11, 20) },
        SurfaceEdit::Split { split: 3, angle_deg: 10.0 },
    ];
    let needed = all(&loaded(&old, &AS_IS), &edits);
    let landmarks = Landmarks::new(&loaded(&old, &how), &how, &RULE, &edits, &needed);
    let text = toml::to_string(&landmarks).expect("landmarks are written");
    let read: Landmarks = toml::from_str(&text).expect("and read");
    assert_eq!(toml::to_string(&read).expect("written again"), text);
    let new = shuffled(&old, 3);
    let found = look_for(&read, &loaded(&new, &AS_IS), &AS_IS, &RULE, &edits, &needed);
    // In the other direction too: the new part as an inch one.
    let plain = Landmarks::new(&loaded(&old, &AS_IS), &AS_IS, &RULE, &edits, &needed);
    assert_eq!(look_for(&plain, &loaded(&new, &how), &how, &RULE, &edits, &needed).numbers, found.numbers);
    let shells = FoundAgain { shells: BTreeMap::new(), ..found.clone() };
    assert_eq!(found.shells, BTreeMap::from([(1, 1)]));
    assert_same(&old, &new, &edits, &shells);
}

/// The first facets of a surface before any edit.
fn facet_numbers(triangles: &Triangles, surface: u32, count: usize) -> Vec<u32> {
    let part = loaded(triangles, &AS_IS);
    surfaces(&part, &[]).get(surface).expect("it exists").facets[..count].to_vec()
}

#[test]
fn flipped_shells_are_found_by_what_they_are() {
    let cube = solids::cube(20.0);
    let other = moved(&solids::cube(12.0), &Isometry3::translation(40.0, 0.0, 0.0));
    let (old, new) = ([cube.clone(), other.clone()].concat(), [other, cube].concat());
    let how = LoadedAs { flipped_shells: &[2], ..AS_IS };
    let needed = BTreeSet::from([1, 12]);
    let landmarks = Landmarks::new(&loaded(&old, &how), &how, &RULE, &[], &needed);
    // The new part may be read with the old numbers or none.
    for how in [how, AS_IS] {
        let found = look_for(&landmarks, &loaded(&new, &how), &how, &RULE, &[], &needed);
        assert!(found.is_complete());
        assert_eq!(found.shells, BTreeMap::from([(1, 2), (2, 1)]));
        assert_eq!(found.numbers[&1], 7);
    }
}

#[test]
fn what_lies_twice_in_one_place_is_not_chosen_from() {
    // Two sheets as good as on top of each other.
    let sheet = |z: f64| vec![[[0.0, 0.0, z], [30.0, 0.0, z], [0.0, 20.0, z]]];
    let old = [sheet(0.0), sheet(1e-6), sheet(5.0)].concat();
    let found = sought_all(&old, &shuffled(&old, 1), &[]);
    let lost: Vec<(u32, LostReason)> = found.lost.iter().map(|l| (l.number, l.why)).collect();
    assert_eq!(lost, [(1, LostReason::SeveralAlike), (2, LostReason::SeveralAlike)]);
    assert_eq!(found.numbers.len(), 1);
}
