//! The window where the robot refuses work: what would help, a better set-up, and the frames of the cell.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test --test window_setup` takes new pictures; look at them before keeping.

mod common;

use clearbeam::app::App;
use common::window::{Answers, bring, click, drag, job_on, press, reveal, settle, snapshot, type_into, window};
use eframe::egui::{self, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// The cup in the hand of an MZ04.
fn job(folder: &tempfile::TempDir, cell: &str) -> PathBuf {
    let text = "[clean]\nsurfaces = [1]\n[layers]\nspacing_mm = 4.0\n[beam]\nspeed_mm_s = 20.0\n\
                [cell]\nrobot = \"mz04\"\n";
    job_on(folder, "acetabular_cup", &format!("{text}{cell}"))
}

/// A laser so far out that part of the cup is beyond the arm.
fn far(folder: &tempfile::TempDir) -> Harness<'static, App> {
    let cell = "base_from_laser = { position_mm = [620.0, 0.0, 300.0], rz_ry_rx_deg = [0.0, 0.0, 0.0] }\n";
    window(Some(job(folder, cell)), &Answers::default())
}

/// Targets that are left out, as the status line says it.
fn left_out(h: &Harness<'_, App>) -> u32 {
    let node = h.get_by_label_contains("proven free").accesskit_node();
    let text = node.label().or_else(|| node.value()).expect("words");
    let Some((number, _)) = text.split_once(" target") else { return 0 };
    number.replace(' ', "").parse().expect("a number")
}

fn field(h: &mut Harness<'_, App>, label: &str) -> String {
    bring(h, label);
    h.get_by_label(label).accesskit_node().value().expect("a value")
}

fn find(h: &mut Harness<'_, App>) {
    reveal(h, "Find a better set-up");
    click(h, "Find a better set-up");
}

#[test]
fn what_is_refused_is_told_with_what_would_help() {
    let folder = tempfile::tempdir().expect("folder");
    let mut h = far(&folder);
    assert!(left_out(&h) > 0);
    assert!(h.query_by_label_contains("refused: out of the robot's reach").is_some());
    assert!(h.query_by_label("What would help").is_some());
    assert!(h.query_all_by_label_contains("nearer to the robot").count() > 0, "the laser stands too far out");
    assert!(h.query_by_label_contains("Put the laser 100 mm nearer").is_some());
    snapshot(&mut h, "advice");
    // Nothing refused: nothing to help with.
    press(&mut h, Modifiers::NONE, Key::Escape);
    type_into(&mut h, "Laser in the base x", "380");
    assert_eq!(left_out(&h), 0);
    assert!(h.query_by_label("What would help").is_none());
}

#[test]
fn a_better_set_up_is_looked_at_applied_and_undone() {
    let folder = tempfile::tempdir().expect("folder");
    let mut h = far(&folder);
    let before = left_out(&h);
    find(&mut h);
    assert!(h.query_by_label_contains("% within reach instead of ").is_some());
    snapshot(&mut h, "better");
    press(&mut h, Modifiers::NONE, Key::K);
    assert!(h.query_by_label("The cell is shown as it would stand").is_some());
    snapshot(&mut h, "better_cell");
    press(&mut h, Modifiers::NONE, Key::K);
    press(&mut h, Modifiers::NONE, Key::Escape);
    assert!(h.query_by_label("Apply").is_none(), "dismissed");
    assert_eq!(left_out(&h), before);

    find(&mut h);
    click(&mut h, "Apply");
    let after = left_out(&h);
    assert!(after < before, "{after} of {before} are left");
    assert!(h.query_by_label("Apply").is_none(), "it was for another plan");
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert_eq!(left_out(&h), before, "one step");
    assert_eq!(field(&mut h, "Laser in the base x"), "x 620.0 mm");
}

/// Steps until something is so, and says how long that took.
fn until(h: &mut Harness<'_, App>, is_so: impl Fn(&Harness<'_, App>) -> bool) -> Duration {
    let begun = Instant::now();
    while !is_so(h) {
        assert!(begun.elapsed() < Duration::from_secs(60), "it never came");
        std::thread::sleep(Duration::from_millis(1));
        h.step();
    }
    begun.elapsed()
}

#[test]
fn a_search_says_what_it_does_and_is_cancelled_at_once() {
    let folder = tempfile::tempdir().expect("folder");
    let mut h = far(&folder);
    reveal(&mut h, "Find a better set-up");
    let found = |h: &Harness<'_, App>| h.query_by_label_contains("% within reach instead of ").is_some();
    // Other tests take time as well: the best of three counts.
    let mut least = Duration::MAX;
    for _ in 0..3 {
        h.get_by_label("Find a better set-up").click();
        until(&mut h, |h| h.query_by_label_contains("trying set-ups ").is_some());
        h.get_by_label("Cancel").click();
        h.step();
        least = least.min(until(&mut h, |h| h.query_by_label("Cancel").is_none()));
        settle(&mut h);
        assert!(!found(&h) && h.query_by_label("Find a better set-up").is_some(), "it can be looked for again");
    }
    assert!(least < Duration::from_millis(100), "{least:?}");
    // What would help is looked for unasked after each plan.
    h.key_press_modifiers(Modifiers::COMMAND, Key::R);
    until(&mut h, |h| h.query_by_label_contains("trying changes ").is_some());
    h.get_by_label("Cancel").click();
    settle(&mut h);
    assert!(h.query_by_label_contains("the search was cancelled").is_some());
    press(&mut h, Modifiers::COMMAND, Key::R);
    assert!(h.query_by_label_contains("Put the laser 100 mm nearer").is_some());
    find(&mut h);
    assert!(found(&h), "and found");
}

#[test]
fn frames_are_set_for_this_job_and_given_back_to_the_cell() {
    let folder = tempfile::tempdir().expect("folder");
    let mut h = window(Some(job(&folder, "")), &Answers::default());
    assert!(h.query_by_label("reset laser in the base").is_none());
    reveal(&mut h, "Laser in the base z");
    let start = field(&mut h, "Laser in the base z");
    let from = h.get_by_label("Laser in the base z").rect().center();
    drag(&mut h, from, from + egui::vec2(30.0, 0.0));
    assert_ne!(field(&mut h, "Laser in the base z"), start);
    assert!(h.query_by_label("●").is_some(), "marked as this job's");
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert_eq!(field(&mut h, "Laser in the base z"), start, "a drag is one step");
    assert!(h.query_by_label("●").is_none());
    type_into(&mut h, "Part on the flange RZ", "30");
    assert_eq!(field(&mut h, "Part on the flange RZ"), "RZ 30.0°");
    reveal(&mut h, "reset part on the flange");
    click(&mut h, "reset part on the flange");
    assert_eq!(field(&mut h, "Part on the flange RZ"), "RZ 0.0°");
    // The other mount has other frames.
    reveal(&mut h, "carries the head");
    click(&mut h, "carries the head");
    assert!(h.query_by_label("Part in the base x").is_some() && h.query_by_label("Laser in the base x").is_none());
    assert!(h.query_by_label("Head on the flange").is_some());
}

#[test]
fn a_fitted_frame_says_how_well_it_fits() {
    let folder = tempfile::tempdir().expect("folder");
    let shipped = include_str!("../assets/cells/mz04.toml");
    let points = "points = [{ model = [0.0, 0.0, 0.0], measured = [0.0, 0.0, 60.0] }, \
                  { model = [50.0, 0.0, 0.0], measured = [50.0, 0.0, 60.0] }, \
                  { model = [0.0, 50.0, 0.0], measured = [0.0, 50.0, 60.0] }, \
                  { model = [0.0, 0.0, 50.0], measured = [0.0, 0.0, 110.4] }]\n";
    let at = shipped.find("[flange_from_part]").expect("there");
    let rest = at + shipped[at..].find("\n\n").expect("a next table");
    let cell = format!("{}[flange_from_part]\n{points}{}", &shipped[..at], &shipped[rest..]);
    std::fs::write(folder.path().join("cell.toml"), cell).expect("writes");
    let mut h = window(Some(job(&folder, "file = \"cell.toml\"\n")), &Answers::default());
    reveal(&mut h, "Part on the flange x");
    // A tetrahedron whose tip was measured 0.4 mm too high.
    h.get_by_label_contains("measured: rms 0.1").hover();
    settle(&mut h);
    for _ in 0..60 {
        h.step();
    }
    assert!(h.query_by_label_contains("point 4: 0.").is_some(), "residuals of each point");
    snapshot(&mut h, "frames");
    type_into(&mut h, "Part on the flange z", "61");
    assert!(h.query_by_label_contains("measured: rms").is_none(), "these figures were not measured");
}
