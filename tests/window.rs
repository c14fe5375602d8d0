//! The real window, driven by its labels and rendered without a screen: the whole job from opening
//! a part to the exported program, which must be the command line's, byte for byte.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test --test window` takes new pictures; look at them before keeping.

mod common;

use clearbeam::app::{App, Purpose};
use clearbeam::document::Edit;
use clearbeam::path::Direction;
use common::window::{Answers, click, drag, press, sample, settle, snapshot, type_into, window};
use eframe::egui::{self, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use std::path::{Path, PathBuf};

/// Copies a sample into a folder of its own, so that jobs stand beside their part.
fn copied(folder: &Path, name: &str) -> PathBuf {
    let to = folder.join(name);
    std::fs::copy(sample(name), &to).expect("copies");
    to
}

fn assert_same_bytes(a: &Path, b: &Path) {
    for name in ["MZ04-01-A.001", "path.csv", "report.json"] {
        let (x, y) = (std::fs::read(a.join(name)).expect(name), std::fs::read(b.join(name)).expect(name));
        assert!(!x.is_empty() && x == y, "{name} differs between window and command line");
    }
}

#[test]
fn the_whole_job_and_the_command_line_writes_the_same() {
    let folder = tempfile::tempdir().expect("folder");
    let part = copied(folder.path(), "workpiece.stl");
    let exported = folder.path().join("from window");
    let answers = Answers::default();
    answers.0.lock().expect("fresh").push((Purpose::Export, exported.clone()));
    let mut h = window(Some(part.clone()), &answers);
    snapshot(&mut h, "opened");

    // Crater and lug boss, in this order of work.
    click(&mut h, "surface 2 sphere Ø17.51");
    press(&mut h, Modifiers::NONE, Key::Enter);
    click(&mut h, "surface 3 plane");
    click(&mut h, "▼ To clean");
    let field = h.get_by_label("Spacing");
    field.click();
    settle(&mut h);
    press(&mut h, Modifiers::COMMAND, Key::A);
    h.get_by_label("Spacing").type_text("0.1 cm");
    press(&mut h, Modifiers::NONE, Key::Enter);
    click(&mut h, "Pose frames");
    for _ in 0..3 {
        press(&mut h, Modifiers::NONE, Key::PageDown);
    }
    press(&mut h, Modifiers::NONE, Key::ArrowRight);
    assert!(h.query_by_label("pass 3 · point 1").is_some(), "stepping shows where it is");
    snapshot(&mut h, "planned");
    click(&mut h, "Export program…");
    assert!(h.query_by_label_contains("Everything on the list to clean is done").is_some());
    click(&mut h, "Export");

    let from_cli = folder.path().join("from command line");
    let status = std::process::Command::new(env!("CARGO_BIN_EXE_clearbeam"))
        .args(["plan", &part.display().to_string(), "--surfaces", "2,3", "--spacing", "1", "--out"])
        .arg(&from_cli)
        .output()
        .expect("runs");
    assert_eq!(status.status.code(), Some(0), "{status:?}");
    assert_same_bytes(&exported, &from_cli);
}

#[test]
fn moving_back_undo_and_the_other_way_round() {
    let mut h = window(Some(sample("workpiece.stl")), &Answers::default());
    click(&mut h, "surface 3 plane");
    press(&mut h, Modifiers::COMMAND, Key::A);
    press(&mut h, Modifiers::NONE, Key::Enter);
    assert!(h.query_by_label("0 of 0").is_some(), "all have left the list of feature surfaces");
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert!(h.query_by_label("18 of 18").is_some());
    press(&mut h, Modifiers::COMMAND, Key::Y);
    assert!(h.query_by_label("18 of 18").is_some(), "now in the list to clean");
    assert!(h.query_by_label("0 of 0").is_some());
    click(&mut h, "surface 4 cylinder Ø26.00");
    press(&mut h, Modifiers::NONE, Key::Delete);
    assert!(h.query_by_label("17 of 17").is_some() && h.query_by_label("1 of 1").is_some());
}

#[test]
fn the_angle_recuts_and_keeps_what_was_chosen() {
    let mut h = window(Some(sample("worm_gear.stl")), &Answers::default());
    assert!(h.query_by_label("61 of 61").is_some());
    click(&mut h, "surface 3 freeform");
    press(&mut h, Modifiers::NONE, Key::Enter);
    type_into(&mut h, "Crease angle", "60");
    assert!(h.query_by_label("61 of 61").is_none(), "other surfaces now");
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert!(h.query_by_label("60 of 60").is_some() && h.query_by_label("1 of 1").is_some(), "undo brings them back");
}

#[test]
fn bad_files_are_said_and_the_window_stays() {
    let folder = tempfile::tempdir().expect("folder");
    let bad = folder.path().join("holiday.stl");
    std::fs::write(&bad, b"\xff\xd8\xff\xe0\x00\x10JFIF").expect("writes");
    let answers = Answers::default();
    answers.0.lock().expect("fresh").push((Purpose::Open, bad));
    let mut h = window(None, &answers);
    snapshot(&mut h, "start");
    press(&mut h, Modifiers::COMMAND, Key::O);
    assert!(h.query_by_label_contains("this is a JPEG file, not a part").is_some());
    click(&mut h, "Close");
    assert!(h.query_by_label_contains("this is a JPEG file, not a part").is_none());
}

#[test]
fn jobs_are_saved_opened_again_and_guarded() {
    let folder = tempfile::tempdir().expect("folder");
    let part = copied(folder.path(), "acetabular_cup.stl");
    let file = folder.path().join("cup.toml");
    let answers = Answers::default();
    answers.0.lock().expect("fresh").extend([(Purpose::SaveJob, file.clone()), (Purpose::Open, part.clone())]);
    let mut h = window(Some(part), &answers);
    click(&mut h, "surface 1 freeform");
    press(&mut h, Modifiers::NONE, Key::Enter);
    press(&mut h, Modifiers::COMMAND, Key::O);
    assert!(h.query_by_label("Save changes?").is_some(), "unsaved changes are guarded");
    click(&mut h, "Cancel");
    press(&mut h, Modifiers::COMMAND, Key::S);
    let text = std::fs::read_to_string(&file).expect("saved");
    assert!(text.contains("file = \"acetabular_cup.stl\"") && text.contains("surfaces = [1]"), "{text}");
    drop(h);
    let h = window(Some(file), &Answers::default());
    assert!(h.query_by_label("1 of 1").is_some(), "the list is as it was saved");
}

#[test]
fn rows_are_dragged_between_the_lists_and_within() {
    let mut h = window(Some(sample("workpiece.stl")), &Answers::default());
    let row = |h: &Harness<'_, App>, name: &str| h.get_by_label(name).rect().center();
    let below_title = h.get_by_label("To clean").rect().center() + egui::vec2(60.0, 130.0);
    for name in ["surface 3 plane", "surface 2 sphere Ø17.51"] {
        let from = row(&h, name);
        drag(&mut h, from, below_title);
    }
    assert!(h.query_by_label("16 of 16").is_some() && h.query_by_label("2 of 2").is_some());
    let (plane, sphere) = (row(&h, "surface 3 plane"), row(&h, "surface 2 sphere Ø17.51"));
    assert!(plane.y < sphere.y, "in the order in which they came");
    drag(&mut h, sphere, plane);
    assert!(row(&h, "surface 2 sphere Ø17.51").y < row(&h, "surface 3 plane").y, "dropped before the other");
    let (from, back) = (row(&h, "surface 3 plane"), row(&h, "surface 5 plane"));
    drag(&mut h, from, back);
    assert!(h.query_by_label("17 of 17").is_some() && h.query_by_label("1 of 1").is_some());
}

#[test]
fn a_click_in_the_view_selects_and_lights_the_row() {
    let mut h = window(Some(sample("workpiece.stl")), &Answers::default());
    let view = h.get_by_label("3D view").rect();
    // Right of the middle: the plate's front in the iso view.
    let front = view.center() + egui::vec2(95.0, 10.0);
    for pressed in [true, false] {
        h.hover_at(front);
        h.event(egui::Event::PointerButton {
            pos: front,
            button: egui::PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        });
        h.step();
    }
    settle(&mut h);
    press(&mut h, Modifiers::NONE, Key::Enter);
    let list = h.get_by_label("To clean").rect();
    assert!(h.get_by_label("surface 1 plane").rect().top() > list.top(), "the front is to be cleaned");
    press(&mut h, Modifiers::NONE, Key::H);
    press(&mut h, Modifiers::ALT, Key::H);
}

#[test]
fn before_and_after_on_one_section_plane() {
    let mut h = window(Some(sample("worm_gear.toml")), &Answers::default());
    for _ in 0..20 {
        press(&mut h, Modifiers::NONE, Key::PageDown);
    }
    click(&mut h, "One section plane");
    press(&mut h, Modifiers::NONE, Key::F);
    snapshot(&mut h, "section");
    click(&mut h, "Before correction");
    snapshot(&mut h, "section_before");
}

#[test]
fn problems_lead_to_their_place() {
    let mut h = window(Some(sample("workpiece.stl")), &Answers::default());
    h.state_mut().send(Edit::Direction(Direction::AXES[2].1));
    click(&mut h, "surface 10 cylinder Ø8.00");
    press(&mut h, Modifiers::NONE, Key::Enter);
    click(&mut h, "Beams");
    h.get_by_label_contains("blocked by surface 10").click();
    settle(&mut h);
    assert!(h.query_by_label_contains("the beam hits surface 10").is_some());
    snapshot(&mut h, "problem");
}

#[test]
fn an_idle_window_repaints_nothing() {
    let mut h = window(Some(sample("workpiece.toml")), &Answers::default());
    h.remove_cursor();
    // Runs while frames are asked for, and fails if that never ends.
    assert!(h.try_run().is_ok(), "frames are asked for without end");
    assert!(h.try_run().is_ok_and(|frames| frames <= 2), "nothing more to paint");
}
