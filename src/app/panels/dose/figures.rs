//! The scale of the colours, the shares of the chosen area, and the histogram.

use super::super::super::dose::DoseView;
use super::super::super::theme;
use crate::picture::dose::{OVER, SHADED, UNDER};
use crate::picture::{Legend, Quantity, viridis};
use crate::process::Thresholds;
use crate::text::{fixed, language, legend_entry, percent, say};
use eframe::egui::{self, Color32, Rect, RichText, Sense, Stroke, pos2, vec2};

/// Classes of the histogram.
const BINS: usize = 40;

fn rgb([r, g, b]: [u8; 3]) -> Color32 {
    Color32::from_rgb(r, g, b)
}

/// A dose for people, with three significant digits.
pub(super) fn j_cm2(value: f64) -> String {
    match value >= 10_000.0 {
        true => say!(dose_panel_kj_cm2, dose = fixed(value * 1e-3, 1)),
        false => say!(dose_panel_j_cm2, dose = fixed(value, 0)),
    }
}

/// The colour bar from end to end; `way`: the share of the colour map at a share of the bar.
pub(in super::super) fn bar(ui: &mut egui::Ui, width: f32, told: impl Fn() -> String, way: impl Fn(f64) -> f64) {
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

/// The colour bar with its range, and what the other colours stand for.
pub(super) fn scale(ui: &mut egui::Ui, legend: &Legend) {
    let width = ui.available_width().min(260.0);
    // Incidence is lightest where the light stands upright.
    let is_angle = legend.quantity == Quantity::Incidence;
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
        for (entry, color) in &legend.entries {
            theme::swatch(ui, *color);
            ui.label(RichText::new(legend_entry(*entry, language())).small());
        }
    });
}

/// How much of the chosen area gets enough light, too little, too much, or none.
pub(super) fn shares(ui: &mut egui::Ui, view: &DoseView) {
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
pub(super) fn histogram(ui: &mut egui::Ui, view: &DoseView) {
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
