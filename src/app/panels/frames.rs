//! Where laser, part and flange stand: the frames in use, each may be set for this job, and how well
//! those of the cell file fit what was measured.

use super::super::{App, quantity, theme};
use crate::cell::calibration::CalibrationNote;
use crate::cell::{Cell, Frame, Mount};
use crate::document::Edit;
use crate::document::model::CellFile;
use eframe::egui::{self, DragValue, RichText};

/// A frame of the panel.
struct Row {
    mount: Mount,
    key: &'static str,
    name: &'static str,
    tip: &'static str,
    /// Its place in the job; the cell file alone has the others.
    own: Option<fn(&mut CellFile) -> &mut Option<Frame>>,
}

const ROWS: [Row; 4] = [
    Row {
        mount: Mount::PartInHand,
        key: "base_from_laser",
        name: "Laser in the base",
        tip: "Where the focus is in the robot's base; z against the light",
        own: Some(|c| &mut c.base_from_laser),
    },
    Row {
        mount: Mount::PartInHand,
        key: "flange_from_part",
        name: "Part on the flange",
        tip: "How the part is held: its origin and axes on the flange",
        own: Some(|c| &mut c.flange_from_part),
    },
    Row {
        mount: Mount::ToolInHand,
        key: "base_from_part",
        name: "Part in the base",
        tip: "Where the part lies in the robot's base",
        own: Some(|c| &mut c.base_from_part),
    },
    Row {
        mount: Mount::ToolInHand,
        key: "flange_from_tool",
        name: "Head on the flange",
        tip: "Where the focus is on the flange; z with the light. Belongs to the cell file",
        own: None,
    },
];

/// A frame as people read it.
pub(super) fn said(frame: &Frame) -> String {
    // Rounded, and + 0 so that no −0.0 is shown.
    let round = |v: f64| (v * 10.0).round() / 10.0 + 0.0;
    let ([x, y, z], [rz, ry, rx]) = (frame.position_mm.map(round), frame.rz_ry_rx_deg.map(round));
    format!("{x:.1} {y:.1} {z:.1} mm  RZ {rz:.1}° RY {ry:.1}° RX {rx:.1}°")
}

/// A number of a field: three decimals where they say anything, never −0.
fn figure(value: f64) -> String {
    let text = format!("{:.3}", (value * 1000.0).round() / 1000.0 + 0.0);
    match text.strip_suffix("00") {
        Some(short) => short.to_owned(),
        None => text.trim_end_matches('0').to_owned(),
    }
}

/// How well a frame fits what was measured.
fn fit(note: &CalibrationNote) -> (String, String) {
    if note.residuals_mm.is_empty() {
        return ("measured by three points".into(), "Three points leave nothing over to tell how good they are".into());
    }
    let what = if note.method == "tip_poses" { "pose" } else { "point" };
    let each = note.residuals_mm.iter().enumerate().map(|(i, mm)| format!("{what} {}: {mm:.2} mm", i + 1));
    let text = format!("measured: rms {:.2} mm, worst {:.2} mm", note.rms_mm, note.worst_mm);
    (text, format!("How far each {what} is off\n{}", each.collect::<Vec<_>>().join("\n")))
}

impl App {
    pub(super) fn frames(&mut self, ui: &mut egui::Ui) {
        let Some(Ok(cell)) = self.derived.pipeline.cell() else { return };
        let cell = cell.clone();
        let mount = self.document.job().cell.mount.unwrap_or(cell.mount);
        let rows = ROWS.iter().filter(|r| r.mount == mount);
        let notes = cell.calibrations();
        for row in rows {
            let note = notes.iter().find(|n| n.frame == row.key);
            self.frame(ui, row, &cell, note);
        }
    }

    fn frame(&mut self, ui: &mut egui::Ui, row: &Row, cell: &Cell, note: Option<&CalibrationNote>) {
        let Some(of_cell) = cell.frames().into_iter().find(|(key, _)| *key == row.key).map(|(_, f)| f) else { return };
        let mut job_cell = self.document.job().cell.clone();
        let Some(own) = row.own.map(|own| own(&mut job_cell)) else {
            ui.label(row.name).on_hover_text(row.tip);
            ui.add(egui::Label::new(RichText::new(said(of_cell)).monospace().small()).wrap());
            calibrated(ui, note);
            return;
        };
        let is_own = own.is_some();
        let mut frame = own.clone().unwrap_or_else(|| of_cell.clone());
        let mut changed = false;
        ui.horizontal(|ui| {
            ui.label(row.name).on_hover_text(row.tip);
            if is_own {
                let dot = RichText::new("●").small().color(theme::ACCENT);
                ui.label(dot).on_hover_text("Set for this job, in place of the cell file's");
                let reset = ui.small_button("↺").on_hover_text(format!("Back to the cell file's:\n{}", said(of_cell)));
                let name = format!("reset {}", row.name.to_lowercase());
                reset.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, name.clone()));
                if reset.clicked() {
                    *own = None;
                    changed = true;
                }
            }
        });
        if changed {
            self.edit(Edit::Frames(Box::new(job_cell)));
            return;
        }
        let lines = [
            (["x", "y", "z"], " mm", 10_000.0, 0.5, &mut frame.position_mm),
            (["RZ", "RY", "RX"], "°", 360.0, 0.2, &mut frame.rz_ry_rx_deg),
        ];
        for (axes, unit, most, speed, values) in lines {
            ui.horizontal(|ui| {
                for (axis, value) in axes.into_iter().zip(values) {
                    let field = DragValue::new(value)
                        .speed(speed)
                        .range(-most..=most)
                        .custom_formatter(|v, _| figure(v))
                        .prefix(format!("{axis} "))
                        .suffix(unit)
                        .update_while_editing(false)
                        .custom_parser(quantity::read);
                    let response = ui.add_sized([82.0, 20.0], field).on_hover_text(row.tip);
                    let name = format!("{} {axis}", row.name);
                    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, name.clone()));
                    changed |= response.changed();
                }
            });
        }
        if changed && frame.position_mm.iter().chain(&frame.rz_ry_rx_deg).all(|v| v.is_finite()) {
            *own = Some(Frame::new(frame.position_mm, frame.rz_ry_rx_deg));
            self.edit_dragging(&Edit::Frames(Box::new(job_cell)), row.key);
        }
        // The measurements are of the cell file's frame.
        calibrated(ui, note.filter(|_| !is_own));
    }
}

fn calibrated(ui: &mut egui::Ui, note: Option<&CalibrationNote>) {
    if let Some((text, tip)) = note.map(fit) {
        ui.label(RichText::new(text).small().weak()).on_hover_text(tip);
    }
}

#[cfg(test)]
mod tests {
    use super::figure;

    #[test]
    fn figures_are_short_and_never_minus_zero() {
        let cases = [(380.0, "380.0"), (-0.0002, "0.0"), (0.14, "0.14"), (-12.3456, "-12.346"), (1.5, "1.5")];
        for (value, text) in cases {
            assert_eq!(figure(value), text);
        }
    }
}
