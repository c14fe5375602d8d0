//! Figures of a scan as plots: how the position was found, what is left over beside the scanner's noise, and how far all
//! points are off the model.

use super::super::super::context::Context;
use super::super::super::theme;
use super::super::plots::diagram::still;
use crate::picture::DeviationScale;
use crate::planning::scanned::{ComparedScan, Scanned};
use crate::text::{exact, fixed, say};
use eframe::egui::{self, CollapsingHeader, Color32, Role, WidgetInfo};
use egui_plot::{Bar, BarChart, Line, LineStyle, Plot, PlotUi, VLine};

const HEIGHT: f32 = 120.0;
const BINS: usize = 61;
/// What is left over is shown up to so many standard deviations: beyond them is wear.
const SIGMAS: f64 = 6.0;
/// Beyond the scale to each side, as a share of it.
const BEYOND: f64 = 0.1;

pub(super) fn ui(ui: &mut egui::Ui, scanned: &Scanned, context: Context<'_>) {
    CollapsingHeader::new(say!(scan_figures)).id_salt("figures of the scan").show(ui, |ui| {
        if let Some(found) = scanned.laid.as_ref().and_then(|l| l.registration.as_ref()) {
            convergence(ui, &found.convergence_mm);
        }
        let (Some(compared), Some(scale)) = (&scanned.compared, context.scan.scale()) else { return };
        let found = scanned.laid.as_ref().and_then(|l| l.registration.as_ref());
        if let Some(found) = found {
            left_over(ui, compared, found.noise_mm);
        }
        let scan = &context.document.job().scan;
        deviation(ui, compared, &scale, scan.min_depth_mm, scan.tolerance_mm);
    });
}

/// The rms of the fit over its steps.
fn convergence(ui: &mut egui::Ui, rms_mm: &[f64]) {
    ui.label(say!(
        scan_figures_convergence,
        steps = rms_mm.len(),
        last = fixed(rms_mm.last().copied().unwrap_or(0.0), 4)
    ));
    let points: Vec<[f64; 2]> = rms_mm.iter().enumerate().map(|(i, mm)| [(i + 1) as f64, log(*mm)]).collect();
    let plot = bare("convergence").y_axis_formatter(|mark, _| exact(decade(mark.value)));
    let shown = plot.show(ui, |p: &mut PlotUi<'_>| p.line(Line::new("rms", points).color(theme::ACCENT).width(1.8)));
    shown.response.widget_info(|| WidgetInfo::labeled(Role::Image, true, say!(scan_figures_convergence_name)));
}

/// What is left over at the points, with the scanner's noise.
fn left_over(ui: &mut egui::Ui, compared: &ComparedScan, noise_mm: f64) {
    ui.label(say!(scan_figures_left_over, noise = fixed(noise_mm, 3)));
    let end_mm = (SIGMAS * compared.statistics.sigma_mm).max(1e-6);
    let lines = [(noise_mm, theme::ATTENTION), (-noise_mm, theme::ATTENTION)];
    histogram(ui, "left over", compared, end_mm, &lines, |count| count, say!(scan_figures_left_over_name));
}

/// How far all points are off, with what counts as a patch and what is tolerated. Counts are drawn as logarithms, since
/// what is worn is few among many.
fn deviation(ui: &mut egui::Ui, compared: &ComparedScan, scale: &DeviationScale, least_mm: f64, tolerance_mm: f64) {
    ui.label(say!(scan_figures_deviation, least = exact(least_mm), tolerance = exact(tolerance_mm)));
    let end_mm = scale.limit_mm().max(tolerance_mm) * (1.0 + BEYOND);
    let lines = [-1.0, 1.0]
        .into_iter()
        .flat_map(|sign| [(sign * least_mm, theme::ATTENTION), (sign * tolerance_mm, theme::ACCENT)]);
    let lines: Vec<(f64, Color32)> = lines.collect();
    histogram(
        ui,
        "deviation",
        compared,
        end_mm,
        &lines,
        |count| libm::log10(1.0 + count),
        say!(scan_figures_deviation_name),
    );
}

fn histogram(
    ui: &mut egui::Ui,
    key: &str,
    compared: &ComparedScan,
    end_mm: f64,
    lines: &[(f64, Color32)],
    height: fn(f64) -> f64,
    told: String,
) {
    let counts = compared.statistics.histogram(-end_mm, end_mm, BINS).counts;
    let width = 2.0 * end_mm / BINS as f64;
    let bar = |(i, count): (usize, usize)| {
        Bar::new(-end_mm + (i as f64 + 0.5) * width, height(count as f64)).width(width).fill(Color32::GRAY)
    };
    let bars: Vec<Bar> = counts.into_iter().enumerate().map(bar).collect();
    let plot = bare(key).show_axes([true, false]).x_axis_formatter(|mark, _| exact(mark.value));
    let shown = plot.show(ui, |p: &mut PlotUi<'_>| {
        p.bar_chart(BarChart::new(key, bars).allow_hover(false));
        for (at_mm, color) in lines {
            p.vline(VLine::new("limit", *at_mm).color(*color).style(LineStyle::dashed_dense()).allow_hover(false));
        }
    });
    shown.response.widget_info(|| WidgetInfo::labeled(Role::Image, true, told.clone()));
}

/// A plot that is looked at, and stays as it is.
fn bare<'a>(key: &str) -> Plot<'a> {
    still(Plot::new(("figure of the scan", key)).height(HEIGHT))
}

fn log(mm: f64) -> f64 {
    libm::log10(mm.max(1e-9))
}

/// What a mark of a logarithmic axis stands for, to two digits.
fn decade(log: f64) -> f64 {
    let value = libm::pow(10.0, log);
    let unit = libm::pow(10.0, libm::floor(log) - 1.0);
    (value / unit).round() * unit
}
