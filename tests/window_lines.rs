//! Surfaces without a line in the real window: what the defaults give, why there is none, the button that cures it,
//! and undo.

mod common;

use clearbeam::app::App;
use clearbeam::document::LineChange;
use clearbeam::part::SurfaceId;
use clearbeam::path::Direction;
use clearbeam::sample::{solids, stl_bytes};
use common::window::{Answers, click, press, reveal, settle, window};
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

/// The top of a box of 40 × 30 × 20 mm, chosen by hand.
fn top_of_a_box(folder: &tempfile::TempDir) -> Harness<'static, App> {
    let file = folder.path().join("box.stl");
    std::fs::write(&file, stl_bytes(&solids::plate([40.0, 30.0, 20.0], &[]))).expect("writes");
    let mut h = window(Some(file), &Answers::default());
    click(&mut h, "surface 2 plane");
    press(&mut h, Modifiers::NONE, Key::Enter);
    h
}

fn shows(h: &Harness<'_, App>, part: &str) -> bool {
    h.query_by_label_contains(part).is_some()
}

/// Passes, and their greatest length along x, mm.
fn passes(h: &Harness<'_, App>) -> (usize, f64) {
    let passes = &h.state().plan().expect("a plan").plan.passes;
    let along_x = passes.iter().filter_map(|p| Some((p.targets.last()?.p - p.targets.first()?.p).x.abs()));
    (passes.len(), along_x.fold(0.0, f64::max))
}

const ALONG: &str = "nothing to do: no line lies on the chosen surfaces: the section planes lie along it";

#[test]
fn a_top_face_has_lines_at_once_and_a_button_gives_them_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = top_of_a_box(&folder);
    assert_eq!(passes(&h), (60, 40.0), "few long ones, half a millimetre apart");
    assert!(shows(&h, "proven free"));

    reveal(&mut h, "direction z");
    click(&mut h, "direction z");
    assert!(shows(&h, ALONG), "in the status line");
    assert!(shows(&h, "surface 2: no line on its 1200.00 mm²: the section planes lie along it"), "among the problems");
    assert_eq!(passes(&h).0, 0);

    click(&mut h, "Use direction y");
    assert_eq!(passes(&h), (60, 40.0));
    assert!(!shows(&h, "no line") && shows(&h, "proven free"));
    assert_eq!(h.state().document().job().layers.direction, Direction::AXES[1].1);

    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert!(shows(&h, ALONG) && shows(&h, "Use direction y"), "undo brings it back");
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert_eq!(h.state().document().job().layers.direction, Direction::Auto);
    assert_eq!(passes(&h).0, 60);
}

#[test]
fn inset_and_shortest_piece_are_cured_as_well() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = top_of_a_box(&folder);
    h.state_mut().set("layers.inset_mm", 16.0);
    settle(&mut h);
    assert!(shows(&h, "nothing to do: no line lies on the chosen surfaces: the inset of 16 mm leaves none"));
    click(&mut h, "Use an inset of 14 mm");
    assert!(passes(&h).0 > 0);
    h.state_mut().set("layers.inset_mm", 0.0);
    h.state_mut().set("layers.shortest_mm", 50.0);
    settle(&mut h);
    let told = "nothing to do: no line lies on the chosen surfaces: no piece is as long as the 50 mm from which pieces are kept";
    assert!(shows(&h, told));
    click(&mut h, "Keep pieces from 40 mm");
    assert_eq!(passes(&h), (60, 40.0));
    let cure = LineChange::Shortest(40.0).edit(h.state().document().job(), SurfaceId(2));
    assert_eq!(h.state().document().undo_step(), Some(&clearbeam::document::UndoStep::Edited(cure)));
}
