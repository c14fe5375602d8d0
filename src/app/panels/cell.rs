//! The robot cell: which robot, what it carries, in which language its program is written.

use super::super::dialogs::Purpose;
use super::super::{App, Command, theme};
use crate::cell::{Mount, Robot, Spin};
use crate::document::Edit;
use crate::document::parameter::Group;
use crate::program::dialects::DIALECTS;
use crate::text::Sentence;
use eframe::egui::{self, ComboBox, RichText};
use std::path::Path;

const NO_ROBOT: &str = "None: poses only";
const WIDTH: f32 = 170.0;

impl App {
    pub(super) fn cell_panel(&mut self, ui: &mut egui::Ui) {
        theme::heading(ui, "Cell");
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
            _ if now.is_empty() => NO_ROBOT.into(),
            Some(Ok(setup)) => setup.robot_name().to_owned(),
            _ => now.clone(),
        };
        let mut chosen = None;
        ui.horizontal(|ui| {
            let label = theme::name(ui, "Robot", 90.0);
            let combo = ComboBox::from_id_salt("robot").width(WIDTH).selected_text(shown).show_ui(ui, |ui| {
                if ui.selectable_label(now.is_empty(), NO_ROBOT).clicked() {
                    chosen = Some(String::new());
                }
                for key in Robot::shipped() {
                    let name = Robot::load(key, None).map_or_else(|_| key.to_owned(), |r| r.name);
                    if ui.selectable_label(now == key, name).clicked() {
                        chosen = Some(key.to_owned());
                    }
                }
                if ui.selectable_label(false, "Robot file…").clicked() {
                    self.ask(Purpose::Robot);
                }
            });
            let tip = "With a robot, reach, limits and time are known, and its motion can be watched";
            combo.response.labelled_by(label.id).on_hover_text(tip);
        });
        if let Some(key) = chosen {
            self.choose_robot(&key);
        }
        let Some(Ok(setup)) = self.derived.pipeline.setup() else { return };
        let unverified = setup.robot.as_ref().map_or(&[][..], |r| &r.unverified);
        if !unverified.is_empty() {
            let text = RichText::new("Some figures of this robot are not verified").small().color(theme::ATTENTION);
            ui.label(text).on_hover_text(format!("Check them in a robot file of your own:\n{}", unverified.join("\n")));
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
        let words = [(Mount::PartInHand, "the part"), (Mount::ToolInHand, "the head")];
        let tip = "The part under a fixed laser, or the laser head over a fixed part";
        if let Some(mount) = choice(ui, "Carries", tip, &words, now) {
            self.edit(Edit::Mount(mount));
        }
    }

    fn spin(&mut self, ui: &mut egui::Ui) {
        let now = self.document.job().cell.spin;
        let words = [(Spin::Free, Spin::Free.word()), (Spin::Travel, Spin::Travel.word())];
        let tip = "Rotation about the beam: free, as suits the arm, or fixed to the direction of travel";
        if let Some(spin) = choice(ui, "Spin", tip, &words, now) {
            self.edit(Edit::Spin(spin));
        }
    }

    fn dialect(&mut self, ui: &mut egui::Ui) {
        let now = self.document.job().cell.dialect.clone();
        let mut chosen = None;
        ui.horizontal(|ui| {
            let label = theme::name(ui, "Program for", 90.0);
            let combo = ComboBox::from_id_salt("dialect").width(WIDTH).selected_text(&now).show_ui(ui, |ui| {
                for word in DIALECTS.iter().map(|d| d.name()) {
                    if ui.selectable_label(now == word, word).clicked() {
                        chosen = Some(word.to_owned());
                    }
                }
            });
            combo.response.labelled_by(label.id).on_hover_text("The controller's language");
        });
        if let Some(word) = chosen {
            self.edit(Edit::Dialect(word));
        }
    }

    fn cell_file(&mut self, ui: &mut egui::Ui) {
        ui.horizontal(|ui| {
            theme::name(ui, "Frames", 90.0).on_hover_text("Where laser, part and flange stand; air moves, outputs");
            if ui.button("Cell file…").clicked() {
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
        let button = egui::Button::new(super::name_of(Command::BetterSetup));
        let tip = "Looks for where part and laser would have to stand so that the robot reaches more of the work";
        let response = ui.add_enabled(self.is_enabled(Command::BetterSetup), button).on_hover_text(tip);
        let why = if self.is_proposing() { "It is being looked for" } else { "The robot refuses nothing" };
        if response.on_disabled_hover_text(why).clicked() {
            let ctx = ui.ctx().clone();
            self.run(Command::BetterSetup, &ctx);
        }
        ui.add_space(4.0);
    }

    /// The program, written into a folder.
    pub(super) fn export_button(&mut self, ui: &mut egui::Ui) {
        ui.add_space(2.0);
        let ready = self.plan().is_some();
        let text = RichText::new("Export program…").strong();
        let button = egui::Button::new(text).fill(theme::ACCENT.gamma_multiply(0.6));
        let why = "Writes program, path, report and job into a folder  Ctrl+E";
        let size = egui::vec2(ui.available_width(), 28.0);
        let response = ui.add_enabled_ui(ready, |ui| ui.add_sized(size, button)).inner;
        if response.on_hover_text(why).on_disabled_hover_text("The plan is not finished").clicked() {
            let ctx = ui.ctx().clone();
            self.run(Command::Export, &ctx);
        }
        ui.add_space(2.0);
    }
}

/// One of a few words.
fn choice<T: Copy + PartialEq>(ui: &mut egui::Ui, name: &str, tip: &str, words: &[(T, &str)], now: T) -> Option<T> {
    let mut chosen = None;
    ui.horizontal(|ui| {
        theme::name(ui, name, 90.0).on_hover_text(tip);
        for &(value, word) in words {
            let button = ui.selectable_label(now == value, word);
            let full = format!("{} {word}", name.to_lowercase());
            button
                .widget_info(|| egui::WidgetInfo::selected(egui::Role::RadioButton, true, now == value, full.clone()));
            if button.clicked() {
                chosen = Some(value);
            }
        }
    });
    chosen
}
