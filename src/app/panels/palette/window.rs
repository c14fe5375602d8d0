//! The search for a command by words of its name: typed, chosen with the arrow keys or a click, given with Enter.

use super::super::super::actions::Actions;
use super::super::super::command::Command;
use super::super::super::context::Context;
use super::super::menu::told_why;
use crate::text::say;
use eframe::egui::{self, Align2, Id, Key, Modal, Modifiers, Role, ScrollArea, TextEdit, WidgetInfo, vec2};

/// Commands whose name or menu has all the words, those that can be given first.
fn found(text: &str, context: Context<'_>) -> Vec<Command> {
    let words: Vec<String> = text.split_whitespace().map(str::to_lowercase).collect();
    let has_words = |command: &Command| {
        let name = format!("{} {}", command.name(), command.menu().title()).to_lowercase();
        words.iter().all(|word| name.contains(word))
    };
    let all = Command::ALL.iter().copied().filter(|c| *c != Command::Palette);
    let (mut now, never): (Vec<Command>, Vec<Command>) =
        all.filter(has_words).partition(|command| context.is_enabled(*command));
    now.extend(never);
    now
}

pub(in super::super::super) fn ui(ctx: &egui::Context, context: Context<'_>, actions: &mut Actions) {
    let Some(mut palette) = context.session.palette.clone() else { return };
    let area = Modal::default_area(Id::unique("palette")).anchor(Align2::CENTER_TOP, vec2(0.0, 60.0));
    let shown = Modal::new(Id::unique("palette")).area(area).show(ctx, |ui| {
        ui.set_width(440.0);
        // The arrow keys are the list's, not the text's.
        let step = ui.input_mut(|i| {
            let down = i.consume_key(Modifiers::NONE, Key::ArrowDown);
            i32::from(down) - i32::from(i.consume_key(Modifiers::NONE, Key::ArrowUp))
        });
        let field =
            ui.add(TextEdit::singleline(&mut palette.text).hint_text(say!(palette_hint)).desired_width(f32::INFINITY));
        field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, say!(palette_hint)));
        field.request_focus();
        if field.changed() {
            palette.at = 0;
        }
        let rows = found(&palette.text, context);
        palette.at = palette.at.saturating_add_signed(step as isize).min(rows.len().saturating_sub(1));
        let given = ui.input(|i| i.key_pressed(Key::Enter)).then_some(palette.at);
        let clicked = ScrollArea::vertical().max_height(320.0).show(ui, |ui| {
            ui.set_min_width(ui.available_width());
            let rows = rows.iter().enumerate();
            rows.filter(|(at, command)| row(ui, **command, palette.at == *at, step != 0, context))
                .map(|(at, _)| at)
                .last()
        });
        clicked.inner.or(given).and_then(|at| rows.get(at).copied())
    });
    match shown.inner.filter(|command| context.is_enabled(*command)) {
        Some(command) => {
            actions.session(|s| s.palette = None);
            actions.command(command);
        }
        None if shown.should_close() => actions.session(|s| s.palette = None),
        None => actions.session(|s| s.palette = Some(palette)),
    }
}

/// A command with its keys; whether it was clicked.
fn row(ui: &mut egui::Ui, command: Command, is_at: bool, is_moved: bool, context: Context<'_>) -> bool {
    let button = egui::Button::selectable(is_at, command.name()).shortcut_text(command.keys_text(ui.ctx()));
    let button = button.min_size(vec2(ui.available_width(), 0.0));
    let is_enabled = context.is_enabled(command);
    let response = ui.add_enabled(is_enabled, button);
    let told = || say!(palette_row, command = command.name());
    response.widget_info(|| WidgetInfo::selected(Role::ListBoxOption, is_enabled, is_at, told()));
    if is_at && is_moved {
        response.scroll_to_me(None);
    }
    told_why(response, command, context).clicked()
}
