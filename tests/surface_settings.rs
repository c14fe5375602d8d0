//! What is said of a surface stays true of it, whatever becomes of its number: over another crease angle, merges,
//! splits and cuts; and laws of any sequence of edits.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::document::{
    Document, Edit, Job, LostSettings, Parameter, Recipe, RecutAnchor, StartFrom, SurfaceSettings, files, segmented,
};
use clearbeam::part::{Part, SurfaceId, Surfaces};
use clearbeam::pose::tilt::TiltSide;
use clearbeam::pose::{Pin, TiltRule};
use clearbeam::text::Sentence;
use parts::{part, sheet};
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::sync::Arc;

/// A strip of unit width whose flats are so long, each bent against the one before by so many degrees.
fn strip(flats: &[(f64, f64)]) -> Part {
    let (mut at, mut angle_deg) = ([0.0, 0.0], 0.0f64);
    let mut profile = vec![at];
    for (bend_deg, length_mm) in flats {
        angle_deg += bend_deg;
        let (sin, cos) = (libm::sin(angle_deg.to_radians()), libm::cos(angle_deg.to_radians()));
        at = [at[0] + length_mm * cos, at[1] + length_mm * sin];
        profile.push(at);
    }
    part(&sheet(&profile, 1.0))
}

/// Surfaces 1, 2, 3 at 20°; with 5° the second falls apart, and the third is number 4.
fn three() -> Part {
    strip(&[(0.0, 1.0), (30.0, 5.0), (10.0, 2.0), (30.0, 1.0)])
}

/// A document over a part, whose surfaces are looked up for each edit as the window does.
struct Desk {
    part: Part,
    doc: Document,
}

impl Desk {
    fn new(part: Part, change: impl FnOnce(&mut Job)) -> Desk {
        let mut job = Job::default();
        change(&mut job);
        Desk { part, doc: Document::new(job, None) }
    }

    fn surfaces(&self) -> Surfaces {
        segmented(&self.part, self.doc.job())
    }

    fn ids(&self) -> Vec<SurfaceId> {
        self.surfaces().ids().collect()
    }

    fn apply(&mut self, edit: &Edit) -> Vec<LostSettings> {
        let ids = self.ids();
        self.doc.apply(edit, &ids, None);
        self.doc.lost().to_vec()
    }

    fn anchor(&self) -> RecutAnchor {
        RecutAnchor { job: self.doc.job().clone(), surfaces: Arc::new(self.surfaces()) }
    }

    fn recut(&mut self, anchor: &RecutAnchor, angle_deg: f64) -> Vec<LostSettings> {
        let edit = Edit::recut(&self.part, anchor, angle(), angle_deg);
        self.apply(&edit)
    }

    fn of(&self, surface: u32) -> &SurfaceSettings {
        self.doc.job().settings.of(SurfaceId(surface))
    }
}

fn angle() -> &'static Parameter {
    Parameter::by_key("surfaces.angle_deg").expect("there")
}

fn set(job: &mut Job, surface: u32, change: impl Fn(&mut SurfaceSettings)) {
    job.settings.change(SurfaceId(surface), change);
}

fn forbidding(sides: &[TiltSide]) -> TiltRule {
    TiltRule { forbidden: sides.to_vec(), ..TiltRule::default() }
}

#[test]
fn parameters_that_recut_are_those_of_the_rule() {
    for p in clearbeam::document::PARAMETERS {
        let mut job = Job::default();
        job.set_number(p, p.limits.greatest);
        assert_eq!(p.recuts(), job.surfaces != Job::default().surfaces, "{}", p.key);
    }
}

#[test]
fn another_angle_keeps_what_is_said_on_its_surface() {
    let mut desk = Desk::new(three(), |job| {
        job.settings.choose([3, 2]);
        set(job, 3, |s| {
            (s.name, s.recipe, s.flipped) = ("Lip".into(), Some("Fine".into()), true);
            s.tilt = forbidding(&[TiltSide::Left]);
            s.centre_mm = Some([1.0, 2.0, 3.0]);
        });
        set(job, 1, |s| s.later = true);
    });
    assert_eq!(desk.ids(), [1, 2, 3].map(SurfaceId));
    let anchor = desk.anchor();
    let lip = desk.of(3).clone();
    assert_eq!(desk.recut(&anchor, 5.0), []);
    assert_eq!(desk.ids(), [1, 2, 3, 4].map(SurfaceId));
    assert_eq!(*desk.of(4), lip, "name, recipe, side, tilt, centre and place are where they were");
    assert_eq!((&desk.of(3).tilt, desk.of(3).name.as_str()), (&TiltRule::default(), ""), "and on no other surface");
    assert_eq!(desk.doc.job().settings.choice(), [4, 2, 3].into(), "both halves are cleaned");
    assert!(desk.of(1).later);
}

#[test]
fn a_drag_there_and_back_loses_nothing() {
    let mut desk = Desk::new(three(), |job| {
        set(job, 3, |s| (s.pins, s.border) = (vec![Pin::default(); 2], Some(StartFrom::Border(0))));
        set(job, 1, |s| s.pins = vec![Pin::default()]);
    });
    desk.apply(&Edit::Merge([1, 2].map(SurfaceId).to_vec()));
    assert!(desk.of(1).pins.is_empty(), "of other facets now");
    set_pins(&mut desk, 1);
    let (anchor, before) = (desk.anchor(), desk.doc.job().clone());
    let lost = desk.recut(&anchor, 60.0);
    let said: Vec<String> = lost.iter().map(LostSettings::sentence).collect();
    assert_eq!(
        said,
        ["1 pinned tilt of surface 1 was dropped", "2 pinned tilts and the border of surface 3 were dropped"]
    );
    assert_eq!(desk.ids(), [SurfaceId(1)]);
    assert!(desk.doc.job().surfaces.edits.is_empty());
    assert_eq!(desk.recut(&anchor, 20.0), []);
    assert_eq!(*desk.doc.job(), before, "merge and pins as well");
    // At 5° the third is the fourth, with the same facets.
    desk.recut(&anchor, 5.0);
    assert_eq!((desk.of(4).pins.len(), desk.of(4).border), (2, Some(StartFrom::Border(0))));
}

fn set_pins(desk: &mut Desk, surface: u32) {
    desk.apply(&Edit::Pins(SurfaceId(surface), vec![Pin::default()]));
}

#[test]
fn what_most_of_a_surface_was_counts_where_several_become_one() {
    // 1, 5 and 2 mm and 1 mm: the first and the middle one are 8 of 9, no recipe has more than half alone.
    let flats = [(0.0, 3.0), (30.0, 3.0), (30.0, 3.0)];
    let mut desk = Desk::new(strip(&flats), |job| {
        job.settings.choose([3, 1]);
        set(job, 1, |s| s.recipe = Some("A".into()));
        set(job, 3, |s| (s.recipe, s.flipped) = (Some("B".into()), true));
    });
    let anchor = desk.anchor();
    desk.recut(&anchor, 80.0);
    assert_eq!(desk.ids(), [SurfaceId(1)]);
    assert_eq!(*desk.of(1), SurfaceSettings { work: Some(0), ..SurfaceSettings::default() });
}

#[test]
fn a_merged_surface_forbids_what_any_of_them_did() {
    let mut desk = Desk::new(three(), |job| {
        job.settings.choose([3]);
        set(job, 1, |s| (s.later, s.recipe, s.tilt) = (true, Some("A".into()), forbidding(&[TiltSide::Right])));
        set(job, 2, |s| (s.recipe, s.tilt.least_deg) = (Some("B".into()), 9.0));
        set(job, 3, |s| (s.name, s.tilt, s.flipped) = ("Lip".into(), forbidding(&[TiltSide::Left]), true));
        set(job, 3, |s| s.pins = vec![Pin::default(); 2]);
    });
    let lost = desk.apply(&Edit::Merge([3, 1, 99].map(SurfaceId).to_vec()));
    assert_eq!(lost, [LostSettings { surface: SurfaceId(3), pins: 2, border: false }]);
    let merged = SurfaceSettings {
        name: "Lip".into(),
        recipe: Some("A".into()),
        work: Some(0),
        tilt: forbidding(&[TiltSide::Left, TiltSide::Right]),
        ..SurfaceSettings::default()
    };
    assert_eq!(*desk.of(1), merged);
    assert_eq!(*desk.of(3), SurfaceSettings::default(), "there is none of that number");
    assert_eq!(desk.of(2).tilt.least_deg, 9.0, "beside it nothing changes");
}

#[test]
fn pieces_are_worked_as_what_they_were_cut_off() {
    for cut in [false, true] {
        let mut desk = Desk::new(three(), |job| {
            job.settings.choose([2, 1]);
            set(job, 2, |s| {
                (s.name, s.recipe, s.flipped) = ("Mid".into(), Some("Fine".into()), true);
                (s.tilt, s.centre_mm) = (forbidding(&[TiltSide::Lag]), Some([0.0; 3]));
                (s.pins, s.border) = (vec![Pin::default()], Some(StartFrom::Whole));
            });
            set(job, 4, |s| s.name = "stray".into());
        });
        let (surfaces, job) = (desk.surfaces(), desk.doc.job().clone());
        let edit = match cut {
            true => Edit::cut(&surfaces, SurfaceId(2), &surfaces.get(2).expect("there").facets[..2]).expect("a cut"),
            false => Edit::split(&desk.part, &surfaces, &job, SurfaceId(2), 5.0),
        };
        assert_eq!(desk.apply(&edit), [LostSettings { surface: SurfaceId(2), pins: 1, border: true }]);
        assert_eq!(desk.ids(), [1, 2, 3, 4].map(SurfaceId));
        let piece = SurfaceSettings {
            recipe: Some("Fine".into()),
            flipped: true,
            tilt: forbidding(&[TiltSide::Lag]),
            ..SurfaceSettings::default()
        };
        assert_eq!(*desk.of(4), piece);
        let rest = SurfaceSettings { pins: Vec::new(), border: None, ..job.settings.of(SurfaceId(2)).clone() };
        assert_eq!(*desk.of(2), rest);
        // A split that finds nothing to split leaves all as it is.
        let none = Edit::split(&desk.part, &desk.surfaces(), desk.doc.job(), SurfaceId(1), 5.0);
        set_pins(&mut desk, 1);
        assert_eq!((desk.apply(&none), desk.of(1).pins.len()), (vec![], 1));
    }
}

#[test]
fn what_comes_back_is_not_chosen_by_that() {
    let mut desk = Desk::new(three(), |job| {
        job.settings.choose(clearbeam::document::Chosen::All);
        set(job, 2, |s| s.later = true);
    });
    desk.apply(&Edit::TakeBack(vec![SurfaceId(2)]));
    assert!(!desk.of(2).later);
    assert_eq!(desk.doc.job().settings.choice(), [1, 3].into());
    desk.apply(&Edit::Later { cuts: vec![], surfaces: vec![SurfaceId(3)] });
    assert_eq!(desk.doc.job().settings.choice(), [1].into());
    desk.apply(&Edit::Clean(vec![SurfaceId(3)]));
    assert_eq!(desk.doc.job().settings.choice(), [1, 3].into(), "chosen it comes back as well");
}

/// What an operator may do, in numbers that a part makes sense of.
#[derive(Clone, Debug)]
enum Deed {
    All,
    Clean(Vec<usize>),
    Unclean(usize),
    Shift(usize, i32),
    Merge(Vec<usize>),
    Split(usize, f64),
    Cut(usize, usize),
    Angle(f64),
    Later(usize),
    TakeBack(usize),
    Rename(usize, u8),
    Tilt(usize, TiltSide),
    Pin(usize),
    Border(usize, u32),
    Centre(usize),
    Flip(usize),
    Recipe(usize, u8),
}

fn deeds() -> impl Strategy<Value = Deed> {
    let one = || 0usize..12;
    let some = || prop::collection::vec(0usize..12, 1..4);
    let side = prop_oneof![Just(TiltSide::Lead), Just(TiltSide::Lag), Just(TiltSide::Left), Just(TiltSide::Right)];
    prop_oneof![
        Just(Deed::All),
        some().prop_map(Deed::Clean),
        one().prop_map(Deed::Unclean),
        (one(), prop_oneof![Just(-1), Just(1)]).prop_map(|(n, by)| Deed::Shift(n, by)),
        some().prop_map(Deed::Merge),
        (one(), 1.0..40.0f64).prop_map(|(n, deg)| Deed::Split(n, deg)),
        (one(), 1usize..6).prop_map(|(n, k)| Deed::Cut(n, k)),
        (1.0..70.0f64).prop_map(Deed::Angle),
        one().prop_map(Deed::Later),
        one().prop_map(Deed::TakeBack),
        (one(), 0u8..3).prop_map(|(n, k)| Deed::Rename(n, k)),
        (one(), side).prop_map(|(n, side)| Deed::Tilt(n, side)),
        one().prop_map(Deed::Pin),
        (one(), 0u32..3).prop_map(|(n, k)| Deed::Border(n, k)),
        one().prop_map(Deed::Centre),
        one().prop_map(Deed::Flip),
        (one(), 0u8..3).prop_map(|(n, k)| Deed::Recipe(n, k)),
    ]
}

/// The edit of a deed on the surfaces that are there now.
fn edit_of(deed: &Deed, desk: &Desk) -> Option<Edit> {
    let (surfaces, job) = (desk.surfaces(), desk.doc.job());
    let ids: Vec<SurfaceId> = surfaces.ids().collect();
    let id = |n: &usize| ids[n % ids.len()];
    let several = |list: &[usize]| list.iter().map(id).collect::<BTreeSet<_>>().into_iter().collect::<Vec<_>>();
    let recipe = |k: &u8| Box::new(Recipe { name: format!("R{k}"), ..Recipe::default() });
    Some(match deed {
        Deed::All => Edit::Reorder(ids),
        Deed::Clean(list) => Edit::Clean(several(list)),
        Deed::Unclean(n) => Edit::Unclean(vec![id(n)]),
        Deed::Shift(n, by) => Edit::Shift(vec![id(n)], *by),
        Deed::Merge(list) => Edit::Merge(several(list)),
        Deed::Split(n, deg) => Edit::split(&desk.part, &surfaces, job, id(n), *deg),
        Deed::Cut(n, count) => {
            let facets: Vec<u32> = surfaces.get(id(n).0)?.facets.iter().copied().take(*count).collect();
            Edit::cut(&surfaces, id(n), &facets)?
        }
        Deed::Angle(deg) => Edit::recut(&desk.part, &desk.anchor(), angle(), *deg),
        Deed::Later(n) => Edit::Later { cuts: Vec::new(), surfaces: vec![id(n)] },
        Deed::TakeBack(n) => Edit::TakeBack(vec![id(n)]),
        Deed::Rename(n, k) => Edit::Rename(id(n), "x".repeat(usize::from(*k))),
        Deed::Tilt(n, side) => Edit::Tilt(id(n), forbidding(&[*side])),
        Deed::Pin(n) => Edit::Pins(id(n), vec![Pin { line: 1, at_mm: 2.0, ..Pin::default() }]),
        Deed::Border(n, k) => Edit::SurfaceBorder(id(n), (*k > 0).then_some(StartFrom::Border(*k))),
        Deed::Centre(n) => Edit::SurfaceCentre(id(n), Some([1.0, 0.5, 0.25])),
        Deed::Flip(n) => Edit::FlipSurface(id(n)),
        Deed::Recipe(n, k) => Edit::GiveRecipe(vec![id(n)], (*k > 0).then(|| recipe(k))),
    })
}

/// What a surface may not do afterwards that it might not before, by facet.
fn forbidden(desk: &Desk) -> Vec<BTreeSet<TiltSide>> {
    let of = |n: &u32| desk.of(*n).tilt.forbidden.iter().copied().collect();
    desk.surfaces().of_facet.iter().map(of).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn any_edits_keep_the_laws(list in prop::collection::vec(deeds(), 1..30), all in any::<bool>()) {
        let flats = [(0.0, 2.0), (5.0, 1.0), (12.0, 3.0), (25.0, 1.0), (18.0, 2.0), (35.0, 1.5), (8.0, 1.0), (50.0, 2.0)];
        let mut desk = Desk::new(strip(&flats), |job| {
            if all {
                job.settings.choose(clearbeam::document::Chosen::All);
            }
        });
        let mut states = vec![desk.doc.job().clone()];
        for deed in &list {
            let Some(edit) = edit_of(deed, &desk) else { continue };
            let before = forbidden(&desk);
            let ids = desk.ids();
            if desk.doc.apply(&edit, &ids, None) {
                states.push(desk.doc.job().clone());
            }
            let (there, job) = (desk.ids(), desk.doc.job());
            prop_assert!(job.settings.iter().all(|(id, s)| there.contains(&id) && *s != SurfaceSettings::default()));
            let mut places: Vec<u32> = job.settings.iter().filter_map(|(_, s)| s.work).collect();
            places.sort_unstable();
            prop_assert!(places.iter().copied().eq(0..places.len() as u32));
            prop_assert!(job.settings.iter().all(|(_, s)| !s.later || s.work.is_none()));
            prop_assert!(!job.settings.cleans_all() || places.is_empty());
            // Reshaped surfaces forbid no less on any facet than before.
            if matches!(edit, Edit::Merge(_) | Edit::Split { .. } | Edit::Cut(_)) {
                prop_assert!(before.iter().zip(forbidden(&desk)).all(|(was, is)| was.is_subset(&is)));
            }
            let text = files::to_toml(job).expect("writes");
            prop_assert_eq!(&toml::from_str::<Job>(&text).expect("reads"), job);
        }
        for state in states.iter().rev() {
            prop_assert_eq!(desk.doc.job(), state);
            desk.doc.undo();
        }
    }
}
