//! The legend of the scan's points, in a corner of the view: the scale of their distances from the model, and what the
//! other colours stand for.

use super::super::super::context::Context;
use super::super::super::scan_tool::ScanTool;
use super::super::super::theme;
use super::super::super::toggle::Toggle;
use super::super::color_strip;
use crate::picture::Legend;
use crate::picture::palette::scan::LEFT_OUT;
use crate::text::{language, legend_entry, legend_mark, say};
use eframe::egui::{self, Align2, Area, FontId, Id, Rect, RichText, Role, Sense, WidgetInfo, pos2, vec2};

const WIDTH: f32 = 200.0;
/// A number on the scale needs so much; those that would run into each other are left out on both sides.
const NUMBER_WIDTH: f32 = 36.0;
/// Below the legend of the spacing, where that is shown too.
const BELOW_SPACING: f32 = 130.0;

/// The legend over a view, while the points are shown.
pub(in super::super::super) fn ui(ui: &egui::Ui, view: Rect, context: Context<'_>) {
    let show = &context.session.show;
    let is_on = show.is_on(Toggle::Scan) || context.shows_deviation_on_model();
    let is_alone = context.session.scan_tool.as_ref().is_some_and(ScanTool::moves_scan);
    let is_shown = is_on && !is_alone && !show.is_on(Toggle::SectionPlane);
    let Some(scale) = context.scan.scale().filter(|_| is_shown && context.scan_is_laid()) else { return };
    let down = if show.is_on(Toggle::Spacing) { BELOW_SPACING } else { 0.0 };
    let at = view.left_top() + vec2(10.0, 10.0 + down);
    Area::new(Id::unique("deviation")).fixed_pos(at).show(ui.ctx(), |ui| {
        egui::Frame::popup(ui.style()).show(ui, |ui| {
            ui.set_width(WIDTH);
            ui.label(RichText::new(say!(scan_panel_legend)).strong());
            let legend = scale.legend();
            bar(ui, &legend);
            for (entry, color) in &legend.entries {
                ui.horizontal(|ui| {
                    theme::swatch(ui, *color);
                    ui.label(legend_entry(*entry, language()));
                });
            }
            if !context.tool.left_out().is_empty() {
                ui.horizontal(|ui| {
                    theme::swatch(ui, LEFT_OUT);
                    ui.label(say!(scan_leave_out_legend));
                });
            }
        });
    });
}

/// The colours from end to end, and the numbers under them.
fn bar(ui: &mut egui::Ui, legend: &Legend) {
    let (rect, response) = ui.allocate_exact_size(vec2(WIDTH, 32.0), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, say!(scan_panel_scale)));
    let [low, high] = legend.range;
    let painter = ui.painter();
    color_strip::fill(painter, rect.with_max_y(rect.top() + 14.0), |share| legend.color(share));
    let from_middle = |mark: f64| rect.width() * (mark.abs() / (high - low)) as f32;
    let apart = if legend.marks.contains(&0.0) { NUMBER_WIDTH } else { 0.5 * NUMBER_WIDTH };
    for &mark in legend.marks.iter().filter(|mark| **mark == 0.0 || from_middle(**mark) >= apart) {
        let x = rect.left() + rect.width() * ((mark - low) / (high - low)) as f32;
        let (font, color) = (FontId::proportional(12.0), ui.visuals().text_color());
        painter.text(pos2(x, rect.top() + 16.0), Align2::CENTER_TOP, legend_mark(legend, mark), font, color);
    }
}
