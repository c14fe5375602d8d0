//! The parameters, made from their table: number with unit, reason when wrong, a way back to the
//! default.

use super::super::{App, Command, quantity, theme};
use super::fields::{self, Change};
use crate::document::parameter::Group;
use crate::document::{Edit, Parameter};
use crate::part::{PartFinding, Units};
use crate::pose::Correction;
use crate::text::Sentence as _;
use eframe::egui::{self, DragValue, RichText};

impl App {
    pub(in super::super) fn parameters(&mut self, ui: &mut egui::Ui) {
        // Always in sight: what is wrong, and what all the rest is for.
        egui::Panel::bottom("export").show(ui, |ui| {
            // What would help stands under what is wrong.
            let height = if self.has_refusals() { 230.0 } else { 130.0 };
            // As high as its text, whatever height the panel had before.
            let area = egui::ScrollArea::vertical().max_height(height).min_scrolled_height(height);
            area.auto_shrink([false, true]).show(ui, |ui| self.problems(ui));
            self.export_button(ui);
        });
        egui::ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            self.layers(ui);
            theme::heading(ui, "Beam");
            self.numbers(ui, Group::Beam);
            self.correction(ui);
            self.tool(ui);
            self.recipe_panel(ui);
            self.library_panel(ui);
            egui::CollapsingHeader::new("Targets, leads").show(ui, |ui| {
                self.numbers(ui, Group::Targets);
            });
            theme::heading(ui, "Feature surfaces");
            self.numbers(ui, Group::Crease);
            egui::CollapsingHeader::new("More on surfaces").show(ui, |ui| {
                self.numbers(ui, Group::Islands);
                ui.horizontal(|ui| {
                    let button = egui::Button::new("Split at");
                    if ui.add_enabled(self.is_enabled(Command::Split), button).clicked() {
                        let ctx = ui.ctx().clone();
                        self.run(Command::Split, &ctx);
                    }
                    let value = DragValue::new(&mut self.session.split_angle_deg).range(0.1..=180.0).suffix("°");
                    ui.add(value)
                        .widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, "split angle"));
                    ui.label("of the selected one");
                });
            });
            egui::CollapsingHeader::new("Part").show(ui, |ui| self.part(ui));
            self.dose_parameters(ui);
            self.cell_panel(ui);
        });
    }

    /// The job's numbers of a group.
    pub(super) fn numbers(&mut self, ui: &mut egui::Ui, group: Group) {
        for p in Parameter::of_group(group) {
            self.number(ui, p);
        }
    }

    fn number(&mut self, ui: &mut egui::Ui, p: &'static Parameter) {
        let now = self.document.job().number(p);
        let to = Some(p.default).filter(|to| (now - to).abs() > 1e-12);
        match fields::number(ui, fields::JOB, p, now, to) {
            Some(Change::To(value)) => self.set_parameter(p, value),
            Some(Change::Back) => self.set_parameter(p, p.default),
            None => {}
        }
    }

    fn correction(&mut self, ui: &mut egui::Ui) {
        let now = self.document.job().path.correction;
        ui.horizontal(|ui| {
            theme::name(ui, "Correction", 130.0)
                .on_hover_text("What is done where the beam along the normal hits the part");
            for c in Correction::ALL {
                let button = ui.selectable_label(now == c, c.word());
                button.widget_info(|| {
                    egui::WidgetInfo::selected(
                        egui::Role::RadioButton,
                        true,
                        now == c,
                        format!("correction {}", c.word()),
                    )
                });
                if button.clicked() {
                    self.edit(Edit::Correction(c));
                }
            }
        });
    }

    fn part(&mut self, ui: &mut egui::Ui) {
        ui.horizontal(|ui| {
            ui.label("Unit of the file");
            for u in Units::ALL {
                if ui.selectable_label(self.document.job().part.units == u, u.word()).clicked() {
                    self.edit(Edit::Units(u));
                }
            }
        });
        let better = self.derived.part.as_ref().and_then(|p| p.findings.better_units);
        if let Some(better) = better {
            ui.label(RichText::new("The size is implausible").color(theme::ATTENTION));
            if ui.button(format!("Take it as {}", better.word())).clicked() {
                self.edit(Edit::Units(better));
            }
        }
        self.numbers(ui, Group::Part);
        let mut placement = self.document.job().part.placement;
        let mut changed = false;
        let rows = [("Turn", "°", &mut placement.rotation_deg), ("Move", " mm", &mut placement.translation_mm)];
        for (name, unit, values) in rows {
            ui.horizontal(|ui| {
                theme::name(ui, name, 50.0);
                for (value, axis) in values.iter_mut().zip(["x", "y", "z"]) {
                    let field =
                        DragValue::new(value).speed(0.5).max_decimals(3).suffix(unit).custom_parser(quantity::read);
                    let response = ui.add(field);
                    response.widget_info(|| {
                        egui::WidgetInfo::labeled(egui::Role::SpinButton, true, format!("{name} {axis}"))
                    });
                    changed |= response.changed();
                }
            });
        }
        if changed {
            self.edit_dragging(&Edit::Place(placement), "place");
        }
        for command in [Command::PickOrigin, Command::LayFlat] {
            if ui.button(super::name_of(command)).clicked() {
                let ctx = ui.ctx().clone();
                self.run(command, &ctx);
            }
        }
        if let Some(part) = &self.derived.part {
            for finding in PartFinding::of(part) {
                ui.label(RichText::new(finding.sentence()).small());
            }
        }
    }
}
