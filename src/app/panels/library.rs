//! The recipes at hand: of the job, the user's own, and shipped ones. They are given by a button, or
//! dragged onto a row of the lists.

use super::super::{App, theme};
use crate::document::{Edit, Recipe};
use crate::part::SurfaceId;
use crate::text::{Sentence, say};
use eframe::egui::{self, DragAndDrop, RichText, Role, Sense, WidgetInfo};

/// Where a recipe stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Shelf {
    /// In the job.
    Job,
    /// In the user's folder.
    Mine,
    /// In the program.
    Shipped,
}

impl Shelf {
    /// Heading of its recipes.
    fn title(self) -> String {
        match self {
            Shelf::Job => say!(library_in_job),
            Shelf::Mine => say!(library_mine),
            Shelf::Shipped => say!(library_shipped),
        }
    }

    /// In a few letters, where recipes of all shelves stand in a row.
    pub(super) fn word(self) -> String {
        match self {
            Shelf::Job => say!(library_job_word),
            Shelf::Mine => say!(library_mine_word),
            Shelf::Shipped => say!(library_shipped_word),
        }
    }
}

/// A recipe on its way onto a surface.
#[derive(Clone)]
pub(super) struct DraggedRecipe(pub Recipe);

impl App {
    /// All recipes at hand.
    pub(super) fn shelves(&self) -> [(Shelf, Vec<Recipe>); 3] {
        let mine = self.recipes.kept.iter().map(|(_, r)| r.clone()).collect();
        [
            (Shelf::Job, self.document.job().recipes.clone()),
            (Shelf::Mine, mine),
            (Shelf::Shipped, self.recipes.shipped.clone()),
        ]
    }

    pub(super) fn library_panel(&mut self, ui: &mut egui::Ui) {
        egui::CollapsingHeader::new(say!(library_title)).id_salt("recipe library").show(ui, |ui| {
            ui.label(RichText::new(say!(library_how)).weak());
            for (shelf, recipes) in self.shelves() {
                if recipes.is_empty() && shelf != Shelf::Job {
                    continue;
                }
                ui.label(RichText::new(shelf.title()).strong());
                if recipes.is_empty() {
                    ui.label(RichText::new(say!(library_none)).small().weak());
                }
                for recipe in recipes {
                    self.library_row(ui, shelf, &recipe);
                }
            }
            self.forgotten_row(ui);
            for why in &self.recipes.broken {
                ui.label(RichText::new(why.sentence()).small().color(theme::WRONG));
            }
            if ui.button(say!(library_compare)).on_hover_text(say!(library_compare_tip)).clicked() {
                self.open_compare();
            }
        });
    }

    /// The way back for the recipe that was removed last.
    fn forgotten_row(&mut self, ui: &mut egui::Ui) {
        let Some(forgotten) = self.session.forgotten.clone() else { return };
        ui.horizontal(|ui| {
            let removed = say!(library_removed, name = &forgotten.recipe.name);
            ui.label(RichText::new(removed).color(theme::ATTENTION));
            let undo = ui.small_button(say!(library_undo));
            undo.widget_info(|| WidgetInfo::labeled(Role::Button, true, say!(library_undo_name)));
            if undo.clicked() {
                self.bring_recipe_back(&forgotten);
            }
        });
    }

    fn library_row(&mut self, ui: &mut egui::Ui, shelf: Shelf, recipe: &Recipe) {
        let name = &recipe.name;
        ui.horizontal(|ui| {
            let button = egui::Button::new(say!(library_apply)).small();
            let apply = ui.add_enabled(!self.session.selected.is_empty(), button);
            let told = || say!(library_apply_name, shelf = shelf.word(), name);
            apply.widget_info(|| WidgetInfo::labeled(Role::Button, true, told()));
            if apply.on_hover_text(say!(library_apply_tip)).clicked() {
                let selected = self.session.selected.iter().copied().map(SurfaceId).collect();
                self.apply_recipe(recipe, selected);
            }
            if shelf == Shelf::Job {
                let copy = ui.small_button(say!(library_duplicate)).on_hover_text(say!(library_duplicate_tip));
                copy.widget_info(|| WidgetInfo::labeled(Role::Button, true, say!(library_duplicate_name, name)));
                if copy.clicked() {
                    self.edit(Edit::DuplicateRecipe(name.clone()));
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
                    self.edit(Edit::RemoveRecipe(name.clone()));
                } else if gone.clicked() {
                    self.forget_recipe(name);
                }
            }
            draggable(ui, recipe, egui::Label::new(name.as_str()).truncate());
        });
    }

    /// Gives surfaces a recipe from any shelf.
    pub(super) fn apply_recipe(&mut self, recipe: &Recipe, surfaces: Vec<SurfaceId>) {
        let guest = self.document.job().under_free_name(recipe);
        self.edit(Edit::GiveRecipe(surfaces, Some(Box::new(guest))));
    }

    /// Keeps a recipe in the user's folder.
    pub(super) fn keep_recipe(&mut self, recipe: &Recipe) {
        match self.recipes.keep(recipe) {
            Ok(file) => self.session.said = say!(library_saved, file = file.display().to_string()),
            Err(why) => self.session.error = Some(why.sentence()),
        }
    }

    /// The name of a recipe that is being dragged, at the cursor.
    pub(in super::super) fn dragged_recipe(&self, ctx: &egui::Context) {
        let Some(dragged) = DragAndDrop::payload::<DraggedRecipe>(ctx) else { return };
        let Some(pointer) = ctx.pointer_interact_pos() else { return };
        let text = say!(library_dragged, name = &dragged.0.name);
        super::super::pick::text_at(ctx, pointer, text);
    }
}

/// A label that carries a recipe onto a surface.
pub(super) fn draggable(ui: &mut egui::Ui, recipe: &Recipe, label: egui::Label) -> egui::Response {
    let response = ui.add(label.selectable(false).sense(Sense::drag()));
    response.dnd_set_drag_payload(DraggedRecipe(recipe.clone()));
    if recipe.note.is_empty() { response } else { response.on_hover_text(&recipe.note) }
}
