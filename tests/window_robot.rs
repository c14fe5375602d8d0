//! The window with a robot: the cell, the simulation, its curves and the program's text.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test --test window_robot` takes new pictures; look at them before keeping.

mod common;

use clearbeam::app::App;
use clearbeam::document::Edit;
use clearbeam::path::Direction;
use common::window::{Answers, click, click_at, job_on, press, sample, settle, snapshot, tab, window};
use eframe::egui::{self, Key, Modifiers};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use egui_kittest::{Harness, Node};
use std::path::PathBuf;

/// A job on a sample with the MZ04.
fn job(folder: &tempfile::TempDir, name: &str, rest: &str) -> PathBuf {
    job_on(folder, name, &format!("{rest}\n[cell]\nrobot = \"mz04\"\n"))
}

fn cup(folder: &tempfile::TempDir) -> Harness<'static, App> {
    let rest = "[clean]\nsurfaces = [1]\n[layers]\nspacing_mm = 6.0\n[beam]\nspeed_mm_s = 20.0";
    window(Some(job(folder, "acetabular_cup", rest)), &Answers::default())
}

#[test]
fn the_arm_carries_the_part_under_the_laser() {
    let folder = tempfile::tempdir().expect("folder");
    let mut h = cup(&folder);
    press(&mut h, Modifiers::NONE, Key::K);
    press(&mut h, Modifiers::NONE, Key::PageDown);
    press(&mut h, Modifiers::NONE, Key::PageDown);
    for _ in 0..12 {
        press(&mut h, Modifiers::NONE, Key::ArrowRight);
    }
    snapshot(&mut h, "cell");
    press(&mut h, Modifiers::NONE, Key::M);
    press(&mut h, Modifiers::NONE, Key::P);
    settle(&mut h);
    snapshot(&mut h, "motion");
    assert!(h.query_by_label("curve of the clearance").is_some());
    assert!(h.query_by_label_contains("Clearance, mm · least ").is_some(), "with the least of all");
    click(&mut h, "Robot cell");
    assert!(h.query_by_label("pass 2 · point 12").is_some());
}

/// Clicks at a share of a widget's width.
fn click_in(h: &mut Harness<'_, App>, label: &str, share: f32) {
    let at = h.get_by_label(label).rect().lerp_inside(egui::vec2(share, 0.5));
    click_at(h, at);
}

fn words(node: &Node<'_>) -> String {
    let node = node.accesskit_node();
    node.label().or_else(|| node.value()).expect("words")
}

/// Where the simulation is: seconds so far and in all, and the target.
fn place(h: &Harness<'_, App>) -> (u64, u64, String) {
    let seconds = |clock: &str| clock.split(':').fold(0, |s, part| 60 * s + part.parse::<u64>().expect("a number"));
    let text = words(&h.get_by_label_contains(" / 00:"));
    let (now, all) = text.split_once(" / ").expect("two times");
    (seconds(now), seconds(all), words(&h.get_by_label_contains("· point ")))
}

#[test]
fn time_and_target_lead_each_other() {
    let folder = tempfile::tempdir().expect("folder");
    let mut h = cup(&folder);
    let (start_s, all_s, first) = place(&h);
    assert!(start_s < all_s && first == "pass 0 · point 0", "{first}");
    click_in(&mut h, "time", 0.5);
    let (middle_s, _, target) = place(&h);
    assert!(middle_s.abs_diff(all_s / 2) <= 1 && target != first, "{middle_s} of {all_s}, {target}");
    // Targets lead the time.
    press(&mut h, Modifiers::NONE, Key::PageDown);
    let (next_s, _, next) = place(&h);
    assert!(next_s > middle_s && next.ends_with("· point 0"), "{next}");
    press(&mut h, Modifiers::NONE, Key::PageUp);
    assert!(place(&h).0 < next_s);
    // Played at ten times the speed for half a second.
    h.get_by_label("play speed").click();
    settle(&mut h);
    press(&mut h, Modifiers::COMMAND, Key::A);
    h.get_by_label("play speed").type_text("10");
    press(&mut h, Modifiers::NONE, Key::Enter);
    let before_s = place(&h).0;
    press(&mut h, Modifiers::NONE, Key::Space);
    h.run_steps(30);
    press(&mut h, Modifiers::NONE, Key::Space);
    let played_s = place(&h).0 - before_s;
    assert!((3..=9).contains(&played_s), "{played_s} s");
    // At the end it stops, or begins again.
    press(&mut h, Modifiers::NONE, Key::End);
    press(&mut h, Modifiers::NONE, Key::Space);
    h.run_steps(60);
    assert_eq!(place(&h).0, all_s);
    assert!(h.query_by_label_contains("Play").is_some(), "it has stopped");
    click(&mut h, "loop");
    press(&mut h, Modifiers::NONE, Key::Space);
    h.run_steps(20);
    assert!(h.query_by_label("Pause").is_some() && place(&h).0 < all_s, "it plays from the start");
}

#[test]
fn a_click_in_a_curve_goes_there_and_the_line_of_the_program_follows() {
    let folder = tempfile::tempdir().expect("folder");
    let mut h = cup(&folder);
    press(&mut h, Modifiers::NONE, Key::M);
    press(&mut h, Modifiers::NONE, Key::P);
    for (curve, share) in [("curves of joints", 0.8), ("curve of the clearance", 0.5)] {
        click_in(&mut h, curve, share);
        let (now_s, all_s, _) = place(&h);
        // The axis stands left of the curve.
        let at = now_s as f64 / all_s as f64;
        assert!((share as f64 - 0.2..share as f64 + 0.1).contains(&at), "{curve}: {now_s} of {all_s}");
    }
    // A click on a line goes to its move, or the next one: the first of the pass.
    press(&mut h, Modifiers::NONE, Key::Home);
    let (begun_s, _, first) = place(&h);
    let line = words(&h.get_by_label_contains("pass 0, surface 1"));
    for _ in 0..8 {
        press(&mut h, Modifiers::NONE, Key::ArrowRight);
    }
    assert_ne!(place(&h).2, first);
    click_in(&mut h, &line, 0.2);
    assert_eq!((place(&h).0, place(&h).2), (begun_s, first));
    h.remove_cursor();
    assert!(h.try_run().is_ok(), "frames are asked for without end");
    assert!(h.try_run().is_ok_and(|frames| frames <= 2), "nothing more to paint with all panels open");
}

#[test]
fn a_robot_is_chosen_and_says_why_it_refuses() {
    let folder = tempfile::tempdir().expect("folder");
    std::fs::copy(sample("acetabular_cup.stl"), folder.path().join("cup.stl")).expect("copies");
    let mut h = window(Some(folder.path().join("cup.stl")), &Answers::default());
    h.state_mut().send(Edit::Direction(Direction::AXES[2].1));
    click(&mut h, "surface 1 freeform");
    press(&mut h, Modifiers::NONE, Key::Enter);
    assert!(h.query_by_label("time").is_none(), "without a robot passes are stepped through");
    tab(&mut h, "Robot");
    h.get_by_role_and_label(egui::accesskit::Role::ComboBox, "Robot").click();
    settle(&mut h);
    click(&mut h, "NACHI MZ04");
    assert!(h.query_by_label("time").is_some(), "with one there is a time");
    let reason = "targets refused: a joint would leave its limits";
    h.get_by_label_contains(reason).click();
    settle(&mut h);
    snapshot(&mut h, "refused");
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert!(h.query_by_label("time").is_none(), "undo takes the robot away");
}
