//! The parameters, made from their table: number with unit, reason when wrong, a way back to the
//! default.

use super::super::{App, Command, quantity, theme};
use super::fields::{self, Change, Owner};
use crate::document::parameter::Group;
use crate::document::{Edit, Parameter};
use crate::part::{PartFinding, Units};
use crate::pose::Correction;
use crate::text::{Sentence as _, choices, say};
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
            theme::heading(ui, &say!(parameters_beam));
            self.numbers(ui, Group::Beam);
            self.correction(ui);
            self.tool(ui);
            self.recipe_panel(ui);
            self.library_panel(ui);
            egui::CollapsingHeader::new(say!(parameters_targets)).id_salt("targets").show(ui, |ui| {
                self.numbers(ui, Group::Targets);
            });
            theme::heading(ui, &say!(parameters_surfaces));
            self.numbers(ui, Group::Crease);
            egui::CollapsingHeader::new(say!(parameters_more_surfaces)).id_salt("more on surfaces").show(ui, |ui| {
                self.numbers(ui, Group::Islands);
                ui.horizontal(|ui| {
                    let button = egui::Button::new(say!(parameters_split));
                    if ui.add_enabled(self.is_enabled(Command::Split), button).clicked() {
                        self.run(Command::Split);
                    }
                    let value = DragValue::new(&mut self.session.split_angle_deg).range(0.1..=180.0);
                    let told = || say!(parameters_split_angle);
                    ui.add(value.suffix(say!(unit_deg)))
                        .widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, told()));
                });
            });
            egui::CollapsingHeader::new(say!(parameters_part)).id_salt("part").show(ui, |ui| self.part(ui));
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
        match fields::number(ui, Owner::Job, p, now, to) {
            Some(Change::To(value)) => self.set_parameter(p, value),
            Some(Change::Back) => self.set_parameter(p, p.default),
            None => {}
        }
    }

    fn correction(&mut self, ui: &mut egui::Ui) {
        let now = self.document.job().path.correction;
        ui.horizontal(|ui| {
            let label = theme::name(ui, &say!(parameters_correction), 130.0);
            label.on_hover_text(say!(parameters_correction_tip));
            for c in Correction::ALL {
                let button = ui.selectable_label(now == c, choices::correction(c));
                let told = || say!(parameters_correction_name, correction = choices::correction(c));
                button.widget_info(|| egui::WidgetInfo::selected(egui::Role::RadioButton, true, now == c, told()));
                if button.clicked() {
                    self.edit(Edit::Correction(c));
                }
            }
        });
    }

    fn part(&mut self, ui: &mut egui::Ui) {
        ui.horizontal(|ui| {
            ui.label(say!(parameters_units));
            for u in Units::ALL {
                if ui.selectable_label(self.document.job().part.units == u, choices::units(u)).clicked() {
                    self.edit(Edit::Units(u));
                }
            }
        });
        let better = self.derived.part.as_ref().and_then(|p| p.figures.better_units);
        if let Some(better) = better {
            ui.label(RichText::new(say!(parameters_implausible)).color(theme::ATTENTION));
            if ui.button(say!(parameters_take_units, units = choices::units(better))).clicked() {
                self.edit(Edit::Units(better));
            }
        }
        self.numbers(ui, Group::Part);
        let mut placement = self.document.job().part.placement;
        let mut changed = false;
        let rows = [
            (say!(parameters_turn), say!(unit_deg), &mut placement.rotation_deg),
            (say!(parameters_move), say!(unit_mm), &mut placement.translation_mm),
        ];
        for (name, unit, values) in rows {
            ui.horizontal(|ui| {
                theme::name(ui, &name, 50.0);
                for (value, axis) in values.iter_mut().zip(["x", "y", "z"]) {
                    let field = DragValue::new(value).speed(0.5).max_decimals(3).suffix(&unit);
                    let response = ui.add(field.custom_parser(quantity::read));
                    let told = || say!(parameters_place_field, name = &name, axis);
                    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, told()));
                    changed |= response.changed();
                }
            });
        }
        if changed {
            self.edit_dragging(&Edit::Place(placement), "place");
        }
        for command in [Command::PickOrigin, Command::LayFlat] {
            if ui.button(command.name()).clicked() {
                self.run(command);
            }
        }
        if let Some(part) = &self.derived.part {
            for finding in PartFinding::of(part) {
                ui.label(RichText::new(finding.sentence()).small());
            }
        }
    }
}
