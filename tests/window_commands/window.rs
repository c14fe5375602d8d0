//! The real window of a test with the files around it, and what can be seen of it.

use crate::common::window::{Answers, job_on, press, sample, settle, window};
use clearbeam::app::{App, Command, Purpose};
use clearbeam::document::{Edit, Job};
use clearbeam::part::SurfaceId;
use eframe::egui::{self, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use std::path::PathBuf;

/// The images of a weld, as they are asked for.
const WELD: [(Purpose, &str); 3] = [
    (Purpose::WeldGray, "weld/gray.png"),
    (Purpose::WeldDepth, "weld/depth.png"),
    (Purpose::WeldCamera, "weld/camera.toml"),
];

/// The real window, and the folder that its files are in.
pub struct Window {
    pub h: Harness<'static, App>,
    folder: tempfile::TempDir,
}

impl Window {
    pub fn on(name: &str, text: &str) -> Window {
        let folder = tempfile::tempdir().expect("a folder");
        let job = job_on(&folder, name, text);
        let answers = Answers::default();
        answers.0.lock().expect("fresh").extend([
            (Purpose::Open, sample("front_shaft.stl")),
            (Purpose::Scan, folder.path().join("scan.xyz")),
            (Purpose::SaveJob, folder.path().join("other.toml")),
            (Purpose::Export, folder.path().join("program")),
            (Purpose::ExportDryRun, folder.path().join("program")),
        ]);
        answers.0.lock().expect("fresh").extend(WELD.map(|(purpose, file)| (purpose, sample(file))));
        Window { h: window(Some(job), &answers), folder }
    }

    /// The window with the images of a weld, which are its part.
    pub fn on_weld() -> Window {
        let answers = Answers::default();
        answers.0.lock().expect("fresh").extend(WELD.map(|(purpose, file)| (purpose, sample(file))));
        let mut w = Window { h: window(None, &answers), folder: tempfile::tempdir().expect("a folder") };
        w.give(Command::OpenWeld, &[]);
        assert!(w.job().weld.is_there());
        w
    }

    pub fn app(&self) -> &App {
        self.h.state()
    }

    pub fn job(&self) -> Job {
        self.app().document().job().clone()
    }

    pub fn give(&mut self, command: Command, selected: &[u32]) {
        self.h.state_mut().give(command, selected);
        settle(&mut self.h);
    }

    pub fn send(&mut self, edit: Edit) {
        self.h.state_mut().send(edit);
        settle(&mut self.h);
    }

    /// Takes the last edit back: the next command finds the job as it was.
    pub fn undo(&mut self) {
        press(&mut self.h, Modifiers::COMMAND, Key::Z);
    }

    pub fn to_clean(&self) -> Vec<u32> {
        let ids = self.job().settings.chosen(self.app().surfaces().into_iter().map(SurfaceId));
        ids.into_iter().map(|id| id.0).collect()
    }

    pub fn says(&self, part: &str) -> bool {
        self.h.query_by_label_contains(part).is_some()
    }

    pub fn file(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The pixels of the 3D view, without what lies over it.
    pub fn picture(&mut self) -> Vec<u8> {
        self.h.remove_cursor();
        settle(&mut self.h);
        let rect = self.h.get_by_label("3D view").rect().shrink(2.0);
        let image = self.h.render().expect("rendered");
        let at = |v: f32| v.round() as u32;
        let rows = at(rect.top())..at(rect.bottom());
        rows.flat_map(|y| (at(rect.left())..at(rect.right())).flat_map(move |x| [x, y]))
            .collect::<Vec<u32>>()
            .chunks_exact(2)
            .flat_map(|xy| image.get_pixel(xy[0], xy[1]).0)
            .collect()
    }

    /// Clicks the front of the plate, right of the middle of the first view.
    pub fn click_part(&mut self) {
        let front = self.h.get_by_label("3D view").rect().center() + egui::vec2(95.0, 10.0);
        for pressed in [true, false] {
            self.h.hover_at(front);
            let (pos, button, modifiers) = (front, egui::PointerButton::Primary, Modifiers::NONE);
            self.h.event(egui::Event::PointerButton { pos, button, pressed, modifiers });
            self.h.step();
        }
        settle(&mut self.h);
    }
}
