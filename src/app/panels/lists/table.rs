//! The table of a list: its columns, its head that sorts, and its rows.

use super::super::super::actions::Actions;
use super::super::super::session::Column;
use super::super::super::theme;
use super::row;
use super::rows::List;
use crate::text::{fixed, id, say};
use eframe::egui::{self, Align, Layout, RichText, Role, Sense, WidgetInfo};
use egui_extras::{Column as Width, TableBuilder, TableRow};

impl List<'_> {
    /// Draws the table, at least so high.
    pub fn ui(self, ui: &mut egui::Ui, height: f32, actions: &mut Actions) {
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
        let wanted = self.context.session.scroll_to;
        if let Some(at) = wanted.and_then(|n| self.rows.iter().position(|&r| r == n)) {
            table = table.scroll_to_row(at, Some(Align::Center));
            actions.session(|s| s.scroll_to = None);
        }
        table.header(20.0, |header| self.head(header, actions)).body(|body| {
            body.rows(20.0, self.rows.len(), |row| self.row(row, actions));
        });
    }

    fn head(self, mut header: TableRow<'_, '_>, actions: &mut Actions) {
        header.col(|_| {});
        let columns = [
            (Column::Number, say!(lists_number)),
            (Column::Shape, say!(lists_shape)),
            (Column::Area, say!(lists_area)),
        ];
        for (column, name) in columns {
            header.col(|ui| {
                if self.is_clean {
                    ui.label(RichText::new(name).strong());
                } else {
                    self.sort_button(ui, column, &name, actions);
                }
            });
        }
    }

    fn sort_button(self, ui: &mut egui::Ui, column: Column, name: &str, actions: &mut Actions) {
        let (sorted_by, turned) = self.context.session.sort;
        let arrow = match (sorted_by == column, turned) {
            (true, true) => " ▲",
            (true, false) => " ▼",
            (false, _) => "",
        };
        let button = egui::Button::new(RichText::new(format!("{name}{arrow}")).strong()).frame(false);
        if ui.add(button).clicked() {
            actions.session(move |s| s.sort = (column, sorted_by == column && !turned));
        }
    }

    fn row(self, mut row: TableRow<'_, '_>, actions: &mut Actions) {
        let List { context, is_clean, .. } = self;
        let (d, session) = (context.derived, context.session);
        let n = self.rows[row.index()];
        let selected = session.selected.contains(&n);
        row.set_selected(selected);
        row.set_hovered(session.hovered == Some(n));
        let label = d.label(context.document.job(), n);
        let area = d.surfaces.get(n).map_or(0.0, |s| s.area_mm2);
        row.col(|ui| {
            let color = d.picture.as_ref().map_or([128; 3], |p| p.swatch(n, is_clean));
            theme::swatch(ui, color);
        });
        row.col(|ui| {
            ui.add(egui::Label::new(n.to_string()).selectable(false));
        });
        row.col(|ui| self.shape_cell(ui, n, &label, actions));
        row.col(|ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                ui.add_space(10.0); // the scroll bar
                ui.add(egui::Label::new(fixed(area, 2)).selectable(false));
            });
        });
        let response = row.response();
        response.widget_info(|| {
            let told = say!(lists_row, surface = id(n), label = &label);
            WidgetInfo::selected(Role::ListBoxOption, true, selected, told)
        });
        row::take(&response, n, self, actions);
    }
}
