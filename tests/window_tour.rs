//! The guided tour: every step is done as its words say, and the program is there at the end.

mod common;

use clearbeam::app::{App, Command, Purpose};
use common::window::{Answers, click, drag, press, settle, type_into, window};
use eframe::egui::{Key, Modifiers, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

fn is_at(h: &Harness<'_, App>, step: u32) -> bool {
    h.query_by_label(&format!("Step {step} of 6")).is_some()
}

#[test]
fn the_tour_does_the_whole_job() {
    let out = tempfile::tempdir().expect("a folder");
    let answers = Answers::default();
    answers.0.lock().expect("fresh").push((Purpose::Export, out.path().to_path_buf()));
    let mut h = window(None, &answers);
    click(&mut h, "Guided tour");
    assert!(is_at(&h, 1), "the sample is open");
    h.run_steps(5);
    assert!(is_at(&h, 1), "the view turned by itself is no step");
    let middle = h.get_by_label("3D view").rect().center();
    drag(&mut h, middle, middle + vec2(60.0, 10.0));
    assert!(is_at(&h, 2));
    click(&mut h, "surface 2 sphere Ø17.51");
    press(&mut h, Modifiers::NONE, Key::Enter);
    assert!(is_at(&h, 3));
    type_into(&mut h, "Spacing", "1");
    assert!(is_at(&h, 4));
    press(&mut h, Modifiers::NONE, Key::ArrowRight);
    assert!(is_at(&h, 5));
    h.state_mut().send(clearbeam::document::Edit::Robot("mz04".into(), "nachi".into()));
    settle(&mut h);
    assert!(is_at(&h, 6));
    h.state_mut().give(Command::Export, &[]);
    settle(&mut h);
    click(&mut h, "Export");
    assert!(h.query_by_label_contains("That was the whole job").is_some());
    assert!(out.path().join("MZ04-01-A.001").is_file());
    h.get_by_label_contains("Close").click();
    settle(&mut h);
    assert!(h.query_by_label_contains("That was the whole job").is_none());
}
