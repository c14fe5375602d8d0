//! The section through part and scan as a drawing: the model's outline, and the scan's with what is off it drawn larger.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::scan_section::SectionAsked;
use crate::text::{exact, say};
use eframe::egui::{self, Color32, RichText, Role, Slider, WidgetInfo};
use egui_plot::{Line, Plot, PlotUi, Points};

const MOST_TIMES: f64 = 100.0;

pub(in super::super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some(part) = &context.derived.part else { return };
    let asked = context.session.section;
    let mut now = asked;
    let (min, max) = part.mesh.bounds();
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(say!(scan_section)).strong());
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let button = ui.selectable_label(asked.axis == axis, name);
            let told = || say!(scan_section_across, axis = name);
            button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, asked.axis == axis, told()));
            if button.clicked() {
                now = SectionAsked { axis, at_mm: None, ..asked };
            }
        }
        let mut at_mm = asked.at_mm(part);
        let range = min[asked.axis]..=max[asked.axis];
        let place = ui.add(Slider::new(&mut at_mm, range).suffix(say!(unit_mm)).max_decimals(2));
        place.widget_info(|| WidgetInfo::labeled(Role::Slider, true, say!(scan_section_place)));
        if place.on_hover_text(say!(scan_section_place_tip)).changed() {
            now.at_mm = Some(at_mm);
        }
        ui.label(say!(scan_section_times));
        let times = ui.add(Slider::new(&mut now.times, 1.0..=MOST_TIMES).logarithmic(true).prefix("×").max_decimals(0));
        times.widget_info(|| WidgetInfo::labeled(Role::Slider, true, say!(scan_section_times_name)));
        ui.label(RichText::new(say!(scan_section_ruler, mm = exact((0.1 * asked.times * 10.0).round() * 0.1))).weak());
    });
    if now != asked {
        actions.session(move |s| s.section = now);
    }
    drawing(ui, &asked, context);
}

fn drawing(ui: &mut egui::Ui, asked: &SectionAsked, context: Context<'_>) {
    let [right, up] = asked.across().map(|k| say!(scan_section_axis, axis = ["x", "y", "z"][k]));
    // Another axis is another drawing, with a zoom of its own.
    let plot = Plot::new(("section of the scan", asked.axis))
        .data_aspect(1.0)
        .show_crosshair(false)
        .label_formatter(|_| None)
        .x_axis_label(right)
        .y_axis_label(up);
    let line = ui.visuals().strong_text_color();
    let shown = plot.show(ui, |p: &mut PlotUi<'_>| {
        for points in context.section.outline() {
            p.line(Line::new("model", points.clone()).color(line).width(1.2).allow_hover(false));
        }
        for ([r, g, b], points) in context.section.points() {
            let color = Color32::from_rgb(*r, *g, *b);
            p.points(Points::new("scan", points.clone()).color(color).radius(1.8).allow_hover(false));
        }
    });
    shown.response.widget_info(|| WidgetInfo::labeled(Role::Image, true, say!(scan_section_name)));
}
