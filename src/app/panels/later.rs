//! The list under *To clean*: surfaces that were put aside for another job, with a way back.

use super::super::{App, theme};
use crate::document::Edit;
use crate::part::SurfaceId;
use crate::text::{fixed, id, say};
use eframe::egui::{self, Align, Layout, RichText, Role, ScrollArea, WidgetInfo};

/// Height of a row, and how many are shown before the list scrolls.
const ROW: f32 = 24.0;
const ROWS: usize = 4;

impl App {
    /// Surfaces that are put aside, by their numbers.
    pub(in super::super) fn later_list(&self) -> Vec<u32> {
        let aside = self.document.job().settings.having(|s| s.later);
        aside.into_iter().map(|id| id.0).filter(|n| self.derived.surfaces.get(*n).is_some()).collect()
    }

    /// The height that the list takes.
    pub(super) fn later_height(&self) -> f32 {
        match self.later_list().len() {
            0 => 0.0,
            count => 54.0 + ROW * count.min(ROWS) as f32,
        }
    }

    /// The list; nothing where nothing is put aside.
    pub(super) fn later(&mut self, ui: &mut egui::Ui) {
        let rows = self.later_list();
        if rows.is_empty() {
            return;
        }
        theme::heading(ui, &say!(later_heading, count = rows.len()));
        let mut edit = None;
        egui::Frame::group(ui.style()).show(ui, |ui| {
            ScrollArea::vertical().id_salt("later").max_height(ROW * ROWS as f32).show(ui, |ui| {
                for n in rows {
                    edit = self.later_row(ui, n).or(edit.take());
                }
            });
        });
        edit.into_iter().for_each(|e| self.edit(e));
    }

    fn later_row(&mut self, ui: &mut egui::Ui, n: u32) -> Option<Edit> {
        let label = self.derived.label(self.document.job(), n);
        let area = self.derived.surfaces.get(n).map_or(0.0, |s| s.area_mm2);
        let mut edit = None;
        ui.horizontal(|ui| {
            let color = self.derived.picture.as_ref().map_or([128; 3], |p| p.swatch(n, false));
            theme::swatch(ui, color);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
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
                    let button = ui.small_button(text).on_hover_text(tip);
                    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, told.clone()));
                    if button.clicked() {
                        edit = Some(way);
                    }
                }
                ui.label(RichText::new(say!(later_area, area = fixed(area, 2))).weak());
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    let selected = self.session.selected.contains(&n);
                    let row = ui.add(egui::Button::selectable(selected, format!("{n}  {label}")).truncate());
                    row.widget_info(|| {
                        let told = say!(later_row, surface = id(n), label = &label);
                        WidgetInfo::selected(Role::ListBoxOption, true, selected, told)
                    });
                    if row.hovered() {
                        self.session.hovered = Some(n);
                    }
                    if row.clicked() {
                        self.select(Some(n), egui::Modifiers::NONE);
                    }
                });
            });
        });
        edit
    }
}
