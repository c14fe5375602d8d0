//! Recipes side by side: the rows in which they differ, or all.

use super::super::App;
use super::library::Shelf;
use crate::document::Recipe;
use crate::document::recipe_table::{ComparedRow, rows};
use crate::part::SurfaceId;
use crate::text::recipe_table::{row_label, value};
use crate::text::say;
use eframe::egui::{self, RichText, Role, WidgetInfo};
use std::collections::BTreeSet;

/// What is compared.
#[derive(Clone, Debug)]
pub struct Compare {
    /// The recipes, by shelf and name.
    chosen: BTreeSet<(Shelf, String)>,
    /// Whether the job's own values stand beside them.
    with_job: bool,
    /// Whether rows in which they agree are shown too.
    all_rows: bool,
}

impl App {
    /// Opens the comparison: the job's own values and its recipes, or those that the selection has.
    pub(super) fn open_compare(&mut self) {
        let job = self.document.job();
        let of_selected: BTreeSet<&str> = self
            .session
            .selected
            .iter()
            .filter_map(|&n| job.recipe_of(SurfaceId(n)))
            .map(|r| r.name.as_str())
            .collect();
        let wanted = |r: &&Recipe| of_selected.len() < 2 || of_selected.contains(r.name.as_str());
        let chosen = job.recipes.iter().filter(wanted).map(|r| (Shelf::Job, r.name.clone())).collect();
        self.session.compare = Some(Compare { chosen, with_job: true, all_rows: false });
    }

    pub(in super::super) fn compare_window(&mut self, ctx: &egui::Context) {
        let Some(mut compare) = self.session.compare.take() else { return };
        let mut open = true;
        // Over the view, so that the lists stay in sight.
        let window = egui::Window::new(say!(compare_title))
            .id(egui::Id::unique("compare recipes"))
            .open(&mut open)
            .collapsible(false);
        let window = window.default_width(460.0).default_pos(egui::pos2(350.0, 110.0));
        window.show(ctx, |ui| {
            self.choose_compared(ui, &mut compare);
            ui.separator();
            let shelves = self.shelves();
            let own = compare.with_job.then_some(None);
            let recipes = shelves.iter().flat_map(|(shelf, list)| list.iter().map(move |r| (*shelf, r)));
            let chosen = recipes.filter(|(shelf, r)| compare.chosen.contains(&(*shelf, r.name.clone())));
            let columns: Vec<Option<&Recipe>> = own.into_iter().chain(chosen.map(|(_, r)| Some(r))).collect();
            if columns.len() < 2 {
                ui.label(say!(compare_too_few));
                return;
            }
            let rows = rows(self.document.job(), &columns);
            let shown: Vec<&ComparedRow> = rows.iter().filter(|r| compare.all_rows || r.differs()).collect();
            if shown.is_empty() {
                ui.label(say!(compare_no_difference));
                return;
            }
            egui::ScrollArea::both().max_height(420.0).show(ui, |ui| table(ui, &columns, &shown));
        });
        if open {
            self.session.compare = Some(compare);
        }
    }

    fn choose_compared(&self, ui: &mut egui::Ui, compare: &mut Compare) {
        ui.horizontal_wrapped(|ui| {
            ui.checkbox(&mut compare.with_job, say!(compare_own));
            for (shelf, recipes) in self.shelves() {
                for recipe in recipes {
                    let key = (shelf, recipe.name.clone());
                    let mut on = compare.chosen.contains(&key);
                    let text = match shelf {
                        Shelf::Job => recipe.name.clone(),
                        _ => say!(compare_recipe, name = &recipe.name, shelf = shelf.word()),
                    };
                    let told = || say!(compare_recipe_name, shelf = shelf.word(), name = &recipe.name);
                    let check = ui.checkbox(&mut on, text);
                    check.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, on, told()));
                    if check.changed() && on {
                        compare.chosen.insert(key);
                    } else if check.changed() {
                        compare.chosen.remove(&key);
                    }
                }
            }
        });
        ui.checkbox(&mut compare.all_rows, say!(compare_all_rows));
    }
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
