//! What the table of parameters says of a row is so in the rest of the program.

use clearbeam::document::model::ScanFile;
use clearbeam::document::parameter::Affects;
use clearbeam::document::{Job, PARAMETERS, Recipe};
use clearbeam::part::{Source, SurfaceId};
use clearbeam::planning::key::Keys;
use clearbeam::sample::{solids, stl_bytes};

fn keys(job: &Job) -> Keys {
    let source = Source::from_bytes(&stl_bytes(&solids::cube(10.0))).expect("a cube");
    Keys::new(&source, job, None, 0)
}

#[test]
fn another_value_makes_stale_what_its_row_says_and_nothing_before_it() {
    let mut scanned = Job::default();
    scanned.scan.files.push(ScanFile::default());
    let mut welded = scanned.clone();
    welded.weld.images.gray.file = "gray.png".into();
    for p in PARAMETERS {
        // How deep a tool may cut in holds the chord error, so in a weld that belongs to the setup.
        let mut job = if p.key.starts_with("weld.") { welded.clone() } else { scanned.clone() };
        let before = keys(&job);
        job.set_number(p, p.limits.greatest);
        let after = keys(&job);
        let affected = [
            (Affects::Part, before.part != after.part),
            (Affects::Surfaces, before.surfaces != after.surfaces),
            (Affects::Scan, before.scan != after.scan),
            (Affects::Weld, before.weld != after.weld),
            (Affects::Setup, before.setup != after.setup),
            (Affects::Plan, before.plan != after.plan),
            (Affects::Dose, before.dose != after.dose),
        ];
        let first = affected.iter().find(|a| a.1).map(|a| a.0);
        assert_eq!(first, Some(p.affects), "{}", p.key);
        assert!(before.dose != after.dose, "{}", p.key);
    }
}

#[test]
fn recipes_hold_what_single_surfaces_can_have() {
    for p in PARAMETERS {
        let values = [(p.key.to_owned(), p.limits.greatest)].into();
        let recipe = Recipe { name: "Own".into(), values, ..Recipe::default() };
        assert_eq!(recipe.check().is_ok(), p.is_for_recipes(), "{}", p.key);
        let mut job = Job::default();
        job.settings.change(SurfaceId(2), |s| s.recipe = Some("Own".into()));
        job.recipes.push(recipe);
        assert_eq!(job.of_surface(SurfaceId(2)).number(p), p.limits.greatest, "{}", p.key);
        assert_eq!(job.of_surface(SurfaceId(1)).number(p), p.default, "{}", p.key);
    }
}
