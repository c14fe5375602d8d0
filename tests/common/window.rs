//! The real window in a test: driven by its labels, rendered without a screen.
#![allow(dead_code, reason = "each test file uses its own share")]

use super::glow_renderer::GlowTestRenderer;
use clearbeam::app::{App, FileDialogs, Purpose, WindowDialogs};
use eframe::egui::{self, Key, Modifiers};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use egui_kittest::{Harness, SnapshotOptions};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// Answers file dialogs at once.
#[derive(Clone, Default)]
pub struct Answers(pub Arc<Mutex<Vec<(Purpose, PathBuf)>>>);

impl FileDialogs for Answers {
    fn ask(
        &self,
        purpose: Purpose,
        _name: &str,
        _ctx: &egui::Context,
        answer: Box<dyn FnOnce(Option<PathBuf>) + Send>,
    ) {
        let known = self.0.lock().expect("not poisoned");
        answer(known.iter().find(|(p, _)| *p == purpose).map(|(_, path)| path.clone()));
    }
}

pub fn sample(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/samples").join(name)
}

pub fn window(open: Option<PathBuf>, answers: &Answers) -> Harness<'static, App> {
    window_with_recipes(open, answers, None)
}

/// The real window with a folder for the user's recipes.
pub fn window_with_recipes(
    open: Option<PathBuf>,
    answers: &Answers,
    recipes: Option<PathBuf>,
) -> Harness<'static, App> {
    let answers = answers.clone();
    let mut harness = built(move |cc| App::new(cc, Box::new(answers), open).with_recipes(recipes));
    settle(&mut harness);
    harness
}

fn built(app: impl FnOnce(&eframe::CreationContext<'_>) -> App) -> Harness<'static, App> {
    Harness::builder()
        .with_size(egui::vec2(1280.0, 800.0))
        .with_render_cursor(false)
        .with_step_dt(1.0 / 60.0)
        .renderer(GlowTestRenderer::new())
        .build_eframe(move |cc| app(cc))
}

/// The real window with the file dialogs that it draws itself, from this folder on.
pub fn window_with_own_dialogs(open: Option<PathBuf>, folder: &Path) -> Harness<'static, App> {
    let dialogs = WindowDialogs::in_window(folder);
    let mut harness = built(move |cc| App::new(cc, Box::new(dialogs), open));
    settle(&mut harness);
    harness
}

/// Runs frames until a label is there.
pub fn wait_for(harness: &mut Harness<'_, App>, label: &str) {
    for _ in 0..2000 {
        harness.step();
        if harness.query_all_by_label(label).next().is_some() {
            return harness.run_steps(8);
        }
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    panic!("{label} never came");
}

/// Runs frames until nothing is being computed.
pub fn settle(harness: &mut Harness<'_, App>) {
    for _ in 0..3000 {
        harness.step();
        if harness.state().is_settled() {
            // What has just come up takes no clicks until it is faded in.
            harness.run_steps(8);
            if harness.state().is_settled() {
                return;
            }
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    panic!("the window never came to rest");
}

/// The tabs of the settings.
const TABS: [&str; 7] = ["Path", "Beam", "Part", "Robot", "Dose", "Scan", "Weld"];

/// Opens a tab of the settings.
pub fn tab(harness: &mut Harness<'_, App>, name: &str) {
    harness.get_by_label(&format!("settings: {name}")).click();
    settle(harness);
}

/// Opens the tab in which a widget stands, as somebody does who looks for it.
pub fn bring(harness: &mut Harness<'_, App>, label: &str) {
    let is_there = |harness: &Harness<'_, App>| harness.query_all_by_label(label).next().is_some();
    for name in TABS {
        if is_there(harness) {
            return;
        }
        if harness.query_all_by_label(&format!("settings: {name}")).next().is_some() {
            tab(harness, name);
        }
    }
}

pub fn click(harness: &mut Harness<'_, App>, label: &str) {
    bring(harness, label);
    harness.get_by_label(label).click();
    settle(harness);
}

/// Brings a widget of a panel into sight.
pub fn reveal(harness: &mut Harness<'_, App>, label: &str) {
    bring(harness, label);
    harness.get_by_label(label).scroll_to_me();
    settle(harness);
}

/// The words of the one widget whose label holds these.
pub fn says(harness: &Harness<'_, App>, part: &str) -> String {
    let node = harness.get_by_label_contains(part).accesskit_node();
    node.label().or_else(|| node.value()).unwrap_or_default()
}

/// Replaces the text of a field.
pub fn type_into(harness: &mut Harness<'_, App>, label: &str, text: &str) {
    reveal(harness, label);
    click(harness, label);
    press(harness, Modifiers::COMMAND, Key::A);
    harness.get_by_label(label).type_text(text);
    press(harness, Modifiers::NONE, Key::Enter);
}

/// Opens the menu of the place in the middle of the 3D view.
pub fn menu_in_the_middle(harness: &mut Harness<'_, App>) {
    let middle = harness.get_by_label("3D view").rect().center();
    harness.hover_at(middle);
    harness.step();
    harness.get_by_label("3D view").click_secondary();
    settle(harness);
}

/// A job file beside a copy of a sample.
pub fn job_on(folder: &tempfile::TempDir, name: &str, text: &str) -> PathBuf {
    let stl = format!("{name}.stl");
    std::fs::copy(sample(&stl), folder.path().join(&stl)).expect("copies");
    let file = folder.path().join("job.toml");
    std::fs::write(&file, format!("[part]\nfile = \"{stl}\"\n{text}")).expect("writes");
    file
}

pub fn press(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    harness.key_press_modifiers(modifiers, key);
    settle(harness);
}

pub fn snapshot(harness: &mut Harness<'_, App>, name: &str) {
    // Software OpenGL differs from version to version in single pixels of edges.
    let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(4000);
    harness.snapshot_options(name, &options);
}

/// Drags from one place to another, as a hand does: in steps.
pub fn drag(harness: &mut Harness<'_, App>, from: egui::Pos2, to: egui::Pos2) {
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    for i in 1..=8 {
        harness.step();
        harness.hover_at(from.lerp(to, i as f32 / 8.0));
    }
    harness.step();
    harness.drop_at(to);
    settle(harness);
}

/// Clicks a place.
pub fn click_at(harness: &mut Harness<'_, App>, at: egui::Pos2) {
    harness.hover_at(at);
    harness.step();
    harness.drag_at(at);
    harness.step();
    harness.drop_at(at);
    settle(harness);
}
