//! Clamps on the part: their files, and where they stand.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::dialogs::Purpose;
use super::super::super::{quantity, theme};
use crate::beam::Obstacle;
use crate::document::Edit;
use crate::text::{id, say};
use eframe::egui::{self, DragValue};

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let mut clamps = context.document.job().clamps.clone();
    let (mut gone, mut dragged) = (None, false);
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
        actions.edit(Edit::Clamps(clamps));
    } else if dragged {
        actions.drag(Edit::Clamps(clamps), "clamps");
    }
    if ui.button(say!(tool_add_clamp)).on_hover_text(say!(tool_add_clamp_tip)).clicked() {
        actions.ask(Purpose::Clamp);
    }
}

/// Where a clamp stands; returns whether that was changed.
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
