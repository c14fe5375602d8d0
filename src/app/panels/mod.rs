//! The panels: each shows a part of the state and sends commands and edits.

mod access;
mod bead;
mod bead_section;
mod beam;
mod cell;
mod compare;
mod dialogs;
mod dose;
mod fields;
mod frames;
mod later;
mod layers;
mod laying;
mod library;
mod lists;
mod menu;
mod own;
mod parameters;
mod plots;
mod problems;
mod program_text;
mod proposal;
mod questions;
mod recipe;
mod scrub;
mod spacing;
mod start;
mod status;
mod timeline;

pub(super) use compare::Compare;
pub(super) use recipe::Draft;

use super::command::{COMMANDS, Command};
use crate::text::clock;
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
