//! The two lists of P1 Fig. 3: *Feature surfaces*, and *To clean* in the order of work.

use super::super::command::Command;
use super::super::session::Column;
use super::super::{App, theme};
use super::library::{DraggedRecipe, draggable, edit_giving};
use crate::document::{Edit, Recipe};
use crate::part::SurfaceId;
use crate::text::{fixed, id, say};
use eframe::egui::{self, Align, Key, Layout, RichText, Role, Sense, WidgetInfo};
use egui_extras::{Column as Width, TableBuilder};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Letters of a recipe's name that are shown in a row.
const CHIP: usize = 9;

/// Surfaces on the way from one list to the other.
struct Dragged {
    surfaces: Vec<SurfaceId>,
    from_clean: bool,
}

impl App {
    pub(in super::super) fn lists(&mut self, ui: &mut egui::Ui) {
        // The hover of this frame is set by the rows and by the view, which is drawn after.
        let hovered = self.session.hovered.take();
        let later = self.later_height();
        let height = ui.available_height() - later;
        self.list(ui, false, (height - 150.0) * 0.55, hovered);
        self.between_lists(ui);
        self.list(ui, true, ui.available_height() - later, hovered);
        self.later(ui);
    }

    /// Rows of the left list as they stand: filtered and sorted.
    pub(in super::super) fn rows_left(&self) -> Vec<u32> {
        let d = &self.derived;
        let job = self.document.job();
        let mut rows: Vec<u32> = self.not_to_clean().into_iter().filter(|n| self.passes_filter(*n, 0)).collect();
        let area = |n: u32| d.surfaces.get(n).map_or(0.0, |s| s.area_mm2);
        let (column, turned) = self.session.sort;
        match column {
            Column::Number => {}
            Column::Shape => rows.sort_by_key(|&n| d.label(job, n)),
            Column::Area => rows.sort_by(|&a, &b| area(b).total_cmp(&area(a))),
        }
        if turned {
            rows.reverse();
        }
        rows
    }

    /// Surfaces that are neither to be cleaned nor put aside.
    fn not_to_clean(&self) -> Vec<u32> {
        let listed: BTreeSet<u32> = self.clean_list().into_iter().chain(self.later_list()).collect();
        let mut rest = self.derived.numbers();
        rest.retain(|n| !listed.contains(n));
        rest
    }

    fn passes_filter(&self, n: u32, list: usize) -> bool {
        let filter = self.session.filter[list].trim().to_lowercase();
        filter.is_empty()
            || format!("{n} {}", self.derived.label(self.document.job(), n)).to_lowercase().contains(&filter)
    }

    fn list(&mut self, ui: &mut egui::Ui, is_clean: bool, height: f32, hovered: Option<u32>) {
        let index = usize::from(is_clean);
        let clean = self.clean_list();
        let rows: Vec<u32> = if is_clean {
            clean.iter().copied().filter(|&n| self.passes_filter(n, 1)).collect()
        } else {
            self.rows_left()
        };
        let whole = if is_clean { clean.len() } else { self.not_to_clean().len() };
        theme::heading(ui, &if is_clean { say!(lists_to_clean) } else { say!(lists_feature_surfaces) });
        ui.horizontal(|ui| {
            let told = || if is_clean { say!(lists_filter_clean) } else { say!(lists_filter_surfaces) };
            let edit = egui::TextEdit::singleline(&mut self.session.filter[index]).hint_text(say!(lists_filter));
            ui.add(edit.desired_width(120.0)).widget_info(|| WidgetInfo::labeled(Role::TextInput, true, told()));
            ui.label(RichText::new(say!(lists_shown, shown = rows.len(), whole)).weak());
        });
        let (_, dropped) = ui.dnd_drop_zone::<Dragged, _>(egui::Frame::group(ui.style()), |ui| {
            ui.push_id(("list", is_clean), |ui| self.table(ui, &rows, is_clean, height - 90.0, hovered));
        });
        if let Some(dragged) = dropped {
            self.drop_on_list(&dragged, is_clean);
        }
    }

    fn table(&mut self, ui: &mut egui::Ui, rows: &[u32], is_clean: bool, height: f32, hovered: Option<u32>) {
        let height = height.max(80.0);
        ui.set_min_height(height);
        let mut table = TableBuilder::new(ui)
            .striped(true)
            .sense(Sense::click_and_drag())
            .cell_layout(Layout::left_to_right(Align::Center))
            .column(Width::exact(20.0))
            .column(Width::exact(44.0))
            .column(Width::remainder().clip(true).at_least(70.0))
            .column(Width::exact(88.0))
            .min_scrolled_height(height)
            .max_scroll_height(height)
            .auto_shrink([false, false]);
        if let Some(at) = self.session.scroll_to.and_then(|n| rows.iter().position(|&r| r == n)) {
            table = table.scroll_to_row(at, Some(Align::Center));
            self.session.scroll_to = None;
        }
        table
            .header(20.0, |mut header| {
                header.col(|_| {});
                let columns = [
                    (Column::Number, say!(lists_number)),
                    (Column::Shape, say!(lists_shape)),
                    (Column::Area, say!(lists_area)),
                ];
                for (column, name) in columns {
                    header.col(|ui| {
                        if is_clean {
                            ui.label(RichText::new(name).strong());
                            return;
                        }
                        let arrow = match self.session.sort {
                            (c, turned) if c == column => {
                                if turned {
                                    " ▲"
                                } else {
                                    " ▼"
                                }
                            }
                            _ => "",
                        };
                        let button = egui::Button::new(RichText::new(format!("{name}{arrow}")).strong()).frame(false);
                        if ui.add(button).clicked() {
                            let (c, turned) = self.session.sort;
                            self.session.sort = (column, c == column && !turned);
                        }
                    });
                }
            })
            .body(|body| {
                body.rows(20.0, rows.len(), |mut row| {
                    let n = rows[row.index()];
                    row.set_selected(self.session.selected.contains(&n));
                    row.set_hovered(hovered == Some(n));
                    let label = self.derived.label(self.document.job(), n);
                    let area = self.derived.surfaces.get(n).map_or(0.0, |s| s.area_mm2);
                    row.col(|ui| {
                        let color = self.derived.picture.as_ref().map_or([128; 3], |p| p.swatch(n, is_clean));
                        theme::swatch(ui, color);
                    });
                    row.col(|ui| {
                        ui.add(egui::Label::new(n.to_string()).selectable(false));
                    });
                    row.col(|ui| self.shape_cell(ui, n, &label, is_clean));
                    row.col(|ui| {
                        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                            ui.add_space(10.0); // the scroll bar
                            ui.add(egui::Label::new(fixed(area, 2)).selectable(false));
                        });
                    });
                    let response = row.response();
                    let selected = self.session.selected.contains(&n);
                    response.widget_info(|| {
                        let told = say!(lists_row, surface = id(n), label = &label);
                        WidgetInfo::selected(Role::ListBoxOption, true, selected, told)
                    });
                    self.take_row(&response, n, rows, is_clean);
                });
            });
    }

    fn shape_cell(&mut self, ui: &mut egui::Ui, n: u32, label: &str, is_clean: bool) {
        if let Some((of, text)) = &mut self.session.renaming
            && *of == n
        {
            let edit = ui.add(egui::TextEdit::singleline(text).desired_width(f32::INFINITY));
            edit.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, say!(lists_name)));
            edit.request_focus();
            if ui.input(|i| i.key_pressed(Key::Enter)) {
                let text = text.clone();
                self.session.renaming = None;
                self.edit(Edit::Rename(SurfaceId(n), text));
            }
            return;
        }
        let state = if is_clean { self.state_of(n) } else { None };
        let recipe = self.document.job().recipe_of(SurfaceId(n)).cloned();
        // From the right, so that a long name gives way to what is beside it.
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if let Some((word, color)) = state {
                // Not selectable: a text that takes the mouse would take the row's clicks.
                ui.add(egui::Label::new(RichText::new(word).small().color(color)).selectable(false));
            }
            if let Some(recipe) = recipe {
                self.recipe_chip(ui, n, &recipe);
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                ui.add(egui::Label::new(label).selectable(false).truncate());
            });
        });
    }

    /// A surface's recipe, to be dragged onto another row.
    fn recipe_chip(&self, ui: &mut egui::Ui, n: u32, recipe: &Recipe) {
        let short: String = recipe.name.chars().take(CHIP).collect();
        let short = if short == recipe.name { short } else { format!("{short}…") };
        let fill = ui.visuals().widgets.inactive.bg_fill;
        let text = RichText::new(format!(" {short} ")).small().background_color(fill);
        let told = say!(lists_recipe, surface = id(n), recipe = &recipe.name);
        let chip = draggable(ui, recipe, egui::Label::new(text)).on_hover_text(&told);
        chip.widget_info(|| WidgetInfo::labeled(Role::Label, true, told.clone()));
    }

    /// What the plan says of a surface.
    fn state_of(&self, n: u32) -> Option<(String, egui::Color32)> {
        // Of a plan that is out of date nothing is said.
        let row = self.plan()?.report.surfaces.iter().find(|s| s.surface == n)?;
        Some(if row.blocked_mm > 0.0 {
            (say!(lists_blocked), theme::WRONG)
        } else if row.missed_area_mm2 > 0.0 {
            (say!(lists_missed), theme::ATTENTION)
        } else if row.corrected_mm > 0.0 {
            (say!(lists_corrected), theme::ATTENTION)
        } else {
            (say!(lists_planned), theme::ACCENT)
        })
    }

    fn take_row(&mut self, response: &egui::Response, n: u32, rows: &[u32], is_clean: bool) {
        if response.hovered() {
            self.session.hovered = Some(n);
        }
        let modifiers = response.ctx.input(|i| i.modifiers);
        // After a move the next row stands where the last one was clicked: that is no double click.
        let same_row = self.session.last_clicked == Some(n);
        if response.clicked() {
            self.session.last_clicked = Some(n);
        }
        if response.double_clicked() && same_row {
            self.session.selected = [n].into();
            let command = if is_clean { Command::Unclean } else { Command::Clean };
            self.run(command);
        } else if response.clicked() {
            let from = self.session.anchor.and_then(|a| rows.iter().position(|&r| r == a));
            let to = rows.iter().position(|&r| r == n);
            match (from, to) {
                (Some(a), Some(b)) if modifiers.shift => {
                    self.session.selected.extend(&rows[a.min(b)..=a.max(b)]);
                }
                _ => self.select(Some(n), egui::Modifiers { shift: false, ..modifiers }),
            }
        }
        if response.drag_started() {
            if !self.session.selected.contains(&n) {
                self.session.selected = [n].into();
            }
            let surfaces = rows.iter().filter(|r| self.session.selected.contains(r)).map(|r| SurfaceId(*r)).collect();
            response.dnd_set_drag_payload(Dragged { surfaces, from_clean: is_clean });
        }
        // Asked first: taking a payload of another type would lose it.
        if response.dnd_hover_payload::<DraggedRecipe>().is_some() {
            self.session.hovered = Some(n);
            if let Some(dragged) = response.dnd_release_payload::<DraggedRecipe>() {
                self.edit(edit_giving(self.document.job(), &dragged.0, vec![SurfaceId(n)]));
            }
            return;
        }
        if is_clean && let Some(dragged) = response.dnd_release_payload::<Dragged>() {
            self.drop_before(&dragged, n);
        }
    }

    fn drop_on_list(&mut self, dragged: &Arc<Dragged>, is_clean: bool) {
        match (dragged.from_clean, is_clean) {
            (false, true) => self.edit(Edit::Clean(dragged.surfaces.clone())),
            (true, false) => self.edit(Edit::Unclean(dragged.surfaces.clone())),
            // To the end of the order.
            (true, true) => self.edit(Edit::Clean(dragged.surfaces.clone())),
            (false, false) => {}
        }
    }

    /// Puts what is dragged before a row of the list to clean.
    fn drop_before(&mut self, dragged: &Arc<Dragged>, row: u32) {
        let rest = self.clean_list().into_iter().map(SurfaceId).filter(|id| !dragged.surfaces.contains(id));
        let mut list: Vec<SurfaceId> = rest.collect();
        let at = list.iter().position(|id| id.0 == row).unwrap_or(list.len());
        list.splice(at..at, dragged.surfaces.iter().copied());
        self.edit(Edit::Reorder(list));
    }

    fn between_lists(&mut self, ui: &mut egui::Ui) {
        ui.add_space(4.0);
        ui.horizontal(|ui| {
            let buttons = [
                (say!(lists_clean), Command::Clean),
                (say!(lists_back), Command::Unclean),
                (say!(lists_earlier), Command::CleanEarlier),
                (say!(lists_later), Command::CleanLater),
            ];
            for (text, command) in buttons {
                let tip = format!("{}  {}", command.name(), command.keys_text(ui.ctx()));
                if ui.add_enabled(self.is_enabled(command), egui::Button::new(text)).on_hover_text(tip).clicked() {
                    self.run(command);
                }
            }
        });
    }
}
