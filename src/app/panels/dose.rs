//! The dose in numbers: shares of the chosen area, histogram, what lands beside, what stays unclean, and
//! which passes come to a clicked place.

use super::super::dose::DoseView;
use super::super::session::Coloring;
use super::super::{App, theme};
use crate::document::Edit;
use crate::picture::dose::{DoseLook, Legend, OVER, SHADED, UNDER, legend};
use crate::picture::viridis;
use crate::process::{Patch, Thresholds};
use crate::text::{NamedSentence as _, Naming, choices, clock, fixed, id, language, legend_entry, percent, say};
use eframe::egui::{self, Color32, Rect, RichText, Sense, Stroke, pos2, vec2};
use std::sync::Arc;

/// Classes of the histogram.
const BINS: usize = 40;
/// Rows of a list before it is cut.
const ROWS: usize = 12;

fn rgb([r, g, b]: [u8; 3]) -> Color32 {
    Color32::from_rgb(r, g, b)
}

/// A dose for people: three digits that say something.
fn j_cm2(value: f64) -> String {
    match value >= 10_000.0 {
        true => say!(dose_panel_kj_cm2, dose = fixed(value * 1e-3, 1)),
        false => say!(dose_panel_j_cm2, dose = fixed(value, 0)),
    }
}

impl App {
    pub(in super::super) fn dose_panel(&mut self, ui: &mut egui::Ui) {
        ui.horizontal(|ui| {
            theme::heading(ui, &say!(dose_panel_heading));
            let ways = [
                (Coloring::Dose, say!(dose_panel_by_dose)),
                (Coloring::Incidence, say!(dose_panel_by_incidence)),
                (Coloring::Surface, say!(dose_panel_by_surface)),
            ];
            for (c, name) in ways {
                if ui.selectable_label(self.session.coloring == c, name).clicked() {
                    self.session.coloring = c;
                }
            }
        });
        let Some(view) = self.dose().cloned() else {
            ui.horizontal(|ui| {
                if self.dose_progress().is_some() {
                    ui.spinner();
                    ui.label(say!(dose_panel_computing));
                } else if self.plan().is_none() {
                    ui.label(say!(dose_panel_no_plan));
                } else {
                    ui.label(say!(dose_panel_not_computed));
                }
            });
            return;
        };
        egui::ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            let look = if self.session.coloring == Coloring::Incidence { DoseLook::Incidence } else { DoseLook::Dose };
            scale(ui, &legend(&view.map, look));
            shares(ui, &view);
            if look == DoseLook::Dose {
                histogram(ui, &view);
            }
            self.clicked(ui);
            self.patches(ui, &view);
            self.collateral(ui, &view);
        });
    }

    fn clicked(&mut self, ui: &mut egui::Ui) {
        theme::heading(ui, &say!(dose_panel_clicked));
        let Some(c) = self.session.clicked.clone() else {
            ui.label(RichText::new(say!(dose_panel_click)).small());
            return;
        };
        let whole: f64 = c.hits.iter().map(|h| h.j_cm2).sum();
        let surface = self.derived.surfaces.of_facet.get(c.facet as usize).copied().unwrap_or(0);
        let (surface, place) = (id(surface), choices::place(c.p.coords.into()));
        ui.label(say!(dose_panel_place, surface, place, dose = j_cm2(whole)));
        if c.hits.is_empty() {
            ui.label(say!(dose_panel_no_beam));
        }
        for h in c.hits.iter().take(ROWS) {
            let (pass, time, angle) = (id(h.pass), clock(h.at_s), fixed(h.angle_deg, 0));
            let text = say!(dose_panel_hit, pass, time, angle, dose = j_cm2(h.j_cm2));
            if ui.link(RichText::new(text).small()).on_hover_text(say!(dose_panel_go_to_pass)).clicked() {
                self.go_to_target((h.pass as usize, 0));
            }
        }
    }

    /// What no light comes to, which may go to a second list, and the gaps between lines, which may not.
    fn patches(&mut self, ui: &mut egui::Ui, view: &Arc<DoseView>) {
        self.patch_list(ui, view, true);
        if view.patches.iter().any(|p| p.cause.keeps_light_away()) {
            let aside = Edit::aside(&view.patches, &view.surfaces);
            let button = ui.add_enabled(aside.is_some(), egui::Button::new(say!(dose_panel_put_aside)));
            if button.on_hover_text(say!(dose_panel_put_aside_tip)).clicked()
                && let Some(edit) = aside
            {
                self.edit(edit);
            }
        }
        self.patch_list(ui, view, false);
    }

    fn patch_list(&mut self, ui: &mut egui::Ui, view: &DoseView, without_light: bool) {
        let told = view.patches.iter().zip(&view.report.not_cleanable);
        let list: Vec<_> = told.filter(|(p, _)| p.cause.keeps_light_away() == without_light).collect();
        if list.is_empty() {
            return;
        }
        let whole: f64 = list.iter().map(|(p, _)| p.area_mm2).sum();
        let area = fixed(0.01 * whole, 2);
        let title =
            if without_light { say!(dose_panel_not_cleanable, area) } else { say!(dose_panel_too_little, area) };
        theme::heading(ui, &title);
        for (p, told) in list.iter().take(ROWS) {
            let (area, surface) = (fixed(told.area_cm2, 2), id(told.surface));
            let text =
                say!(dose_panel_patch, area, surface, why = told.sentence_with(&Naming::of(self.document.job())));
            if ui.link(RichText::new(text).small()).on_hover_text(say!(dose_panel_show)).clicked() {
                self.look_at(p);
            }
        }
        if list.len() > ROWS {
            ui.label(RichText::new(say!(dose_panel_smaller, count = list.len() - ROWS)).small());
        }
    }

    fn look_at(&mut self, patch: &Patch) {
        self.session.selected = [patch.surface].into();
        self.session.scroll_to = Some(patch.surface);
        let radius = (patch.area_mm2).sqrt().max(2.0);
        let (place, out) = (self.scene_from_part(), nalgebra::Vector3::repeat(radius));
        let centre = place * patch.centre;
        self.viewport.fit(crate::view::Bounds { min: centre - out, max: centre + out });
    }

    fn collateral(&mut self, ui: &mut egui::Ui, view: &Arc<DoseView>) {
        if view.report.collateral.is_empty() {
            return;
        }
        theme::heading(ui, &say!(dose_panel_beside, area = fixed(view.report.collateral_mm2, 1)));
        let over = say!(dose_panel_beside_over, dose = j_cm2(view.report.collateral_j_cm2));
        ui.label(RichText::new(over).small());
        for c in view.report.collateral.iter().take(ROWS) {
            let (surface, area) = (id(c.surface), fixed(c.area_mm2, 1));
            let text = say!(dose_panel_beside_surface, surface, area, dose = j_cm2(c.greatest_j_cm2));
            if ui.link(RichText::new(text).small()).on_hover_text(say!(dose_panel_show)).clicked() {
                self.session.selected = [c.surface].into();
                self.session.scroll_to = Some(c.surface);
                self.focus_surface(c.surface);
            }
        }
    }
}

/// The colours from end to end; `way`: share of their way at a share of the bar.
pub(super) fn bar(ui: &mut egui::Ui, width: f32, told: impl Fn() -> String, way: impl Fn(f64) -> f64) {
    let (rect, response) = ui.allocate_exact_size(vec2(width, 14.0), Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, told()));
    let steps = 48;
    for k in 0..steps {
        let left = rect.left() + rect.width() * k as f32 / steps as f32;
        let size = vec2(rect.width() / steps as f32 + 0.5, rect.height());
        let share = way((f64::from(k) + 0.5) / f64::from(steps));
        ui.painter().rect_filled(Rect::from_min_size(pos2(left, rect.top()), size), 0, rgb(viridis(share)));
    }
}

fn scale(ui: &mut egui::Ui, legend: &Legend) {
    let width = ui.available_width().min(260.0);
    // Incidence is lightest where the light stands upright.
    let is_angle = legend.look == DoseLook::Incidence;
    bar(ui, width, || say!(dose_panel_scale), |share| if is_angle { 1.0 - share } else { share });
    ui.horizontal(|ui| {
        let [low, high] = legend.range;
        let said = |v: f64| if is_angle { say!(dose_panel_angle, angle = fixed(v, 0)) } else { j_cm2(v) };
        ui.label(RichText::new(said(low)).small());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(RichText::new(said(high)).small());
        });
    });
    ui.horizontal_wrapped(|ui| {
        for entry in legend.entries {
            theme::swatch(ui, entry.color());
            ui.label(RichText::new(legend_entry(*entry, language())).small());
        }
    });
}

fn shares(ui: &mut egui::Ui, view: &DoseView) {
    let r = &view.report;
    let rows = [
        (say!(dose_panel_within, percent = percent(r.within, 1)), r.within, rgb(viridis(0.6))),
        (say!(dose_panel_under, percent = percent(r.under, 1)), r.under, rgb(UNDER)),
        (say!(dose_panel_over, percent = percent(r.over, 1)), r.over, rgb(OVER)),
        (say!(dose_panel_shaded, percent = percent(r.shaded, 1)), r.shaded, rgb(SHADED)),
    ];
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width().min(260.0), 10.0), Sense::hover());
    let mut left = rect.left();
    for (_, share, color) in &rows {
        let width = rect.width() * *share as f32;
        ui.painter().rect_filled(Rect::from_min_size(pos2(left, rect.top()), vec2(width, rect.height())), 0, *color);
        left += width;
    }
    for (text, _, color) in rows {
        ui.horizontal(|ui| {
            theme::swatch(ui, [color.r(), color.g(), color.b()]);
            ui.label(text);
        });
    }
    let text = say!(dose_panel_window, low = j_cm2(r.low_j_cm2), high = j_cm2(r.high_j_cm2));
    ui.label(RichText::new(text).small());
}

/// Area by dose, with the window's ends.
fn histogram(ui: &mut egui::Ui, view: &DoseView) {
    let Thresholds { low_j_cm2, high_j_cm2, .. } = view.map.thresholds;
    let to = 1.25 * high_j_cm2;
    let bins = view.map.histogram(&view.surfaces, BINS, to);
    let most = bins.iter().copied().fold(1e-12, f64::max);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width().min(260.0), 60.0), Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, say!(dose_panel_histogram)));
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 0, ui.visuals().extreme_bg_color);
    let width = rect.width() / BINS as f32;
    for (k, area) in bins.iter().enumerate() {
        let middle = (k as f64 + 0.5) / BINS as f64 * to;
        let color = if middle > high_j_cm2 { rgb(OVER) } else { rgb(viridis(middle / high_j_cm2)) };
        let height = (area / most) as f32 * (rect.height() - 2.0);
        let left = rect.left() + k as f32 * width;
        let bar = Rect::from_min_max(pos2(left, rect.bottom() - height), pos2(left + width - 0.5, rect.bottom()));
        painter.rect_filled(bar, 0, color);
    }
    for value in [low_j_cm2, high_j_cm2] {
        let x = rect.left() + (value / to) as f32 * rect.width();
        let stroke = Stroke::new(1.0, ui.visuals().strong_text_color());
        painter.line_segment([pos2(x, rect.top()), pos2(x, rect.bottom())], stroke);
    }
    ui.label(RichText::new(say!(dose_panel_histogram_note)).small());
}
