//! The parameters, made from their table: number with unit, reason when wrong, a way back to the
//! default.

use super::super::App;
use super::super::{Command, quantity, theme};
use crate::job::{Edit, Offset, PARAMETERS, Parameter};
use crate::part::Units;
use crate::path::{Direction, Order};
use crate::pose::Correction;
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
            theme::heading(ui, "Layers");
            self.direction(ui);
            self.numbers(ui, &["layers.spacing_mm"]);
            self.offset(ui);
            self.order(ui);
            theme::heading(ui, "Beam");
            self.numbers(
                ui,
                &["beam.defocus_mm", "beam.spot_mm", "beam.power_w", "beam.speed_mm_s", "beam.air_speed_mm_s"],
            );
            self.correction(ui);
            self.tool(ui);
            egui::CollapsingHeader::new("Targets").show(ui, |ui| {
                self.numbers(ui, &["path.chord_error_mm", "path.max_step_mm", "path.max_turn_deg"]);
            });
            theme::heading(ui, "Feature surfaces");
            self.numbers(ui, &["surfaces.angle_deg"]);
            egui::CollapsingHeader::new("More on surfaces").show(ui, |ui| {
                self.numbers(ui, &["surfaces.min_area_mm2", "surfaces.hysteresis_deg"]);
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

    pub(super) fn numbers(&mut self, ui: &mut egui::Ui, keys: &[&str]) {
        for p in PARAMETERS.iter().filter(|p| keys.contains(&p.key)) {
            self.number(ui, p);
        }
    }

    fn number(&mut self, ui: &mut egui::Ui, p: &'static Parameter) {
        let before = (p.get)(self.document.job());
        let mut value = before;
        let (low, high) = p.range;
        let low = if p.least_allowed { low } else { low + 1e-6 * (high - low).min(1000.0) };
        ui.horizontal(|ui| {
            let label = theme::name(ui, p.label, 130.0);
            let speed = (before.abs() * 0.01).clamp(0.001, 1.0);
            let suffix = if p.unit == "°" { "°".into() } else { format!(" {}", p.unit) };
            let field = DragValue::new(&mut value)
                .speed(speed)
                .range(low..=high)
                .max_decimals(4)
                .suffix(suffix)
                .update_while_editing(false)
                .custom_parser(quantity::read);
            let mut tip = format!("{}\n{low:.4} to {high} {}", p.meaning, p.unit);
            if !p.symbol.is_empty() {
                tip.push_str(&format!("\n{}", p.symbol));
            }
            let response = ui.add_sized([96.0, 20.0], field).labelled_by(label.id).on_hover_text(&tip);
            label.on_hover_text(tip);
            if response.changed() && value != before && value.is_finite() {
                self.set_parameter(p, value);
            }
            if (before - p.default()).abs() > 1e-12 {
                let tip = format!("Back to {} {}", p.default(), p.unit);
                let reset = ui.small_button("↺").on_hover_text(tip);
                reset.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, format!("reset {}", p.label)));
                if reset.clicked() {
                    self.set_parameter(p, p.default());
                }
            }
        });
        if let Err(why) = p.check(before) {
            ui.label(RichText::new(why).small().color(theme::WRONG));
        }
    }

    fn direction(&mut self, ui: &mut egui::Ui) {
        let now = self.document.job().layers.direction;
        ui.horizontal(|ui| {
            theme::name(ui, "Direction", 130.0).on_hover_text("Normal of the section planes");
            for (name, direction) in Direction::AXES.into_iter().chain([("auto", Direction::Auto)]) {
                let button = ui.selectable_label(now == direction, name);
                button.widget_info(|| {
                    egui::WidgetInfo::selected(
                        egui::Role::RadioButton,
                        true,
                        now == direction,
                        format!("direction {name}"),
                    )
                });
                if button.clicked() {
                    self.edit(Edit::Direction(direction));
                }
            }
        });
        let Direction::Along(mut v) = now else { return };
        ui.horizontal(|ui| {
            theme::name(ui, "Vector", 130.0);
            for (k, name) in ["x", "y", "z"].into_iter().enumerate() {
                let field = DragValue::new(&mut v[k]).speed(0.01).range(-1.0..=1.0).max_decimals(3);
                let response = ui.add(field);
                response.widget_info(|| {
                    egui::WidgetInfo::labeled(egui::Role::SpinButton, true, format!("direction vector {name}"))
                });
                if response.changed() && v.iter().any(|c| c.abs() > 1e-6) {
                    self.edit_dragging(&Edit::Direction(Direction::Along(v)), "direction");
                }
            }
        });
    }

    fn offset(&mut self, ui: &mut egui::Ui) {
        let now = self.document.job().layers.offset_mm;
        let spacing = self.document.job().layers.spacing_mm;
        ui.horizontal(|ui| {
            theme::name(ui, "First plane", 130.0);
            let mut centred = now == Offset::Centred;
            if ui.checkbox(&mut centred, "centred").changed() {
                self.edit(Edit::Offset(if centred { Offset::Centred } else { Offset::FromLowest(0.5 * spacing) }));
            }
            if let Offset::FromLowest(mut mm) = now {
                let field = DragValue::new(&mut mm)
                    .speed(0.01)
                    .range(0.0..=spacing)
                    .suffix(" mm")
                    .custom_parser(quantity::read);
                let response =
                    ui.add(field).on_hover_text("Above the lowest point of the surfaces, at most one spacing");
                response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, "first offset"));
                if response.changed() {
                    self.edit_dragging(&Edit::Offset(Offset::FromLowest(mm)), "offset");
                }
            }
        });
    }

    fn order(&mut self, ui: &mut egui::Ui) {
        let now = self.document.job().layers.order;
        ui.horizontal(|ui| {
            theme::name(ui, "Lines", 130.0);
            for order in [Order::Zigzag, Order::OneWay] {
                if ui.selectable_label(now == order, order.word()).clicked() {
                    self.edit(Edit::Order(order));
                }
            }
        });
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
        self.numbers(ui, &["part.placement.scale"]);
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
            for s in part.findings.sentences(&part.mesh, &part.orientation) {
                ui.label(RichText::new(s).small());
            }
        }
    }
}
