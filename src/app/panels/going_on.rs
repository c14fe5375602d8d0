//! Going on after a stop: the rows of menus that begin it, and the chip that shows it and ends it.

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use crate::text::{id, say};
use eframe::egui::{self, RichText};

/// The row of the view's menu: from the pass that lies at the place.
pub(super) fn from_place(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let target = context.target_at_menu_place();
    let is_enabled = target.is_some() && context.plan().is_some();
    let button = ui.add_enabled(is_enabled, egui::Button::new(Command::ExportFromPass.name()));
    let button = match target {
        Some((pass, _)) => button.on_hover_text(say!(going_on_tip, pass = id(pass))),
        None => button,
    };
    if button.on_disabled_hover_text(say!(going_on_no_pass)).clicked() {
        if let Some(target) = target {
            actions.go_to_target(target);
            actions.command(Command::ExportFromPass);
        }
        ui.close();
    }
}

/// The menu of the strip and of the sliders: from the current pass.
pub(super) fn menu(response: &egui::Response, context: Context<'_>, actions: &mut Actions) {
    response.context_menu(|ui| {
        let button = egui::Button::new(Command::ExportFromPass.name());
        let response = ui.add_enabled(context.is_enabled(Command::ExportFromPass), button);
        if response.on_hover_text(say!(going_on_tip, pass = id(context.session.playback.at.0))).clicked() {
            actions.command(Command::ExportFromPass);
            ui.close();
        }
    });
}

/// What counts as done, and the button that ends that.
pub(super) fn chip(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some(pass) = context.going_on_from() else { return };
    let text = RichText::new(say!(going_on_chip, pass = id(pass))).strong();
    if ui.button(text).on_hover_text(say!(going_on_chip_tip, pass = id(pass))).clicked() {
        actions.session(|s| s.going_on = None);
    }
}
