//! One diagram: title, numbers at the cursor and curves, and what the pointer does on it.

use super::super::super::actions::Actions;
use super::scale::{InSight, Timed, range, thinned, zoomed};
use crate::text::{exact, fixed, say};
use eframe::egui::{self, Color32, RichText};
use egui_plot::{HLine, Line, LineStyle, Plot, PlotBounds, PlotResponse, PlotUi, VLine};

/// A plot that stays as it is, whatever the pointer does.
pub(in super::super) fn still(plot: Plot<'_>) -> Plot<'_> {
    plot.allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_axis_zoom_drag(false)
        .allow_double_click_reset(false)
        .show_crosshair(false)
        .label_formatter(|_| None)
}

/// One diagram over samples.
pub(super) struct Diagram<'a, T> {
    /// Tells it apart from the others.
    pub key: &'static str,
    /// Its accessible name.
    pub name: String,
    /// Title above it.
    pub title: String,
    /// Its curves.
    pub curves: Vec<Curve<'a, T>>,
    /// Text behind the numbers of the curves.
    pub words: Option<fn(&T) -> String>,
    /// Limits: value and colour.
    pub bounds: Vec<(f64, Color32)>,
    /// Decimals of the numbers of its curves.
    pub decimals: usize,
    /// Least range of the scale of values.
    pub least: f64,
}

/// A curve of a diagram.
pub(super) struct Curve<'a, T> {
    /// What stands before its number.
    pub name: String,
    /// Colour of line and number.
    pub color: Color32,
    /// Its value at a sample.
    pub value: Box<dyn Fn(&T) -> f64 + 'a>,
}

impl<T> Diagram<'_, T> {
    /// Its share of the width: room for the numbers of its curves, and for words.
    pub fn share(&self) -> f32 {
        3.0 + self.curves.len() as f32 + if self.words.is_some() { 2.0 } else { 0.0 }
    }
}

impl<T: Timed> Diagram<'_, T> {
    /// Draws it; a click or a drag goes to a time, the wheel zooms, a double click shows all.
    pub fn ui(&self, ui: &mut egui::Ui, samples: &[T], sight: InSight, actions: &mut Actions) {
        ui.add(egui::Label::new(RichText::new(&self.title).strong()).truncate());
        let now = samples.get(samples.partition_point(|s| s.time_s() < sight.now_s)).or(samples.last());
        ui.horizontal_wrapped(|ui| self.numbers(ui, now));
        let shown = self.plot(ui, samples, sight);
        let response = shown.response;
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, &self.name));
        let Some(x) = shown.inner else { return };
        if response.dragged() || response.clicked() {
            actions.go_to_time(x);
        }
        let wheel = ui.input(|i| i.smooth_scroll_delta().y);
        if response.double_clicked() {
            actions.session(|s| s.plot_span = None);
        } else if response.hovered() && wheel != 0.0 {
            let span_s = zoomed(sight.span_s, x, libm::exp(-0.0035 * f64::from(wheel)), sight.total_s);
            actions.session(move |s| s.plot_span = span_s);
        }
    }

    /// The values of the curves where the simulation is.
    fn numbers(&self, ui: &mut egui::Ui, now: Option<&T>) {
        ui.spacing_mut().item_spacing.x = 5.0;
        let small = |text: String| RichText::new(text).small().monospace();
        for c in &self.curves {
            let value = now.map_or(0.0, |s| (c.value)(s));
            let decimals = if value.abs() < 100.0 { self.decimals } else { 0 };
            let text = format!("{} {}", c.name, fixed(value, decimals));
            ui.add(egui::Label::new(small(text).color(c.color)).selectable(false));
        }
        if let (Some(now), Some(words)) = (now, self.words) {
            ui.add(egui::Label::new(small(words(now))).selectable(false).truncate());
        }
    }

    /// Curves, limits and cursor; the time under the pointer, s.
    fn plot(&self, ui: &mut egui::Ui, samples: &[T], sight: InSight) -> PlotResponse<Option<f64>> {
        let lines: Vec<Vec<[f64; 2]>> = self.curves.iter().map(|c| thinned(samples, sight.span_s, &c.value)).collect();
        let (span, range) = (sight.span_s, range(&lines, self.least));
        let cursor = ui.visuals().strong_text_color();
        let plot = still(Plot::new(self.key))
            .y_axis_min_width(34.0)
            .x_axis_formatter(|mark, _| say!(plots_seconds, value = exact(mark.value)));
        plot.show(ui, |p: &mut PlotUi<'_>| {
            p.set_plot_bounds(PlotBounds::from_min_max([span[0], range[0]], [span[1], range[1]]));
            for (value, color) in self.bounds.iter().filter(|(v, _)| (range[0]..=range[1]).contains(v)) {
                p.hline(HLine::new("limit", *value).color(*color).style(LineStyle::dashed_dense()).allow_hover(false));
            }
            for (c, points) in self.curves.iter().zip(lines) {
                // An angle that goes on from 180° at −180° is no stroke from top to bottom.
                for piece in points.chunk_by(|a, b| (a[1] - b[1]).abs() < 180.0) {
                    p.line(Line::new(c.name.as_str(), piece.to_vec()).color(c.color).width(1.6).allow_hover(false));
                }
            }
            p.vline(VLine::new("now", sight.now_s).color(cursor).width(1.5).allow_hover(false));
            p.pointer_coordinate().map(|at| at.x)
        })
    }
}
