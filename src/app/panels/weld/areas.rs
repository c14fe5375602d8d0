//! The areas that were found, and which of them are ground.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::theme;
use crate::document::WeldEdit;
use crate::document::model::AreaChoice;
use crate::picture::weld_image::area_color;
use crate::planning::welded::{MeasuredArea, MeasuredWeld, WeldReport};
use crate::text::{Sentence as _, area_word, fixed, id, say};
use eframe::egui::{self, RichText, Role, WidgetInfo};

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    theme::heading(ui, &say!(weld_panel_areas));
    let Some(measured) = context.weld.measured() else {
        ui.label(RichText::new(say!(weld_panel_no_areas)).weak());
        return;
    };
    let report = context.weld.report();
    let choice = &context.document.job().weld.areas;
    for (i, area) in measured.areas.iter().enumerate() {
        ui.horizontal(|ui| {
            let mut on = area.is_chosen(choice);
            let name = say!(weld_panel_area, area = id(i + 1), kind = area_word(area.kind()));
            let tick = ui.checkbox(&mut on, "").on_hover_text(say!(weld_panel_area_tip));
            tick.widget_info(|| {
                WidgetInfo::selected(Role::CheckBox, true, on, say!(weld_panel_grind_area, area = id(i + 1)))
            });
            if tick.changed() {
                actions.grind(WeldEdit::Areas(chosen(measured, choice, i, on)));
            }
            if let Some(place) = place_in_mask(context, area) {
                let [r, g, b, _] = area_color(place);
                theme::swatch(ui, [r, g, b]);
            }
            let text = format!("{name}  {}", figures(area, report));
            ui.add(egui::Label::new(text).truncate());
        });
    }
    for unmeasured in &measured.unmeasured {
        ui.label(RichText::new(theme::capital(&unmeasured.sentence())).color(ui.visuals().warn_fg_color));
    }
}

/// Size and height, as far as they are known.
fn figures(area: &MeasuredArea, report: Option<&WeldReport>) -> String {
    let [u, v] = area.seen.centroid_px;
    let is_it = |[x, y]: [f64; 2]| (x - u).abs() < 1.0 && (y - v).abs() < 1.0;
    let known = report.and_then(|r| r.areas.iter().find(|a| is_it(a.centre_px)));
    let size = match known {
        Some(known) => say!(weld_panel_area_mm2, area = fixed(known.area_mm2, 0)),
        None => say!(weld_panel_area_px, pixels = area.seen.pixels),
    };
    match &area.bead {
        Some(bead) => say!(weld_panel_area_high, size, height = fixed(bead.max_height_mm, 2)),
        None => size,
    }
}

/// The place of an area in the list of the mask, which the images are coloured by.
fn place_in_mask(context: Context<'_>, area: &MeasuredArea) -> Option<usize> {
    context.weld.masked()?.areas.list.iter().position(|seen| *seen == area.seen)
}

/// The choice with one area ticked or not.
fn chosen(measured: &MeasuredWeld, before: &AreaChoice, at: usize, on: bool) -> AreaChoice {
    let is_on = |(i, area): (usize, &MeasuredArea)| if i == at { on } else { area.is_chosen(before) };
    let ticked: Vec<&MeasuredArea> =
        measured.areas.iter().enumerate().filter(|(i, area)| is_on((*i, *area))).map(|(_, area)| area).collect();
    if ticked.len() == measured.areas.len() {
        return AreaChoice::All;
    }
    AreaChoice::At(ticked.into_iter().filter_map(MeasuredArea::place_px).collect())
}
