//! Numbers of the parameter table as fields: those of the job, and those of a recipe.

use super::super::actions::Actions;
use super::super::context::Context;
use super::fields::{self, Change, Owner};
use crate::document::parameter::Group;
use crate::document::{Job, Parameter, Recipe};
use eframe::egui;

/// The job's numbers of a group.
pub(super) fn of_job(ui: &mut egui::Ui, group: Group, context: Context<'_>, actions: &mut Actions) {
    chosen_of_job(ui, Parameter::of_group(group), context, actions);
}

/// Some of the job's numbers.
pub(super) fn chosen_of_job(
    ui: &mut egui::Ui,
    parameters: impl IntoIterator<Item = &'static Parameter>,
    context: Context<'_>,
    actions: &mut Actions,
) {
    for p in parameters {
        let now = context.document.job().number(p);
        let to = Some(p.default).filter(|to| (now - to).abs() > 1e-12);
        match fields::number(ui, Owner::Job, p, now, to) {
            Some(Change::To(value)) => actions.number(p, value),
            Some(Change::Back) => actions.number(p, p.default),
            None => {}
        }
    }
}

/// A number of a recipe; `own`: the job with it. Changes the recipe, and says what was changed.
pub(super) fn of_recipe(
    ui: &mut egui::Ui,
    job: &Job,
    own: &Job,
    recipe: &mut Recipe,
    p: &'static Parameter,
) -> Option<&'static str> {
    let to = recipe.values.contains_key(p.key).then(|| job.number(p));
    match fields::number(ui, Owner::Recipe, p, own.number(p), to)? {
        Change::To(value) => recipe.values.insert(p.key.into(), value),
        Change::Back => recipe.values.remove(p.key),
    };
    Some(p.key)
}
