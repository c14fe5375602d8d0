//! The dose in numbers: shares of the chosen area, histogram, what lands beside, what stays unclean, and
//! which passes come to a clicked place.

use super::super::dose::DoseView;
use super::super::session::Coloring;
use super::super::{App, theme};
use crate::document::Edit;
use crate::picture::dose::{DoseLook, Legend, OVER, SHADED, UNDER, legend};
use crate::picture::viridis;
use crate::process::{Patch, Thresholds};
use crate::text::{NamedSentence as _, Naming, clock, language, legend_entry};
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
    if value >= 10_000.0 { format!("{:.1} kJ/cm²", value * 1e-3) } else { format!("{value:.0} J/cm²") }
}

impl App {
    pub(in super::super) fn dose_panel(&mut self, ui: &mut egui::Ui) {
        ui.horizontal(|ui| {
            theme::heading(ui, "Dose");
            let ways = [(Coloring::Dose, "dose"), (Coloring::Incidence, "incidence"), (Coloring::Surface, "surfaces")];
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
                    ui.label("computing what lands");
                } else if self.plan().is_none() {
                    ui.label("waits for the plan of the job as it is");
                } else {
                    ui.label("not computed; close and open the panel to try again");
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
        theme::heading(ui, "Clicked place");
        let Some(c) = self.session.clicked.clone() else {
            ui.label(RichText::new("click the part: which passes come there").small());
            return;
        };
        let whole: f64 = c.hits.iter().map(|h| h.j_cm2).sum();
        let surface = self.derived.surfaces.of_facet.get(c.facet as usize).copied().unwrap_or(0);
        ui.label(format!("surface {surface} at ({:.1}, {:.1}, {:.1}): {}", c.p.x, c.p.y, c.p.z, j_cm2(whole)));
        if c.hits.is_empty() {
            ui.label("no beam comes here");
        }
        for h in c.hits.iter().take(ROWS) {
            let text = format!("pass {} at {}, {:.0}°, {}", h.pass, clock(h.at_s), h.angle_deg, j_cm2(h.j_cm2));
            if ui.link(RichText::new(text).small()).on_hover_text("Go to this pass").clicked() {
                self.go_to_target((h.pass as usize, 0));
            }
        }
    }

    /// What no light comes to, which may go to a second list, and the gaps between lines, which may not.
    fn patches(&mut self, ui: &mut egui::Ui, view: &Arc<DoseView>) {
        self.patch_list(ui, view, "Not cleanable", true);
        if view.patches.iter().any(|p| p.cause.keeps_light_away()) {
            let aside = Edit::aside(&view.patches, &view.surfaces);
            let button = ui.add_enabled(aside.is_some(), egui::Button::new("Put them on a second list"));
            let tip = "They become surfaces of their own, put aside for another job, and are not planned";
            if button.on_hover_text(tip).clicked()
                && let Some(edit) = aside
            {
                self.edit(edit);
            }
        }
        self.patch_list(ui, view, "Too little", false);
    }

    fn patch_list(&mut self, ui: &mut egui::Ui, view: &DoseView, title: &str, without_light: bool) {
        let told = view.patches.iter().zip(&view.report.not_cleanable);
        let list: Vec<_> = told.filter(|(p, _)| p.cause.keeps_light_away() == without_light).collect();
        if list.is_empty() {
            return;
        }
        let whole: f64 = list.iter().map(|(p, _)| p.area_mm2).sum();
        theme::heading(ui, &format!("{title}: {:.2} cm²", 0.01 * whole));
        for (p, told) in list.iter().take(ROWS) {
            let why = told.sentence_with(&Naming::of(self.document.job()));
            let text = format!("{:.2} cm² of surface {}: {why}", told.area_cm2, told.surface);
            if ui.link(RichText::new(text).small()).on_hover_text("Show it").clicked() {
                self.look_at(p);
            }
        }
        if list.len() > ROWS {
            ui.label(RichText::new(format!("and {} smaller ones", list.len() - ROWS)).small());
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
        theme::heading(ui, &format!("Beside what was chosen: {:.1} mm²", view.report.collateral_mm2));
        ui.label(RichText::new(format!("more than {}", j_cm2(view.report.collateral_j_cm2))).small());
        for c in view.report.collateral.iter().take(ROWS) {
            let text = format!("surface {}: {:.1} mm², up to {}", c.surface, c.area_mm2, j_cm2(c.greatest_j_cm2));
            if ui.link(RichText::new(text).small()).on_hover_text("Show it").clicked() {
                self.session.selected = [c.surface].into();
                self.session.scroll_to = Some(c.surface);
                self.focus_surface(c.surface);
            }
        }
    }
}

/// The colours from end to end; `way`: share of their way at a share of the bar.
pub(super) fn bar(ui: &mut egui::Ui, width: f32, told: &str, way: impl Fn(f64) -> f64) {
    let (rect, response) = ui.allocate_exact_size(vec2(width, 14.0), Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, told));
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
    bar(ui, width, "colour scale", |share| if legend.look == DoseLook::Incidence { 1.0 - share } else { share });
    ui.horizontal(|ui| {
        let [low, high] = legend.range;
        let said = |v: f64| if legend.look == DoseLook::Incidence { format!("{v:.0}°") } else { j_cm2(v) };
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
        ("within the window", r.within, rgb(viridis(0.6))),
        ("under", r.under, rgb(UNDER)),
        ("over", r.over, rgb(OVER)),
        ("shaded", r.shaded, rgb(SHADED)),
    ];
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width().min(260.0), 10.0), Sense::hover());
    let mut left = rect.left();
    for (_, share, color) in rows {
        let width = rect.width() * share as f32;
        ui.painter().rect_filled(Rect::from_min_size(pos2(left, rect.top()), vec2(width, rect.height())), 0, color);
        left += width;
    }
    for (name, share, color) in rows {
        ui.horizontal(|ui| {
            theme::swatch(ui, [color.r(), color.g(), color.b()]);
            ui.label(format!("{:.1}% {name}", 100.0 * share));
        });
    }
    let text = format!("window {} to {}", j_cm2(r.low_j_cm2), j_cm2(r.high_j_cm2));
    ui.label(RichText::new(text).small());
}

/// Area by dose, with the window's ends.
fn histogram(ui: &mut egui::Ui, view: &DoseView) {
    let Thresholds { low_j_cm2, high_j_cm2, .. } = view.map.thresholds;
    let to = 1.25 * high_j_cm2;
    let bins = view.map.histogram(&view.surfaces, BINS, to);
    let most = bins.iter().copied().fold(1e-12, f64::max);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width().min(260.0), 60.0), Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "histogram of the dose"));
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
    ui.label(RichText::new("chosen area by dose; lines: the window").small());
}
