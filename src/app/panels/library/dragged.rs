//! Dragging a recipe onto a surface: the label that it is dragged from, its name at the cursor, and the edit that it
//! becomes.

use super::super::super::at_cursor;
use crate::document::{Edit, Job, Recipe};
use crate::part::SurfaceId;
use crate::text::say;
use eframe::egui::{self, DragAndDrop, Sense};

/// A recipe that is dragged.
#[derive(Clone)]
pub(in super::super) struct DraggedRecipe(pub Recipe);

/// A label that carries a recipe onto a surface.
pub(in super::super) fn draggable(ui: &mut egui::Ui, recipe: &Recipe, label: egui::Label) -> egui::Response {
    let response = ui.add(label.selectable(false).sense(Sense::drag()));
    response.dnd_set_drag_payload(DraggedRecipe(recipe.clone()));
    if recipe.note.is_empty() { response } else { response.on_hover_text(&recipe.note) }
}

/// The edit that gives surfaces a recipe from any shelf.
pub(in super::super) fn edit_giving(job: &Job, recipe: &Recipe, surfaces: Vec<SurfaceId>) -> Edit {
    Edit::GiveRecipe(surfaces, Some(Box::new(job.under_free_name(recipe))))
}

/// The name of a recipe that is being dragged, at the cursor.
pub(in super::super::super) fn at_cursor(ctx: &egui::Context) {
    let Some(dragged) = DragAndDrop::payload::<DraggedRecipe>(ctx) else { return };
    let Some(pointer) = ctx.pointer_interact_pos() else { return };
    at_cursor::text(ctx, pointer, say!(library_dragged, name = &dragged.0.name));
}
