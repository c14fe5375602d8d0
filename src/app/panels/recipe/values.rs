//! Fields of all that a recipe can hold, each with a way back to the job's value.

use super::super::fields::{self, Change, Owner};
use super::super::{bead, laying, numbers};
use crate::document::parameter::{Group, Scope};
use crate::document::{Job, PARAMETERS, Parameter, Recipe};
use crate::path::Strategy;
use crate::text::say;
use eframe::egui;

/// Fields of all that a recipe can hold; changes the recipe, and says what was changed.
pub(super) fn values(ui: &mut egui::Ui, job: &Job, recipe: &mut Recipe) -> Option<&'static str> {
    let own = recipe.applied(job);
    let what = lines(ui, job, &own, recipe);
    let what = spacing(ui, job, &own, recipe).or(what);
    let what = more(ui, job, &own, recipe).or(what);
    bead::recipe::ui(ui, job, &own, recipe).or(what)
}

/// How lines are laid; `own`: the job with the recipe.
fn lines(ui: &mut egui::Ui, job: &Job, own: &Job, recipe: &mut Recipe) -> Option<&'static str> {
    let (l, jobs) = (&own.layers, &job.layers);
    let mut what = None;
    if let Some(change) = laying::strategy(ui, Owner::Recipe, l.strategy, recipe.strategy.map(|_| jobs.strategy)) {
        take(&mut recipe.strategy, change);
        what = Some("recipe strategy");
    }
    let by_planes = matches!(l.strategy, Strategy::Planes | Strategy::Adaptive | Strategy::Cross);
    if by_planes
        && let Some(change) =
            laying::direction(ui, Owner::Recipe, l.direction, recipe.direction.map(|_| jobs.direction))
    {
        take(&mut recipe.direction, change);
        what = Some("recipe direction");
    }
    if let Some(change) = laying::order(ui, Owner::Recipe, l.strategy, l.order, recipe.order.map(|_| jobs.order)) {
        take(&mut recipe.order, change);
        what = Some("recipe order");
    }
    if l.strategy == Strategy::Spiral {
        if let Some(change) = laying::inward(ui, Owner::Recipe, l.inward, recipe.inward.map(|_| jobs.inward)) {
            take(&mut recipe.inward, change);
            what = Some("recipe spiral");
        }
        if laying::centre(ui, Owner::Recipe, l.centre_mm, recipe.centre_mm.is_some()) {
            recipe.centre_mm = None;
            what = Some("recipe centre");
        }
    }
    if l.strategy == Strategy::Offset
        && let Some(change) =
            laying::border(ui, Owner::Recipe, l.border.into(), recipe.border.map(|_| jobs.border.into()))
    {
        take(&mut recipe.border, change);
        what = Some("recipe border");
    }
    what
}

/// Numbers that are set for a surface first, and the overlap with them.
fn spacing(ui: &mut egui::Ui, job: &Job, own: &Job, recipe: &mut Recipe) -> Option<&'static str> {
    let mut what = None;
    let is_cross = own.layers.strategy == Strategy::Cross;
    let first = |p: &&Parameter| p.scope == Scope::SurfaceFirst && (is_cross || p.group != Group::Cross);
    for p in PARAMETERS.iter().filter(first) {
        what = numbers::of_recipe(ui, job, own, recipe, p).or(what);
        if p == fields::SPACING
            && let Some(mm) = fields::overlap(ui, Owner::Recipe, own)
        {
            recipe.values.insert(p.key.into(), mm);
            what = Some("recipe overlap");
        }
    }
    what
}

/// All other numbers but the bead's.
fn more(ui: &mut egui::Ui, job: &Job, own: &Job, recipe: &mut Recipe) -> Option<&'static str> {
    let mut what = None;
    let of_bead = |p: &Parameter| matches!(p.group, Group::BeadSize | Group::BeadLayers);
    let more = PARAMETERS.iter().filter(|p| p.scope == Scope::Surface && !of_bead(p));
    let held = more.clone().filter(|p| recipe.values.contains_key(p.key)).count();
    let title = if held > 0 { say!(recipe_panel_more_own, count = held) } else { say!(recipe_panel_more) };
    egui::CollapsingHeader::new(title).id_salt("more of a recipe").show(ui, |ui| {
        for p in more {
            what = numbers::of_recipe(ui, job, own, recipe, p).or(what);
        }
    });
    what
}

fn take<T>(value: &mut Option<T>, change: Change<T>) {
    *value = match change {
        Change::To(to) => Some(to),
        Change::Back => None,
    };
}
