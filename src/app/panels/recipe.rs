//! *Recipe of surface N*: what the selected surfaces are worked with, where that differs from the job's
//! own values, and the spacing that came of it.

use super::super::{App, theme};
use super::fields::{self, Change, Owner};
use super::{bead, laying};
use crate::document::parameter::{Group, Scope};
use crate::document::{Edit, Job, PARAMETERS, Parameter, Recipe};
use crate::part::SurfaceId;
use crate::path::Strategy;
use crate::text::{Sentence as _, fixed, id, say};
use eframe::egui::{self, ComboBox, RichText, Role, TextEdit, WidgetInfo};
use std::collections::BTreeSet;

/// Surfaces whose spacing is told, at most.
const TOLD: usize = 4;

/// A name or note that is being typed, and the recipe it belongs to.
#[derive(Clone, Debug)]
pub struct Draft {
    recipe: String,
    is_note: bool,
    text: String,
}

impl App {
    pub(super) fn recipe_panel(&mut self, ui: &mut egui::Ui) {
        let selected: Vec<SurfaceId> = self.session.selected.iter().copied().map(SurfaceId).collect();
        let job = self.document.job();
        let names: BTreeSet<Option<String>> =
            selected.iter().map(|&n| job.recipe_of(n).map(|r| r.name.clone())).collect();
        let whose = match selected[..] {
            [] => say!(recipe_panel_none),
            [one] => say!(recipe_panel_one, surface = id(one)),
            _ => say!(recipe_panel_many, count = selected.len()),
        };
        let common = names.first().cloned().filter(|_| names.len() == 1);
        let title = match &common {
            Some(Some(name)) => say!(recipe_panel_titled, whose, name),
            None if names.len() > 1 => say!(recipe_panel_titled, whose, name = say!(recipe_panel_several)),
            _ => whose,
        };
        egui::CollapsingHeader::new(title).id_salt("recipe of surface").show(ui, |ui| {
            if selected.is_empty() {
                ui.label(RichText::new(say!(recipe_panel_select)).small());
                return;
            }
            self.choose_recipe(ui, &selected, common.as_ref());
            match &common {
                Some(name) => self.recipe_values(ui, &selected, name.as_deref()),
                None => {
                    ui.label(RichText::new(say!(recipe_panel_different)).small());
                }
            }
            self.achieved_spacing(ui, &selected);
        });
    }

    /// Which recipe the surfaces have; `common`: the one they share, if they do.
    fn choose_recipe(&mut self, ui: &mut egui::Ui, selected: &[SurfaceId], common: Option<&Option<String>>) {
        let recipes = self.document.job().recipes.clone();
        let shown = match common {
            None => say!(recipe_panel_several),
            Some(None) => say!(recipe_panel_jobs),
            Some(Some(name)) => name.clone(),
        };
        let mut wanted: Option<Option<Recipe>> = None;
        ui.horizontal(|ui| {
            theme::name(ui, &say!(recipe_panel_recipe), 60.0);
            let combo = ComboBox::from_id_salt("recipe").width(170.0).selected_text(shown).show_ui(ui, |ui| {
                if ui.selectable_label(common == Some(&None), say!(recipe_panel_jobs)).clicked() {
                    wanted = Some(None);
                }
                for r in &recipes {
                    let on = common.and_then(Option::as_ref).is_some_and(|name| *name == r.name);
                    if ui.selectable_label(on, &r.name).on_hover_text(&r.note).clicked() {
                        wanted = Some(Some(r.clone()));
                    }
                }
                if ui.selectable_label(false, say!(recipe_panel_new)).clicked() {
                    wanted = Some(Some(self.document.job().new_recipe()));
                }
            });
            combo.response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, say!(recipe_panel_recipe_name)));
        });
        let job = self.document.job();
        let others = job.settings.having(|s| s.recipe.is_some()).into_iter().filter(|n| !selected.contains(n));
        let others: Vec<(SurfaceId, Recipe)> = others.filter_map(|n| Some((n, job.recipe_of(n)?.clone()))).collect();
        if !others.is_empty() {
            ui.menu_button(say!(recipe_panel_copy), |ui| {
                for (n, r) in others {
                    if ui.button(say!(recipe_panel_copy_row, surface = id(n), recipe = &r.name)).clicked() {
                        wanted = Some(Some(r));
                        ui.close();
                    }
                }
            });
        }
        if let Some(recipe) = wanted {
            self.edit(Edit::GiveRecipe(selected.to_vec(), recipe.map(Box::new)));
        }
    }

    /// The values of the recipe; without one, the job's, and the first that is changed makes one.
    fn recipe_values(&mut self, ui: &mut egui::Ui, selected: &[SurfaceId], name: Option<&str>) {
        let job = self.document.job().clone();
        let known = name.and_then(|name| job.recipes.iter().find(|r| r.name == name));
        self.name_and_note(ui, known);
        if let Some(r) = known {
            let others: Vec<String> = job
                .surfaces_of_recipe(&r.name)
                .iter()
                .filter(|n| !selected.contains(n))
                .map(SurfaceId::to_string)
                .collect();
            if !others.is_empty() {
                let text = say!(recipe_panel_others, count = others.len(), surfaces = others.join(", "));
                ui.label(RichText::new(text).small().color(theme::ATTENTION));
            }
        }
        let mut recipe = known.cloned().unwrap_or_else(|| job.new_recipe());
        if let Some(what) = values(ui, &job, &mut recipe) {
            self.edit_dragging(&Edit::Recipe(Box::new(recipe), selected.to_vec()), what);
        }
        let Some(known) = known else {
            ui.label(RichText::new(say!(recipe_panel_change_makes)).small().weak());
            return;
        };
        ui.horizontal_wrapped(|ui| {
            let folder = self.recipes.folder().map(|f| f.display().to_string());
            let keep = ui.add_enabled(folder.is_some(), egui::Button::new(say!(recipe_panel_keep)));
            if keep.on_hover_text(folder.unwrap_or_default()).clicked() {
                self.keep_recipe(known);
            }
            let remove = ui.button(say!(recipe_panel_remove)).on_hover_text(say!(recipe_panel_remove_tip));
            if remove.clicked() {
                self.edit(Edit::RemoveRecipe(known.name.clone()));
            }
        });
    }

    fn name_and_note(&mut self, ui: &mut egui::Ui, recipe: Option<&Recipe>) {
        // What was typed for a recipe that is no longer shown is not lost.
        if let Some(draft) = self.session.draft.take_if(|d| recipe.is_none_or(|r| r.name != d.recipe)) {
            self.take_draft(&draft);
        }
        let Some(recipe) = recipe else { return };
        let rows = [
            (say!(recipe_panel_name), say!(recipe_panel_name_field), false, &recipe.name),
            (say!(recipe_panel_note), say!(recipe_panel_note_field), true, &recipe.note),
        ];
        for (label, told, is_note, now) in rows {
            ui.horizontal(|ui| {
                theme::name(ui, &label, 60.0);
                let draft = self.session.draft.as_ref().filter(|d| d.is_note == is_note);
                let mut text = draft.map_or_else(|| now.clone(), |d| d.text.clone());
                let field = ui.add(TextEdit::singleline(&mut text).desired_width(170.0));
                field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, &told));
                if field.changed() {
                    self.session.draft = Some(Draft { recipe: recipe.name.clone(), is_note, text });
                }
                if field.lost_focus()
                    && let Some(draft) = self.session.draft.take_if(|d| d.is_note == is_note)
                    && !ui.input(|i| i.key_pressed(egui::Key::Escape))
                {
                    self.take_draft(&draft);
                }
            });
        }
    }

    fn take_draft(&mut self, draft: &Draft) {
        let Some(known) = self.document.job().recipes.iter().find(|r| r.name == draft.recipe).cloned() else { return };
        let text = draft.text.trim().to_owned();
        if draft.is_note {
            self.edit(Edit::Recipe(Box::new(Recipe { note: text, ..known }), Vec::new()));
        } else {
            self.edit(Edit::RenameRecipe(known.name, text));
        }
    }

    /// What came of the wanted spacing, and what else is to be said of how lines lie.
    fn achieved_spacing(&self, ui: &mut egui::Ui, selected: &[SurfaceId]) {
        let Some(of) = self.derived.plan() else { return };
        let (plan, job) = (&of.plan, &of.job);
        for s in plan.surfaces.iter().filter(|s| selected.contains(&SurfaceId(s.toolpath.surface))).take(TOLD) {
            let n = SurfaceId(s.toolpath.surface);
            let told = |what: String| match selected.len() {
                0..=1 => what,
                _ => say!(recipe_panel_of_surface, surface = id(n), what),
            };
            if let Some(a) = &s.toolpath.achieved {
                let wanted = job.of_surface(n).layers.spacing_mm;
                let (least, greatest) = (fixed(a.min_mm, 2), fixed(a.max_mm, 2));
                ui.label(told(say!(recipe_panel_spacing, least, greatest, wanted = fixed(wanted, 2))));
            }
            for (_, remark) in plan.remarks().filter(|r| r.0 == n) {
                ui.label(RichText::new(told(remark.sentence())).small().color(theme::ATTENTION));
            }
        }
    }
}

/// Fields of all that a recipe can hold; changes it, and says what was changed.
fn values(ui: &mut egui::Ui, job: &Job, recipe: &mut Recipe) -> Option<&'static str> {
    let own = recipe.applied(job);
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
    let is_cross = l.strategy == Strategy::Cross;
    let first = |p: &&Parameter| p.scope == Scope::SurfaceFirst && (is_cross || p.group != Group::Cross);
    for p in PARAMETERS.iter().filter(first) {
        what = number(ui, job, &own, recipe, p).or(what);
        if p == fields::SPACING
            && let Some(mm) = fields::overlap(ui, Owner::Recipe, &own)
        {
            recipe.values.insert(p.key.into(), mm);
            what = Some("recipe overlap");
        }
    }
    let of_bead = |p: &Parameter| matches!(p.group, Group::BeadSize | Group::BeadLayers);
    let more = PARAMETERS.iter().filter(|p| p.scope == Scope::Surface && !of_bead(p));
    let held = more.clone().filter(|p| recipe.values.contains_key(p.key)).count();
    let title = if held > 0 { say!(recipe_panel_more_own, count = held) } else { say!(recipe_panel_more) };
    egui::CollapsingHeader::new(title).id_salt("more of a recipe").show(ui, |ui| {
        for p in more {
            what = number(ui, job, &own, recipe, p).or(what);
        }
    });
    bead::of_recipe(ui, job, &own, recipe).or(what)
}

/// A number of a recipe; changes it, and says what was changed.
pub(super) fn number(
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

fn take<T>(value: &mut Option<T>, change: Change<T>) {
    *value = match change {
        Change::To(to) => Some(to),
        Change::Back => None,
    };
}
