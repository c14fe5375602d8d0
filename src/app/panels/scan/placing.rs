//! Where the scanner stands in the cell: its frame in figures, or fitted to markers that the robot touched. Without it
//! nothing of the scan goes to the cell.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::theme;
use super::super::frames;
use super::place::place;
use crate::cell::calibration::PointPair;
use crate::cell::{Frame, Mount};
use crate::document::Edit;
use crate::document::scan_edit::ScanEdit;
use crate::text::{Sentence as _, fixed, id, say, scan_not_placed};
use eframe::egui::{self, RichText, Role, WidgetInfo};

/// Fewest markers.
const FEWEST: usize = 3;
const FAR_MM: f64 = 100_000.0;

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    theme::heading(ui, &say!(scan_placing));
    let Some(mount) = mount(context) else { return };
    let given = context.document.job().scan.scanner(mount);
    let markers = context.session.markers.as_deref().or_else(|| given.and_then(Frame::points));
    if given.is_none() {
        ui.label(RichText::new(theme::capital(&scan_not_placed())).color(ui.visuals().warn_fg_color));
    }
    if mount == Mount::PartInHand {
        ui.label(say!(scan_placing_part_in_hand));
    }
    ui.horizontal_wrapped(|ui| {
        if given.is_none() && ui.button(say!(scan_placing_by_frame)).clicked() {
            actions.session(|s| s.markers = None);
            actions.scan(ScanEdit::Scanner(mount, Some(Frame::new([0.0; 3], [0.0; 3]))));
        }
        if markers.is_none() && ui.button(say!(scan_placing_by_markers)).clicked() {
            let empty = vec![PointPair { model: [0.0; 3], measured: [0.0; 3] }; FEWEST];
            actions.session(|s| s.markers = Some(empty));
        }
        if given.is_some() && ui.button(say!(scan_placing_forget)).clicked() {
            actions.session(|s| s.markers = None);
            actions.scan(ScanEdit::Scanner(mount, None));
        }
    });
    match (markers, given) {
        (Some(markers), _) => table(ui, markers, (mount, given), actions),
        (None, Some(given)) => {
            let mut frame = given.clone();
            let [name, tip] = match mount {
                Mount::ToolInHand => [say!(scan_placing_frame), say!(scan_placing_frame_tip)],
                Mount::PartInHand => [say!(scan_placing_frame_on_flange), say!(scan_placing_frame_on_flange_tip)],
            };
            if frames::figures(ui, &name, &tip, &mut frame) {
                let frame = Frame::new(frame.position_mm, frame.rz_ry_rx_deg);
                actions.drag(Edit::Scan(Box::new(ScanEdit::Scanner(mount, Some(frame)))), "frame of the scanner");
            }
        }
        (None, None) => {}
    }
}

/// How the part is held; `None` while the cell cannot be used.
fn mount(context: Context<'_>) -> Option<Mount> {
    let of_cell = || Some(context.derived.pipeline.cell()?.ok()?.mount);
    context.document.job().cell.mount.or_else(of_cell)
}

/// The markers with what each is off; as soon as they tell a frame it is the job's.
fn table(ui: &mut egui::Ui, markers: &[PointPair], (mount, given): (Mount, Option<&Frame>), actions: &mut Actions) {
    let mut now = markers.to_vec();
    let fitted = Frame::of_points(markers.to_vec());
    let off_mm = fitted.as_ref().ok().and_then(|f| f.calibration("base_from_scan")).map(|note| note.residuals_mm);
    let mut gone = None;
    for (at, marker) in now.iter_mut().enumerate() {
        ui.horizontal(|ui| {
            let remove = ui.small_button("×");
            remove.widget_info(|| {
                WidgetInfo::labeled(Role::Button, true, say!(scan_placing_remove, marker = id(at + 1)))
            });
            if remove.clicked() {
                gone = Some(at);
            }
            ui.label(match off_mm.as_ref().and_then(|off| off.get(at)) {
                Some(mm) => say!(scan_placing_marker_off, marker = id(at + 1), off = fixed(*mm, 2)),
                None => say!(scan_placing_marker, marker = id(at + 1)),
            });
        });
        let touched = match mount {
            Mount::ToolInHand => say!(scan_placing_in_base),
            Mount::PartInHand => say!(scan_placing_on_flange),
        };
        let rows = [(say!(scan_placing_in_scan), &mut marker.model), (touched, &mut marker.measured)];
        for (frame, place) in rows {
            figures(ui, at, &frame, place);
        }
    }
    if let Some(at) = gone {
        now.remove(at);
    }
    ui.horizontal(|ui| {
        if ui.button(say!(scan_placing_add)).clicked() {
            now.push(PointPair { model: [0.0; 3], measured: [0.0; 3] });
        }
    });
    match &fitted {
        Err(why) => drop(ui.label(RichText::new(theme::capital(&why.sentence())).color(ui.visuals().warn_fg_color))),
        Ok(frame) => drop(ui.label(RichText::new(frames::said(frame)).monospace().small())),
    }
    if now != markers {
        take(now, (mount, given), actions);
    }
}

/// The place of a marker in one of the two frames.
fn figures(ui: &mut egui::Ui, at: usize, frame: &str, at_mm: &mut [f64; 3]) {
    ui.label(RichText::new(frame).small());
    place(ui, at_mm, FAR_MM, |axis| say!(scan_placing_field, marker = id(at + 1), frame, axis));
}

/// Markers that tell a frame go into the job; others wait in the session.
fn take(markers: Vec<PointPair>, (mount, given): (Mount, Option<&Frame>), actions: &mut Actions) {
    match Frame::of_points(markers.clone()) {
        Ok(frame) => {
            actions.session(|s| s.markers = None);
            if given != Some(&frame) {
                actions.drag(Edit::Scan(Box::new(ScanEdit::Scanner(mount, Some(frame)))), "markers of the scan");
            }
        }
        Err(_) => actions.session(|s| s.markers = Some(markers)),
    }
}
