//! Nothing that the operator did is lost in silence: parts that change, other windows that save, files that are
//! somebody else's, killed programs, and recipes that are removed.

mod common;

use clearbeam::app::{App, Purpose};
use clearbeam::document::{Document, Edit, Journal, files, save};
use clearbeam::part::SurfaceId;
use clearbeam::sample::{Triangles, solids, stl_bytes};
use common::glow_renderer::GlowTestRenderer;
use common::window::{Answers, click, press, reveal, settle, tab, window};
use eframe::egui::{self, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use std::path::{Path, PathBuf};

const JOB: &str = "[part]\nfile = \"part.stl\"\n[clean]\nsurfaces = [4, 2]\n[surfaces]\nnames = { 4 = \"Flank\" }\n\
                   [layers]\nspacing_mm = 4.0\ndirection = \"auto\"\n[[recipes]]\nname = \"Fine\"\n\
                   values = { \"layers.spacing_mm\" = 2.0 }\n[recipe_of]\n2 = \"Fine\"\n";

fn groove() -> Triangles {
    solids::v_groove(35.0, 8.0, 9.0, 40.0)
}

/// The same block, exported in another order of facets.
fn reordered() -> Triangles {
    let mut facets = groove();
    facets.reverse();
    facets.rotate_left(7);
    facets
}

fn put(folder: &Path, triangles: &Triangles) {
    std::fs::write(folder.join("part.stl"), stl_bytes(triangles)).expect("writes");
}

/// A job on the grooved block, saved by the window, so that it knows what its surfaces look like.
fn saved_job(folder: &Path) -> PathBuf {
    put(folder, &groove());
    let file = folder.join("job.toml");
    std::fs::write(&file, JOB).expect("writes");
    let mut h = window(Some(file.clone()), &Answers::default());
    h.state_mut().send(Edit::Set("beam.power_w", 450.0));
    press(&mut h, Modifiers::COMMAND, Key::S);
    assert!(!h.state().document().is_dirty());
    file
}

fn shows(h: &Harness<'_, App>, part: &str) -> bool {
    h.query_by_label_contains(part).is_some()
}

fn journalled(open: Option<PathBuf>, journal: &Path) -> Harness<'static, App> {
    let journal = journal.to_path_buf();
    let mut h = Harness::builder()
        .with_size(egui::vec2(1280.0, 800.0))
        .with_step_dt(1.0 / 60.0)
        .renderer(GlowTestRenderer::new())
        .build_eframe(move |cc| App::new(cc, Box::new(Answers::default()), open).with_journal(Some(journal)));
    settle(&mut h);
    h
}

#[test]
fn a_part_exported_anew_keeps_choices_names_and_recipes() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = saved_job(folder.path());
    let before = std::fs::read(&file).expect("reads");
    put(folder.path(), &reordered());
    let mut h = window(Some(file.clone()), &Answers::default());
    assert!(shows(&h, "The part's file has changed") && shows(&h, "was found again"));
    click(&mut h, "Use the changed part");
    let job = h.state().document().job().clone();
    assert!(h.state().document().is_dirty(), "nothing is saved by itself");
    assert_eq!(std::fs::read(&file).expect("reads"), before);
    let named = job.settings.having(|s| s.name == "Flank");
    let fine = job.settings.having(|s| s.recipe.as_deref() == Some("Fine"));
    assert_eq!((named.len(), fine.len()), (1, 1));
    assert_eq!(
        job.chosen(&clearbeam::document::segmented(&files::load_part(&job, Some(&file)).expect("loads"), &job)),
        [named[0].0, fine[0].0]
    );
    assert!(h.state().plan().is_some(), "and it is planned");
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert_eq!(h.state().document().job().settings.having(|s| s.name == "Flank"), [SurfaceId(4)]);
    assert!(h.state().plan().is_none(), "the old numbers are never planned on the new facets");
    assert!(h.state().why_no_plan().is_some_and(|why| why.contains("not the one")));
    press(&mut h, Modifiers::COMMAND, Key::Y);
    assert!(h.state().plan().is_some());
}

#[test]
fn a_part_that_changes_while_it_is_open_is_noticed() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = saved_job(folder.path());
    let mut h = window(Some(file), &Answers::default());
    h.state_mut().send(Edit::Rename(SurfaceId(2), "Land".into()));
    // Another length, so that the look at the file's size is enough whatever its clock shows.
    let mut other = reordered();
    other.push([[0.0, 0.0, 900.0], [0.0, 0.0, 900.0], [0.0, 0.0, 900.0]]);
    put(folder.path(), &other);
    press(&mut h, Modifiers::COMMAND, Key::R);
    assert!(shows(&h, "The part's file has changed"));
    click(&mut h, "Cancel");
    assert!(h.state().plan().is_some(), "the part in memory is worked on");
    press(&mut h, Modifiers::COMMAND, Key::R);
    assert!(!shows(&h, "The part's file has changed"), "once is enough");
}

#[test]
fn a_part_that_was_moved_is_looked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = saved_job(folder.path());
    std::fs::create_dir(folder.path().join("parts")).expect("makes");
    let moved = folder.path().join("parts/renamed.stl");
    std::fs::rename(folder.path().join("part.stl"), &moved).expect("moves");
    let answers = Answers::default();
    answers.0.lock().expect("no panic").push((Purpose::Part, moved));
    let mut h = window(Some(file), &answers);
    assert!(shows(&h, "The part is not there"));
    click(&mut h, "Choose another file…");
    let job = h.state().document().job();
    assert_eq!((job.part.file.as_str(), h.state().document().is_dirty()), ("parts/renamed.stl", true));
    assert!(h.state().plan().is_some() && !job.settings.cleans_nothing());
}

#[test]
fn what_is_not_found_again_is_told_before_anything_is_dropped() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = saved_job(folder.path());
    put(folder.path(), &solids::v_groove(20.0, 8.0, 9.0, 40.0));
    let before = std::fs::read(&file).expect("reads");
    let mut h = window(Some(file.clone()), &Answers::default());
    assert!(shows(&h, "not found: surface 4 (Flank)"), "by number and name");
    click(&mut h, "Cancel");
    assert!(h.state().surfaces().is_empty(), "nothing is opened");
    assert_eq!(std::fs::read(&file).expect("reads"), before);
}

#[test]
fn two_windows_on_one_job_do_not_overwrite_each_other_in_silence() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = saved_job(folder.path());
    let mut one = window(Some(file.clone()), &Answers::default());
    let mut two = window(Some(file.clone()), &Answers::default());
    one.state_mut().send(Edit::Set("beam.power_w", 300.0));
    press(&mut one, Modifiers::COMMAND, Key::S);
    two.state_mut().send(Edit::Set("beam.power_w", 200.0));
    press(&mut two, Modifiers::COMMAND, Key::S);
    assert!(shows(&two, "The job file has changed"));
    assert_eq!(files::read(&file).expect("reads").beam.power_w, 300.0);
    click(&mut two, "Overwrite");
    assert_eq!(files::read(&file).expect("reads").beam.power_w, 200.0);
    assert_eq!(files::read(&save::backup_of(&file)).expect("reads").beam.power_w, 300.0, "the save before is kept");
    one.state_mut().send(Edit::Set("beam.power_w", 100.0));
    press(&mut one, Modifiers::COMMAND, Key::S);
    click(&mut one, "Reload");
    assert_eq!((one.state().document().job().beam.power_w, one.state().document().is_dirty()), (200.0, false));
}

#[test]
fn an_export_never_replaces_what_is_not_its_own() {
    let (folder, out) = (tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder"));
    let file = saved_job(folder.path());
    let answers = Answers::default();
    answers.0.lock().expect("no panic").push((Purpose::Export, out.path().to_path_buf()));
    let mut h = window(Some(file), &answers);
    press(&mut h, Modifiers::COMMAND, Key::E);
    click(&mut h, "Export");
    let program = out.path().join("MZ04-01-A.001");
    let text = std::fs::read_to_string(&program).expect("exported");
    std::fs::write(&program, text.replace("R=10.0", "R=11.0")).expect("changed by hand");
    press(&mut h, Modifiers::COMMAND, Key::E);
    assert!(shows(&h, "MZ04-01-A.001 was changed by hand"));
    assert!(std::fs::read_to_string(&program).expect("there").contains("R=11.0"));
    click(&mut h, "Cancel");
    assert!(std::fs::read_to_string(&program).expect("there").contains("R=11.0"));
    press(&mut h, Modifiers::COMMAND, Key::E);
    click(&mut h, "Replace and export");
    assert_eq!(std::fs::read_to_string(&program).expect("there"), text);
}

#[test]
fn what_a_killed_program_left_is_offered_and_restored() {
    let (folder, journal) = (tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder"));
    let file = saved_job(folder.path());
    let mut h = journalled(Some(file.clone()), journal.path());
    h.state_mut().send(Edit::Set("beam.power_w", 123.0));
    settle(&mut h);
    // As a kill does: the window is gone without a word, and its locks with it.
    drop(h);
    let mut h = journalled(None, journal.path());
    assert!(shows(&h, "Unsaved changes were found") && shows(&h, "last edit just now"));
    click(&mut h, "Restore");
    assert_eq!(h.state().document().job().beam.power_w, 123.0);
    assert_eq!((h.state().document().file(), h.state().document().is_dirty()), (Some(file.as_path()), true));
    assert_eq!(h.state().document().undo_step(), Some(&clearbeam::document::UndoStep::Restored));
    assert!(h.state().plan().is_some());
    press(&mut h, Modifiers::COMMAND, Key::S);
    drop(h);
    let h = journalled(None, journal.path());
    assert!(!shows(&h, "Unsaved changes were found"), "what is saved is not offered");
}

#[test]
fn a_restored_job_on_a_changed_part_loses_nothing() {
    let (folder, journal) = (tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder"));
    let file = saved_job(folder.path());
    let (job, kept) = save::open(&file).expect("opens");
    let mut document = Document::new(job, Some(kept));
    document.apply(&Edit::Rename(SurfaceId(2), "Land".into()), &[], None);
    let mut left = Journal::open(Some(journal.path())).expect("a slot");
    left.record(&document).expect("kept");
    drop(left);
    put(folder.path(), &reordered());
    let mut h = journalled(None, journal.path());
    click(&mut h, "Restore");
    assert!(shows(&h, "The part's file has changed"));
    click(&mut h, "Use the changed part");
    let settings = &h.state().document().job().settings;
    assert_eq!((settings.having(|s| s.name == "Land").len(), settings.having(|s| s.name == "Flank").len()), (1, 1));
}

#[test]
fn surfaces_put_aside_are_seen_and_come_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = saved_job(folder.path());
    let mut h = window(Some(file), &Answers::default());
    h.state_mut().send(Edit::Later { cuts: Vec::new(), surfaces: vec![SurfaceId(2)] });
    settle(&mut h);
    assert!(shows(&h, "Later (1)") && shows(&h, "put aside: surface 2"));
    assert_eq!(h.state().document().job().settings.having(|s| s.work.is_some()), [SurfaceId(4)]);
    click(&mut h, "take surface 2 back");
    assert!(!shows(&h, "Later (1)"));
    h.state_mut().send(Edit::Later { cuts: Vec::new(), surfaces: vec![SurfaceId(2)] });
    settle(&mut h);
    click(&mut h, "clean surface 2 after all");
    assert_eq!(h.state().document().job().settings.having(|s| s.work.is_some()), [SurfaceId(2), SurfaceId(4)]);
}

#[test]
fn a_plan_with_nothing_to_do_is_called_that() {
    let (folder, out) = (tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder"));
    let file = saved_job(folder.path());
    let answers = Answers::default();
    answers.0.lock().expect("no panic").push((Purpose::Export, out.path().to_path_buf()));
    let mut h = window(Some(file), &answers);
    press(&mut h, Modifiers::COMMAND, Key::E);
    click(&mut h, "Export");
    assert!(out.path().join("MZ04-01-A.001").exists());
    h.state_mut().set("layers.shortest_mm", 1000.0);
    settle(&mut h);
    assert!(!shows(&h, "proven free"));
    assert!(shows(&h, "nothing to do: no line lies on the chosen surfaces"), "in the status line");
    assert!(
        shows(&h, "nothing to do, so there is no program: no line lies on the chosen surfaces"),
        "among the problems"
    );
    press(&mut h, Modifiers::COMMAND, Key::E);
    click(&mut h, "Export");
    assert!(!out.path().join("MZ04-01-A.001").exists(), "the program of yesterday is gone");
    assert!(std::fs::read_to_string(out.path().join("report.json")).expect("there").contains("nothing_planned"));
}

#[test]
fn corners_are_joined_otherwise_with_what_is_said_of_surfaces_and_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut cube = solids::cube(10.0);
    // One facet lies a rounding off its neighbours.
    cube[0] = cube[0].map(|p| p.map(|x| f64::from((x as f32).next_up())));
    put(folder.path(), &cube);
    let file = folder.path().join("job.toml");
    let text = "[part]\nfile = \"part.stl\"\n[clean]\nsurfaces = [7]\n[surfaces]\nnames = { 7 = \"Lid\" }\n";
    std::fs::write(&file, text).expect("writes");
    let mut h = window(Some(file), &Answers::default());
    assert_eq!(h.state().surfaces().len(), 7, "a job of before welds equal corners alone");
    tab(&mut h, "Part");
    reveal(&mut h, "a rounding apart");
    click(&mut h, "a rounding apart");
    assert_eq!(h.state().surfaces().len(), 6);
    let named = |h: &Harness<'_, App>, n: u32| h.state().document().job().settings.of(SurfaceId(n)).name.clone();
    assert_eq!((named(&h, 6), named(&h, 7)), ("Lid".into(), String::new()));
    assert!(h.query_all_by_label_contains("3 corners were joined").count() > 0);
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert_eq!((h.state().surfaces().len(), named(&h, 7)), (7, "Lid".into()));
}
