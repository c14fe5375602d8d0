//! What of the model does not count when the scan is laid: painted, taken off, or in boxes.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::scan_tool::{LeaveOutDraft, LeaveOutHand, ScanTool, around, left_out};
use super::super::entry::refused;
use super::tool_button::{brush_mm, hint, radius, tool_button};
use crate::document::scan_edit::ScanEdit;
use crate::text::say;
use crate::view::Bounds;
use eframe::egui::{self, Role, WidgetInfo};

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let of_job = &context.document.job().scan.left_out;
    let draft = match context.scan_tool() {
        Some(ScanTool::LeaveOut(draft)) => Some(draft),
        _ => None,
    };
    ui.horizontal_wrapped(|ui| {
        let begun = || ScanTool::LeaveOut(LeaveOutDraft::new(brush_mm(context)));
        tool_button(ui, [say!(scan_leave_out), say!(scan_leave_out)], draft.is_some(), actions, begun);
        if !of_job.is_empty() {
            ui.label(say!(scan_leave_out_count, count = of_job.len()));
            if ui.small_button(say!(scan_leave_out_clear)).on_hover_text(say!(scan_leave_out_clear_tip)).clicked() {
                actions.scan(ScanEdit::LeftOut(Vec::new()));
            }
        }
    });
    let Some(draft) = draft else { return };
    hands(ui, draft, actions);
    hint(
        ui,
        match (draft.hand, draft.corner) {
            (LeaveOutHand::Brush, _) => say!(scan_leave_out_hint_brush),
            (LeaveOutHand::Rubber, _) => say!(scan_leave_out_hint_rubber),
            (LeaveOutHand::Corners, None) => say!(scan_leave_out_hint_corner),
            (LeaveOutHand::Corners, Some(_)) => say!(scan_leave_out_hint_other_corner),
        },
    );
    let button = egui::Button::new(say!(scan_leave_out_selected));
    let selected = selected_bounds(context);
    let response = ui.add_enabled(selected.is_some(), button).on_hover_text(say!(scan_leave_out_selected_tip));
    if let (true, Some(Bounds { min, max })) = (response.clicked(), selected) {
        actions.edit(left_out(of_job, &[around(min, max, draft.radius_mm)]));
    }
}

/// Brush, rubber or corners, and how large.
fn hands(ui: &mut egui::Ui, draft: &LeaveOutDraft, actions: &mut Actions) {
    let mut radius_mm = draft.radius_mm;
    let row = ui.horizontal_wrapped(|ui| {
        let hands = [
            (LeaveOutHand::Brush, say!(scan_leave_out_brush)),
            (LeaveOutHand::Rubber, say!(scan_leave_out_rubber)),
            (LeaveOutHand::Corners, say!(scan_leave_out_corners)),
        ];
        for (hand, name) in hands {
            let button = ui.selectable_label(draft.hand == hand, &name);
            button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, draft.hand == hand, &name));
            if button.clicked() {
                change(actions, move |draft| (draft.hand, draft.corner) = (hand, None));
            }
        }
        radius(ui, &mut radius_mm)
    });
    refused(ui, [&row.inner]);
    if radius_mm != draft.radius_mm {
        change(actions, move |draft| draft.radius_mm = radius_mm);
    }
}

fn change(actions: &mut Actions, change: impl FnOnce(&mut LeaveOutDraft) + 'static) {
    actions.session(move |s| {
        if let Some(ScanTool::LeaveOut(draft)) = &mut s.scan_tool {
            change(draft);
        }
    });
}

/// The box around the surfaces that are selected, part frame.
pub(super) fn selected_bounds(context: Context<'_>) -> Option<Bounds> {
    let (part, surfaces) = (context.derived.part.as_ref()?, &context.derived.surfaces);
    let facets = context.session.selected.iter().filter_map(|n| surfaces.get(*n)).flat_map(|s| &s.facets);
    Bounds::around(facets.flat_map(|&f| part.mesh.corners(f as usize)))
}
