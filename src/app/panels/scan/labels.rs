//! Labels on the scan: a click says how far off the model a point is. They stay while the window is open.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::scan_tool::ScanTool;
use super::tool_button::{hint, tool_button};
use crate::text::{fixed, id, say};
use eframe::egui::{self, Role, WidgetInfo};

/// In sight around a label that is gone to, mm.
const AROUND_MM: f64 = 5.0;

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let is_in_hand = matches!(context.scan_tool(), Some(ScanTool::Label));
    let labels = &context.session.labels;
    ui.horizontal_wrapped(|ui| {
        tool_button(ui, [say!(scan_labels), say!(scan_labels)], is_in_hand, actions, || ScanTool::Label);
        if !labels.is_empty() && ui.small_button(say!(scan_labels_clear)).clicked() {
            actions.session(|s| s.labels.clear());
        }
    });
    if is_in_hand {
        hint(ui, say!(scan_labels_hint));
    }
    for (at, label) in labels.iter().enumerate() {
        ui.horizontal(|ui| {
            let gone = ui.small_button("×").on_hover_text(say!(scan_labels_remove));
            gone.widget_info(|| {
                WidgetInfo::labeled(Role::Button, true, say!(scan_labels_remove_name, label = id(at + 1)))
            });
            if gone.clicked() {
                actions.session(move |s| {
                    s.labels.remove(at);
                });
            }
            let [x, y, z]: [f64; 3] = label.at.coords.into();
            let [x, y, z] = [x, y, z].map(|c| fixed(c, 1));
            let text = say!(scan_labels_row, label = id(at + 1), off = signed(label.off_mm), x, y, z);
            if ui.link(text).on_hover_text(say!(scan_panel_show)).clicked() {
                actions.look_at(label.at, AROUND_MM);
            }
        });
    }
}

/// A distance with its sign, mm.
pub(super) fn signed(mm: f64) -> String {
    let told = fixed(mm, 3);
    if mm > 0.0 { format!("+{told}") } else { told }
}
