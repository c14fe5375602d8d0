//! The access map: from which directions a spot can be reached, and why not from the others. Beside it the strip: the
//! tilt along a line with what is blocked, which pins bend by hand.

mod draw_strip;
mod map;
mod palette;
mod strip;
mod strip_scale;

use super::super::actions::Actions;
use super::super::context::Context;
use eframe::egui::{self, vec2};

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let height = ui.available_height();
    ui.horizontal_top(|ui| {
        ui.allocate_ui(vec2(height + 130.0, height), |ui| ui.vertical(|ui| map::ui(ui, context)));
        ui.separator();
        ui.vertical(|ui| strip::ui(ui, context, actions));
    });
}
