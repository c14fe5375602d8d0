//! Where laser, part and flange stand: the frames in use, each may be set for this job, and how well
//! those of the cell file fit what was measured.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::gizmo::state::Moved;
use super::entry::{Entry, refused};
use super::handles_button;
use crate::cell::calibration::CalibrationNote;
use crate::cell::frame::{FARTHEST_ORIGIN_MM, MOST_TURNS_DEG};
use crate::cell::{Frame, Mount};
use crate::document::Edit;
use crate::document::model::JobCell;
use crate::text::{fixed, id, say, short};
use eframe::egui::{self, RichText};

/// A frame of the panel.
struct Row {
    mount: Mount,
    key: &'static str,
    name: fn() -> String,
    tip: fn() -> String,
    /// Its place in the job; the cell file alone has the others.
    own: Option<Own>,
}

/// A frame that a job can set.
struct Own {
    frame: fn(&mut JobCell) -> &mut Option<Frame>,
    /// Accessible name of the way back to the cell file's.
    reset: fn() -> String,
}

const ROWS: [Row; 4] = [
    Row {
        mount: Mount::PartInHand,
        key: "base_from_laser",
        name: || say!(frames_laser_in_base),
        tip: || say!(frames_laser_in_base_tip),
        own: Some(Own { frame: |c| &mut c.base_from_laser, reset: || say!(frames_reset_laser_in_base) }),
    },
    Row {
        mount: Mount::PartInHand,
        key: "flange_from_part",
        name: || say!(frames_part_on_flange),
        tip: || say!(frames_part_on_flange_tip),
        own: Some(Own { frame: |c| &mut c.flange_from_part, reset: || say!(frames_reset_part_on_flange) }),
    },
    Row {
        mount: Mount::ToolInHand,
        key: "base_from_part",
        name: || say!(frames_part_in_base),
        tip: || say!(frames_part_in_base_tip),
        own: Some(Own { frame: |c| &mut c.base_from_part, reset: || say!(frames_reset_part_in_base) }),
    },
    Row {
        mount: Mount::ToolInHand,
        key: "flange_from_tool",
        name: || say!(frames_head_on_flange),
        tip: || say!(frames_head_on_flange_tip),
        own: None,
    },
];

/// A frame as people read it.
pub(super) fn said(frame: &Frame) -> String {
    let tenths = |v: f64| fixed(v, 1);
    let ([x, y, z], [rz, ry, rx]) = (frame.position_mm.map(tenths), frame.rz_ry_rx_deg.map(tenths));
    say!(frames_pose, x, y, z, rz, ry, rx)
}

/// How well a frame fits what was measured.
fn fit(note: &CalibrationNote) -> (String, String) {
    if note.residuals_mm.is_empty() {
        return (say!(frames_three_points), say!(frames_three_points_tip));
    }
    let is_of_poses = note.method == "tip_poses";
    let each = note.residuals_mm.iter().enumerate().map(|(i, mm)| {
        let (number, off) = (id(i + 1), fixed(*mm, 2));
        if is_of_poses { say!(frames_pose_off, number, off) } else { say!(frames_point_off, number, off) }
    });
    let each = each.collect::<Vec<_>>().join("\n");
    let text = say!(frames_measured, rms = fixed(note.rms_mm, 2), worst = fixed(note.worst_mm, 2));
    let head = if is_of_poses { say!(frames_poses_off) } else { say!(frames_points_off) };
    (text, format!("{head}\n{each}"))
}

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some(Ok(cell)) = context.derived.pipeline.cell() else { return };
    let mount = context.document.job().cell.mount.unwrap_or(cell.mount);
    let notes = cell.calibrations();
    if context.document.job().cell.file.is_empty() {
        let text = RichText::new(say!(frames_examples)).small().color(ui.visuals().warn_fg_color);
        ui.label(text).on_hover_text(say!(frames_examples_tip));
    }
    for row in ROWS.iter().filter(|r| r.mount == mount) {
        let Some(of_cell) = cell.frames().into_iter().find(|(key, _)| *key == row.key).map(|(_, f)| f) else {
            continue;
        };
        let note = notes.iter().find(|n| n.frame == row.key);
        match &row.own {
            Some(own) => of_job(ui, row, own, of_cell, note, context, actions),
            None => {
                ui.label((row.name)()).on_hover_text((row.tip)());
                ui.add(egui::Label::new(RichText::new(said(of_cell)).monospace().small()).wrap());
                calibrated(ui, note);
            }
        }
    }
}

/// A frame that the job can set in place of the cell file's.
fn of_job(
    ui: &mut egui::Ui,
    row: &Row,
    own: &Own,
    of_cell: &Frame,
    note: Option<&CalibrationNote>,
    context: Context<'_>,
    actions: &mut Actions,
) {
    let mut job_cell = context.document.job().cell.clone();
    let now = (own.frame)(&mut job_cell);
    let is_own = now.is_some();
    if heading(ui, row, is_own.then_some(own), of_cell) {
        *now = None;
        actions.edit(Edit::Frames(Box::new(job_cell)));
        return;
    }
    by_hand(ui, row.key, context, actions);
    let mut frame = now.clone().unwrap_or_else(|| of_cell.clone());
    let is_finite = |f: &Frame| f.position_mm.iter().chain(&f.rz_ry_rx_deg).all(|v| v.is_finite());
    if figures(ui, &(row.name)(), &(row.tip)(), &mut frame) && is_finite(&frame) {
        *now = Some(Frame::new(frame.position_mm, frame.rz_ry_rx_deg));
        actions.drag(Edit::Frames(Box::new(job_cell)), row.key);
    }
    // The measurements are of the cell file's frame.
    calibrated(ui, note.filter(|_| !is_own));
}

/// Handles in the view of the cell, for what stands there.
fn by_hand(ui: &mut egui::Ui, key: &str, context: Context<'_>, actions: &mut Actions) {
    let moved = match key {
        "base_from_laser" => Moved::Laser,
        "base_from_part" => Moved::Part,
        _ => return,
    };
    let why_not = (!context.is_in_cell()).then(|| say!(frames_move_not));
    handles_button::ui(ui, moved, [say!(handles_move), say!(frames_move_tip)], why_not, context, actions);
}

/// The frame's name, and the way back if it is the job's own; whether that was taken.
fn heading(ui: &mut egui::Ui, row: &Row, own: Option<&Own>, of_cell: &Frame) -> bool {
    let taken = ui.horizontal(|ui| {
        ui.label((row.name)()).on_hover_text((row.tip)());
        let Some(own) = own else { return false };
        let dot = RichText::new("●").small().color(ui.visuals().hyperlink_color);
        ui.label(dot).on_hover_text(say!(frames_set_for_job));
        let reset = ui.small_button("↺").on_hover_text(say!(frames_back, pose = said(of_cell)));
        reset.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, (own.reset)()));
        reset.clicked()
    });
    taken.inner
}

/// Position and angles of a frame, in a line each; returns whether they were changed.
pub(super) fn figures(ui: &mut egui::Ui, name: &str, tip: &str, frame: &mut Frame) -> bool {
    let mut changed = false;
    let lines = [
        (["x", "y", "z"], say!(unit_mm), FARTHEST_ORIGIN_MM, 0.5, &mut frame.position_mm),
        (["RZ", "RY", "RX"], say!(unit_deg), MOST_TURNS_DEG, 0.2, &mut frame.rz_ry_rx_deg),
    ];
    for (axes, unit, most, speed, values) in lines {
        let mut drawn = Vec::new();
        ui.horizontal(|ui| {
            for (axis, value) in axes.into_iter().zip(values) {
                let prefix = format!("{axis} ");
                let size = Some([82.0, 20.0]);
                let field =
                    Entry { speed, prefix, size, written: Some(short), ..Entry::new(-most..=most, unit.clone()) };
                let shown = field.show(ui, value);
                let response = shown.response.clone().on_hover_text(tip);
                let told = || say!(frames_field, frame = name, axis);
                response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, told()));
                changed |= response.changed();
                drawn.push(shown);
            }
        });
        refused(ui, &drawn);
    }
    changed
}

fn calibrated(ui: &mut egui::Ui, note: Option<&CalibrationNote>) {
    if let Some((text, tip)) = note.map(fit) {
        ui.label(RichText::new(text).small().weak()).on_hover_text(tip);
    }
}
