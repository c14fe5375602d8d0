//! Fields of a recipe's name and note: what is typed becomes an edit when the field is left.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::theme;
use super::draft::{Draft, Typed};
use crate::document::Recipe;
use crate::text::say;
use eframe::egui::{self, Key, Role, TextEdit, WidgetInfo};

/// The fields of the recipe that is shown, if there is one.
pub(super) fn ui(ui: &mut egui::Ui, recipe: Option<&Recipe>, context: Context<'_>, actions: &mut Actions) {
    let before = &context.session.draft;
    let mut draft = before.clone();
    // What was typed for a recipe that is no longer shown is not lost.
    if let Some(left) = draft.take_if(|d| recipe.is_none_or(|r| !d.is_of(r))) {
        take(&left, context, actions);
    }
    if let Some(recipe) = recipe {
        field(ui, recipe, Typed::Name, &mut draft, context, actions);
        field(ui, recipe, Typed::Note, &mut draft, context, actions);
    }
    if draft != *before {
        actions.session(|s| s.draft = draft);
    }
}

fn field(
    ui: &mut egui::Ui,
    recipe: &Recipe,
    what: Typed,
    draft: &mut Option<Draft>,
    context: Context<'_>,
    actions: &mut Actions,
) {
    let (label, told, now) = match what {
        Typed::Name => (say!(recipe_panel_name), say!(recipe_panel_name_field), &recipe.name),
        Typed::Note => (say!(recipe_panel_note), say!(recipe_panel_note_field), &recipe.note),
    };
    ui.horizontal(|ui| {
        theme::name(ui, &label, 60.0);
        let typed = draft.as_ref().filter(|d| d.is(what)).map(Draft::text);
        let mut text = typed.unwrap_or(now).to_owned();
        let field = ui.add(TextEdit::singleline(&mut text).desired_width(170.0));
        field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, &told));
        if field.changed() {
            *draft = Some(Draft::new(recipe, what, text));
        }
        if field.lost_focus()
            && let Some(left) = draft.take_if(|d| d.is(what))
            && !ui.input(|i| i.key_pressed(Key::Escape))
        {
            take(&left, context, actions);
        }
    });
}

fn take(draft: &Draft, context: Context<'_>, actions: &mut Actions) {
    if let Some(edit) = draft.edit(context.document.job()) {
        actions.edit(edit);
    }
}
