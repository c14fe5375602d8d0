//! What is wrong, and under it the button that writes the program into a folder.

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use super::super::theme;
use super::problems;
use crate::text::{id, say};
use eframe::egui::{self, RichText};

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let height = (0.36 * ui.ctx().content_rect().height()).clamp(90.0, 260.0);
    problems::ui(ui, height, context, actions);
    button(ui, context, actions);
}

fn button(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let ready = context.plan().is_some();
    let text = match context.going_on_from() {
        None => say!(cell_panel_export),
        Some(pass) => say!(cell_panel_export_from_pass, pass = id(pass)),
    };
    let text = RichText::new(text).strong();
    let button = egui::Button::new(text).fill(theme::ACCENT.gamma_multiply(0.6));
    let tip = say!(cell_panel_export_tip, keys = Command::Export.keys_text(ui.ctx()));
    let size = egui::vec2(ui.available_width(), 28.0);
    let response = ui.add_enabled_ui(ready, |ui| ui.add_sized(size, button)).inner;
    if response.on_hover_text(tip).on_disabled_hover_text(say!(cell_panel_not_planned)).clicked() {
        actions.command(Command::Export);
    }
    ui.add_space(2.0);
}
