//! A weld in the real window: its images are opened, its bead found, the mask changed by threshold and brush, areas chosen,
//! strategies and roughness set; each step undone. Images that cannot be used are told, and change nothing.

mod common;

use clearbeam::app::{App, Command, Purpose, Toggle};
use clearbeam::document::model::{AreaChoice, GrindingStrategy, RoughnessReading};
use clearbeam::document::{Edit, WeldEdit};
use clearbeam::sample::weld_panel::{self, WeldScene};
use common::window::{Answers, click, drag, job_on, press, reveal, sample, says, settle, snapshot, type_into, window};
use eframe::egui::{Key, Modifiers, Pos2, Rect, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use std::path::PathBuf;

fn answers(gray: PathBuf) -> Answers {
    let answers = Answers::default();
    answers.0.lock().expect("fresh").extend([
        (Purpose::WeldGray, gray),
        (Purpose::WeldDepth, sample("weld/depth.png")),
        (Purpose::WeldCamera, sample("weld/camera.toml")),
    ]);
    answers
}

/// The window with the sample's images opened in it.
fn opened() -> Harness<'static, App> {
    let mut h = window(None, &answers(sample("weld/gray.png")));
    h.state_mut().give(Command::OpenWeld, &[]);
    settle(&mut h);
    h
}

fn undo(h: &mut Harness<'_, App>) {
    press(h, Modifiers::COMMAND, Key::Z);
}

/// What a field holds.
fn number(h: &Harness<'_, App>, label: &str) -> f64 {
    let node = h.get_by_label(label);
    let node = node.accesskit_node();
    let text = node.value().unwrap_or_default();
    node.numeric_value().or_else(|| text.trim().parse().ok()).expect("a number")
}

fn rect_of(h: &Harness<'_, App>, label: &str) -> Rect {
    h.get_by_label(label).rect()
}

#[test]
fn the_images_are_opened_and_the_bead_is_found() {
    let mut h = opened();
    let weld = h.state().document().job().weld.clone();
    assert!(h.state().document().job().part.file.ends_with("depth.png"));
    assert_eq!((weld.images.gray.sha256.len(), weld.images.depth.sha256.len()), (64, 64));
    assert!(!h.state().document().is_dirty(), "as a part that was opened");
    let bead = says(&h, "1 bead");
    let height: f64 =
        bead.split("mm high").next().and_then(|s| s.split_whitespace().last()?.parse().ok()).expect(&bead);
    assert!((height - 15.0).abs() < 0.3, "{bead}");
    assert!(says(&h, "2 defect area").contains(|c: char| c.is_ascii_digit()));
    assert!(h.query_by_label("scale of the bead's height").is_some(), "the legend of its points");
    // From the camera's side.
    assert!((h.state().camera().pitch_rad + std::f64::consts::FRAC_PI_2).abs() < 1e-9);
    for command in [Command::Toggle(Toggle::Dose), Command::Toggle(Toggle::BeforeCorrection), Command::Merge] {
        assert!(!h.state().can(command), "{command:?}");
    }
    h.state_mut().give(Command::Toggle(Toggle::WeldImages), &[]);
    settle(&mut h);
    for image in ["grey image of the weld", "depth image of the weld", "scale of the depths"] {
        assert!(h.query_by_label(image).is_some(), "{image}");
    }
    snapshot(&mut h, "weld");
}

#[test]
fn the_threshold_is_dragged_and_follows_the_histogram_again() {
    let mut h = opened();
    let found = number(&h, "level of the threshold");
    let plot = "histogram of the weld's grey image";
    reveal(&mut h, plot);
    let rect = rect_of(&h, plot);
    let at = |level: f64| pos2(rect.left() + rect.width() * (level / 255.0) as f32, rect.center().y);
    drag(&mut h, at(found), at(found + 40.0));
    let given = h.state().document().job().weld.threshold.expect("by hand");
    assert!((given - found - 40.0).abs() < 4.0, "{found} → {given}");
    // Elsewhere nothing is taken hold of.
    drag(&mut h, at(20.0), at(60.0));
    assert_eq!(h.state().document().job().weld.threshold, Some(given));
    undo(&mut h);
    assert_eq!(h.state().document().job().weld.threshold, None, "one drag is one step");
    // Beyond all levels there is no area, and the way back is still there.
    type_into(&mut h, "level of the threshold", "254");
    assert!(h.state().why_no_plan().expect("a reason").contains("no area stands out"));
    click(&mut h, "from the histogram");
    assert_eq!(h.state().why_no_plan(), None);
}

#[test]
fn a_stroke_is_one_step_and_what_was_painted_is_taken_off() {
    let mut h = opened();
    h.state_mut().give(Command::Toggle(Toggle::WeldImages), &[]);
    settle(&mut h);
    let place = |h: &Harness<'_, App>, x: f32, y: f32| -> Pos2 {
        let rect = rect_of(h, "grey image of the weld");
        rect.left_top() + rect.size() * eframe::egui::vec2(x, y)
    };
    let painted = |h: &Harness<'_, App>| h.state().document().job().weld.painted.clone();
    // Without a brush a drag shifts the images alone.
    let (from, to) = (place(&h, 0.2, 0.75), place(&h, 0.5, 0.75));
    drag(&mut h, from, to);
    assert!(painted(&h).is_empty());
    click(&mut h, "Whole");
    click(&mut h, "Add");
    drag(&mut h, from, to);
    let [stroke] = &painted(&h)[..] else { panic!("{:?}", painted(&h)) };
    assert!(stroke.adds && stroke.way_px.len() > 3, "{stroke:?}");
    let [first, last] = [stroke.way_px[0], stroke.way_px[stroke.way_px.len() - 1]];
    assert!((first[0] - 128.0).abs() < 30.0 && (last[0] - 320.0).abs() < 30.0, "{stroke:?}");
    click(&mut h, "Erase");
    drag(&mut h, from, to);
    assert_eq!(painted(&h).iter().map(|s| s.adds).collect::<Vec<_>>(), [true, false]);
    undo(&mut h);
    assert_eq!(painted(&h).len(), 1);
    click(&mut h, "Take off what was painted");
    assert!(painted(&h).is_empty());
    undo(&mut h);
    undo(&mut h);
    assert!(painted(&h).is_empty() && h.state().document().undo_step().is_none());
}

#[test]
fn areas_strategies_and_roughness_are_chosen() {
    let mut h = opened();
    let weld = |h: &Harness<'_, App>| h.state().document().job().weld.clone();
    reveal(&mut h, "grind area 1");
    click(&mut h, "grind area 1");
    let AreaChoice::At(places) = weld(&h).areas else { panic!("chosen") };
    assert_eq!(places.len(), 1);
    click(&mut h, "grind area 1");
    assert_eq!(weld(&h).areas, AreaChoice::All);

    for (label, of) in [("Areas without height zigzag", false), ("Beads spiral", true)] {
        reveal(&mut h, label);
        click(&mut h, label);
        let expected = if of { GrindingStrategy::Spiral } else { GrindingStrategy::Zigzag };
        assert_eq!(weld(&h).strategy_of(of), expected);
    }
    assert!(h.query_by_label("Areas without height along").is_none(), "only a bead has a centre line");

    reveal(&mut h, "Roughness");
    click(&mut h, "Roughness");
    reveal(&mut h, "Add point");
    click(&mut h, "Add point");
    type_into(&mut h, "roughness before at point 1", "2.9");
    reveal(&mut h, "measured after at point 1");
    click(&mut h, "measured after at point 1");
    type_into(&mut h, "roughness after at point 1", "0.6");
    let reading = RoughnessReading { point: 1, before_um: 2.9, after_um: Some(0.6) };
    assert_eq!(weld(&h).roughness, [reading]);
    assert!(says(&h, "Mean of 1 point").contains("79.3 % less"));
    click(&mut h, "take point 1 out");
    assert!(weld(&h).roughness.is_empty());
    undo(&mut h);
    assert_eq!(weld(&h).roughness, [reading]);
}

#[test]
fn times_and_roughness_follow_what_they_hang_on() {
    let mut h = opened();
    let report = |h: &Harness<'_, App>| h.state().plan().expect("a plan").report.weld.clone().expect("a weld");
    let sums = |h: &Harness<'_, App>| report(h).times.iter().map(|t| t.one_way_s + t.zigzag_s).collect::<Vec<_>>();
    let quicker = |now: &[f64], before: &[f64]| now.len() == 8 && now.iter().zip(before).all(|(n, b)| n < b);
    let first = sums(&h);
    h.state_mut().set("layers.spacing_mm", 8.0);
    settle(&mut h);
    let fewer_lines = sums(&h);
    assert!(quicker(&fewer_lines, &first), "{fewer_lines:?} {first:?}");
    h.state_mut().set("weld.acceleration_mm_s2", 2000.0);
    settle(&mut h);
    let brisk = sums(&h);
    assert!(quicker(&brisk, &fewer_lines), "{brisk:?} {fewer_lines:?}");
    let reading = RoughnessReading { point: 1, before_um: 3.0, after_um: Some(0.6) };
    h.state_mut().send(Edit::Grind(Box::new(WeldEdit::Roughness(vec![reading]))));
    settle(&mut h);
    assert_eq!(report(&h).roughness.map(|r| (r.points, r.after_um)), Some((1, 0.6)));
}

#[test]
fn images_that_cannot_be_used_are_told_and_open_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window(None, &answers(folder.path().join("gone.png")));
    h.state_mut().give(Command::OpenWeld, &[]);
    settle(&mut h);
    assert!(says(&h, "gone.png").len() > 8);
    assert!(h.state().surfaces().is_empty());
}

#[test]
fn on_a_part_the_images_are_laid_and_on_another_they_are_refused_and_undone() {
    let folder = tempfile::tempdir().expect("a folder");
    let job = job_on(&folder, "front_shaft", "[clean]\nsurfaces = [1]\n[layers]\nspacing_mm = 8.0\n");
    let mut h = window(Some(job), &answers(sample("weld/gray.png")));
    let before = h.state().document().job().clone();
    h.state_mut().give(Command::OpenWeld, &[]);
    settle(&mut h);
    let now = h.state().document().job();
    assert!(now.weld.is_there() && now.part == before.part, "the part stays");
    assert!(h.state().why_no_plan().expect("a reason").contains("lies nowhere on the part"));
    undo(&mut h);
    assert_eq!(*h.state().document().job(), before);
    assert!(h.state().can(Command::Export));
}

/// Whatever else took the images anew: what is planned is of those that the job knows, until he takes the others.
#[test]
fn images_that_have_changed_are_told_and_one_click_takes_each() {
    let folder = tempfile::tempdir().expect("a folder");
    let copied = ["gray.png", "depth.png", "camera.toml"].map(|name| {
        let file = folder.path().join(name);
        std::fs::copy(sample("weld").join(name), &file).expect("copied");
        file
    });
    let [gray, depth, camera] = copied.clone();
    let answers = Answers::default();
    let named = [(Purpose::WeldGray, gray), (Purpose::WeldDepth, depth), (Purpose::WeldCamera, camera)];
    answers.0.lock().expect("fresh").extend(named);
    let mut h = window(None, &answers);
    h.state_mut().give(Command::OpenWeld, &[]);
    settle(&mut h);
    assert_eq!(h.state().why_no_plan(), None);
    let (grey, far) = WeldScene::new().images(0.3, 9);
    std::fs::write(&copied[0], weld_panel::grey_png(&grey)).expect("written");
    std::fs::write(&copied[1], weld_panel::depth_png(&far)).expect("written");
    h.state_mut().give(Command::Plan, &[]);
    for is_focused in [false, true] {
        h.input_mut().focused = is_focused;
        h.step();
    }
    settle(&mut h);
    // The depth image is the part as well.
    click(&mut h, "Use the changed part");
    let why = h.state().why_no_plan().expect("a reason");
    assert!(why.contains("gray.png is another file"), "{why}");
    assert!(!h.state().can(Command::Export));
    click(&mut h, "Use the changed image");
    assert_eq!(h.state().why_no_plan(), None);
    assert!(h.state().can(Command::Export));
}

#[test]
fn unsaved_changes_are_asked_about_before_other_images_begin_a_new_job() {
    let mut h = opened();
    let speed = h.state().document().job().beam.speed_mm_s;
    h.state_mut().send(Edit::Set("beam.speed_mm_s", speed + 1.0));
    h.state_mut().give(Command::OpenWeld, &[]);
    h.run_steps(3);
    assert!(says(&h, "Save changes?").len() > 4);
    click(&mut h, "Don't save");
    assert_eq!(h.state().document().job().beam.speed_mm_s, speed);
    assert!(!h.state().document().is_dirty());
}
