//! The strategies side by side: how long each takes at each speed (P4 Table 1), as a table and as bars, and a click that
//! takes the quickest.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::theme;
use super::super::plots::diagram::still;
use super::strategy::{edit, name, title};
use crate::document::model::GrindingStrategy;
use crate::planning::welded::AreaTimes;
use crate::text::{exact, fixed, say};
use crate::weld::bead::AreaKind;
use eframe::egui::{self, CollapsingHeader, Color32, Grid, RichText, Role, WidgetInfo};
use egui_plot::{Bar, BarChart, Plot, PlotUi};

const HEIGHT: f32 = 130.0;
/// What is compared, in the order of the times, and the colours of their bars; apart to colour-blind eyes.
const COMPARED: [(GrindingStrategy, [u8; 3]); 3] = [
    (GrindingStrategy::OneWay, [214, 84, 20]),
    (GrindingStrategy::Zigzag, [134, 154, 0]),
    (GrindingStrategy::Spiral, [0, 118, 190]),
];
/// Width of a bar, as a share of the distance between two speeds.
const BAR: f64 = 0.26;

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some(report) = context.weld.report() else { return };
    CollapsingHeader::new(say!(weld_panel_times)).id_salt("strategies compared").show(ui, |ui| {
        if report.times.is_empty() {
            ui.label(RichText::new(say!(weld_panel_no_times)).weak());
        }
        for kind in [AreaKind::Bead, AreaKind::Flat] {
            let times: Vec<&AreaTimes> = report.times.iter().filter(|t| t.area == kind).collect();
            if !times.is_empty() {
                ui.label(RichText::new(title(kind)).strong());
                table(ui, kind, &times);
                bars(ui, kind, &times);
                quickest(ui, kind, &times, context, actions);
            }
        }
    });
}

/// Seconds of each strategy, and how often each leaves the surface.
fn table(ui: &mut egui::Ui, kind: AreaKind, times: &[&AreaTimes]) {
    Grid::new(("times of strategies", kind == AreaKind::Bead)).striped(true).spacing([12.0, 3.0]).show(ui, |ui| {
        ui.label(RichText::new(say!(weld_panel_speed)).strong());
        for (strategy, color) in COMPARED {
            ui.horizontal(|ui| {
                theme::swatch(ui, color);
                ui.label(RichText::new(name(strategy)).strong());
            });
        }
        ui.end_row();
        for t in times {
            ui.label(exact(t.speed_mm_s));
            let best = t.quickest();
            for (k, s) in [t.one_way_s, t.zigzag_s, t.spiral_s].into_iter().enumerate() {
                let text = RichText::new(say!(weld_panel_seconds, seconds = fixed(s, 1)));
                ui.label(if k == best { text.strong() } else { text });
            }
            ui.end_row();
        }
        if let Some(t) = times.first() {
            ui.label(say!(weld_panel_lifts)).on_hover_text(say!(weld_panel_lifts_tip));
            for lifts in t.lifts {
                ui.label(lifts.to_string());
            }
            ui.end_row();
        }
    });
}

fn bars(ui: &mut egui::Ui, kind: AreaKind, times: &[&AreaTimes]) {
    let speeds: Vec<f64> = times.iter().map(|t| t.speed_mm_s).collect();
    let plot = still(Plot::new(("bars of strategies", kind == AreaKind::Bead)).height(HEIGHT))
        .y_axis_min_width(34.0)
        .y_axis_formatter(|mark, _| say!(weld_panel_seconds, seconds = exact(mark.value)))
        .x_axis_formatter(move |mark, _| {
            // Under each group its speed, and nothing between.
            let at = mark.value.round();
            let speed = (at >= 0.0 && (mark.value - at).abs() < 1e-6).then(|| speeds.get(at as usize)).flatten();
            speed.map_or_else(String::new, |s| exact(*s))
        });
    let shown = plot.show(ui, |p: &mut PlotUi<'_>| {
        for (k, (strategy, [r, g, b])) in COMPARED.into_iter().enumerate() {
            let of = |t: &AreaTimes| [t.one_way_s, t.zigzag_s, t.spiral_s][k];
            let bar = |(i, t): (usize, &&AreaTimes)| {
                Bar::new(i as f64 + (k as f64 - 1.0) * BAR, of(t)).width(BAR).fill(Color32::from_rgb(r, g, b))
            };
            let bars: Vec<Bar> = times.iter().enumerate().map(bar).collect();
            p.bar_chart(BarChart::new(strategy.word(), bars).allow_hover(false));
        }
    });
    let told = || say!(weld_panel_times_chart, what = title(kind));
    shown.response.widget_info(|| WidgetInfo::labeled(Role::Image, true, told()));
}

/// Takes what is quickest at the speed nearest to the job's.
fn quickest(ui: &mut egui::Ui, kind: AreaKind, times: &[&AreaTimes], context: Context<'_>, actions: &mut Actions) {
    let job = context.document.job();
    let off = |t: &AreaTimes| (t.speed_mm_s - job.beam.speed_mm_s).abs();
    let Some(at_speed) = times.iter().min_by(|a, b| off(a).total_cmp(&off(b))) else { return };
    let Some((strategy, _)) = COMPARED.get(at_speed.quickest()) else { return };
    let is_taken = job.weld.strategy_of(kind == AreaKind::Bead) == *strategy;
    let text = say!(weld_panel_take_quickest, strategy = name(*strategy));
    let button = ui.add_enabled(!is_taken, egui::Button::new(text));
    let told = || say!(weld_panel_take_quickest_name, what = title(kind));
    button.widget_info(|| WidgetInfo::labeled(Role::Button, !is_taken, told()));
    if button.on_disabled_hover_text(say!(weld_panel_quickest_taken)).clicked() {
        actions.grind(edit(kind, *strategy));
    }
}
