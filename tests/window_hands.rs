//! What hands do in the view: boxes and strokes that select, measuring, handles that move, and whose habits it follows.

mod common;

use clearbeam::app::{App, Command, Purpose};
use clearbeam::view::{Navigation, ViewSize};
use common::window::{Answers, click, click_at, drag, press, sample, settle, tab, window};
use eframe::egui::{Key, Modifiers, Pos2, Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use nalgebra::{Point3, Vector3};

fn view(h: &Harness<'_, App>) -> Rect {
    h.get_by_label("3D view").rect()
}

fn opened() -> Harness<'static, App> {
    window(Some(sample("workpiece.stl")), &Answers::default())
}

/// Where a point of the part is on the screen.
fn on_screen(h: &Harness<'_, App>, at: Point3<f64>) -> Pos2 {
    let rect = view(h);
    let size = ViewSize::new(f64::from(rect.width()), f64::from(rect.height()));
    let (x, y, _) = h.state().camera().project(&at, size).expect("before the eye");
    rect.min + vec2(x as f32, y as f32)
}

#[test]
fn a_box_selects_what_is_seen_in_it() {
    let mut h = opened();
    h.state_mut().give(Command::Navigate(Navigation::Cad), &[]);
    settle(&mut h);
    let (camera, rect) = (*h.state().camera(), view(&h));
    drag(&mut h, rect.left_top() + vec2(8.0, 60.0), rect.right_bottom() - vec2(8.0, 8.0));
    let all = h.state().selected().clone();
    assert_eq!(*h.state().camera(), camera, "a box turns nothing");
    // From the front right and above: its back, its bottom and its left are not seen.
    assert!(all.len() > 6 && all.len() < 18, "{all:?}");
    let boss = on_screen(&h, Point3::new(40.0, -14.0, 20.0));
    let (from, to) = (boss - vec2(14.0, 14.0), boss + vec2(14.0, 14.0));
    drag(&mut h, from, to);
    assert!(h.state().selected().len() < all.len(), "a smaller box selects anew: {:?}", h.state().selected());
    h.state_mut().give(Command::Navigate(Navigation::Slicer), &[]);
    drag(&mut h, rect.center(), rect.center() + vec2(50.0, 10.0));
    assert_ne!(*h.state().camera(), camera, "the left button orbits as in a slicer");
}

#[test]
fn painting_selects_what_it_goes_over() {
    let mut h = opened();
    h.state_mut().give(Command::SelectByPainting, &[]);
    settle(&mut h);
    let (camera, rect) = (*h.state().camera(), view(&h));
    drag(&mut h, rect.center() - vec2(120.0, 0.0), rect.center() + vec2(120.0, 40.0));
    assert!(h.state().selected().len() >= 2, "{:?}", h.state().selected());
    assert_eq!(*h.state().camera(), camera);
    press(&mut h, Modifiers::NONE, Key::Escape);
    assert!(h.query_by_label_contains("Paint over surfaces").is_none());
}

#[test]
fn two_places_are_measured() {
    let mut h = opened();
    h.state_mut().give(Command::Measure, &[]);
    settle(&mut h);
    let centre = view(&h).center();
    for at in [centre + vec2(95.0, 10.0), centre + vec2(95.0, 60.0)] {
        click_at(&mut h, at);
    }
    let node = h.get_by_label_contains("mm apart").accesskit_node();
    let said = node.label().or_else(|| node.value()).expect("words");
    // Both on the front of the plate: their distance is that of its parts, and lies in the plane.
    let number = |before: &str| -> f64 {
        let rest = said.split(before).nth(1).expect(before).trim_start();
        rest.split([' ', ';']).next().expect("digits").parse().expect("a number")
    };
    let parts = ["Δx", "Δy", "Δz"].map(number);
    let apart: f64 =
        said.split(" mm apart").next().and_then(|s| s.rsplit(' ').next()).expect("mm").parse().expect("a number");
    assert!((Vector3::from(parts).norm() - apart).abs() < 2e-3, "{said}");
    assert!(apart > 1.0 && said.contains("parallel, 0.000 mm apart"), "{said}");
    press(&mut h, Modifiers::NONE, Key::Escape);
    assert!(h.query_by_label_contains("mm apart").is_none());
}

#[test]
fn a_clamp_is_moved_by_its_handles_and_put_on_a_face() {
    let answers = Answers::default();
    answers.0.lock().expect("fresh").push((Purpose::Clamp, sample("front_shaft.stl")));
    let mut h = window(Some(sample("workpiece.stl")), &answers);
    tab(&mut h, "Beam");
    click(&mut h, "Clamps");
    click(&mut h, "Add clamp…");
    let clamp = |h: &Harness<'_, App>| h.state().document().job().clamps[0].clone();
    click(&mut h, "move clamp 1 in the view");
    let camera = *h.state().camera();
    let origin = on_screen(&h, Point3::origin());
    let along = (on_screen(&h, Point3::new(1.0, 0.0, 0.0)) - origin).normalized();
    drag(&mut h, origin + along * 60.0, origin + along * 110.0);
    let [x, y, z] = clamp(&h).position_mm;
    assert!(x > 1.0 && x % 0.5 == 0.0 && y == 0.0 && z == 0.0, "{:?}", clamp(&h).position_mm);
    assert_eq!(*h.state().camera(), camera, "a handle turns no camera");
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert_eq!(clamp(&h).position_mm, [0.0; 3], "a drag is one step");
    press(&mut h, Modifiers::NONE, Key::Escape);
    click(&mut h, "put clamp 1 on a face");
    let front = view(&h).center() + vec2(95.0, 10.0);
    click_at(&mut h, front);
    assert_ne!(clamp(&h).position_mm, [0.0; 3]);
    click(&mut h, "unit of clamp 1: inch");
    assert_eq!(clamp(&h).units, clearbeam::part::Units::Inch);
}

#[test]
fn several_surfaces_are_named_at_once() {
    let mut h = opened();
    h.state_mut().give(Command::Rename, &[4, 5]);
    settle(&mut h);
    h.get_by_label("surface name").type_text("Bore");
    press(&mut h, Modifiers::NONE, Key::Enter);
    let name = |h: &Harness<'_, App>, n: u32| {
        h.state().document().job().settings.of(clearbeam::part::SurfaceId(n)).name.clone()
    };
    assert_eq!([name(&h, 4), name(&h, 5)], ["Bore 1", "Bore 2"]);
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert_eq!([name(&h, 4), name(&h, 5)], ["", ""], "one step");
}

#[test]
fn a_part_that_is_cut_open_is_picked_inside() {
    let mut h = opened();
    // The block at the left; the toolbar grows by the cut's own fields, and the view moves with it.
    let at = |h: &Harness<'_, App>| view(h).center() + vec2(-70.0, -10.0);
    let selected_at = |h: &mut Harness<'_, App>| {
        let place = at(h);
        click_at(h, place);
        h.state().selected().clone()
    };
    let block = selected_at(&mut h);
    assert_eq!(block.len(), 1);
    h.state_mut().give(Command::Toggle(clearbeam::app::Toggle::Cut), &[]);
    settle(&mut h);
    click(&mut h, "cut across x");
    let behind = selected_at(&mut h);
    assert_ne!(behind, block, "the block is cut away");
    click(&mut h, "Other side");
    assert_eq!(selected_at(&mut h), block, "the block is what stays");
}
