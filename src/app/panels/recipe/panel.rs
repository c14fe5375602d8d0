//! The group of the recipe of the selected surfaces.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::recipe_library::LibraryChange;
use super::values::values;
use super::{achieved, choice, typed};
use crate::document::{Edit, Recipe};
use crate::part::SurfaceId;
use crate::text::{id, listed, say};
use eframe::egui::{self, RichText};
use std::collections::BTreeSet;

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let selected = context.session.selected_ids();
    let job = context.document.job();
    let names: BTreeSet<Option<&str>> = selected.iter().map(|&n| job.recipe_of(n).map(|r| r.name.as_str())).collect();
    let whose = match selected[..] {
        [] => say!(recipe_panel_none),
        [one] => say!(recipe_panel_one, surface = id(one)),
        _ => say!(recipe_panel_many, count = selected.len()),
    };
    let common = names.first().copied().filter(|_| names.len() == 1);
    let title = match common {
        Some(Some(name)) => say!(recipe_panel_titled, whose, name),
        None if names.len() > 1 => say!(recipe_panel_titled, whose, name = say!(recipe_panel_several)),
        _ => whose,
    };
    egui::CollapsingHeader::new(title).id_salt("recipe of surface").show(ui, |ui| {
        if selected.is_empty() {
            ui.label(RichText::new(say!(recipe_panel_select)).small());
            return;
        }
        choice::ui(ui, &selected, common, context, actions);
        match common {
            Some(name) => recipe(ui, &selected, name, context, actions),
            None => {
                ui.label(RichText::new(say!(recipe_panel_different)).small());
            }
        }
        achieved::ui(ui, &selected, context);
    });
}

/// The values of the recipe; without one those of the job, and the first that is changed makes a recipe.
fn recipe(ui: &mut egui::Ui, selected: &[SurfaceId], name: Option<&str>, context: Context<'_>, actions: &mut Actions) {
    let job = context.document.job();
    let known = name.and_then(|name| job.recipes.iter().find(|r| r.name == name));
    typed::ui(ui, known, context, actions);
    if let Some(known) = known {
        others(ui, selected, known, context);
    }
    let mut recipe = known.cloned().unwrap_or_else(|| job.new_recipe(choice::numbered_name));
    if let Some(what) = values(ui, job, &mut recipe) {
        actions.drag(Edit::Recipe(Box::new(recipe), selected.to_vec()), what);
    }
    match known {
        Some(known) => keep_or_remove(ui, known, context, actions),
        None => {
            ui.label(RichText::new(say!(recipe_panel_change_makes)).small().weak());
        }
    }
}

/// The other surfaces that have this recipe.
fn others(ui: &mut egui::Ui, selected: &[SurfaceId], recipe: &Recipe, context: Context<'_>) {
    let all = context.document.job().surfaces_of_recipe(&recipe.name);
    let others: Vec<String> = all.iter().filter(|n| !selected.contains(n)).map(SurfaceId::to_string).collect();
    if !others.is_empty() {
        let text = say!(recipe_panel_others, count = others.len(), surfaces = listed(others));
        ui.label(RichText::new(text).small().color(ui.visuals().warn_fg_color));
    }
}

fn keep_or_remove(ui: &mut egui::Ui, recipe: &Recipe, context: Context<'_>, actions: &mut Actions) {
    ui.horizontal_wrapped(|ui| {
        let folder = context.recipes.folder().map(|f| f.display().to_string());
        let keep = ui.add_enabled(folder.is_some(), egui::Button::new(say!(recipe_panel_keep)));
        if keep.on_hover_text(folder.unwrap_or_default()).clicked() {
            actions.library(LibraryChange::Keep(recipe.clone()));
        }
        let remove = ui.button(say!(recipe_panel_remove)).on_hover_text(say!(recipe_panel_remove_tip));
        if remove.clicked() {
            actions.edit(Edit::RemoveRecipe(recipe.name.clone()));
        }
    });
}
