//! The empty window: drop a part, take a sample, go on with a recent job.

use super::super::App;
use super::super::command::Command;
use crate::sample::SAMPLES;
use crate::text::{Sentence, say};
use eframe::egui::{self, RichText};
use std::path::PathBuf;

impl App {
    pub(in super::super) fn start(&mut self, ui: &mut egui::Ui) {
        ui.vertical_centered(|ui| {
            ui.add_space((ui.available_height() * 0.16).max(20.0));
            ui.label(RichText::new(say!(start_name)).size(34.0).strong());
            ui.add_space(4.0);
            ui.label(RichText::new(say!(start_claim)).size(16.0).weak());
            ui.add_space(22.0);
            let frame = egui::Frame::group(ui.style()).inner_margin(26);
            frame.show(ui, |ui| {
                ui.set_width(460.0);
                ui.vertical_centered(|ui| {
                    ui.label(RichText::new(say!(start_drop)).size(20.0));
                    ui.add_space(6.0);
                    if ui.button(RichText::new(say!(start_open)).size(16.0)).clicked() {
                        self.run(Command::Open);
                    }
                });
            });
            ui.add_space(14.0);
            ui.label(RichText::new(say!(start_steps)).size(14.0));
            ui.add_space(18.0);
            ui.label(RichText::new(say!(start_samples)).strong());
            for s in SAMPLES {
                if ui.link(s.name.replace('_', " ")).on_hover_text(crate::text::about_sample(s.part)).clicked() {
                    self.open_sample(s.name);
                }
            }
            if !self.recent.is_empty() {
                ui.add_space(12.0);
                ui.label(RichText::new(say!(start_recent)).strong());
                for path in self.recent.clone() {
                    let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
                    if ui.link(name).on_hover_text(path.display().to_string()).clicked() {
                        self.open(path);
                    }
                }
            }
        });
    }

    /// Puts a sample into the user's temporary folder and opens it from there.
    fn open_sample(&mut self, name: &str) {
        let Some(sample) = SAMPLES.into_iter().find(|s| s.name == name) else { return };
        let folder = std::env::temp_dir().join("clearbeam-samples");
        let file: PathBuf = folder.join(format!("{name}.stl"));
        let bytes = crate::sample::stl_bytes(&(sample.triangles)());
        let written = std::fs::create_dir_all(&folder)
            .map_err(|e| say!(start_no_folder, folder = folder.display().to_string(), reason = e.to_string()))
            .and_then(|()| crate::document::files::write_atomic(&file, &bytes).map_err(|e| e.sentence()));
        match written {
            Ok(()) => self.open(file),
            Err(why) => self.session.error = Some(why),
        }
    }
}
