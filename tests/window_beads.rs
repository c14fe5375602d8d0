//! Cladding in the window: the bead and its section, in the job's panel and in a recipe's; the border that offset
//! lines start from, chosen in the view; recipes that are duplicated, and kept by what is split off.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test --test window_beads` takes new pictures; look at them before keeping.

mod common;

use clearbeam::app::App;
use common::window::{
    Answers, click, job_on, menu_in_the_middle, press, reveal, says, settle, snapshot, type_into, window,
};
use eframe::egui::{Event, Key, Modifiers, PointerButton, Role, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use std::path::PathBuf;

/// The workpiece with some surfaces to work.
fn job(folder: &tempfile::TempDir, surfaces: &str, more: &str) -> PathBuf {
    job_on(folder, "workpiece", &format!("[clean]\nsurfaces = {surfaces}\n{more}"))
}

fn value(h: &Harness<'_, App>, label: &str) -> Option<String> {
    h.get_by_label(label).accesskit_node().value()
}

fn shows(h: &Harness<'_, App>, label: &str) -> bool {
    h.query_by_label(label).is_some()
}

fn open(h: &mut Harness<'_, App>, header: &str) {
    reveal(h, header);
    click(h, header);
}

fn undo(h: &mut Harness<'_, App>) {
    press(h, Modifiers::COMMAND, Key::Z);
}

/// The menu of the view at a place, as a share of its width and height.
fn right_click(h: &mut Harness<'_, App>, share: [f32; 2]) {
    let view = h.get_by_label("3D view").rect();
    let at = view.min + view.size() * Vec2::from(share);
    h.hover_at(at);
    h.step();
    for pressed in [true, false] {
        h.event(Event::PointerButton {
            pos: at,
            button: PointerButton::Secondary,
            pressed,
            modifiers: Modifiers::NONE,
        });
        h.step();
    }
    settle(h);
}

const BEAD: &str = "[layers]\nspacing_mm = 2.4\n[bead]\nwidth_mm = 3\nheight_mm = 0.9\nlayers = 3\n";

#[test]
fn the_section_follows_the_bead_while_it_is_changed() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "[3]", BEAD)), &Answers::default());
    // R = (1.5² + 0.9²)/1.8 = 1.7; beads 2.4 mm apart meet at 1.7 − √(1.7² − 1.2²) below their tops.
    let ripple = 1.7 - (1.7f64 * 1.7 - 1.2 * 1.2).sqrt();
    let said = says(&h, "section of the beads");
    let wanted = format!(
        "section of the beads: width ω 3.00 mm, height h 0.90 mm, centres c 2.40 mm, overlap η 20.0 %, \
         ripple r {ripple:.2} mm, build-up 2.70 mm"
    );
    assert_eq!(said, wanted);
    reveal(&mut h, "Bead: 3 × 0.9 mm, 3 layers");
    let section = says(&h, "section of the beads");
    reveal(&mut h, &section);
    snapshot(&mut h, "bead");
    type_into(&mut h, "Bead width", "4");
    assert!(
        says(&h, "section of the beads").contains("width ω 4.00 mm")
            && value(&h, "Overlap").as_deref() == Some("40.0 %")
    );
    undo(&mut h);
    assert_eq!(says(&h, "section of the beads"), wanted, "undone");
    // A drag is one step, and the section goes with it.
    let field = h.get_by_label("Bead height").rect().center();
    h.hover_at(field);
    h.step();
    h.drag_at(field);
    for i in 1..=6 {
        h.step();
        h.hover_at(field + vec2(6.0 * i as f32, 0.0));
    }
    h.step();
    assert_ne!(says(&h, "section of the beads"), wanted, "while it is dragged");
    h.drop_at(field + vec2(36.0, 0.0));
    settle(&mut h);
    undo(&mut h);
    assert_eq!(says(&h, "section of the beads"), wanted, "one step");
}

#[test]
fn a_bead_is_laid_and_taken_away() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "[3]", "[layers]\nspacing_mm = 1.5\n")), &Answers::default());
    assert!(!shows(&h, "lay a bead"), "closed where nothing is laid");
    open(&mut h, "Bead: none");
    assert!(h.query_by_label_contains("section of the beads").is_none() && !shows(&h, "Bead width"));
    reveal(&mut h, "lay a bead");
    click(&mut h, "lay a bead");
    assert!(shows(&h, "Bead: 1 × 0.3 mm") && says(&h, "section of the beads").contains("overlap η -50.0 %"));
    // A heading has the same name.
    let layers = |h: &Harness<'_, App>| h.get_by_role_and_label(Role::SpinButton, "Layers").rect().center();
    let at = layers(&h);
    h.hover_at(at);
    h.step();
    h.drag_at(at);
    h.step();
    h.drop_at(at);
    settle(&mut h);
    press(&mut h, Modifiers::COMMAND, Key::A);
    h.event(Event::Text("2.4".into()));
    press(&mut h, Modifiers::NONE, Key::Enter);
    let count = h.get_by_role_and_label(Role::SpinButton, "Layers").accesskit_node().value();
    assert_eq!(count.as_deref(), Some("2"), "whole");
    reveal(&mut h, "across the others");
    click(&mut h, "across the others");
    assert!(shows(&h, "layers that run across are drawn as if they did not"));
    reveal(&mut h, "lay a bead");
    click(&mut h, "lay a bead");
    assert!(shows(&h, "Bead: none"));
    for title in ["Bead: 1 × 0.3 mm, 2 layers", "Bead: 1 × 0.3 mm, 2 layers", "Bead: 1 × 0.3 mm", "Bead: none"] {
        undo(&mut h);
        assert!(shows(&h, title), "{title}");
    }
}

#[test]
fn spacing_and_bead_follow_from_each_other() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "[3]", BEAD)), &Answers::default());
    let bead = clearbeam::process::bead::Bead::new(3.0, 0.9).expect("a bead");
    let take = format!("take spacing {:.2} mm", bead.spacing_mm());
    reveal(&mut h, &take);
    click(&mut h, &take);
    assert_eq!(value(&h, "Overlap"), Some(format!("{:.1} %", 100.0 * bead.overlap())));
    assert!(shows(&h, "The beads fill a layer of their own height (P3)"));
    undo(&mut h);
    for (word, field) in [("height", "Bead height"), ("width", "Bead width")] {
        let before = value(&h, field);
        let take = says(&h, &format!("take {word} "));
        reveal(&mut h, &take);
        click(&mut h, &take);
        assert!(shows(&h, "The beads fill a layer of their own height (P3)"), "{take}");
        assert_ne!(value(&h, field), before);
        undo(&mut h);
        assert_eq!(value(&h, field), before);
    }
}

const CLAD: &str = "[layers]\nspacing_mm = 1.5\n[recipe_of]\n2 = \"Clad\"\n[[recipes]]\nname = \"Clad\"\n\
                    [recipes.values]\n\"bead.width_mm\" = 2.0\n\"bead.height_mm\" = 0.5\n";
const CRATER: &str = "surface 2 sphere Ø17.51";

#[test]
fn a_recipe_has_a_bead_of_its_own() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "[2, 3]", CLAD)), &Answers::default());
    click(&mut h, CRATER);
    open(&mut h, "Recipe of surface 2: Clad");
    assert!(shows(&h, "Bead: none"), "the job's");
    assert!(says(&h, "recipe section of the beads").contains("width ω 2.00 mm, height h 0.50 mm, centres c 1.50 mm"));
    type_into(&mut h, "recipe Bead width", "2.5");
    assert!(says(&h, "recipe section of the beads").contains("overlap η 40.0 %"));
    assert!(!shows(&h, "recipe reset Bead width"), "to half a bead there is no way back");
    reveal(&mut h, "recipe lay a bead");
    click(&mut h, "recipe lay a bead");
    assert!(h.query_by_label_contains("section of the beads").is_none());
    undo(&mut h);
    reveal(&mut h, "recipe reset bead");
    click(&mut h, "recipe reset bead");
    assert!(h.query_by_label_contains("section of the beads").is_none() && !shows(&h, "recipe reset bead"));
    undo(&mut h);
    assert!(says(&h, "recipe section of the beads").contains("overlap η 40.0 %"));
}

const OFFSET: &str = "[layers]\nspacing_mm = 2.0\nstrategy = \"offset\"\n";

#[test]
fn offset_lines_start_from_the_border_that_was_right_clicked() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "[1]", OFFSET)), &Answers::default());
    let before = says(&h, " passes · ");
    assert!(!shows(&h, "border"), "the whole outline");
    // On the plate's front, beside the rim of the bore Ø10.
    right_click(&mut h, [0.70, 0.49]);
    click(&mut h, "Offset from this border");
    assert!(shows(&h, "Surface 1 from") && shows(&h, "border 5"));
    assert!(!shows(&h, "border"), "the job's stays the whole outline");
    assert_ne!(says(&h, " passes · "), before, "other lines");
    snapshot(&mut h, "border");
    undo(&mut h);
    assert!(!shows(&h, "border 5") && says(&h, " passes · ") == before, "undone");
}

#[test]
fn a_border_is_for_offset_lines_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "[2]", "[layers]\nspacing_mm = 2.0\n")), &Answers::default());
    click(&mut h, CRATER);
    press(&mut h, Modifiers::NONE, Key::F);
    menu_in_the_middle(&mut h);
    assert!(h.get_by_label("Offset from this border").accesskit_node().is_disabled());
}

#[test]
fn a_recipe_goes_back_to_the_whole_outline() {
    let folder = tempfile::tempdir().expect("a folder");
    let more = format!("{OFFSET}border = 0\n[recipe_of]\n2 = \"R\"\n[[recipes]]\nname = \"R\"\n");
    let mut h = window(Some(job(&folder, "[2]", &more)), &Answers::default());
    click(&mut h, CRATER);
    open(&mut h, "Recipe of surface 2: R");
    assert_eq!(value(&h, "recipe border").as_deref(), Some("border 1"), "the job's");
    reveal(&mut h, "recipe whole outline");
    click(&mut h, "recipe whole outline");
    assert!(!shows(&h, "recipe border") && value(&h, "border").as_deref() == Some("border 1"));
    click(&mut h, "recipe reset border");
    assert_eq!(value(&h, "recipe border").as_deref(), Some("border 1"));
    press(&mut h, Modifiers::NONE, Key::F);
    menu_in_the_middle(&mut h);
    click(&mut h, "Offset from this border");
    assert!(shows(&h, "surface reset start of 2") && !shows(&h, "recipe reset border"), "it is the surface's own");
}

#[test]
fn a_recipe_is_duplicated() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "[2, 3]", CLAD)), &Answers::default());
    open(&mut h, "Recipe library");
    reveal(&mut h, "duplicate recipe Clad");
    click(&mut h, "duplicate recipe Clad");
    assert!(shows(&h, "apply job recipe Clad 2") && !shows(&h, "surface 3 has recipe Clad 2"));
    undo(&mut h);
    assert!(!shows(&h, "apply job recipe Clad 2") && shows(&h, "apply job recipe Clad"));
}

#[test]
fn what_is_split_off_keeps_its_recipe() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "[2, 3]", CLAD)), &Answers::default());
    click(&mut h, CRATER);
    open(&mut h, "More on surfaces");
    type_into(&mut h, "filter surfaces", "180");
    click(&mut h, CRATER);
    type_into(&mut h, "split angle", "2");
    reveal(&mut h, "Split selected surface at");
    click(&mut h, "Split selected surface at");
    assert!(shows(&h, "surface 2 has recipe Clad") && shows(&h, "surface 180 has recipe Clad"));
    undo(&mut h);
    assert!(shows(&h, "surface 2 has recipe Clad") && !shows(&h, "surface 180 has recipe Clad"));
}
