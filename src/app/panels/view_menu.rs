//! The context menu of the 3D view: what can be done at the place, and with the surface, that was right clicked.

use super::super::actions::Actions;
use super::super::command::{Command, More};
use super::super::context::Context;
use super::going_on;
use super::menu::told_why;
use crate::document::{Edit, StartFrom};
use crate::text::say;
use eframe::egui;

/// Commands on the surface.
const COMMANDS: [Command; 9] = [
    Command::Clean,
    Command::Unclean,
    Command::Hide,
    Command::Isolate,
    Command::ShowAll,
    Command::Select(More::SameShape),
    Command::Select(More::Neighbours),
    Command::FlipSurface,
    Command::Fit,
];

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    spiral_centre(ui, context, actions);
    first_border(ui, context, actions);
    going_on::from_place(ui, context, actions);
    for command in COMMANDS {
        let button = egui::Button::new(command.name());
        let response = ui.add_enabled(context.is_enabled(command), button);
        if told_why(response, command, context).clicked() {
            actions.command(command);
            ui.close();
        }
    }
}

/// The centre of the surface's spiral goes to the place.
fn spiral_centre(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let place = context.spiral_place();
    let button = ui.add_enabled(place.is_some(), egui::Button::new(say!(view_spiral_centre_here)));
    if button.on_disabled_hover_text(say!(view_only_with_spiral)).clicked() {
        if let Some((surface, at)) = place {
            actions.edit(Edit::SurfaceCentre(surface, Some(at.coords.into())));
        }
        ui.close();
    }
}

/// The surface's offset lines start from the border nearest to the place.
fn first_border(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let border = context.border_place();
    let button = ui.add_enabled(border.is_some(), egui::Button::new(say!(view_offset_from_this_border)));
    let button = match border.and_then(|(surface, index)| context.borders.words(surface.0, index)) {
        Some(words) => button.on_hover_text(words),
        None => button,
    };
    if button.on_disabled_hover_text(say!(view_only_with_offset)).clicked() {
        if let Some((surface, index)) = border {
            actions.edit(Edit::SurfaceBorder(surface, Some(StartFrom::Border(index))));
        }
        ui.close();
    }
}
