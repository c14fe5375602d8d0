//! The menu bar, made from the command table.

use super::super::actions::Actions;
use super::super::command::{Command, Menu, Toggle};
use super::super::context::Context;
use crate::text::{Sentence as _, say};
use eframe::egui::{self, Align, Layout};

/// Commands that are always in sight.
const BUTTONS: [Command; 4] = [Command::Open, Command::Save, Command::Undo, Command::Redo];

/// What stands beside the view.
const SWITCHES: [Toggle; 5] = [Toggle::ProgramText, Toggle::Plots, Toggle::AccessMap, Toggle::Dose, Toggle::Cell];

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    egui::MenuBar::new().ui(ui, |ui| {
        for menu in Menu::ALL {
            ui.menu_button(menu.title(), |ui| rows(ui, menu, context, actions));
        }
        ui.separator();
        for command in BUTTONS {
            let name = command.name();
            let tip = context.name_now(command) + "  " + &command.keys_text(ui.ctx());
            let button = egui::Button::new(name.trim_end_matches('…')).frame(false);
            if ui.add_enabled(context.is_enabled(command), button).on_hover_text(tip).clicked() {
                actions.command(command);
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| switches(ui, context, actions));
    });
}

fn rows(ui: &mut egui::Ui, menu: Menu, context: Context<'_>, actions: &mut Actions) {
    for command in menu.commands() {
        let on = if context.is_shown(command) { "● " } else { "" };
        let button = egui::Button::new(format!("{on}{}", context.name_now(command)));
        let button = button.shortcut_text(command.keys_text(ui.ctx()));
        let response = ui.add_enabled(context.is_enabled(command), button);
        if told_why(response, command, context).clicked() {
            actions.command(command);
            ui.close();
        }
    }
    if menu == Menu::File && !context.recent.is_empty() {
        ui.separator();
        for path in context.recent {
            let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
            if ui.button(name).on_hover_text(path.display().to_string()).clicked() {
                actions.open(path.clone());
                ui.close();
            }
        }
    }
}

/// Says on hover why a command cannot be given, where that is not to be seen.
pub(super) fn told_why(response: egui::Response, command: Command, context: Context<'_>) -> egui::Response {
    match context.why_not(command) {
        Some(why) => response.on_disabled_hover_text(why),
        None => response,
    }
}

/// Opens what stands beside the view.
fn switches(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    if context.derived.plan().is_none() && context.derived.cell.is_none() {
        return;
    }
    for command in SWITCHES.map(Command::Toggle) {
        let button = egui::Button::selectable(context.is_shown(command), command.name());
        let response = ui.add_enabled(context.is_enabled(command), button).on_hover_text(command.keys_text(ui.ctx()));
        let why = context.why_not(command).unwrap_or_else(|| say!(menu_needs_robot));
        if response.on_disabled_hover_text(why).clicked() {
            actions.command(command);
        }
    }
}

impl Context<'_> {
    /// The name of a command, with what it would do now: "Undo move 3 surfaces to clean".
    fn name_now(self, command: Command) -> String {
        let step = match command {
            Command::Undo => self.document.undo_step(),
            Command::Redo => self.document.redo_step(),
            _ => None,
        };
        step.map_or_else(
            || command.name(),
            |step| say!(command_with_step, name = command.name(), step = step.sentence()),
        )
    }
}
