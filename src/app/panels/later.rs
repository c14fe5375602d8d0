//! The list under *To clean*: surfaces that were put aside for another job, with a way back.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::theme;
use crate::document::Edit;
use crate::part::SurfaceId;
use crate::text::{fixed, id, say};
use eframe::egui::{self, Align, Layout, RichText, Role, ScrollArea, WidgetInfo};

/// Height of a row, and how many are shown before the list scrolls.
const ROW: f32 = 24.0;
const ROWS: usize = 4;

impl Context<'_> {
    /// Surfaces that are put aside, by their numbers.
    pub fn later_list(self) -> Vec<u32> {
        let aside = self.document.job().settings.having(|s| s.later);
        aside.into_iter().map(|id| id.0).filter(|n| self.derived.surfaces.get(*n).is_some()).collect()
    }
}

/// The height that the list takes.
pub(super) fn height(context: Context<'_>) -> f32 {
    match context.later_list().len() {
        0 => 0.0,
        count => 54.0 + ROW * count.min(ROWS) as f32,
    }
}

/// The list; nothing where nothing is put aside.
pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let rows = context.later_list();
    if rows.is_empty() {
        return;
    }
    theme::heading(ui, &say!(later_heading, count = rows.len()));
    egui::Frame::group(ui.style()).show(ui, |ui| {
        ScrollArea::vertical().id_salt("later").max_height(ROW * ROWS as f32).show(ui, |ui| {
            for n in rows {
                row(ui, n, context, actions);
            }
        });
    });
}

fn row(ui: &mut egui::Ui, n: u32, context: Context<'_>, actions: &mut Actions) {
    let area = context.derived.surfaces.get(n).map_or(0.0, |s| s.area_mm2);
    ui.horizontal(|ui| {
        let color = context.derived.picture.as_ref().map_or([128; 3], |p| p.swatch(n, false));
        theme::swatch(ui, color);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ways(ui, n, context, actions);
            ui.label(RichText::new(say!(later_area, area = fixed(area, 2))).weak());
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| name(ui, n, context, actions));
        });
    });
}

/// Buttons that bring a surface back: to the feature surfaces, or to the list to clean.
fn ways(ui: &mut egui::Ui, n: u32, context: Context<'_>, actions: &mut Actions) {
    let why = context.why_told_what_to_work();
    let is_free = why.is_none();
    let ways = [
        (
            say!(later_back),
            say!(later_back_name, surface = id(n)),
            say!(later_back_tip),
            Edit::TakeBack(vec![SurfaceId(n)]),
        ),
        (
            say!(later_clean),
            say!(later_clean_name, surface = id(n)),
            say!(later_clean_tip),
            Edit::Clean(vec![SurfaceId(n)]),
        ),
    ];
    for (text, told, tip, way) in ways {
        let button = ui.add_enabled(is_free, egui::Button::new(text).small()).on_hover_text(tip);
        let button = button.on_disabled_hover_text(why.clone().unwrap_or_default());
        button.widget_info(|| WidgetInfo::labeled(Role::Button, is_free, told.clone()));
        if button.clicked() {
            actions.edit(way);
        }
    }
}

fn name(ui: &mut egui::Ui, n: u32, context: Context<'_>, actions: &mut Actions) {
    let label = context.derived.label(context.document.job(), n);
    let selected = context.session.selected.contains(&n);
    let row = ui.add(egui::Button::selectable(selected, format!("{n}  {label}")).truncate());
    row.widget_info(|| {
        let told = say!(later_row, surface = id(n), label = &label);
        WidgetInfo::selected(Role::ListBoxOption, true, selected, told)
    });
    if row.hovered() {
        actions.session(move |s| s.hovered = Some(n));
    }
    if row.clicked() {
        actions.session(move |s| s.select(Some(n), egui::Modifiers::NONE));
    }
}
