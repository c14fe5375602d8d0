//! The tool: optics and the spot they give, the head, clamps on the part, and what surfaces ask of the
//! tilt.

use super::super::dialogs::Purpose;
use super::super::{App, quantity, theme};
use crate::beam::{Head, Obstacle};
use crate::document::Edit;
use crate::document::parameter::{Group, Parameter};
use crate::part::SurfaceId;
use crate::pose::Correction;
use crate::pose::tilt::Side;
use crate::process::Profile;
use eframe::egui::{self, DragValue, RichText};

/// A spot that the optics would give is told from the one that is set from this share on.
const OTHER_SPOT: f64 = 0.05;
const SPOT: &Parameter = Parameter::named("beam.spot_mm");
const DEFOCUS: &Parameter = Parameter::named("beam.defocus_mm");

impl App {
    /// Head, clamps, optics and tilt, under the numbers of the beam.
    pub(super) fn tool(&mut self, ui: &mut egui::Ui) {
        self.head(ui);
        let clearance = self.document.job().path.correction == Correction::Clearance;
        if clearance || !self.document.job().beam.head.is_empty() {
            self.numbers(ui, Group::Tilt);
        }
        if clearance {
            egui::CollapsingHeader::new("Tilt").show(ui, |ui| {
                self.numbers(ui, Group::TiltRates);
                self.tilt_rule(ui);
            });
        }
        egui::CollapsingHeader::new("Optics").show(ui, |ui| self.optics(ui));
        egui::CollapsingHeader::new("Clamps").show(ui, |ui| self.clamps(ui));
    }

    fn head(&mut self, ui: &mut egui::Ui) {
        let file = self.document.job().beam.head.clone();
        ui.horizontal(|ui| {
            theme::name(ui, "Head", 130.0).on_hover_text(
                "With a head the beam is a cone, and cone and head keep their margin from everything; without one it is a ray",
            );
            let shown = std::path::Path::new(&file).file_name().map_or("none: a ray".into(), |n| n.to_string_lossy());
            if ui.button("Open head…").on_hover_text("A stack of cylinders and cones (TOML), or an STL").clicked() {
                self.ask(Purpose::Head);
            }
            ui.add(egui::Label::new(shown).truncate());
            if !file.is_empty() && ui.small_button("×").on_hover_text("Take the head away").clicked() {
                self.edit(Edit::Head(String::new()));
            }
        });
        if file.is_empty() {
            return;
        }
        self.numbers(ui, Group::Head);
        let Some(Ok(setup)) = self.derived.pipeline.setup() else { return };
        if let Some(Head::Solid(..)) = &setup.tool.head {
            ui.label(RichText::new("An STL counts as what it sweeps about the beam").small());
        }
    }

    fn optics(&mut self, ui: &mut egui::Ui) {
        self.numbers(ui, Group::Optics);
        let (optics, beam) = (self.document.job().optics, self.document.job().beam.clone());
        let (spot, (low, high)) = (optics.spot_mm(beam.defocus_mm), optics.tolerance_mm(beam.defocus_mm));
        ui.label(format!("M² = {:.2}", optics.m_squared()));
        ui.label(format!("Spot at D = {:.1} mm: {spot:.3} mm", beam.defocus_mm));
        ui.label(RichText::new(format!("within 10% from D = {low:.1} to {high:.1} mm")).small());
        if (spot / beam.spot_mm - 1.0).abs() <= OTHER_SPOT {
            return;
        }
        let text = format!("The spot is set to {} mm", beam.spot_mm);
        ui.label(RichText::new(text).color(theme::ATTENTION));
        ui.horizontal_wrapped(|ui| {
            if ui.button(format!("Take {spot:.2} mm")).on_hover_text("The spot that these optics give").clicked() {
                self.edit(Edit::Set(SPOT.key, (spot * 1000.0).round() / 1000.0));
            }
            match optics.defocus_for(beam.spot_mm) {
                Some(d) => {
                    for d in [d, -d] {
                        let side = if d < 0.0 { "The focus in the part" } else { "The focus above the surface" };
                        if ui.button(format!("D = {d:.1} mm")).on_hover_text(side).clicked() {
                            self.edit(Edit::Set(DEFOCUS.key, (d * 1000.0).round() / 1000.0));
                        }
                    }
                }
                None => {
                    ui.label("narrower than at the focus: no D gives it");
                }
            }
        });
    }

    fn clamps(&mut self, ui: &mut egui::Ui) {
        let before = self.document.job().clamps.clone();
        let (mut clamps, mut gone, mut dragged) = (before.clone(), None, false);
        for (i, c) in clamps.iter_mut().enumerate() {
            ui.horizontal(|ui| {
                ui.add(egui::Label::new(format!("{} {}", i + 1, c.file)).truncate());
                if ui.small_button("×").on_hover_text("Take this clamp away").clicked() {
                    gone = Some(i);
                }
            });
            dragged |= placed(ui, c, i);
        }
        if let Some(i) = gone {
            clamps.remove(i);
            self.edit(Edit::Clamps(clamps));
        } else if dragged {
            self.edit_dragging(&Edit::Clamps(clamps), "clamps");
        }
        if ui.button("Add clamp…").on_hover_text("An STL that stands on the part, in the part's frame").clicked() {
            self.ask(Purpose::Clamp);
        }
    }

    /// What the selected surface asks of the tilt.
    fn tilt_rule(&mut self, ui: &mut egui::Ui) {
        let Some(&surface) = self.session.selected.first().filter(|_| self.session.selected.len() == 1) else {
            ui.label(RichText::new("Select one surface to give it a tilt of its own").small());
            return;
        };
        let before = self.document.job().settings.of(SurfaceId(surface)).tilt.clone();
        let mut rule = before.clone();
        ui.label(RichText::new(format!("Surface {surface}")).strong());
        let numbers = [
            ("Lead", "The tilt that is best, towards the travel", -75.0, &mut rule.preferred.lead_deg),
            ("Lean", "The tilt that is best, to the right of the travel", -75.0, &mut rule.preferred.lean_deg),
            ("Least tilt", "No beam stands nearer to the normal: no reflection returns", 0.0, &mut rule.least_deg),
        ];
        for (name, tip, least, value) in numbers {
            ui.horizontal(|ui| {
                let label = theme::name(ui, name, 130.0).on_hover_text(tip);
                let field = DragValue::new(value).speed(0.5).range(least..=75.0).max_decimals(1).suffix("°");
                ui.add(field.custom_parser(quantity::read)).labelled_by(label.id);
            });
        }
        let sides = [(Side::Lead, "ahead"), (Side::Lag, "behind"), (Side::Left, "left"), (Side::Right, "right")];
        ui.horizontal_wrapped(|ui| {
            theme::name(ui, "Never to", 60.0).on_hover_text("Sides to which the beam must not stand");
            for (side, name) in sides {
                let on = rule.forbidden.contains(&side);
                if ui.selectable_label(on, name).clicked() {
                    rule.forbidden.retain(|s| *s != side);
                    if !on {
                        rule.forbidden.push(side);
                        rule.forbidden.sort();
                    }
                }
            }
        });
        if rule != before {
            self.edit_dragging(&Edit::Tilt(SurfaceId(surface), rule), "tilt");
        }
    }

    /// Profile and thresholds of the dose.
    pub(super) fn dose_parameters(&mut self, ui: &mut egui::Ui) {
        egui::CollapsingHeader::new("Dose").show(ui, |ui| {
            let now = self.document.job().dose.profile;
            ui.horizontal(|ui| {
                theme::name(ui, "Profile", 90.0).on_hover_text("How the power is spread over the spot");
                for p in Profile::ALL {
                    if ui.selectable_label(now == p, p.word()).clicked() {
                        self.edit(Edit::Profile(p));
                    }
                }
            });
            if now == Profile::Line {
                self.numbers(ui, Group::ScannedLine);
            }
            self.numbers(ui, Group::Dose);
        });
    }
}

/// Where a clamp stands; whether that was changed.
fn placed(ui: &mut egui::Ui, c: &mut Obstacle, number: usize) -> bool {
    let mut changed = false;
    let rows =
        [("At", " mm", ["x", "y", "z"], &mut c.position_mm), ("Turned", "°", ["RZ", "RY", "RX"], &mut c.rz_ry_rx_deg)];
    for (name, unit, axes, values) in rows {
        ui.horizontal(|ui| {
            theme::name(ui, name, 50.0);
            for (value, axis) in values.iter_mut().zip(axes) {
                let field = DragValue::new(value).speed(0.5).max_decimals(3).suffix(unit);
                let response = ui.add(field.custom_parser(quantity::read));
                let label = format!("clamp {} {axis}", number + 1);
                response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, label.clone()));
                changed |= response.changed();
            }
        });
    }
    changed
}
