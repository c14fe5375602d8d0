//! Strategies and recipes in the window: chosen, given by button and by drag, compared, kept; and the
//! spacing that came of them.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test --test window_recipes` takes new pictures; look at them before keeping.

mod common;

use clearbeam::app::App;
use common::window::{
    Answers, click, drag, job_on, menu_in_the_middle, press, reveal, sample, says, snapshot, tab, type_into, window,
    window_with_recipes,
};
use eframe::egui::{Key, Modifiers, Role};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use std::path::PathBuf;

/// The crater beside the lug, and the top.
fn job(folder: &tempfile::TempDir, more: &str) -> PathBuf {
    job_on(folder, "workpiece", &format!("[clean]\nsurfaces = [2, 3]\n{more}"))
}

fn shows(h: &Harness<'_, App>, label: &str) -> bool {
    h.query_by_label(label).is_some()
}

fn open(h: &mut Harness<'_, App>, header: &str) {
    reveal(h, header);
    click(h, header);
}

/// The job's power, beside which a recipe's may be shown.
fn own_power(h: &mut Harness<'_, App>) -> Option<String> {
    tab(h, "Beam");
    let power = h.get_by_role_and_label(Role::SpinButton, "Power").accesskit_node().value();
    tab(h, "Path");
    power
}

fn row(n: u32) -> &'static str {
    match n {
        2 => "surface 2 sphere Ø17.51",
        _ => "surface 3 plane",
    }
}

#[test]
fn a_strategy_is_chosen_and_shows_what_concerns_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "[layers]\nspacing_mm = 1.5\n")), &Answers::default());
    let planes = says(&h, " passes · ");
    assert!(shows(&h, "direction x") && shows(&h, "First plane") && !shows(&h, "Spiral runs"));
    click(&mut h, "strategy");
    click(&mut h, "spiral – one line, the laser stays on");
    let spiral = says(&h, " passes · ");
    assert_ne!(planes, spiral, "other lines");
    assert!(!shows(&h, "direction x") && !shows(&h, "First plane") && shows(&h, "Spiral runs"));
    click(&mut h, "inwards");
    // A place of the part becomes the centre.
    menu_in_the_middle(&mut h);
    click(&mut h, "Spiral centre here");
    let own = |h: &Harness<'_, App>| h.query_by_label_contains("surface reset start of ").is_some();
    assert!(own(&h) && !shows(&h, "reset centre"), "of that surface alone");
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert!(!own(&h), "undone");
    for (strategy, field) in [
        ("offset – lines that follow the border", "whole outline"),
        ("cross – two rasters across each other", "Cross angle"),
    ] {
        click(&mut h, "strategy");
        click(&mut h, strategy);
        assert!(shows(&h, field), "{strategy}");
    }
    for _ in 0..4 {
        press(&mut h, Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(says(&h, " passes · "), planes, "undone");
}

#[test]
fn overlap_and_spacing_are_one() {
    let mut h = window(Some(sample("workpiece.stl")), &Answers::default());
    let value = |h: &Harness<'_, App>, label: &str| h.get_by_label(label).accesskit_node().value();
    assert_eq!(value(&h, "Overlap").as_deref(), Some("50.0 %"));
    type_into(&mut h, "Overlap", "30 %");
    assert_eq!(value(&h, "Spacing").as_deref(), Some("0.700 mm"));
    type_into(&mut h, "Spacing", "1.5");
    assert_eq!(value(&h, "Overlap").as_deref(), Some("-50.0 %"), "they do not meet");
}

#[test]
fn a_recipe_is_given_by_button_marked_changed_and_taken_away() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, "[layers]\nspacing_mm = 1.5\n")), &Answers::default());
    click(&mut h, row(2));
    let before = says(&h, " passes · ");
    open(&mut h, "Recipe library");
    reveal(&mut h, "apply shipped recipe Layers 6 mm");
    click(&mut h, "apply shipped recipe Layers 6 mm");
    assert!(shows(&h, "surface 2 has recipe Layers 6 mm"), "the row says so");
    assert_ne!(says(&h, " passes · "), before, "fewer lines");
    open(&mut h, "Recipe of surface 2: Layers 6 mm");
    assert!(shows(&h, "recipe reset Spacing") && shows(&h, "recipe reset Defocus distance"));
    assert!(!shows(&h, "recipe reset Power"), "the job's own");
    type_into(&mut h, "recipe Power", "750");
    assert!(shows(&h, "recipe reset Power"));
    assert_eq!(own_power(&mut h).as_deref(), Some("500 W"), "the job's stays");
    click(&mut h, "recipe reset Power");
    assert!(!shows(&h, "recipe reset Power"));
    reveal(&mut h, "recipe reset Spacing");
    click(&mut h, "recipe reset Spacing");
    assert!(says(&h, " (wanted ").ends_with("mm (wanted 1.50)"));
    for _ in 0..4 {
        press(&mut h, Modifiers::COMMAND, Key::Z);
    }
    assert!(!shows(&h, "surface 2 has recipe Layers 6 mm"), "undone");
    assert_eq!(says(&h, " passes · "), before);
    // The first value that is changed makes a recipe.
    type_into(&mut h, "recipe Speed", "12");
    assert!(shows(&h, "surface 2 has recipe Recipe 1"));
    click(&mut h, "recipe");
    click(&mut h, "none: the job's values");
    assert!(!shows(&h, "surface 2 has recipe Recipe 1"));
}

#[test]
fn recipes_are_dragged_kept_and_removed() {
    let folder = tempfile::tempdir().expect("a folder");
    let mine = folder.path().join("recipes");
    std::fs::create_dir(&mine).expect("a folder");
    std::fs::write(mine.join("torn.toml"), "name = \"To").expect("writes");
    let mut h = window_with_recipes(Some(job(&folder, "")), &Answers::default(), Some(mine.clone()));
    click(&mut h, row(3));
    open(&mut h, "Recipe library");
    reveal(&mut h, "Grinding 15 N");
    assert!(says(&h, "torn.toml").ends_with("correct or remove the file"));
    let (from, to) = (h.get_by_label("Grinding 15 N").rect().center(), h.get_by_label(row(2)).rect().center());
    drag(&mut h, from, to);
    assert!(shows(&h, "surface 2 has recipe Grinding 15 N") && !shows(&h, "surface 3 has recipe Grinding 15 N"));
    let (from, to) =
        (h.get_by_label("surface 2 has recipe Grinding 15 N").rect().center(), h.get_by_label(row(3)).rect().center());
    drag(&mut h, from, to);
    assert!(shows(&h, "surface 3 has recipe Grinding 15 N"), "dragged from row to row");
    open(&mut h, "Recipe of surface 3: Grinding 15 N");
    reveal(&mut h, "Changes apply to surface 2 too");
    type_into(&mut h, "recipe name", "Slow");
    assert!(shows(&h, "surface 2 has recipe Slow") && shows(&h, "surface 3 has recipe Slow"));
    reveal(&mut h, "Save to my recipes");
    click(&mut h, "Save to my recipes");
    assert!(mine.join("recipe-slow.toml").is_file());
    reveal(&mut h, "remove mine recipe Slow");
    click(&mut h, "remove mine recipe Slow");
    assert!(shows(&h, "Removed Slow") && !shows(&h, "remove mine recipe Slow"));
    reveal(&mut h, "bring the removed recipe back");
    click(&mut h, "bring the removed recipe back");
    reveal(&mut h, "remove mine recipe Slow");
    click(&mut h, "remove mine recipe Slow");
    assert!(!mine.join("recipe-slow.toml").exists() && mine.join("torn.toml").exists());
    reveal(&mut h, "remove job recipe Slow");
    click(&mut h, "remove job recipe Slow");
    assert!(!shows(&h, "surface 3 has recipe Slow"));
}

const STRONG: &str = "[recipe_of]\n2 = \"Strong\"\n[[recipes]]\nname = \"Strong\"\nstrategy = \"spiral\"\n\
                      [recipes.values]\n\"beam.power_w\" = 900.0\n";

#[test]
fn recipes_follow_their_surfaces_when_those_are_cut_anew() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, STRONG)), &Answers::default());
    let number = |h: &Harness<'_, App>| says(h, "has recipe Strong");
    let before = number(&h);
    type_into(&mut h, "Crease angle", "8");
    let after = number(&h);
    let of: u32 = after.split(' ').nth(1).and_then(|n| n.parse().ok()).expect("a number");
    assert!(shows(&h, &format!("surface {of} sphere Ø17.51")), "{after}: still the crater");
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert_eq!(number(&h), before);
}

#[test]
fn the_centre_of_a_spiral_is_its_surface_s_own_and_goes_before_the_recipe_s() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, STRONG)), &Answers::default());
    click(&mut h, row(2));
    open(&mut h, "Recipe of surface 2: Strong");
    press(&mut h, Modifiers::NONE, Key::F);
    menu_in_the_middle(&mut h);
    click(&mut h, "Spiral centre here");
    assert!(shows(&h, "Surface 2 from") && !shows(&h, "recipe reset centre"));
    reveal(&mut h, "surface reset start of 2");
    click(&mut h, "surface reset start of 2");
    assert!(!shows(&h, "Surface 2 from"));
}

#[test]
fn pins_that_a_merge_drops_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let pins = "[[pins]]\nsurface = 3\nline = 0\nat_mm = 1.0\n[[pins]]\nsurface = 3\nline = 2\nat_mm = 1.0\n";
    let mut h = window(Some(job(&folder, pins)), &Answers::default());
    click(&mut h, row(2));
    h.get_by_label(row(3)).click_modifiers(Modifiers::COMMAND);
    h.step();
    press(&mut h, Modifiers::COMMAND, Key::M);
    assert!(shows(&h, "2 pinned tilts of surface 3 were dropped"));
}

#[test]
fn remarks_stand_among_the_problems() {
    let folder = tempfile::tempdir().expect("a folder");
    let more = "[layers]\nspacing_mm = 2.0\nstrategy = \"offset\"\nborder = 9\n";
    let mut h = window(Some(job(&folder, more)), &Answers::default());
    assert!(says(&h, "surface 2: no line on its").ends_with("there is no border 10: the surface has one"));
    assert!(shows(&h, "Start from the whole outline"));
    click(&mut h, "strategy");
    click(&mut h, "planes – parallel planes, equally far apart");
    assert!(h.query_by_label_contains("there is no border 10").is_none());
}

#[test]
fn recipes_stand_side_by_side() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(Some(job(&folder, STRONG)), &Answers::default());
    open(&mut h, "Recipe library");
    reveal(&mut h, "Compare…");
    click(&mut h, "Compare…");
    for cell in ["Power, W 500", "Power, W 900", "Strategy planes", "Strategy spiral"] {
        assert!(shows(&h, cell), "{cell}");
    }
    assert!(h.query_all_by_label("Spot diameter, mm 1").next().is_none(), "they agree in it");
    click(&mut h, "compare shipped recipe Remanufacturing 800 W");
    snapshot(&mut h, "recipes");
    assert!(shows(&h, "Power, W 800") && shows(&h, "Speed, mm/s 8"));
    click(&mut h, "also rows that do not differ");
    assert_eq!(h.query_all_by_label("Spot diameter, mm 1").count(), 3);
}

#[test]
fn the_achieved_spacing_is_shown_on_the_part() {
    let folder = tempfile::tempdir().expect("a folder");
    let recipes = "[layers]\nspacing_mm = 1.0\n[recipe_of]\n2 = \"Fine\"\n[[recipes]]\nname = \"Fine\"\nstrategy = \"adaptive\"\n\
                   [recipes.values]\n\"beam.speed_mm_s\" = 6.0\n";
    let mut h = window(Some(job(&folder, recipes)), &Answers::default());
    click(&mut h, row(2));
    press(&mut h, Modifiers::NONE, Key::F);
    press(&mut h, Modifiers::NONE, Key::I);
    for label in ["Achieved spacing", "scale of the spacing", "1.00 mm"] {
        h.get_by_label(label);
    }
    assert!(says(&h, "least ").contains(" mm on surface "));
    open(&mut h, "Recipe of surface 2: Fine");
    let said = says(&h, " (wanted ");
    assert!(said.starts_with("spacing ") && said.ends_with(" mm (wanted 1.00)"), "{said}");
    reveal(&mut h, &said);
    reveal(&mut h, "Recipe of surface 2: Fine");
    snapshot(&mut h, "spacing");
    press(&mut h, Modifiers::NONE, Key::I);
    assert!(!shows(&h, "scale of the spacing"));
}
