//! The group of the recipes at hand, shelf by shelf.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::recipe_library::LibraryChange;
use super::super::compare::state::Compare;
use super::dragged::{draggable, edit_giving};
use super::shelf::Shelf;
use crate::document::{Edit, Recipe};
use crate::text::{Sentence as _, say};
use eframe::egui::{self, RichText, Role, WidgetInfo};

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    egui::CollapsingHeader::new(say!(library_title)).id_salt("recipe library").show(ui, |ui| {
        ui.label(RichText::new(say!(library_how)).weak());
        for (shelf, recipes) in context.shelves() {
            if recipes.is_empty() && shelf != Shelf::Job {
                continue;
            }
            ui.label(RichText::new(shelf.title()).strong());
            if recipes.is_empty() {
                ui.label(RichText::new(say!(library_none)).small().weak());
            }
            for recipe in recipes {
                row(ui, shelf, recipe, context, actions);
            }
        }
        forgotten(ui, context, actions);
        for why in &context.recipes.broken {
            ui.label(RichText::new(why.sentence()).small().color(ui.visuals().error_fg_color));
        }
        if ui.button(say!(library_compare)).on_hover_text(say!(library_compare_tip)).clicked() {
            let compare = Compare::of(context.document.job(), &context.session.selected_ids());
            actions.session(|s| s.compare = Some(compare));
        }
    });
}

/// The button that brings back the recipe that was removed last.
fn forgotten(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some(forgotten) = &context.session.forgotten else { return };
    ui.horizontal(|ui| {
        let removed = say!(library_removed, name = &forgotten.recipe.name);
        ui.label(RichText::new(removed).color(ui.visuals().warn_fg_color));
        let undo = ui.small_button(say!(library_undo));
        undo.widget_info(|| WidgetInfo::labeled(Role::Button, true, say!(library_undo_name)));
        if undo.clicked() {
            actions.library(LibraryChange::BringBack);
        }
    });
}

fn row(ui: &mut egui::Ui, shelf: Shelf, recipe: &Recipe, context: Context<'_>, actions: &mut Actions) {
    let name = &recipe.name;
    ui.horizontal(|ui| {
        let button = egui::Button::new(say!(library_apply)).small();
        let apply = ui.add_enabled(!context.session.selected.is_empty(), button);
        let told = || say!(library_apply_name, shelf = shelf.word(), name);
        apply.widget_info(|| WidgetInfo::labeled(Role::Button, true, told()));
        if apply.on_hover_text(say!(library_apply_tip)).clicked() {
            actions.edit(edit_giving(context.document.job(), recipe, context.session.selected_ids()));
        }
        if shelf == Shelf::Job {
            let copy = ui.small_button(say!(library_duplicate)).on_hover_text(say!(library_duplicate_tip));
            copy.widget_info(|| WidgetInfo::labeled(Role::Button, true, say!(library_duplicate_name, name)));
            if copy.clicked() {
                actions.edit(Edit::DuplicateRecipe(name.clone()));
            }
        }
        if shelf != Shelf::Shipped {
            let gone = ui.small_button("×").on_hover_text(match shelf {
                Shelf::Job => say!(library_remove_job_tip),
                _ => say!(library_remove_mine_tip),
            });
            let told = || say!(library_remove_name, shelf = shelf.word(), name);
            gone.widget_info(|| WidgetInfo::labeled(Role::Button, true, told()));
            if gone.clicked() && shelf == Shelf::Job {
                actions.edit(Edit::RemoveRecipe(name.clone()));
            } else if gone.clicked() {
                actions.library(LibraryChange::Forget(name.clone()));
            }
        }
        draggable(ui, recipe, egui::Label::new(name.as_str()).truncate());
    });
}
