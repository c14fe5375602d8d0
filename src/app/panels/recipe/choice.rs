//! Which recipe the selected surfaces have: one of the job, a new one, or that of another surface.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::theme;
use crate::document::{Edit, Recipe};
use crate::part::SurfaceId;
use crate::text::{id, say};
use eframe::egui::{self, ComboBox, Role, WidgetInfo};

/// The choice; `common`: the recipe that all the surfaces share, or none, if they do.
pub(super) fn ui(
    ui: &mut egui::Ui,
    selected: &[SurfaceId],
    common: Option<Option<&str>>,
    context: Context<'_>,
    actions: &mut Actions,
) {
    let job = context.document.job();
    let mut give = |recipe: Option<Recipe>| actions.edit(Edit::GiveRecipe(selected.to_vec(), recipe.map(Box::new)));
    let shown = match common {
        None => say!(recipe_panel_several),
        Some(None) => say!(recipe_panel_jobs),
        Some(Some(name)) => name.to_owned(),
    };
    ui.horizontal(|ui| {
        theme::name(ui, &say!(recipe_panel_recipe), 60.0);
        let combo = ComboBox::from_id_salt("recipe").width(170.0).selected_text(shown).show_ui(ui, |ui| {
            if ui.selectable_label(common == Some(None), say!(recipe_panel_jobs)).clicked() {
                give(None);
            }
            for r in &job.recipes {
                let on = common.flatten() == Some(&r.name);
                if ui.selectable_label(on, &r.name).on_hover_text(&r.note).clicked() {
                    give(Some(r.clone()));
                }
            }
            if ui.selectable_label(false, say!(recipe_panel_new)).clicked() {
                give(Some(job.new_recipe(numbered_name)));
            }
        });
        combo.response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, say!(recipe_panel_recipe_name)));
    });
    let others = job.settings.having(|s| s.recipe.is_some()).into_iter().filter(|n| !selected.contains(n));
    let others: Vec<(SurfaceId, &Recipe)> = others.filter_map(|n| Some((n, job.recipe_of(n)?))).collect();
    if !others.is_empty() {
        ui.menu_button(say!(recipe_panel_copy), |ui| {
            for (n, r) in others {
                if ui.button(say!(recipe_panel_copy_row, surface = id(n), recipe = &r.name)).clicked() {
                    give(Some(r.clone()));
                    ui.close();
                }
            }
        });
    }
}

/// Name of a new recipe, before the operator gives it another.
pub(super) fn numbered_name(number: u32) -> String {
    say!(recipe_panel_new_name, number = id(number))
}
