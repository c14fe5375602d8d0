//! Clamps on the part: their files, and where they stand.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::dialogs::Purpose;
use super::super::super::gizmo::state::Moved;
use super::super::super::session::PointerTool;
use super::super::super::theme;
use super::super::entry::{Entry, refused};
use super::super::handles_button;
use crate::beam::Obstacle;
use crate::cell::frame::MOST_TURNS_DEG;
use crate::document::Edit;
use crate::document::job_file::FARTHEST_MM;
use crate::part::Units;
use crate::text::{choices, id, say};
use eframe::egui;

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let mut clamps = context.document.job().clamps.clone();
    let (mut gone, mut chosen, mut dragged) = (None, false, false);
    for (i, c) in clamps.iter_mut().enumerate() {
        ui.horizontal(|ui| {
            ui.add(egui::Label::new(say!(tool_clamp, number = id(i + 1), file = &c.file)).truncate());
            if ui.small_button("×").on_hover_text(say!(tool_remove_clamp)).clicked() {
                gone = Some(i);
            }
        });
        by_hand(ui, i, context, actions);
        dragged |= placed(ui, c, i);
        chosen |= units(ui, c, i);
    }
    if let Some(i) = gone {
        clamps.remove(i);
        actions.edit(Edit::Clamps(clamps));
    } else if chosen {
        actions.edit(Edit::Clamps(clamps));
    } else if dragged {
        actions.drag(Edit::Clamps(clamps), "clamps");
    }
    if ui.button(say!(tool_add_clamp)).on_hover_text(say!(tool_add_clamp_tip)).clicked() {
        actions.ask(Purpose::Clamp);
    }
}

/// Handles in the view, and a click on the part.
fn by_hand(ui: &mut egui::Ui, i: usize, context: Context<'_>, actions: &mut Actions) {
    let is_put = context.session.tool == PointerTool::PutClamp(i);
    ui.horizontal(|ui| {
        let words = [say!(tool_clamp_move_name, number = id(i + 1)), say!(tool_clamp_move_tip)];
        handles_button::ui(ui, Moved::Clamp(i), words, None, context, actions);
        let button = ui.selectable_label(is_put, say!(tool_clamp_put)).on_hover_text(say!(tool_clamp_put_tip));
        button.widget_info(|| {
            egui::WidgetInfo::selected(egui::Role::Button, true, is_put, say!(tool_clamp_put_name, number = id(i + 1)))
        });
        if button.clicked() {
            actions.session(move |s| {
                s.empty_hand();
                if !is_put {
                    s.tool = PointerTool::PutClamp(i);
                }
            });
        }
    });
}

/// The unit of a clamp's file; returns whether that was changed.
fn units(ui: &mut egui::Ui, clamp: &mut Obstacle, i: usize) -> bool {
    let before = clamp.units;
    ui.horizontal(|ui| {
        theme::name(ui, &say!(tool_clamp_units), 50.0);
        for u in Units::ALL {
            let is_on = before == u;
            let button = ui.selectable_label(is_on, choices::units(u));
            let told = || say!(tool_clamp_units_name, number = id(i + 1), unit = choices::units(u));
            button.widget_info(|| egui::WidgetInfo::selected(egui::Role::RadioButton, true, is_on, told()));
            if button.clicked() {
                clamp.units = u;
            }
        }
    });
    clamp.units != before
}

/// Where a clamp stands; returns whether that was changed.
fn placed(ui: &mut egui::Ui, c: &mut Obstacle, number: usize) -> bool {
    let mut changed = false;
    let rows = [
        (say!(tool_clamp_at), say!(unit_mm), FARTHEST_MM, ["x", "y", "z"], &mut c.position_mm),
        (say!(tool_clamp_turned), say!(unit_deg), MOST_TURNS_DEG, ["RZ", "RY", "RX"], &mut c.rz_ry_rx_deg),
    ];
    for (name, unit, most, axes, values) in rows {
        let mut drawn = Vec::new();
        ui.horizontal(|ui| {
            theme::name(ui, &name, 50.0);
            for (value, axis) in values.iter_mut().zip(axes) {
                let shown = Entry::new(-most..=most, unit.clone()).show(ui, value);
                let told = || say!(tool_clamp_field, number = id(number + 1), axis);
                shown.response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, told()));
                changed |= shown.response.changed();
                drawn.push(shown);
            }
        });
        refused(ui, &drawn);
    }
    changed
}
