//! What takes the last line, said by the first step that leaves none; and changes that were seen to give lines.

use super::*;
use crate::cell::Setup;
use crate::document::{Chosen, Recipe, segmented};
use crate::part::{Placement, Units};
use crate::planning::plan;
use crate::planning::report::{NothingReason, Notice, PlanFinding, Report, notices_worst_first};
use crate::sample::solids::{PlateFeature, plate};
use crate::sample::{Triangles, solids, stl_bytes};

struct Bare {
    part: Part,
    surfaces: Surfaces,
    job: Job,
    plan: Plan,
    report: Report,
}

fn made(triangles: &Triangles, job: Job) -> Bare {
    let part = Part::from_bytes(&stl_bytes(triangles), Units::Mm, &Placement::default(), &[]).expect("a part");
    let surfaces = segmented(&part, &job);
    let setup = Setup::shipped().expect("shipped");
    let plan = plan(&part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default()).expect("a plan");
    let report = Report::new(&plan, &surfaces);
    Bare { part, surfaces, job, plan, report }
}

impl Bare {
    fn causes(&self) -> Vec<(u32, TakenBy)> {
        self.plan.bare().map(|(surface, taken_by)| (surface.0, taken_by)).collect()
    }

    /// The changes that are offered, each of which is planned here and gives lines.
    fn cured(&self, triangles: &Triangles) -> Vec<LineChange> {
        let (cache, progress) = (PlanCache::default(), Progress::default());
        let found = cures(&self.part, &self.surfaces, &self.job, &self.plan, &cache, &progress).expect("not cancelled");
        for cure in &found {
            let mut job = self.job.clone();
            cure.edit.apply(&mut job, &[]);
            let again = made(triangles, job);
            let passes = |n: &SurfaceId| again.report.surfaces.iter().find(|s| s.surface == n.0).map(|s| s.passes);
            assert!(cure.surfaces.iter().all(|n| passes(n) > Some(0)), "{cure:?}");
        }
        found.into_iter().map(|cure| cure.change).collect()
    }
}

/// 40 × 30 × 20 mm; surface 2 is its top.
fn boxed() -> Triangles {
    plate([40.0, 30.0, 20.0], &[])
}

fn job(change: impl FnOnce(&mut Job)) -> Job {
    let mut job = Job::default();
    job.layers.spacing_mm = 2.5;
    job.settings.choose([2]);
    change(&mut job);
    job
}

#[test]
fn the_first_step_that_leaves_no_line_is_named_and_what_helps_was_tried() {
    let [x, y, z] = Direction::AXES.map(|(_, axis)| axis);
    let (inset_mm, shortest_mm) = (14.99, 50.0);
    for (changed, taken_by, cure) in [
        (job(|j| j.layers.direction = z), TakenBy::Direction, LineChange::Direction(y)),
        (job(|j| j.layers.inset_mm = inset_mm), TakenBy::Inset { inset_mm }, LineChange::Inset(13.0)),
        (job(|j| j.layers.shortest_mm = shortest_mm), TakenBy::Shortest { shortest_mm }, LineChange::Shortest(40.0)),
        // Lines of 30 mm are the first to be too short.
        (
            job(|j| (j.layers.direction, j.layers.shortest_mm) = (x, 30.5)),
            TakenBy::Shortest { shortest_mm: 30.5 },
            LineChange::Shortest(30.0),
        ),
    ] {
        let bare = made(&boxed(), changed);
        assert_eq!(bare.causes(), [(2, taken_by)]);
        assert_eq!(bare.cured(&boxed()), [cure]);
        assert!(matches!(
            &bare.report.findings[..],
            [PlanFinding::NothingPlanned { reason: NothingReason::NoLines { taken_by: Some(said), area_mm2, by } }]
                if *said == taken_by && *area_mm2 == 1200.0 && by.len() == 1
        ));
        assert_eq!(bare.report.missed_area_mm2, 1200.0, "all of it");
        assert!(!bare.report.is_complete());
        let told = notices_worst_first(&bare.report, &bare.job, &[]);
        assert!(
            matches!(told[..], [Notice::NothingPlanned(_), Notice::NoLines { surface: SurfaceId(2), .. }]),
            "{told:?}"
        );
    }
}

#[test]
fn holes_are_told_from_the_outline() {
    // A hole of 24 mm in a plate of 40: within 8 mm of the rim and the hole lies all of the top.
    let feature = PlateFeature { centre: [20.0, 20.0], diameter: 24.0, sides: 64, height: 0.0 };
    let holed = plate([40.0, 40.0, 5.0], &[feature]);
    let bare = made(&holed, job(|j| j.layers.inset_mm = 9.9));
    assert_eq!(bare.causes(), [(2, TakenBy::Holes { inset_mm: 9.9 })]);
    let cured = bare.cured(&holed);
    assert!(
        matches!(cured[..], [LineChange::IgnoredHoles(mm), LineChange::Inset(inset)] if mm > 24.0 && inset > 5.0),
        "{cured:?}"
    );
}

#[test]
fn strategies_name_their_own_reasons() {
    let ball = solids::sphere(10.0, 24, 12);
    let offset = |j: &mut Job| {
        j.layers.strategy = Strategy::Offset;
        j.settings.choose(Chosen::All);
    };
    let closed = made(&ball, job(offset));
    assert_eq!(closed.causes(), [(1, TakenBy::Border { borders: 0, border: None })]);
    assert_eq!(closed.cured(&ball), [LineChange::Strategy(Strategy::Planes)]);

    let bare = made(&boxed(), job(|j| (j.layers.strategy, j.layers.border) = (Strategy::Offset, Some(7))));
    assert_eq!(bare.causes(), [(2, TakenBy::Border { borders: 1, border: Some(7) })]);
    assert_eq!(bare.cured(&boxed()), [LineChange::WholeOutline]);
}

#[test]
fn surfaces_without_lines_beside_others_are_told_and_keep_those() {
    // With planes along z the ends of a cylinder have none; along x its wall would miss some of its area.
    let can = solids::cylinder(10.0, 20.0, 48);
    let all = |j: &mut Job| {
        j.settings.choose(Chosen::All);
        j.layers.direction = Direction::AXES[2].1;
    };
    let bare = made(&can, job(all));
    assert_eq!(bare.causes().iter().map(|c| c.1).collect::<Vec<_>>(), [TakenBy::Direction; 2]);
    assert!(bare.report.findings.is_empty(), "there is something to do");
    assert_eq!(bare.cured(&can), [LineChange::Direction(Direction::Auto)], "one change for both");
    let ends: f64 = bare.report.surfaces.iter().filter(|s| s.passes == 0).map(|s| s.area_mm2).sum();
    assert!((bare.report.missed_area_mm2 - ends).abs() < 1e-9);
    let told = notices_worst_first(&bare.report, &bare.job, &[]);
    assert_eq!(told.iter().filter(|n| matches!(n, Notice::NoLines { .. })).count(), 2);
    assert_eq!(told.len(), 2, "{told:?}");
}

#[test]
fn a_recipe_is_changed_where_the_value_is_its_own() {
    let values = [("layers.inset_mm".to_owned(), 14.99)].into();
    let recipe = Recipe { name: "Fine".into(), values, ..Recipe::default() };
    let mut job = job(|j| j.settings.choose([2, 3]));
    job.recipes.push(recipe.clone());
    job.settings.change(SurfaceId(2), |s| s.recipe = Some("Fine".into()));
    let bare = made(&boxed(), job);
    let (cache, progress) = (PlanCache::default(), Progress::default());
    let found = cures(&bare.part, &bare.surfaces, &bare.job, &bare.plan, &cache, &progress).expect("not cancelled");
    let changed = Recipe { values: [("layers.inset_mm".to_owned(), 13.0)].into(), ..recipe };
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].edit, Edit::Recipe(Box::new(changed), Vec::new()));
    progress.cancel();
    assert!(cures(&bare.part, &bare.surfaces, &bare.job, &bare.plan, &cache, &progress).is_err());
}

#[test]
fn numbers_are_rounded_to_two_digits() {
    for (value, rounded) in [(40.0, 40.0), (38.71, 38.0), (3.871, 3.8), (0.1239, 0.12), (0.3, 0.3), (1234.0, 1200.0)] {
        assert_eq!(rounded_down(value), rounded);
    }
    assert_eq!(greatest(9, |n| Ok(n <= 6)), Ok(Some(6)));
    assert_eq!(greatest(9, |_| Ok(true)), Ok(Some(9)));
    assert_eq!(greatest(0, |_| Ok(false)), Ok(None));
}
