//! Merges, splits and cuts are repeated over other facets.

use super::*;
use proptest::prelude::*;

/// Edits chosen by dice: of surfaces that exist, in the order in which they come to exist.
fn edits(part: &Part, dice: &[(u8, u32, u32)]) -> Vec<SurfaceEdit> {
    let mut made: Vec<SurfaceEdit> = Vec::new();
    for (kind, a, b) in dice {
        let now = surfaces(part, &made);
        let pick = |n: u32| &now.list[n as usize % now.list.len()];
        made.push(match kind % 3 {
            0 => SurfaceEdit::Merge { merge: vec![pick(*a).number, pick(*b).number] },
            1 => SurfaceEdit::Split { split: pick(*a).number, angle_deg: f64::from(b % 30) },
            _ => {
                let facets = &pick(*a).facets;
                let some = facets.iter().copied().filter(|f| f % (2 + b % 5) == 0).collect();
                SurfaceEdit::Cut { cut: pick(*a).number, facets: some }
            }
        });
    }
    made
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn edits_are_repeated_in_any_order_of_facets(
        seed in any::<u64>(),
        dice in prop::collection::vec((any::<u8>(), any::<u32>(), any::<u32>()), 1..6),
    ) {
        let old = bracket(24);
        let edits = edits(&loaded(&old, &AS_IS), &dice);
        let new = shuffled(&old, seed);
        let found = sought_all(&old, &new, &edits);
        let (was, is) = (facet_sets(&loaded(&old, &AS_IS), &edits), facet_sets(&loaded(&new, &AS_IS), &found.edits));
        // Facets of a cut that lie through each other are too much alike, and so is what is edited of them, and what comes
        // of an edit that is lost for that; but nothing is wrong.
        let whys: Vec<LostReason> =
            found.lost_edits.iter().map(|l| l.why).chain(found.lost.iter().map(|l| l.why)).collect();
        let follows = found.lost_edits.iter().any(|l| l.why == LostReason::SeveralAlike);
        let is_told = |why: &LostReason| {
            *why == LostReason::SeveralAlike || follows && *why == LostReason::EditNotRepeated
        };
        prop_assert!(whys.iter().all(is_told), "{:?}, {:?} of {edits:?}", found.lost_edits, found.lost);
        prop_assume!(found.lost_edits.is_empty());
        for (old, new) in &found.numbers {
            prop_assert_eq!(&is[new], &was[old], "surface {}", old);
        }
        prop_assert_eq!(was.len(), is.len());
    }
}

/// A merge of all sides, a cut of half of the boss, a split of the rest.
fn some_edits(part: &Part) -> Vec<SurfaceEdit> {
    let now = surfaces(part, &[]);
    let wall = &now.get(11).expect("the boss").facets;
    vec![
        SurfaceEdit::Merge { merge: vec![3, 4, 5, 6] },
        SurfaceEdit::Cut { cut: 11, facets: wall[..wall.len() / 2].to_vec() },
        SurfaceEdit::Merge { merge: vec![13, 12] },
    ]
}

#[test]
fn a_part_moved_with_its_facets_keeps_its_cuts() {
    let old = bracket(48);
    let edits = some_edits(&loaded(&old, &AS_IS));
    let motion = Isometry3::new([140.0, -33.0, 71.0].into(), [0.7, -1.1, 0.4].into());
    let new = shuffled(&moved(&old, &motion), 5);
    let found = sought_all(&old, &new, &edits);
    assert!(found.is_complete(), "{found:?}");
    let told = found.motion.expect("it has moved");
    let (was, is) = (surfaces(&loaded(&old, &AS_IS), &edits), surfaces(&loaded(&new, &AS_IS), &found.edits));
    for s in &was.list {
        let new = is.get(found.numbers[&s.number]).expect("it exists");
        assert_eq!(new.facets.len(), s.facets.len());
        assert!((new.area_mm2 - s.area_mm2).abs() < 1e-3);
    }
    let corner = Point3::new(100.0, 80.0, 12.0);
    assert!((told * corner - motion * corner).norm() < 1e-4);
}

#[test]
fn a_cut_is_lost_where_the_facets_are_others_and_all_that_came_of_it() {
    let old = bracket(48);
    let edits = some_edits(&loaded(&old, &AS_IS));
    let found = sought_all(&old, &bracket(96), &edits);
    assert_eq!(
        found.lost_edits,
        [LostEdit { index: 1, why: LostReason::OtherFacets }, LostEdit { index: 2, why: LostReason::EditNotRepeated }]
    );
    assert_eq!(found.edits, [SurfaceEdit::Merge { merge: vec![3, 4, 5, 6] }]);
    let lost: Vec<u32> = found.lost.iter().map(|l| l.number).collect();
    assert_eq!(lost, [11, 12]);
    assert!(found.lost.iter().all(|l| l.why == LostReason::EditNotRepeated));
    assert!([1, 2, 3, 7, 8, 9, 10].iter().all(|n| found.numbers[n] == *n));
    assert_eq!(found.motion, None);
}

#[test]
fn what_was_not_remembered_is_said_to_be_so() {
    let old = loaded(&bracket(48), &AS_IS);
    let landmarks = Landmarks::new(&old, &AS_IS, &RULE, &[], &BTreeSet::from([1]));
    let edits = [SurfaceEdit::Split { split: 7, angle_deg: 2.0 }];
    let found = look_for(&landmarks, &old, &AS_IS, &RULE, &edits, &BTreeSet::from([1, 99]));
    assert_eq!(found.lost_edits, [LostEdit { index: 0, why: LostReason::NotRemembered }]);
    assert_eq!(found.lost.iter().map(|l| (l.number, l.why)).collect::<Vec<_>>(), [(99, LostReason::NotRemembered)]);
}

#[test]
fn landmarks_that_make_no_sense_lose_surfaces_and_confuse_none() {
    let part = loaded(&bracket(48), &AS_IS);
    let edits = some_edits(&part);
    let needed = all(&part, &edits);
    let text = toml::to_string(&Landmarks::new(&part, &AS_IS, &RULE, &edits, &needed)).expect("written");
    for (what, with) in [
        ("grid = ", "grid = 0.0\n#"),
        ("grid = ", "grid = nan\n#"),
        ("diagonal = ", "diagonal = -inf\n#"),
        ("area = ", "area = 1e300\n#"),
        ("last_number = 12\n", "last_number = 4294967295\n"),
        ("last_number = 13\n", "last_number = 4294967295\n"),
        ("facets = \"", "facets = \"ä"),
    ] {
        let spoilt = text.replacen(what, with, 1);
        assert_ne!(spoilt, text, "{what}");
        let spoilt: Landmarks = toml::from_str(&spoilt).expect("still landmarks");
        let found = look_for(&spoilt, &part, &AS_IS, &RULE, &edits, &needed);
        assert!(found.numbers.iter().all(|(old, new)| old == new), "{what}: {:?}", found.numbers);
    }
    assert!(toml::from_str::<Landmarks>(&text.replacen("plane", "plain", 1)).is_err());
}
