//! The true beam in the window: head, optics, access map, tilt along a line, dose.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test --test window_beam` takes new pictures; look at them before keeping.

mod common;

use clearbeam::app::{Command, Purpose};
use clearbeam::beam::{Head, Obstacle};
use clearbeam::document::Edit;
use common::window::{Answers, click, drag, job_on, press, reveal, says, settle, snapshot, window};
use eframe::egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable as _;
use std::path::PathBuf;

/// The crater beside the lug, its lines 1.5 mm apart.
fn job(folder: &tempfile::TempDir, more: &str) -> PathBuf {
    let head = "[[part]]\nfrom_mm = 60\nto_mm = 90\nr0_mm = 6\nr1_mm = 14\n[[part]]\nfrom_mm = 90\nto_mm = 200\nr0_mm = 18\nr1_mm = 18\n";
    std::fs::write(folder.path().join("head.toml"), head).expect("writes");
    let text = "[clean]\nsurfaces = [2]\n[layers]\nspacing_mm = 1.5\n[path]\ncorrection = \"clearance\"\n";
    job_on(folder, "workpiece", &format!("{text}{more}"))
}

#[test]
fn a_head_is_opened_seen_and_taken_away() {
    let folder = tempfile::tempdir().expect("a folder");
    let answers = Answers::default();
    answers.0.lock().expect("answers").push((Purpose::Head, folder.path().join("head.toml")));
    let mut h = window(Some(job(&folder, "")), &answers);
    assert!(h.query_by_label("Margin").is_none(), "a ray keeps no margin");
    click(&mut h, "Open head…");
    assert!(h.query_by_label("head.toml").is_some());
    h.get_by_label("Margin");
    assert!(says(&h, "proven").contains("proven free"));
    press(&mut h, Modifiers::NONE, Key::T);
    let free = says(&h, "Access at the target");
    assert!(free.ends_with("% free"), "{free}");
    for label in ["access map", "tilt along the line"] {
        h.get_by_label(label);
    }
    snapshot(&mut h, "access");
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert!(h.query_by_label("Margin").is_none(), "undone");
}

/// A head of three pieces is taken from the samples, gets a fourth, and is written where it is asked for.
#[test]
fn a_head_is_put_together_and_used() {
    let folder = tempfile::tempdir().expect("a folder");
    let answers = Answers::default();
    let file = folder.path().join("mine.toml");
    answers.0.lock().expect("answers").push((Purpose::SaveHead, file.clone()));
    let mut h = window(Some(job(&folder, "")), &answers);
    click(&mut h, "Edit…");
    h.get_by_label("it has no part");
    click(&mut h, "Scan head");
    snapshot(&mut h, "head_editor");
    click(&mut h, "Add a piece");
    click(&mut h, "Remove piece 1");
    click(&mut h, "Save and use…");
    let Ok(Head::Stack(parts)) = Head::load(&file) else { panic!("a stack") };
    let spans: Vec<(f64, f64)> = parts.iter().map(|p| (p.from_mm, p.to_mm)).collect();
    assert_eq!(spans, [(195.0, 330.0), (330.0, 430.0), (430.0, 480.0)]);
    assert!(h.query_by_label("mine.toml").is_some(), "the job uses it");
    h.get_by_label("Margin");
    assert!(h.query_by_label("Save and use…").is_none(), "the window is closed");
}

#[test]
fn a_tilt_is_pinned_by_dragging_and_let_go() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "")), &Answers::default());
    press(&mut h, Modifiers::NONE, Key::PageDown);
    press(&mut h, Modifiers::NONE, Key::T);
    let strip = h.get_by_label("tilt along the line").rect();
    let middle = strip.center();
    drag(&mut h, middle, middle - eframe::egui::vec2(0.0, 0.25 * strip.height()));
    assert!(h.query_by_label("Remove all pins").is_some(), "a pin");
    assert!(h.query_by_label("Undo").is_some());
    snapshot(&mut h, "pinned");
    click(&mut h, "Remove all pins");
    assert!(h.query_by_label("Remove all pins").is_none());
}

#[test]
fn the_spot_of_the_optics_and_both_ways_to_a_wanted_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "[beam]\nspot_mm = 2.0\n")), &Answers::default());
    click(&mut h, "Optics");
    reveal(&mut h, "Wavelength");
    assert_eq!(says(&h, "Spot at D"), "Spot at D = 20.0 mm: 1.005 mm");
    assert_eq!(says(&h, "M² ="), "M² = 3.69");
    reveal(&mut h, "D = -39.9 mm");
    click(&mut h, "D = -39.9 mm");
    let said = says(&h, "Spot at D");
    assert!(said.starts_with("Spot at D = -") && said.ends_with(": 2.000 mm"), "{said}");
}

#[test]
fn the_dose_is_shown_and_what_stays_unclean_put_aside() {
    let folder = tempfile::tempdir().expect("a folder");
    // The planes along z miss what is parallel to them: a lug's side.
    let mut h = window(Some(job(&folder, "")), &Answers::default());
    press(&mut h, Modifiers::NONE, Key::D);
    for label in ["colour scale", "histogram of the dose"] {
        h.get_by_label(label);
    }
    let within = says(&h, "% within the window");
    let share: f64 = within.split('%').next().and_then(|s| s.parse().ok()).expect("a share");
    assert!((5.0..=100.0).contains(&share), "{within}");
    snapshot(&mut h, "dose");
    click(&mut h, "incidence");
    assert!(h.query_by_label("histogram of the dose").is_none());
    press(&mut h, Modifiers::NONE, Key::D);
    assert!(h.query_by_label("colour scale").is_none());
}

#[test]
fn after_a_cancel_the_old_plan_is_out_of_date_and_nothing_is_called_proven() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "")), &Answers::default());
    assert!(says(&h, "proven").contains("proven free"));
    assert!(h.query_by_label("out of date").is_none());
    let block = clearbeam::sample::stl_bytes(&clearbeam::sample::solids::cube(10.0));
    std::fs::write(folder.path().join("clamp.stl"), block).expect("writes");
    let mut clamp = Obstacle::named("clamp.stl".into());
    clamp.position_mm = [300.0, 0.0, 40.0];
    h.state_mut().send(Edit::Clamps(vec![clamp]));
    h.step();
    h.state_mut().give(Command::Cancel, &[]);
    settle(&mut h);
    assert!(h.state().plan().is_none());
    assert!(h.query_by_label_contains("proven free").is_none());
    h.get_by_label("out of date");
    h.state_mut().give(Command::Plan, &[]);
    settle(&mut h);
    assert!(says(&h, "proven").contains("proven free"), "a clamp far away");
    assert!(h.query_by_label("out of date").is_none());
}
