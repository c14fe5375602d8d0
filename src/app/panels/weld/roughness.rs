//! Roughness before and after grinding at numbered points (P4 Fig. 28), as the operator measured it.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::entry::{Drawn, Entry, refused};
use crate::document::model::RoughnessReading;
use crate::document::{Edit, WeldEdit};
use crate::text::{fixed, id, say};
use eframe::egui::{self, CollapsingHeader, Grid, RichText, Role, WidgetInfo};

/// The roughest that is taken, µm.
const MOST_UM: f64 = 1000.0;
/// Of a skin that is new to the table, µm.
const NEW_UM: f64 = 3.0;

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let now = &context.document.job().weld.roughness;
    let mut readings = now.clone();
    CollapsingHeader::new(say!(weld_panel_roughness)).id_salt("roughness").show(ui, |ui| {
        rows(ui, &mut readings);
        if ui.button(say!(weld_panel_add_point)).clicked() {
            let point = readings.iter().map(|r| r.point).max().unwrap_or(0).saturating_add(1);
            readings.push(RoughnessReading { point, before_um: NEW_UM, after_um: None });
        }
        if let Some(r) = context.weld.report().and_then(|report| report.roughness.as_ref()) {
            let (before, after, fell) = (fixed(r.before_um, 2), fixed(r.after_um, 2), fixed(r.fell_percent, 1));
            ui.label(say!(weld_panel_roughness_mean, points = r.points, before, after, fell));
        }
    });
    if readings.len() != now.len() {
        actions.grind(WeldEdit::Roughness(readings));
    } else if readings != *now {
        actions.drag(Edit::Grind(Box::new(WeldEdit::Roughness(readings))), "roughness of the weld");
    }
}

fn rows(ui: &mut egui::Ui, readings: &mut Vec<RoughnessReading>) {
    if readings.is_empty() {
        return;
    }
    let (mut gone, mut drawn) = (None, Vec::new());
    Grid::new("roughness of the weld").spacing([10.0, 3.0]).show(ui, |ui| {
        for title in [say!(weld_panel_point), say!(weld_panel_before_um), say!(weld_panel_after_um), String::new()] {
            ui.label(RichText::new(title).strong());
        }
        ui.end_row();
        for (i, reading) in readings.iter_mut().enumerate() {
            let point = reading.point.to_string();
            ui.label(&point);
            let told = say!(weld_panel_before_at, point = id(reading.point));
            drawn.push(field(ui, &mut reading.before_um, told));
            match &mut reading.after_um {
                Some(after_um) => {
                    let told = say!(weld_panel_after_at, point = id(reading.point));
                    drawn.push(field(ui, after_um, told));
                }
                None => {
                    let measured = ui.button(say!(weld_panel_measured)).on_hover_text(say!(weld_panel_measured_tip));
                    let told = || say!(weld_panel_measure_after, point = id(reading.point));
                    measured.widget_info(|| WidgetInfo::labeled(Role::Button, true, told()));
                    if measured.clicked() {
                        reading.after_um = Some(reading.before_um);
                    }
                }
            }
            let remove = ui.small_button("×").on_hover_text(say!(weld_panel_remove_point));
            let told = || say!(weld_panel_remove_point_name, point = id(reading.point));
            remove.widget_info(|| WidgetInfo::labeled(Role::Button, true, told()));
            if remove.clicked() {
                gone = Some(i);
            }
            ui.end_row();
        }
    });
    refused(ui, &drawn);
    if let Some(i) = gone {
        readings.remove(i);
    }
}

fn field(ui: &mut egui::Ui, um: &mut f64, told: String) -> Drawn {
    let entry = Entry { speed: 0.02, decimals: 3, ..Entry::new(0.0..=MOST_UM, String::new()) };
    let drawn = entry.show(ui, um);
    drawn.response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, told.clone()));
    drawn
}
