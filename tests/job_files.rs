//! Job files of version 1, which users have and their scripts write: they open, mean what they meant, and are the
//! same after they were saved.

use clearbeam::cell::Spin;
use clearbeam::document::{Chosen, FirstPlane, Job, JobError, Recipe, StartFrom, files};
use clearbeam::part::{Placement, SurfaceEdit, SurfaceId, Units, Weld};
use clearbeam::path::{Direction, Strategy};
use clearbeam::pose::tilt::TiltSide;
use clearbeam::pose::{Correction, Pin, Tilt, TiltRule};
use clearbeam::text::Sentence;
use std::path::{Path, PathBuf};

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/jobs").join(name)
}

/// What a file that says nothing means: the defaults of new jobs, but for welding and direction of before.
fn silent() -> Job {
    let mut job = Job::default();
    job.part.weld = Weld::Exact;
    job.layers.direction = Direction::AXES[2].1;
    job
}

/// Reads a job of version 1, and holds it against what it meant; saved, it is of version 2 and the same.
fn means(name: &str, meant: &Job) {
    let job = files::read(&file(name)).expect("opens");
    assert_eq!(job, *meant, "{name}");
    let folder = tempfile::tempdir().expect("a folder");
    let saved = folder.path().join(name);
    std::fs::write(&saved, files::to_toml(&job).expect("writes")).expect("writes");
    let text = std::fs::read_to_string(&saved).expect("reads");
    assert!(text.starts_with("version = 2\n"), "{text}");
    assert_eq!(files::read(&saved).expect("opens again"), job, "{text}");
    assert_eq!(toml::from_str::<Job>(&text).expect("reads"), job);
}

#[test]
fn every_list_of_surfaces_is_read() {
    let mut job = silent();
    job.part.file = "parts/gear.stl".into();
    job.part.sha256 = "0123456789abcdef".repeat(4);
    job.part.units = Units::Inch;
    job.part.flipped_shells = vec![2];
    job.part.placement = Placement { scale: 1.0, rotation_deg: [0.0, 0.0, 90.0], translation_mm: [10.0, 0.0, -2.5] };
    (job.surfaces.angle_deg, job.surfaces.min_area_mm2, job.surfaces.hysteresis_deg) = (25.0, 0.5, 10.0);
    job.layers.direction = Direction::Along([1.0, 0.5, 0.0]);
    job.layers.offset_mm = FirstPlane::FromLowest(0.25);
    (job.layers.strategy, job.layers.border) = (Strategy::Offset, Some(2));
    job.path.correction = Correction::Clearance;
    job.settings.choose([4, 1, 7]);
    let change = |job: &mut Job, n: u32, c: &dyn Fn(&mut clearbeam::document::SurfaceSettings)| {
        job.settings.change(SurfaceId(n), c);
    };
    change(&mut job, 1, &|s| {
        s.tilt.forbidden = vec![TiltSide::Lag];
        let tilt = Tilt { lead_deg: 1.0, lean_deg: 20.0 };
        s.pins = vec![Pin { line: 3, at_mm: 12.5, tilt }, Pin { line: 0, at_mm: 2.0, tilt: Tilt::default() }];
    });
    change(&mut job, 4, &|s| {
        s.name = "Dichtfläche".into();
        let preferred = Tilt { lead_deg: 3.0, lean_deg: -2.0 };
        s.tilt = TiltRule { preferred, least_deg: 5.0, forbidden: vec![TiltSide::Lead, TiltSide::Right] };
        s.pins = vec![Pin { line: 0, at_mm: 0.0, tilt: Tilt { lead_deg: -4.0, lean_deg: 0.0 } }];
    });
    change(&mut job, 3, &|s| s.flipped = true);
    change(&mut job, 7, &|s| s.flipped = true);
    change(&mut job, 9, &|s| s.later = true);
    change(&mut job, 12, &|s| (s.later, s.name) = (true, "Rim".into()));
    means("lists.toml", &job);
    // Put aside, 12 is in no order of work.
    assert_eq!(job.settings.chosen((1..13).map(SurfaceId)), [4, 1, 7].map(SurfaceId));
    assert_eq!(job.offset_start(SurfaceId(7)), Some(StartFrom::Border(2)));
}

#[test]
fn all_surfaces_after_edits_are_read() {
    let mut job = silent();
    job.part.file = "cube.stl".into();
    job.surfaces.edits = vec![
        SurfaceEdit::Merge { merge: vec![1, 2] },
        SurfaceEdit::Split { split: 3, angle_deg: 4.0 },
        SurfaceEdit::Cut { cut: 4, facets: vec![7, 9] },
    ];
    job.settings.choose(Chosen::All);
    job.settings.change(SurfaceId(8), |s| s.later = true);
    (job.cell.robot, job.cell.dialect, job.cell.spin) = ("irb1200".into(), "abb".into(), Spin::Travel);
    means("edits.toml", &job);
    assert_eq!(job.settings.chosen([6, 7, 8, 9].map(SurfaceId)), [6, 7, 9].map(SurfaceId));
}

#[test]
fn recipes_are_read() {
    let mut job = silent();
    job.part.file = "cube.stl".into();
    let values = [("layers.spacing_mm".to_owned(), 0.3), ("beam.power_w".to_owned(), 350.0)].into();
    let fine = Recipe { name: "Fine".into(), note: "sealing face".into(), values, ..Recipe::default() };
    job.recipes.push(Recipe { strategy: Some(Strategy::Adaptive), ..fine });
    job.recipes.push(Recipe {
        name: "Turn".into(),
        strategy: Some(Strategy::Spiral),
        centre_mm: Some([1.0, 2.0, 3.0]),
        inward: Some(true),
        border: Some(StartFrom::Whole),
        ..Recipe::default()
    });
    job.settings.choose([6, 2]);
    for (n, recipe) in [(2, "Fine"), (5, "Fine"), (6, "Turn")] {
        job.settings.change(SurfaceId(n), |s| s.recipe = Some(recipe.into()));
    }
    means("recipes.toml", &job);
    assert_eq!(job.check_recipes(), Ok(()));
    assert_eq!(job.of_surface(SurfaceId(5)).beam.power_w, 350.0);
}

#[test]
fn a_job_without_keys_is_the_default_one_with_planes_along_z() {
    let folder = tempfile::tempdir().expect("a folder");
    let empty = folder.path().join("empty.toml");
    std::fs::write(&empty, "").expect("writes");
    assert_eq!(files::read(&empty).expect("opens"), silent());
}

#[test]
fn starts_of_single_surfaces_are_kept() {
    let mut job = silent();
    job.settings.change(SurfaceId(3), |s| s.border = Some(StartFrom::Whole));
    job.settings
        .change(SurfaceId(1), |s| (s.border, s.centre_mm) = (Some(StartFrom::Border(4)), Some([1.0, 0.0, 2.5])));
    let text = files::to_toml(&job).expect("writes");
    let rows = "[[starts]]\nsurface = 1\nborder = 4\ncentre_mm = [1.0, 0.0, 2.5]\n\n\
                [[starts]]\nsurface = 3\nborder = \"whole\"\n";
    assert!(text.ends_with(rows), "{text}");
    assert_eq!(toml::from_str::<Job>(&text).expect("reads"), job);
}

#[test]
fn what_is_no_job_is_refused_with_file_key_reason_and_remedy() {
    let folder = tempfile::tempdir().expect("a folder");
    let bad = folder.path().join("bad.toml");
    let near = "[cell]\nbase_from_part = { three_points = { origin = [0, 0, 0], x = [1, 0, 0], xy = [0, 50, 0] } }\n";
    for (text, parts) in [
        (near, ["base_from_part", "x is 1.0 mm from origin", "measure x again"]),
        ("[clean]\nsurfaces = [4, 4]\n", ["clean.surfaces", "surface 4 is listed twice", "name it once"]),
        ("version = 7\n", ["version = 7", "made by a later clearbeam", "open it with a newer clearbeam"]),
        ("[recipe_of]\nfour = \"Fine\"\n", ["recipe_of", "\"four\" is not a surface number", "give a number"]),
        ("[clean]\nsurface = [4]\n", ["line 2", "clean.surface: there is no such key", "did you mean surfaces?"]),
    ] {
        std::fs::write(&bad, text).expect("writes");
        let refused = files::read(&bad).expect_err(text);
        assert!(matches!(refused, JobError::File(_) | JobError::NoJob { .. }));
        let said = refused.sentence();
        assert!(said.starts_with(&bad.display().to_string()) && said.lines().count() == 1, "{said}");
        assert!(parts.iter().all(|part| said.contains(part)), "{said}");
    }
}
