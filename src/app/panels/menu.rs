//! The menu bar, made from the command table.

use super::super::actions::Actions;
use super::super::command::{Command, Menu};
use super::super::context::Context;
use super::super::toggle::Toggle;
use crate::text::{Sentence as _, say};
use eframe::egui::{self, Align, Layout};

/// Commands that are always in sight.
const BUTTONS: [Command; 4] = [Command::Open, Command::Save, Command::Undo, Command::Redo];

/// Below this the switches would stand over the buttons: they go into a menu.
const TIGHT: f32 = 1010.0;

/// What stands beside the view.
const SWITCHES: [Toggle; 7] = [
    Toggle::Settings,
    Toggle::ProgramText,
    Toggle::Plots,
    Toggle::AccessMap,
    Toggle::Dose,
    Toggle::Cell,
    Toggle::Lists,
];

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let is_tight = ui.available_width() < TIGHT;
    egui::MenuBar::new().ui(ui, |ui| {
        for menu in Menu::ALL {
            ui.menu_button(menu.title(), |ui| rows(ui, menu, context, actions));
        }
        ui.separator();
        for command in BUTTONS {
            let name = command.name();
            let tip = context.name_now(command) + "  " + &command.keys_text(ui.ctx());
            let button = egui::Button::new(name.trim_end_matches('…')).frame(false);
            let response = ui.add_enabled(context.is_enabled(command), button).on_hover_text(tip);
            if told_why(response, command, context).clicked() {
                actions.command(command);
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if is_tight && context.derived.part.is_some() {
                let menu = ui.menu_button(say!(menu_panels), |ui| switches(ui, context, actions));
                menu.response.on_hover_text(say!(menu_panels_tip));
            } else {
                switches(ui, context, actions);
            }
        });
    });
}

fn rows(ui: &mut egui::Ui, menu: Menu, context: Context<'_>, actions: &mut Actions) {
    for command in menu.commands() {
        let on = if context.is_shown(command) { "● " } else { "" };
        let button = egui::Button::new(format!("{on}{}", context.name_now(command)));
        let button = button.shortcut_text(command.keys_text(ui.ctx()));
        let response = ui.add_enabled(context.is_enabled(command), button);
        let response = match command {
            Command::Toggle(what) => response.on_hover_text(what.about()),
            _ => response,
        };
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

/// What a toggle shows, and its keys.
pub(super) fn tip(command: Command, ctx: &egui::Context) -> String {
    let about = if let Command::Toggle(what) = command { what.about() } else { String::new() };
    format!("{about}  {}", command.keys_text(ctx)).trim_end().to_owned()
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
    if context.derived.part.is_none() {
        return;
    }
    for command in SWITCHES.map(Command::Toggle) {
        let button = egui::Button::selectable(context.is_shown(command), command.name());
        let response = ui.add_enabled(context.is_enabled(command), button).on_hover_text(tip(command, ui.ctx()));
        if told_why(response, command, context).clicked() {
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
