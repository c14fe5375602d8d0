//! A row of a list: the cell with shape or name, and what clicks and drags on the row do.

use super::super::super::actions::Actions;
use super::super::super::command::Command;
use super::super::super::context::Context;
use super::super::library::{DraggedRecipe, draggable, edit_giving};
use super::Dragged;
use super::rows::List;
use crate::document::{Edit, Recipe};
use crate::part::SurfaceId;
use crate::text::{id, say};
use eframe::egui::{self, Align, Key, Layout, RichText, Role, WidgetInfo};
use std::collections::BTreeSet;

/// Letters of a recipe's name that are shown in a row.
const CHIP: usize = 9;

impl List<'_> {
    /// Shape or name, recipe, and what the plan says of a surface; or the field in which it is renamed.
    pub fn shape_cell(self, ui: &mut egui::Ui, n: u32, label: &str, actions: &mut Actions) {
        let context = self.context;
        if let Some((of, text)) = &context.session.renaming
            && *of == n
        {
            rename(ui, n, text.clone(), context, actions);
            return;
        }
        let state = if self.is_clean { state_of(n, context, ui.visuals()) } else { None };
        // From the right, so that a long name gives way to what is beside it.
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if let Some((word, color)) = state {
                // Not selectable: a text that takes the mouse would take the row's clicks.
                ui.add(egui::Label::new(RichText::new(word).small().color(color)).selectable(false));
            }
            if let Some(recipe) = context.document.job().recipe_of(SurfaceId(n)) {
                recipe_chip(ui, n, recipe);
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                ui.add(egui::Label::new(label).selectable(false).truncate());
            });
        });
    }
}

/// The field of a name. Of several selected surfaces each gets it with a number.
fn rename(ui: &mut egui::Ui, n: u32, mut text: String, context: Context<'_>, actions: &mut Actions) {
    let edit = ui.add(egui::TextEdit::singleline(&mut text).desired_width(f32::INFINITY));
    edit.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, say!(lists_name)));
    edit.request_focus();
    if ui.input(|i| i.key_pressed(Key::Enter)) {
        actions.session(|s| s.renaming = None);
        match context.session.selected_ids() {
            many if many.len() > 1 && many.contains(&SurfaceId(n)) && !text.trim().is_empty() => {
                actions.edit(Edit::RenameSeveral(many, text));
            }
            _ => actions.edit(Edit::Rename(SurfaceId(n), text)),
        }
    } else if edit.changed() {
        actions.session(move |s| s.renaming = Some((n, text)));
    }
}

/// A surface's recipe, to be dragged onto another row.
fn recipe_chip(ui: &mut egui::Ui, n: u32, recipe: &Recipe) {
    let short: String = recipe.name.chars().take(CHIP).collect();
    let short = if short == recipe.name { short } else { format!("{short}…") };
    let fill = ui.visuals().widgets.inactive.bg_fill;
    let text = RichText::new(format!(" {short} ")).small().background_color(fill);
    let told = say!(lists_recipe, surface = id(n), recipe = &recipe.name);
    let chip = draggable(ui, recipe, egui::Label::new(text)).on_hover_text(&told);
    chip.widget_info(|| WidgetInfo::labeled(Role::Label, true, told.clone()));
}

/// What the plan says of a surface; nothing if it is out of date.
fn state_of(n: u32, context: Context<'_>, visuals: &egui::Visuals) -> Option<(String, egui::Color32)> {
    let row = context.plan()?.report.surfaces.iter().find(|s| s.surface == n)?;
    Some(if row.blocked_mm > 0.0 {
        (say!(lists_blocked), visuals.error_fg_color)
    } else if row.missed_area_mm2 > 0.0 {
        (say!(lists_missed), visuals.warn_fg_color)
    } else if row.corrected_mm > 0.0 {
        (say!(lists_corrected), visuals.warn_fg_color)
    } else {
        (say!(lists_planned), visuals.hyperlink_color)
    })
}

/// Does what the pointer does on a row.
pub(super) fn take(response: &egui::Response, n: u32, list: List<'_>, actions: &mut Actions) {
    if response.hovered() {
        actions.session(move |s| s.hovered = Some(n));
    }
    click(response, n, list, actions);
    if response.drag_started() {
        drag(response, n, list, actions);
    }
    // Asked first: taking a payload of another type would lose it.
    if response.dnd_hover_payload::<DraggedRecipe>().is_some() {
        actions.session(move |s| s.hovered = Some(n));
        if let Some(dragged) = response.dnd_release_payload::<DraggedRecipe>() {
            actions.edit(edit_giving(list.context.document.job(), &dragged.0, vec![SurfaceId(n)]));
        }
        return;
    }
    if list.is_clean
        && !list.context.is_told_what_to_work()
        && let Some(dragged) = response.dnd_release_payload::<Dragged>()
    {
        actions.edit(put_before(&dragged.surfaces, n, list.context));
    }
}

/// Selects, with Shift from where the last click was; a double click moves the surface to the other list.
fn click(response: &egui::Response, n: u32, list: List<'_>, actions: &mut Actions) {
    let List { rows, is_clean, context } = list;
    let modifiers = response.ctx.input(|i| i.modifiers);
    // After a move the next row stands where the last one was clicked: that is no double click.
    let same_row = context.session.last_clicked == Some(n);
    if response.clicked() {
        actions.session(move |s| s.last_clicked = Some(n));
    }
    if response.double_clicked() && same_row {
        actions.session(move |s| s.selected = [n].into());
        actions.command(if is_clean { Command::Unclean } else { Command::Clean });
    } else if response.clicked() {
        let place = |of: u32| rows.iter().position(|&r| r == of);
        match (context.session.anchor.and_then(place), place(n)) {
            (Some(a), Some(b)) if modifiers.shift => {
                let between = rows[a.min(b)..=a.max(b)].to_vec();
                actions.session(move |s| s.selected.extend(between));
            }
            _ => actions.session(move |s| s.select(Some(n), egui::Modifiers { shift: false, ..modifiers })),
        }
    }
}

/// Takes the selected surfaces along, or this one alone if it is not among them.
fn drag(response: &egui::Response, n: u32, list: List<'_>, actions: &mut Actions) {
    let selected = &list.context.session.selected;
    let taken: BTreeSet<u32> = if selected.contains(&n) { selected.clone() } else { [n].into() };
    let surfaces = list.rows.iter().filter(|r| taken.contains(r)).map(|r| SurfaceId(*r)).collect();
    response.dnd_set_drag_payload(Dragged { surfaces, from_clean: list.is_clean });
    if !selected.contains(&n) {
        actions.session(move |s| s.selected = taken);
    }
}

/// Puts surfaces before a row of the list to clean.
fn put_before(surfaces: &[SurfaceId], row: u32, context: Context<'_>) -> Edit {
    let rest = context.clean_list().into_iter().map(SurfaceId).filter(|id| !surfaces.contains(id));
    let mut order: Vec<SurfaceId> = rest.collect();
    let at = order.iter().position(|id| id.0 == row).unwrap_or(order.len());
    order.splice(at..at, surfaces.iter().copied());
    Edit::Reorder(order)
}
