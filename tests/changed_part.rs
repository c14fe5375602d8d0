//! The command line on a job whose part's file has changed: it goes on where all that is to be cleaned is found
//! again in its place, and stops with the list where not.

use clearbeam::document::{Document, Edit, Job, Remembered, files, segmented};
use clearbeam::part::{Part, Placement, SurfaceId, Units};
use clearbeam::sample::{Triangles, solids, stl_bytes};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn clearbeam(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_clearbeam")).args(arguments).output().expect("runs")
}

fn groove() -> Triangles {
    solids::v_groove(35.0, 8.0, 9.0, 40.0)
}

fn put(folder: &Path, triangles: &Triangles) {
    std::fs::write(folder.join("part.stl"), stl_bytes(triangles)).expect("writes");
}

/// A job on the groove's flank (surface 4) and a land (2), saved with what its surfaces look like.
fn job(folder: &Path) -> PathBuf {
    put(folder, &groove());
    let mut job = Job::default();
    job.part.file = "part.stl".into();
    job.layers.direction = clearbeam::path::Direction::Auto;
    job.layers.spacing_mm = 4.0;
    job.settings.choose([4, 2]);
    job.settings.change(SurfaceId(1), |s| s.name = "Floor".into());
    let part = Part::from_bytes(&stl_bytes(&groove()), Units::Mm, &Placement::default(), &[]).expect("a part");
    job.part.sha256.clone_from(&part.sha256);
    job.part.landmarks = Remembered::of(&job, &part, &job.part);
    let file = folder.join("job.toml");
    std::fs::write(&file, files::to_toml(&job).expect("text")).expect("writes");
    file
}

fn plan(job: &Path, out: &Path) -> (i32, String, serde_json::Value) {
    let output = clearbeam(&["plan", &job.display().to_string(), "--out", &out.display().to_string(), "--overwrite"]);
    let report = std::fs::read_to_string(out.join("report.json")).unwrap_or("null".into());
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    (output.status.code().expect("ends"), told, serde_json::from_str(&report).expect("JSON"))
}

/// Findings, but for what nobody has checked of cell and controller, which is no matter of the part.
fn of_job(report: &serde_json::Value) -> usize {
    let all = report["findings"].as_array().expect("a list");
    all.iter().filter(|f| !f["code"].as_str().is_some_and(|code| code.starts_with("unverified"))).count()
}

#[test]
fn another_order_of_facets_is_planned_and_told() {
    let (folder, out) = (tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder"));
    let file = job(folder.path());
    let (unchanged, told, before) = plan(&file, out.path());
    assert_eq!(of_job(&before), 0, "{told}");
    let mut facets = groove();
    facets.reverse();
    put(folder.path(), &facets);
    let (status, told, after) = plan(&file, out.path());
    assert_eq!((status, after["findings"][0]["code"].as_str()), (3, Some("part_changed")), "{told}");
    for key in ["passes", "work_mm", "blocked_mm"] {
        let value = |report: &serde_json::Value| report[key].as_f64().expect("a number");
        assert!((value(&before) - value(&after)).abs() < 1e-6, "{key}");
    }
    // What was exported is a job for the changed part, and nothing more is to be said of it.
    let again = out.path().join("job.toml");
    let exported = files::read(&again).expect("reads");
    assert_eq!(exported.settings.having(|s| s.name == "Floor").len(), 1);
    let (status, told, report) = plan(&again, out.path());
    assert_eq!((status, of_job(&report)), (unchanged, 0), "{told}");
}

#[test]
fn what_is_not_in_its_place_stops_with_the_list() {
    let (folder, out) = (tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder"));
    let file = job(folder.path());
    put(folder.path(), &solids::v_groove(20.0, 8.0, 9.0, 40.0));
    let (status, told, report) = plan(&file, out.path());
    assert_eq!(status, 1);
    assert!(told.contains("not found: surface 4") && told.lines().count() == 1, "{told}");
    assert!(report.is_null(), "nothing is written");
    // Moved as a whole: everything is there, and the operator has to say whether that was meant.
    let moved: Triangles = groove().into_iter().map(|t| t.map(|[x, y, z]| [x, y + 250.0, z])).collect();
    put(folder.path(), &moved);
    let (status, told, _) = plan(&file, out.path());
    assert_eq!(status, 1);
    assert!(told.contains("the whole part has moved by (0.000, 250.000, 0.000)"), "{told}");
}

#[test]
fn a_job_that_cleans_all_goes_on_where_all_is_found() {
    let (folder, out) = (tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder"));
    let file = job(folder.path());
    let mut all = files::read(&file).expect("reads");
    all.settings = Default::default();
    all.settings.choose(clearbeam::document::Chosen::All);
    let part = files::load_part(&all, Some(&file)).expect("loads");
    all.part.landmarks = Remembered::of(&all, &part, &all.part);
    std::fs::write(&file, files::to_toml(&all).expect("text")).expect("writes");
    let mut facets = groove();
    facets.reverse();
    put(folder.path(), &facets);
    let (status, told, report) = plan(&file, out.path());
    assert_eq!((status, report["findings"][0]["code"].as_str()), (3, Some("part_changed")), "{told}");
    put(folder.path(), &solids::v_groove(20.0, 8.0, 9.0, 40.0));
    let (status, told, _) = plan(&file, out.path());
    assert_eq!(status, 1);
    assert!(told.contains("not found: surface"), "{told}");
}

#[test]
fn verify_names_a_changed_part_first_and_render_refuses_it() {
    let (folder, out) = (tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder"));
    let file = job(folder.path());
    plan(&file, out.path());
    let mut facets = groove();
    facets.reverse();
    put(folder.path(), &facets);
    let program = out.path().join("MZ04-01-A.001");
    let told = clearbeam(&["verify", &program.display().to_string(), "--job", &file.display().to_string()]);
    assert_eq!(told.status.code(), Some(3), "it is compared all the same");
    let said = String::from_utf8_lossy(&told.stdout).into_owned();
    assert!(said.lines().next().is_some_and(|first| first.contains("part.stl")), "{said}");
}

#[test]
fn another_angle_by_an_option_keeps_what_the_job_says_of_surfaces() {
    let (folder, out) = (tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder"));
    let file = job(folder.path());
    let before = files::read(&file).expect("reads");
    let part = files::load_part(&before, Some(&file)).expect("loads");
    // At 60° flanks and lands are one surface each, so that numbers behind them are others.
    let [job_file, dir] = [&file, &out.path().to_path_buf()].map(|p| p.display().to_string());
    let output = clearbeam(&["plan", &job_file, "--out", &dir, "--angle", "60"]);
    assert!(output.status.code().is_some_and(|status| status == 0 || status == 3), "{output:?}");
    let after = files::read(&out.path().join("job.toml")).expect("reads");
    let floor_mm2 = |job: &Job| -> Vec<f64> {
        let surfaces = segmented(&part, job);
        job.settings
            .having(|s| s.name == "Floor")
            .iter()
            .map(|id| surfaces.get(id.0).expect("there").area_mm2)
            .collect()
    };
    assert_ne!(segmented(&part, &before).list.len(), segmented(&part, &after).list.len());
    assert_eq!(floor_mm2(&before), floor_mm2(&after));
    assert!(!after.settings.cleans_nothing());
}

#[test]
fn edits_are_repeated_on_the_changed_part() {
    let (folder, out) = (tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder"));
    let file = job(folder.path());
    let mut document = Document::new(files::read(&file).expect("reads"), None);
    let part = files::load_part(document.job(), Some(&file)).expect("loads");
    let all: Vec<SurfaceId> = segmented(&part, document.job()).ids().collect();
    document.apply(&Edit::Merge(vec![SurfaceId(2), SurfaceId(3)]), &all, None);
    let mut job = document.job().clone();
    job.part.landmarks = Remembered::of(&job, &part, &job.part);
    std::fs::write(&file, files::to_toml(&job).expect("text")).expect("writes");
    let (_, _, before) = plan(&file, out.path());
    let mut facets = groove();
    facets.rotate_left(9);
    put(folder.path(), &facets);
    let (status, told, after) = plan(&file, out.path());
    assert_eq!(status, 3, "{told}");
    let areas = |report: &serde_json::Value| -> Vec<f64> {
        let rows = report["surfaces"].as_array().expect("rows").iter();
        rows.map(|r| (r["area_mm2"].as_f64().expect("a number") * 1e6).round()).collect()
    };
    assert_eq!(areas(&before), areas(&after), "in the order of work");
}
