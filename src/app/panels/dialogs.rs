//! Small windows: unsaved changes, errors, and the page of shortcuts.

use super::super::App;
use super::super::command::Menu;
use super::super::session::AfterGuard;
use eframe::egui::{self, Id, Modal, RichText};

impl App {
    /// *Save / Don't save / Cancel* before unsaved changes would be lost.
    pub(in super::super) fn guard_dialog(&mut self, ctx: &egui::Context) {
        let Some(after) = self.session.after_guard.clone() else { return };
        if !self.document.is_dirty() {
            self.go_on();
            return;
        }
        if !self.answers.is_empty() && self.session.said == SAVING {
            return; // the file dialog is open
        }
        let shown = Modal::new(Id::unique("guard")).show(ctx, |ui| {
            ui.set_width(340.0);
            ui.heading("Save changes?");
            let what = if after == AfterGuard::Close { "closing" } else { "opening another part" };
            ui.label(format!("The job has changes that are not saved. What about them before {what}?"));
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                if ui.button(RichText::new("Save").strong()).clicked() {
                    self.session.said = SAVING.into();
                    self.save_job();
                }
                if ui.button("Don't save").clicked() {
                    match after.clone() {
                        AfterGuard::Close => self.session.may_close = true,
                        AfterGuard::Open(path) => self.open(path),
                        AfterGuard::AskOpen => self.ask(super::super::Purpose::Open),
                    }
                    self.session.after_guard = None;
                }
                if ui.button("Cancel").clicked() {
                    self.session.after_guard = None;
                }
            });
        });
        if shown.should_close() {
            self.session.after_guard = None;
        }
    }

    /// An error, until it was read.
    pub(in super::super) fn message_dialog(&mut self, ctx: &egui::Context) {
        let Some(why) = self.session.error.clone() else { return };
        let shown = Modal::new(Id::unique("error")).show(ctx, |ui| {
            ui.set_width(460.0);
            ui.heading("That did not work");
            ui.label(why);
            ui.add_space(8.0);
            if ui.button("Close").clicked() {
                self.session.error = None;
            }
        });
        if shown.should_close() {
            self.session.error = None;
        }
    }

    /// All keys, made from the command table.
    pub(in super::super) fn help(&mut self, ctx: &egui::Context) {
        let mut open = self.session.help_open;
        egui::Window::new("Shortcuts").open(&mut open).resizable(false).collapsible(false).show(ctx, |ui| {
            egui::ScrollArea::vertical().max_height(520.0).show(ui, |ui| {
                for menu in Menu::ALL {
                    ui.label(RichText::new(menu.title()).strong());
                    egui::Grid::new(menu.title()).num_columns(2).min_col_width(150.0).show(ui, |ui| {
                        for command in menu.commands().filter(|c| c.keys().is_some()) {
                            ui.label(command.name());
                            ui.monospace(command.keys_text(ctx));
                            ui.end_row();
                        }
                    });
                }
                ui.label(RichText::new("View").strong());
                ui.label("Left drag orbits, click selects · middle or right drag pans · wheel zooms at the cursor");
                ui.label("Double click on a surface focuses it, on nothing shows all");
            });
        });
        self.session.help_open = open;
    }
}

const SAVING: &str = "saving…";
