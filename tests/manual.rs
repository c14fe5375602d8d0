//! The operator's manual: its pictures are those of the window as it is, in both languages, and its pages name nothing
//! that is not there. The language is the whole process's, so one test makes all pictures, one language after the other.

mod common;

use clearbeam::app::{App, Command, Jump, Purpose, Toggle};
use clearbeam::text::{choose, language_of};
use common::scanned::{files, scan};
use common::window::{Answers, job_on, sample, settle, window};
use eframe::egui::vec2;
use egui_kittest::kittest::Queryable as _;
use egui_kittest::{Harness, SnapshotOptions, image_snapshot_options};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

const LANGUAGES: [&str; 2] = ["en", "zh"];
const FIRST: &str = "[clean]\nsurfaces = [2, 3]\n[layers]\nspacing_mm = 1.0\n[cell]\nrobot = \"mz04\"\n";

fn book(language: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs").join(language).join("src")
}

/// The window of one language, and what it is asked for.
struct Scene {
    language: &'static str,
    folder: tempfile::TempDir,
    answers: Answers,
}

impl Scene {
    fn window(&self, open: Option<PathBuf>) -> Harness<'static, App> {
        let mut h = window(open, &self.answers);
        h.set_size(vec2(1000.0, 640.0));
        settle(&mut h);
        h
    }

    fn job(&self, text: &str) -> Harness<'static, App> {
        self.window(Some(job_on(&self.folder, "workpiece", text)))
    }

    /// A word by its language.
    fn word(&self, [english, chinese]: [&'static str; 2]) -> &'static str {
        if self.language == "en" { english } else { chinese }
    }

    fn click(&self, h: &mut Harness<'_, App>, words: [&'static str; 2]) {
        h.get_by_label(self.word(words)).click();
        settle(h);
    }

    fn keep(&self, h: &mut Harness<'_, App>, name: &str) {
        h.remove_cursor();
        h.run_steps(4);
        // Software OpenGL differs from version to version in single pixels of edges.
        let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(4000);
        let picture = h.render().expect("drawn");
        image_snapshot_options(&picture, name, &options.output_path(book(self.language).join("pictures")));
    }
}

fn give(h: &mut Harness<'_, App>, command: Command) {
    h.state_mut().give(command, &[]);
    settle(h);
}

#[test]
fn the_pictures_are_those_of_the_window() {
    for language in LANGUAGES {
        choose(language_of(language).expect("a language"));
        let scene = Scene { language, folder: tempfile::tempdir().expect("a folder"), answers: Answers::default() };
        first_job(&scene);
        checking(&scene);
        measured(&scene);
    }
}

fn first_job(scene: &Scene) {
    let mut h = scene.window(None);
    scene.keep(&mut h, "start");
    let mut h = scene.window(Some(sample("workpiece.stl")));
    h.state_mut().give(Command::Fit, &[2, 3]);
    h.state_mut().give(Command::Escape, &[]);
    give(&mut h, Command::Fit);
    h.state_mut().give(Command::SelectRow(clearbeam::app::RowStep::Below), &[2, 3]);
    settle(&mut h);
    scene.keep(&mut h, "first_surfaces");
    // The folder stands in the picture: it is the same everywhere.
    scene.answers.0.lock().expect("no panic").push((Purpose::Export, PathBuf::from("/programs/workpiece")));
    let mut h = scene.job(FIRST);
    scene.keep(&mut h, "first_planned");
    give(&mut h, Command::Export);
    scene.keep(&mut h, "first_export");
    scene.click(&mut h, ["Cancel", "取消"]);
    give(&mut h, Command::Palette);
    let hint = scene.word(["Type what you are looking for", "输入要查找的内容"]);
    h.get_by_label(hint).type_text(scene.word(["pass", "道"]));
    settle(&mut h);
    scene.keep(&mut h, "palette");
    let mut h = scene.job(FIRST);
    scene.click(&mut h, ["settings: Robot", "设置：机器人"]);
    give(&mut h, Command::Toggle(Toggle::Cell));
    scene.keep(&mut h, "robot");
    let mut h = scene.job(FIRST);
    h.set_size(vec2(800.0, 520.0));
    settle(&mut h);
    scene.keep(&mut h, "narrow");
}

fn checking(scene: &Scene) {
    let mut h =
        scene.job("[clean]\nsurfaces = [10]\n[layers]\ndirection = \"z\"\n[path]\ncorrection = \"section-plane\"\n");
    give(&mut h, Command::Toggle(Toggle::Beams));
    give(&mut h, Command::Go(Jump::NextPass));
    h.state_mut().give(Command::Fit, &[10]);
    settle(&mut h);
    scene.keep(&mut h, "problem");
    let text = "[clean]\nsurfaces = [2]\n[layers]\nspacing_mm = 2.0\n[path]\ncorrection = \"clearance\"\n";
    let mut h = scene.job(text);
    scene.click(&mut h, ["settings: Beam", "设置：光束"]);
    give(&mut h, Command::Toggle(Toggle::Beams));
    scene.keep(&mut h, "beam");
    give(&mut h, Command::Toggle(Toggle::AccessMap));
    scene.keep(&mut h, "access");
    give(&mut h, Command::Toggle(Toggle::AccessMap));
    give(&mut h, Command::Toggle(Toggle::Dose));
    scene.keep(&mut h, "dose");
    let mut h = scene.job("[clean]\nsurfaces = [2]\n[layers]\nspacing_mm = 2.0\n");
    for _ in 0..3 {
        give(&mut h, Command::Go(Jump::NextPass));
    }
    give(&mut h, Command::Toggle(Toggle::SectionPlane));
    scene.keep(&mut h, "section");
    let mut h = scene.job(FIRST);
    scene.click(&mut h, ["Recipe library", "工艺配方库"]);
    scene.keep(&mut h, "recipes");
}

fn measured(scene: &Scene) {
    let (folder, job) = files(&scan(), None);
    scene.answers.0.lock().expect("no panic").push((Purpose::Scan, folder.path().join("worn.ply")));
    let mut h = scene.window(Some(job));
    give(&mut h, Command::OpenScan);
    scene.keep(&mut h, "scan");
    let images = [
        (Purpose::WeldGray, "weld/gray.png"),
        (Purpose::WeldDepth, "weld/depth.png"),
        (Purpose::WeldCamera, "weld/camera.toml"),
    ];
    scene.answers.0.lock().expect("no panic").extend(images.map(|(purpose, file)| (purpose, sample(file))));
    let mut h = scene.window(None);
    give(&mut h, Command::OpenWeld);
    give(&mut h, Command::Toggle(Toggle::WeldImages));
    scene.keep(&mut h, "weld");
}

/// The text of a page.
fn page(language: &str, name: &str) -> String {
    std::fs::read_to_string(book(language).join(name)).unwrap_or_else(|e| panic!("{language}/{name}: {e}"))
}

/// What the links of a page lead to: pages and pictures.
fn links(text: &str) -> BTreeSet<String> {
    let all = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    all.filter(|to| !to.starts_with("http")).map(|to| to.split('#').next().unwrap_or(to).to_owned()).collect()
}

#[test]
fn both_books_have_the_same_pages_and_every_link_leads_somewhere() {
    let chapters = |language: &str| links(&page(language, "SUMMARY.md"));
    assert!(chapters("en").len() > 10);
    assert_eq!(chapters("en"), chapters("zh"));
    for language in LANGUAGES {
        for chapter in chapters(language) {
            let text = page(language, &chapter);
            assert!(text.starts_with("# "), "{language}/{chapter} has no title");
            for to in links(&text).iter().filter(|to| !to.is_empty()) {
                assert!(book(language).join(to).exists(), "{language}/{chapter} leads to {to}");
            }
        }
    }
}

/// The words of a line of messages, cut where something is filled in; of all in small letters, since sentences that stand
/// alone begin with a capital.
fn pieces(line: &str) -> Vec<String> {
    let words = line.split_once(" = ").map_or(line, |(_, words)| words).trim();
    let words = words.strip_prefix('*').unwrap_or(words);
    let words = if words.starts_with('[') { words.split_once("] ").map_or(words, |(_, w)| w) } else { words };
    let cut = words
        .split('{')
        .enumerate()
        .map(|(at, part)| if at == 0 { part } else { part.split_once('}').map_or("", |(_, p)| p) });
    cut.map(|part| part.trim().to_lowercase()).filter(|part| !part.is_empty()).collect()
}

/// Whether all pieces stand in a text, one behind the other.
fn in_order(pieces: &[String], mut text: &str) -> bool {
    pieces.iter().all(|piece| {
        let Some((_, rest)) = text.split_once(piece.as_str()) else { return false };
        text = rest;
        true
    })
}

/// Words in bold are those of the window: a manual of yesterday's words is worse than none.
#[test]
fn words_in_bold_are_words_of_the_window() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/text");
    let lines = |language: &str| -> Vec<String> {
        let files = std::fs::read_dir(root.join(language)).expect("the words");
        let text = files.map(|file| std::fs::read_to_string(file.expect("readable").path()).expect("text"));
        text.flat_map(|text| text.lines().map(str::to_owned).collect::<Vec<_>>()).collect()
    };
    for language in LANGUAGES {
        // The command that changes the language is named in the other one.
        let all: Vec<String> = LANGUAGES.into_iter().flat_map(lines).collect();
        let mut missing = Vec::new();
        for chapter in links(&page(language, "SUMMARY.md")) {
            for bold in page(language, &chapter).split("**").skip(1).step_by(2) {
                let words = bold.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase();
                // What is cut short in the manual, and what is filled in in the window.
                let cut: Vec<String> = words.split('…').map(|part| part.trim().to_owned()).collect();
                let is_of = |line: &&String| {
                    let pieces = pieces(line);
                    let is_long = pieces.iter().map(|piece| piece.chars().count()).sum::<usize>() > 3;
                    let begun = pieces.iter().take_while(|piece| words.contains(piece.as_str())).cloned();
                    let begun: Vec<String> = if words.ends_with('…') { begun.collect() } else { pieces.clone() };
                    let is_long = is_long && begun.iter().map(|piece| piece.chars().count()).sum::<usize>() > 3;
                    in_order(&cut, &line.to_lowercase()) || is_long && in_order(&begun, &words)
                };
                if !all.iter().any(|line| is_of(&line)) {
                    missing.push(format!("{chapter}: {words}"));
                }
            }
        }
        assert!(missing.is_empty(), "{language}: {missing:#?}");
    }
}
