//! A button that takes a tool for the scan into the hand, or lays it down.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::scan_tool::ScanTool;
use super::super::entry::{Drawn, Entry};
use crate::text::say;
use eframe::egui::{self, Role, WidgetInfo};

/// The largest brush, mm.
const MOST_MM: f64 = 1000.0;

/// The button, with its word and its accessible name; `is_in_hand`: that tool is in the hand now.
pub(super) fn tool_button(
    ui: &mut egui::Ui,
    [word, told]: [String; 2],
    is_in_hand: bool,
    actions: &mut Actions,
    tool: impl FnOnce() -> ScanTool,
) {
    let button = ui.selectable_label(is_in_hand, word);
    button.widget_info(|| WidgetInfo::selected(Role::Button, true, is_in_hand, told.clone()));
    if button.clicked() {
        let taken = (!is_in_hand).then(tool);
        actions.session(move |s| {
            s.empty_hand();
            s.scan_tool = taken;
        });
    }
}

/// A brush for a scan of this size: wide enough to see, mm.
pub(super) fn brush_mm(context: Context<'_>) -> f64 {
    let size_mm = context.derived.part.as_ref().map_or(100.0, |p| p.mesh.diagonal());
    (0.03 * size_mm * 10.0).round().max(1.0) * 0.1
}

/// The radius of a brush; whether it was changed.
pub(super) fn radius(ui: &mut egui::Ui, radius_mm: &mut f64) -> Drawn {
    let entry =
        Entry { speed: 0.02, prefix: say!(scan_tool_radius_prefix), ..Entry::new(0.01..=MOST_MM, say!(unit_mm)) };
    let drawn = entry.show(ui, radius_mm);
    drawn.response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, say!(scan_tool_radius)));
    drawn
}

/// What to do now, as a line.
pub(super) fn hint(ui: &mut egui::Ui, text: String) {
    ui.label(egui::RichText::new(text).color(ui.visuals().warn_fg_color));
}

impl Context<'_> {
    /// The tool for the scan that is in the hand.
    pub(super) fn scan_tool(&self) -> Option<&ScanTool> {
        self.session.scan_tool.as_ref()
    }
}
