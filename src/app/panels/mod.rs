//! The panels: each shows a part of the state and sends commands and edits.

mod dialogs;
mod lists;
mod menu;
mod parameters;
mod problems;
mod start;
mod status;
mod timeline;

use super::command::{COMMANDS, Command};
use eframe::egui;

/// Name of a command.
pub(super) fn name_of(command: Command) -> &'static str {
    COMMANDS.iter().find(|r| r.command == command).map_or("", |r| r.name)
}

/// Its keys, as written on this system.
pub(super) fn keys_of(ctx: &egui::Context, command: Command) -> String {
    let keys = COMMANDS.iter().find(|r| r.command == command).and_then(|r| r.keys);
    keys.map_or_else(String::new, |k| ctx.format_shortcut(&k))
}
