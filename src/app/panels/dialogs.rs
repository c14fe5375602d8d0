//! Small windows: unsaved changes, errors, and the page of shortcuts.

use super::super::actions::Actions;
use super::super::command::Menu;
use super::super::context::Context;
use super::super::session::AfterGuard;
use crate::text::say;
use crate::view::Navigation;
use eframe::egui::{self, Id, Modal, RichText};

/// *Save / Don't save / Cancel* before unsaved changes would be lost.
pub(in super::super) fn guard(ctx: &egui::Context, context: Context<'_>, actions: &mut Actions) {
    let Some(after) = &context.session.after_guard else { return };
    if !context.document.is_dirty() {
        actions.go_on();
        return;
    }
    // A file is being picked.
    if !context.answers.is_empty() {
        return;
    }
    let shown = Modal::new(Id::unique("guard")).show(ctx, |ui| {
        ui.set_width(340.0);
        ui.heading(say!(ask_save));
        let is_close = *after == AfterGuard::Close;
        ui.label(if is_close { say!(ask_save_before_close) } else { say!(ask_save_before_open) });
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            if ui.button(RichText::new(say!(ask_save_yes)).strong()).clicked() {
                actions.session(|s| s.said = say!(ask_saving));
                actions.save();
            }
            if ui.button(say!(ask_save_no)).clicked() {
                actions.go_on();
            }
            if ui.button(say!(ask_cancel)).clicked() {
                actions.session(|s| s.after_guard = None);
            }
        });
    });
    if shown.should_close() {
        actions.session(|s| s.after_guard = None);
    }
}

/// An error, until the operator closes it.
pub(in super::super) fn message(ctx: &egui::Context, context: Context<'_>, actions: &mut Actions) {
    let Some(why) = &context.session.error else { return };
    let shown = Modal::new(Id::unique("error")).show(ctx, |ui| {
        ui.set_width(460.0);
        ui.heading(say!(ask_error));
        ui.label(why);
        ui.add_space(8.0);
        ui.button(say!(ask_close)).clicked()
    });
    if shown.inner || shown.should_close() {
        actions.session(|s| s.error = None);
    }
}

/// All keys, made from the command table.
pub(in super::super) fn help(ctx: &egui::Context, context: Context<'_>, actions: &mut Actions) {
    let mut open = context.session.help_open;
    let window = egui::Window::new(say!(ask_shortcuts)).id(Id::unique("shortcuts")).open(&mut open);
    window.resizable(false).collapsible(false).show(ctx, |ui| {
        egui::ScrollArea::vertical().max_height(520.0).show(ui, |ui| {
            for menu in Menu::ALL {
                ui.label(RichText::new(menu.title()).strong());
                egui::Grid::new(menu.title()).num_columns(2).min_col_width(150.0).show(ui, |ui| {
                    for command in menu.commands().filter(|c| c.keys().is_some()) {
                        ui.label(command.name());
                        ui.monospace(command.keys_text(ctx));
                        ui.end_row();
                    }
                });
            }
            ui.label(RichText::new(say!(ask_view)).strong());
            ui.label(match context.session.navigation {
                Navigation::Slicer => say!(ask_view_mouse),
                Navigation::Cad => say!(ask_view_mouse_cad),
                Navigation::Blender => say!(ask_view_mouse_blender),
            });
            ui.label(say!(ask_view_focus));
        });
    });
    if open != context.session.help_open {
        actions.session(move |s| s.help_open = open);
    }
}
