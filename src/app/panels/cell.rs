//! The robot cell: which robot, what it carries, in which language its program is written.

use super::super::dialogs::Purpose;
use super::super::{App, Command, theme};
use crate::cell::{Mount, Robot, Spin};
use crate::document::Edit;
use crate::document::parameter::Group;
use crate::program::dialects::DIALECTS;
use crate::text::{Sentence, choices, say};
use eframe::egui::{self, ComboBox, RichText};
use std::path::Path;

const WIDTH: f32 = 170.0;

impl App {
    pub(super) fn cell_panel(&mut self, ui: &mut egui::Ui) {
        theme::heading(ui, &say!(cell_panel_heading));
        self.robot(ui);
        self.mount(ui);
        self.spin(ui);
        self.numbers(ui, Group::Cell);
        self.dialect(ui);
        self.cell_file(ui);
        self.frames(ui);
        self.better_setup(ui);
    }

    fn robot(&mut self, ui: &mut egui::Ui) {
        let now = self.document.job().cell.robot.clone();
        let shown = match self.derived.pipeline.setup() {
            _ if now.is_empty() => say!(cell_panel_no_robot),
            Some(Ok(setup)) => setup.robot_name().to_owned(),
            _ => now.clone(),
        };
        let mut chosen = None;
        ui.horizontal(|ui| {
            let label = theme::name(ui, &say!(cell_panel_robot), 90.0);
            let combo = ComboBox::from_id_salt("robot").width(WIDTH).selected_text(shown).show_ui(ui, |ui| {
                if ui.selectable_label(now.is_empty(), say!(cell_panel_no_robot)).clicked() {
                    chosen = Some(String::new());
                }
                for key in Robot::shipped() {
                    let name = Robot::load(key, None).map_or_else(|_| key.to_owned(), |r| r.name);
                    if ui.selectable_label(now == key, name).clicked() {
                        chosen = Some(key.to_owned());
                    }
                }
                if ui.selectable_label(false, say!(cell_panel_robot_file)).clicked() {
                    self.ask(Purpose::Robot);
                }
            });
            combo.response.labelled_by(label.id).on_hover_text(say!(cell_panel_robot_tip));
        });
        if let Some(key) = chosen {
            self.choose_robot(&key);
        }
        let Some(Ok(setup)) = self.derived.pipeline.setup() else { return };
        let unverified = setup.robot.as_ref().map_or(&[][..], |r| &r.unverified);
        if !unverified.is_empty() {
            let text = RichText::new(say!(cell_panel_unverified)).small().color(theme::ATTENTION);
            ui.label(text).on_hover_text(say!(cell_panel_unverified_tip, figures = unverified.join("\n")));
        }
    }

    /// Takes a robot by its key or file, with the language of its controller.
    pub(in super::super) fn choose_robot(&mut self, name: &str) {
        let dialect = self.document.job().cell.dialect.clone();
        if name.is_empty() {
            self.edit(Edit::Robot(String::new(), dialect));
            return;
        }
        match Robot::load(name, self.document.file().and_then(Path::parent)) {
            Ok(robot) => self.edit(Edit::Robot(name.into(), robot.dialect)),
            Err(e) => self.session.error = Some(e.sentence()),
        }
    }

    fn mount(&mut self, ui: &mut egui::Ui) {
        let Some(Ok(setup)) = self.derived.pipeline.setup() else { return };
        let now = setup.mount;
        let options = [
            (Mount::PartInHand, say!(cell_panel_the_part), say!(cell_panel_carries_part)),
            (Mount::ToolInHand, say!(cell_panel_the_head), say!(cell_panel_carries_head)),
        ];
        let label = [say!(cell_panel_carries), say!(cell_panel_carries_tip)];
        if let Some(mount) = choice(ui, label, options, now) {
            self.edit(Edit::Mount(mount));
        }
    }

    fn spin(&mut self, ui: &mut egui::Ui) {
        let now = self.document.job().cell.spin;
        let option = |s: Spin| (s, choices::spin(s), say!(cell_panel_spin_name, spin = choices::spin(s)));
        let label = [say!(cell_panel_spin), say!(cell_panel_spin_tip)];
        if let Some(spin) = choice(ui, label, [Spin::Free, Spin::Travel].map(option), now) {
            self.edit(Edit::Spin(spin));
        }
    }

    fn dialect(&mut self, ui: &mut egui::Ui) {
        let now = self.document.job().cell.dialect.clone();
        let mut chosen = None;
        ui.horizontal(|ui| {
            let label = theme::name(ui, &say!(cell_panel_program_for), 90.0);
            let combo = ComboBox::from_id_salt("dialect").width(WIDTH).selected_text(&now).show_ui(ui, |ui| {
                for word in DIALECTS.iter().map(|d| d.name()) {
                    if ui.selectable_label(now == word, word).clicked() {
                        chosen = Some(word.to_owned());
                    }
                }
            });
            combo.response.labelled_by(label.id).on_hover_text(say!(cell_panel_program_for_tip));
        });
        if let Some(word) = chosen {
            self.edit(Edit::Dialect(word));
        }
    }

    fn cell_file(&mut self, ui: &mut egui::Ui) {
        ui.horizontal(|ui| {
            theme::name(ui, &say!(cell_panel_frames), 90.0).on_hover_text(say!(cell_panel_frames_tip));
            if ui.button(say!(cell_panel_cell_file)).clicked() {
                self.ask(Purpose::Cell);
            }
        });
        match self.derived.pipeline.setup() {
            Some(Ok(setup)) => ui.label(RichText::new(&setup.cell.name).small().weak()),
            Some(Err(why)) => ui.label(RichText::new(why.sentence()).color(theme::WRONG)),
            None => return,
        };
    }

    fn better_setup(&mut self, ui: &mut egui::Ui) {
        if self.document.job().cell.robot.is_empty() {
            return;
        }
        ui.add_space(2.0);
        let button = egui::Button::new(Command::BetterSetup.name());
        let response = ui.add_enabled(self.is_enabled(Command::BetterSetup), button);
        let response = response.on_hover_text(say!(cell_panel_better_tip));
        let why = if self.is_proposing() { say!(cell_panel_better_running) } else { say!(cell_panel_nothing_refused) };
        if response.on_disabled_hover_text(why).clicked() {
            self.run(Command::BetterSetup);
        }
        ui.add_space(4.0);
    }

    /// The program, written into a folder.
    pub(super) fn export_button(&mut self, ui: &mut egui::Ui) {
        ui.add_space(2.0);
        let ready = self.plan().is_some();
        let text = RichText::new(say!(cell_panel_export)).strong();
        let button = egui::Button::new(text).fill(theme::ACCENT.gamma_multiply(0.6));
        let tip = say!(cell_panel_export_tip, keys = Command::Export.keys_text(ui.ctx()));
        let size = egui::vec2(ui.available_width(), 28.0);
        let response = ui.add_enabled_ui(ready, |ui| ui.add_sized(size, button)).inner;
        if response.on_hover_text(tip).on_disabled_hover_text(say!(cell_panel_not_planned)).clicked() {
            self.run(Command::Export);
        }
        ui.add_space(2.0);
    }
}

/// One of two values, each with its word and its accessible name, behind a name with a tip.
fn choice<T: Copy + PartialEq>(
    ui: &mut egui::Ui,
    [name, tip]: [String; 2],
    options: [(T, String, String); 2],
    now: T,
) -> Option<T> {
    let mut chosen = None;
    ui.horizontal(|ui| {
        theme::name(ui, &name, 90.0).on_hover_text(tip);
        for (value, word, told) in options {
            let button = ui.selectable_label(now == value, word);
            let is_on = now == value;
            button.widget_info(|| egui::WidgetInfo::selected(egui::Role::RadioButton, true, is_on, told.clone()));
            if button.clicked() {
                chosen = Some(value);
            }
        }
    });
    chosen
}
