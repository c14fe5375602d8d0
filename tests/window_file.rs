//! What casts doubt on a part's file, as the real window shows it: above the view at once, with the click that cures it.

mod common;

use clearbeam::app::App;
use clearbeam::part::Units;
use clearbeam::sample::{Triangles, solids, stl_bytes};
use common::window::{Answers, click, press, window};
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

fn opened(folder: &tempfile::TempDir, triangles: &Triangles) -> Harness<'static, App> {
    let file = folder.path().join("part.stl");
    std::fs::write(&file, stl_bytes(triangles)).expect("writes");
    window(Some(file), &Answers::default())
}

fn shows(h: &Harness<'_, App>, part: &str) -> bool {
    h.query_by_label_contains(part).is_some()
}

fn undo(h: &mut Harness<'_, App>) {
    press(h, Modifiers::COMMAND, Key::Z);
}

#[test]
fn an_implausible_size_stands_above_the_view_and_is_cured_by_one_click() {
    let folder = tempfile::tempdir().expect("a folder");
    // A cube in inches, without a facet: its size comes before its open edges.
    let mut h = opened(&folder, &solids::cube(2.0)[1..].to_vec());
    let told = "A size of 2.000 × 2.000 × 2.000 mm is implausible; in inch it would be 50.8 × 50.8 × 50.8 mm";
    let (banner, view) = (h.get_by_label(told).rect(), h.get_by_label("3D view").rect());
    assert!(banner.bottom() <= view.top(), "{banner} {view}");
    let units = |h: &Harness<'_, App>| h.state().document().job().part.units;
    click(&mut h, "Treat as inches");
    assert_eq!(units(&h), Units::Inch);
    assert!(!shows(&h, "implausible") && h.query_by_label("Treat as inches").is_none(), "cured");
    undo(&mut h);
    assert_eq!(units(&h), Units::Mm);
    assert!(h.query_by_label(told).is_some(), "it is so again");
    // What is dismissed is no longer above the view, and can still be cured from the list.
    click(&mut h, "Dismiss");
    assert!(h.query_by_label(told).is_none());
    click(&mut h, "Treat as inches");
    assert_eq!(units(&h), Units::Inch);
}

#[test]
fn a_part_that_shatters_is_brought_to_order_by_one_click() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = opened(&folder, &solids::folded_sheet(150, 0.03));
    let least = |h: &Harness<'_, App>| h.state().document().job().surfaces.min_area_mm2;
    let absorb = "Absorb islands below 1 mm²";
    assert!(h.query_by_label(absorb).is_some());
    click(&mut h, absorb);
    assert_eq!(least(&h), 1.0);
    assert!(h.query_by_label(absorb).is_none(), "nothing more to absorb");
    undo(&mut h);
    assert_eq!(least(&h), 0.0);
    assert!(h.query_by_label(absorb).is_some());
}

#[test]
fn a_part_far_from_the_origin_is_told_before_anything_is_planned() {
    let folder = tempfile::tempdir().expect("a folder");
    let far = |[x, y, z]: [f64; 3]| [x + 512_345.0, y + 5_412_345.0, z + 120.0];
    let mut h = opened(&folder, &solids::cube(40.0).into_iter().map(|t| t.map(far)).collect());
    assert!(shows(&h, "The part lies 5436.563 m from the origin"));
    assert!(h.state().plan().is_none());
    click(&mut h, "Dismiss");
    assert!(!shows(&h, "The part lies"));
    let sound = opened(&folder, &solids::cube(40.0));
    assert!(sound.query_by_label("Dismiss").is_none(), "of a sound part there is nothing to say");
}
