//! The window of the comparison.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::library::shelf::Shelf;
use super::state::Compare;
use crate::document::Recipe;
use crate::document::recipe_table::{ComparedRow, rows};
use crate::text::recipe_table::{row_label, value};
use crate::text::say;
use eframe::egui::{self, RichText, Role, WidgetInfo};

/// The window, if it is open.
pub(in super::super::super) fn ui(ctx: &egui::Context, context: Context<'_>, actions: &mut Actions) {
    let Some(before) = &context.session.compare else { return };
    let (mut compare, mut open) = (before.clone(), true);
    // Over the view, so that the lists stay in sight.
    let window = egui::Window::new(say!(compare_title))
        .id(egui::Id::unique("compare recipes"))
        .open(&mut open)
        .collapsible(false);
    let window = window.default_width(460.0).default_pos(egui::pos2(350.0, 110.0));
    window.show(ctx, |ui| {
        choice(ui, &mut compare, context);
        ui.separator();
        comparison(ui, &compare, context);
    });
    if !open {
        actions.session(|s| s.compare = None);
    } else if compare != *before {
        actions.session(|s| s.compare = Some(compare));
    }
}

/// What is compared.
fn choice(ui: &mut egui::Ui, compare: &mut Compare, context: Context<'_>) {
    ui.horizontal_wrapped(|ui| {
        ui.checkbox(&mut compare.with_job, say!(compare_own));
        for (shelf, recipes) in context.shelves() {
            for recipe in recipes {
                let mut on = compare.has(shelf, recipe);
                let text = match shelf {
                    Shelf::Job => recipe.name.clone(),
                    _ => say!(compare_recipe, name = &recipe.name, shelf = shelf.word()),
                };
                let told = || say!(compare_recipe_name, shelf = shelf.word(), name = &recipe.name);
                let check = ui.checkbox(&mut on, text);
                check.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, on, told()));
                if check.changed() {
                    compare.set(shelf, recipe, on);
                }
            }
        }
    });
    ui.checkbox(&mut compare.all_rows, say!(compare_all_rows));
}

/// The rows that are wanted, or why there are none.
fn comparison(ui: &mut egui::Ui, compare: &Compare, context: Context<'_>) {
    let shelves = context.shelves();
    let own = compare.with_job.then_some(None);
    let recipes = shelves.iter().flat_map(|(shelf, list)| list.iter().map(move |r| (*shelf, *r)));
    let chosen = recipes.filter(|(shelf, r)| compare.has(*shelf, r));
    let columns: Vec<Option<&Recipe>> = own.into_iter().chain(chosen.map(|(_, r)| Some(r))).collect();
    if columns.len() < 2 {
        ui.label(say!(compare_too_few));
        return;
    }
    let rows = rows(context.document.job(), &columns);
    let shown: Vec<&ComparedRow> = rows.iter().filter(|r| compare.all_rows || r.differs()).collect();
    if shown.is_empty() {
        ui.label(say!(compare_no_difference));
        return;
    }
    egui::ScrollArea::both().max_height(420.0).show(ui, |ui| table(ui, &columns, &shown));
}

fn table(ui: &mut egui::Ui, columns: &[Option<&Recipe>], rows: &[&ComparedRow]) {
    egui::Grid::new("compared").striped(true).spacing([18.0, 4.0]).show(ui, |ui| {
        ui.label("");
        for column in columns {
            let name = column.map_or_else(|| say!(compare_own_column), |r| r.name.clone());
            ui.label(RichText::new(name).strong());
        }
        ui.end_row();
        for row in rows {
            let title = row_label(row.what);
            ui.label(&title);
            for cell in &row.cells {
                let value = value(cell.value);
                let told = || say!(compare_cell, label = &title, value = &value);
                let text = RichText::new(&value);
                let label = ui.label(if cell.is_own { text.strong() } else { text.weak() });
                label.widget_info(|| WidgetInfo::labeled(Role::Label, true, told()));
            }
            ui.end_row();
        }
    });
}
