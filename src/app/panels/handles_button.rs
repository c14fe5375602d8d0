//! The button that shows handles on something in the view, or takes them away.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::gizmo::state::{Gizmo, Moved};
use crate::text::say;
use eframe::egui::{self, Role, WidgetInfo};

/// The button. `told`: its accessible name; `why_not`: why it can show nothing now.
pub(super) fn ui(
    ui: &mut egui::Ui,
    moved: Moved,
    [told, tip]: [String; 2],
    why_not: Option<String>,
    context: Context<'_>,
    actions: &mut Actions,
) {
    let is_on = context.session.gizmo.as_ref().is_some_and(|gizmo| gizmo.of == moved);
    let is_enabled = why_not.is_none();
    let button = ui.add_enabled(is_enabled, egui::Button::selectable(is_on, say!(handles_move)));
    button.widget_info(|| WidgetInfo::selected(Role::Button, is_enabled, is_on, told.clone()));
    if button.on_hover_text(tip).on_disabled_hover_text(why_not.unwrap_or_default()).clicked() {
        actions.session(move |s| {
            s.empty_hand();
            s.gizmo = (!is_on).then(|| Gizmo::on(moved));
        });
    }
}
