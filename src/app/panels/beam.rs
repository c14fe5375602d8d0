//! The tool: optics and the spot they give, the head, clamps on the part, and what surfaces ask of the
//! tilt.

use super::super::dialogs::Purpose;
use super::super::{App, quantity, theme};
use crate::beam::{Head, Obstacle};
use crate::document::Edit;
use crate::document::parameter::{Group, Parameter};
use crate::part::SurfaceId;
use crate::pose::Correction;
use crate::pose::tilt::TiltSide;
use crate::process::Profile;
use crate::text::{choices, exact, fixed, id, say};
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
            egui::CollapsingHeader::new(say!(tool_tilt)).id_salt("tilt").show(ui, |ui| {
                self.numbers(ui, Group::TiltRates);
                self.tilt_rule(ui);
            });
        }
        egui::CollapsingHeader::new(say!(tool_optics)).id_salt("optics").show(ui, |ui| self.optics(ui));
        egui::CollapsingHeader::new(say!(tool_clamps)).id_salt("clamps").show(ui, |ui| self.clamps(ui));
    }

    fn head(&mut self, ui: &mut egui::Ui) {
        let file = self.document.job().beam.head.clone();
        ui.horizontal(|ui| {
            theme::name(ui, &say!(tool_head), 130.0).on_hover_text(say!(tool_head_tip));
            let shown = std::path::Path::new(&file).file_name().map(|n| n.to_string_lossy().into_owned());
            let shown = shown.unwrap_or_else(|| say!(tool_head_none));
            if ui.button(say!(tool_open_head)).on_hover_text(say!(tool_open_head_tip)).clicked() {
                self.ask(Purpose::Head);
            }
            ui.add(egui::Label::new(shown).truncate());
            if !file.is_empty() && ui.small_button("×").on_hover_text(say!(tool_remove_head)).clicked() {
                self.edit(Edit::Head(String::new()));
            }
        });
        if file.is_empty() {
            return;
        }
        self.numbers(ui, Group::Head);
        let Some(Ok(setup)) = self.derived.pipeline.setup() else { return };
        if let Some(Head::Solid(..)) = &setup.tool.head {
            ui.label(RichText::new(say!(tool_head_of_facets)).small());
        }
    }

    fn optics(&mut self, ui: &mut egui::Ui) {
        self.numbers(ui, Group::Optics);
        let (optics, beam) = (self.document.job().optics, self.document.job().beam.clone());
        let (spot, (low, high)) = (optics.spot_mm(beam.defocus_mm), optics.tolerance_mm(beam.defocus_mm));
        ui.label(say!(tool_m_squared, value = fixed(optics.m_squared(), 2)));
        ui.label(say!(tool_spot, defocus = fixed(beam.defocus_mm, 1), spot = fixed(spot, 3)));
        ui.label(RichText::new(say!(tool_tolerance, from = fixed(low, 1), to = fixed(high, 1))).small());
        if (spot / beam.spot_mm - 1.0).abs() <= OTHER_SPOT {
            return;
        }
        let text = say!(tool_spot_is_set, spot = exact(beam.spot_mm));
        ui.label(RichText::new(text).color(theme::ATTENTION));
        ui.horizontal_wrapped(|ui| {
            let take = ui.button(say!(tool_take_spot, spot = fixed(spot, 2)));
            if take.on_hover_text(say!(tool_take_spot_tip)).clicked() {
                self.edit(Edit::Set(SPOT.key, (spot * 1000.0).round() / 1000.0));
            }
            match optics.defocus_for(beam.spot_mm) {
                Some(d) => {
                    for d in [d, -d] {
                        let side = if d < 0.0 { say!(tool_focus_in_part) } else { say!(tool_focus_above) };
                        let take = ui.button(say!(tool_take_defocus, defocus = fixed(d, 1)));
                        if take.on_hover_text(side).clicked() {
                            self.edit(Edit::Set(DEFOCUS.key, (d * 1000.0).round() / 1000.0));
                        }
                    }
                }
                None => {
                    ui.label(say!(tool_too_narrow));
                }
            }
        });
    }

    fn clamps(&mut self, ui: &mut egui::Ui) {
        let before = self.document.job().clamps.clone();
        let (mut clamps, mut gone, mut dragged) = (before.clone(), None, false);
        for (i, c) in clamps.iter_mut().enumerate() {
            ui.horizontal(|ui| {
                ui.add(egui::Label::new(say!(tool_clamp, number = id(i + 1), file = &c.file)).truncate());
                if ui.small_button("×").on_hover_text(say!(tool_remove_clamp)).clicked() {
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
        if ui.button(say!(tool_add_clamp)).on_hover_text(say!(tool_add_clamp_tip)).clicked() {
            self.ask(Purpose::Clamp);
        }
    }

    /// What the selected surface asks of the tilt.
    fn tilt_rule(&mut self, ui: &mut egui::Ui) {
        let Some(&surface) = self.session.selected.first().filter(|_| self.session.selected.len() == 1) else {
            ui.label(RichText::new(say!(tool_tilt_select)).small());
            return;
        };
        let before = self.document.job().settings.of(SurfaceId(surface)).tilt.clone();
        let mut rule = before.clone();
        ui.label(RichText::new(say!(tool_tilt_surface, surface = id(surface))).strong());
        let numbers = [
            (say!(tool_lead), say!(tool_lead_tip), -75.0, &mut rule.preferred.lead_deg),
            (say!(tool_lean), say!(tool_lean_tip), -75.0, &mut rule.preferred.lean_deg),
            (say!(tool_least_tilt), say!(tool_least_tilt_tip), 0.0, &mut rule.least_deg),
        ];
        for (name, tip, least, value) in numbers {
            ui.horizontal(|ui| {
                let label = theme::name(ui, &name, 130.0).on_hover_text(tip);
                let field = DragValue::new(value).speed(0.5).range(least..=75.0).max_decimals(1).suffix(say!(unit_deg));
                ui.add(field.custom_parser(quantity::read)).labelled_by(label.id);
            });
        }
        let sides = [
            (TiltSide::Lead, say!(tool_ahead)),
            (TiltSide::Lag, say!(tool_behind)),
            (TiltSide::Left, say!(tool_left)),
            (TiltSide::Right, say!(tool_right)),
        ];
        ui.horizontal_wrapped(|ui| {
            theme::name(ui, &say!(tool_never_to), 60.0).on_hover_text(say!(tool_never_to_tip));
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
        egui::CollapsingHeader::new(say!(tool_dose)).id_salt("dose").show(ui, |ui| {
            let now = self.document.job().dose.profile;
            ui.horizontal(|ui| {
                theme::name(ui, &say!(tool_profile), 90.0).on_hover_text(say!(tool_profile_tip));
                for p in Profile::ALL {
                    if ui.selectable_label(now == p, choices::profile(p)).clicked() {
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
    let rows = [
        (say!(tool_clamp_at), say!(unit_mm), ["x", "y", "z"], &mut c.position_mm),
        (say!(tool_clamp_turned), say!(unit_deg), ["RZ", "RY", "RX"], &mut c.rz_ry_rx_deg),
    ];
    for (name, unit, axes, values) in rows {
        ui.horizontal(|ui| {
            theme::name(ui, &name, 50.0);
            for (value, axis) in values.iter_mut().zip(axes) {
                let field = DragValue::new(value).speed(0.5).max_decimals(3).suffix(&unit);
                let response = ui.add(field.custom_parser(quantity::read));
                let told = || say!(tool_clamp_field, number = id(number + 1), axis);
                response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, told()));
                changed |= response.changed();
            }
        });
    }
    changed
}
