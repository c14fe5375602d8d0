//! The bead in figures: height and width along its centre line, and how many of its points stand how high (P4 Fig. 16).

use super::super::super::context::Context;
use super::super::super::theme;
use super::super::plots::diagram::still;
use crate::text::{exact, fixed, say};
use crate::weld::bead::WeldBead;
use eframe::egui::{self, CollapsingHeader, Color32, Grid, Role, WidgetInfo};
use egui_plot::{Bar, BarChart, Line, Plot, PlotUi};

const HEIGHT: f32 = 120.0;

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>) {
    let Some(bead) = context.weld.measured().and_then(|m| m.bead()) else { return };
    theme::heading(ui, &say!(weld_panel_bead));
    figures(ui, bead);
    CollapsingHeader::new(say!(weld_panel_bead_plots)).id_salt("plots of the bead").show(ui, |ui| {
        let along = |of: fn(&crate::weld::bead::WeldSection) -> f64| -> Vec<[f64; 2]> {
            bead.sections.iter().map(|s| [s.along_mm, of(s)]).collect()
        };
        ui.label(say!(weld_panel_height_along));
        curve(ui, "height", along(|s| s.height_mm), say!(weld_panel_height_plot));
        ui.label(say!(weld_panel_width_along));
        curve(ui, "width", along(|s| s.width_mm), say!(weld_panel_width_plot));
        ui.label(say!(weld_panel_heights));
        heights(ui, bead);
    });
}

fn figures(ui: &mut egui::Ui, bead: &WeldBead) {
    let rows = [
        (say!(weld_panel_greatest_height), bead.max_height_mm, 2),
        (say!(weld_panel_mean_width), bead.width_mm, 1),
        (say!(weld_panel_length), bead.length_mm, 1),
        (say!(weld_panel_noise), bead.parent.noise_mm, 3),
        (say!(weld_panel_parent_rms), bead.parent.rms_mm, 3),
    ];
    Grid::new("figures of the bead").num_columns(2).spacing([18.0, 3.0]).show(ui, |ui| {
        for (title, mm, decimals) in rows {
            ui.label(title);
            ui.label(say!(weld_panel_mm, number = fixed(mm, decimals)));
            ui.end_row();
        }
    });
}

/// Something along the centre line, mm.
fn curve(ui: &mut egui::Ui, key: &str, points: Vec<[f64; 2]>, told: String) {
    let plot = bare(key).include_y(0.0);
    let shown = plot.show(ui, |p: &mut PlotUi<'_>| {
        p.line(Line::new("along", points).color(theme::ACCENT).width(1.8).allow_hover(false));
    });
    shown.response.widget_info(|| WidgetInfo::labeled(Role::Image, true, told.clone()));
}

/// How many points stand how high.
fn heights(ui: &mut egui::Ui, bead: &WeldBead) {
    let h = &bead.heights;
    let bar = |(i, count): (usize, &usize)| {
        Bar::new(h.from_mm + (i as f64 + 0.5) * h.bin_mm, *count as f64).width(h.bin_mm).fill(Color32::GRAY)
    };
    let bars: Vec<Bar> = h.counts.iter().enumerate().map(bar).collect();
    let shown =
        bare("heights").show(ui, |p: &mut PlotUi<'_>| p.bar_chart(BarChart::new("points", bars).allow_hover(false)));
    shown.response.widget_info(|| WidgetInfo::labeled(Role::Image, true, say!(weld_panel_heights_plot)));
}

/// A plot that is looked at, and stays as it is.
fn bare<'a>(key: &str) -> Plot<'a> {
    let plot = still(Plot::new(("figure of the bead", key)).height(HEIGHT)).y_axis_min_width(34.0);
    plot.x_axis_formatter(|mark, _| exact(mark.value)).y_axis_formatter(|mark, _| exact(mark.value))
}
