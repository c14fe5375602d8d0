//! The menu bar, made from the command table.

use super::super::App;
use super::super::command::{COMMANDS, Command, Menu};
use crate::text::Sentence;
use eframe::egui::{self, Align, Layout};

impl App {
    pub(in super::super) fn menu(&mut self, ui: &mut egui::Ui) {
        egui::MenuBar::new().ui(ui, |ui| {
            for (menu, title) in Menu::ALL {
                ui.menu_button(title, |ui| self.menu_rows(ui, menu));
            }
            ui.separator();
            for command in [Command::Open, Command::Save, Command::Undo, Command::Redo] {
                let name = super::name_of(command).trim_end_matches('…');
                let tip = self.name_now(command) + "  " + &super::keys_of(ui.ctx(), command);
                let button = egui::Button::new(name).frame(false);
                if ui.add_enabled(self.is_enabled(command), button).on_hover_text(tip).clicked() {
                    let ctx = ui.ctx().clone();
                    self.run(command, &ctx);
                }
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| self.switches(ui));
        });
    }

    /// Opens what stands beside the view.
    fn switches(&mut self, ui: &mut egui::Ui) {
        if self.derived.plan().is_none() && self.derived.cell.is_none() {
            return;
        }
        for command in [Command::Text, Command::Plots, Command::Access, Command::Dose, Command::Cell] {
            let button = egui::Button::selectable(self.is_shown(command), super::name_of(command));
            let keys = super::keys_of(ui.ctx(), command);
            let response = ui.add_enabled(self.is_enabled(command), button).on_hover_text(keys);
            if response.on_disabled_hover_text("Choose a robot under Cell").clicked() {
                let ctx = ui.ctx().clone();
                self.run(command, &ctx);
            }
        }
    }

    fn menu_rows(&mut self, ui: &mut egui::Ui, menu: Menu) {
        for row in COMMANDS.iter().filter(|r| r.menu == menu) {
            let keys = row.keys.map_or_else(String::new, |k| ui.ctx().format_shortcut(&k));
            let on = if self.is_shown(row.command) { "● " } else { "" };
            let button = egui::Button::new(format!("{on}{}", self.name_now(row.command))).shortcut_text(keys);
            if ui.add_enabled(self.is_enabled(row.command), button).clicked() {
                let ctx = ui.ctx().clone();
                self.run(row.command, &ctx);
                ui.close();
            }
        }
        if menu == Menu::File && !self.recent.is_empty() {
            ui.separator();
            for path in self.recent.clone() {
                let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
                if ui.button(name).on_hover_text(path.display().to_string()).clicked() {
                    self.open_guarded(path);
                    ui.close();
                }
            }
        }
    }

    /// The name with what it would do now: "Undo move 3 surfaces to clean".
    fn name_now(&self, command: Command) -> String {
        let step = match command {
            Command::Undo => self.document.undo_step(),
            Command::Redo => self.document.redo_step(),
            _ => None,
        };
        let name = super::name_of(command);
        step.map_or_else(|| name.into(), |s| format!("{name} {}", s.sentence()))
    }
}
