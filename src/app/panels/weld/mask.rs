//! How areas are found in the grey image: the histogram with its main mode, the threshold from it or by hand, and the
//! numbers of the steps.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::theme;
use super::super::entry::{Entry, refused};
use super::super::numbers;
use super::super::plots::diagram::still;
use crate::document::parameter::Group;
use crate::document::{Edit, WeldEdit};
use crate::text::{fixed, say};
use crate::weld::masking::GreyHistogram;
use eframe::egui::{self, CollapsingHeader, Color32, Role, WidgetInfo};
use egui_plot::{Line, LineStyle, Plot, PlotBounds, PlotPoint, PlotUi, VLine};

const HEIGHT: f32 = 130.0;
/// Levels of a grey image.
const WHITE: f64 = 255.0;
/// How near to its line the threshold is taken hold of, points.
const REACH: f32 = 10.0;
/// All drags of the threshold are one step.
const GESTURE: &str = "threshold of the weld";

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    theme::heading(ui, &say!(weld_panel_mask));
    if let Some(masked) = context.weld.masked() {
        // While it is dragged the line is ahead of the mask.
        let level = context.document.job().weld.threshold.unwrap_or(masked.threshold);
        histogram(ui, &masked.histogram, level, actions);
    }
    threshold(ui, context, actions);
    CollapsingHeader::new(say!(weld_panel_mask_numbers)).id_salt("numbers of the mask").show(ui, |ui| {
        numbers::of_job(ui, Group::WeldMask, context, actions);
    });
}

/// The levels, most of which are the skin's: their counts as logarithms, since what is bright is little among much.
fn histogram(ui: &mut egui::Ui, h: &GreyHistogram, level: f64, actions: &mut Actions) {
    let points: Vec<[f64; 2]> =
        h.counts.iter().enumerate().map(|(level, n)| [level as f64, libm::log10(1.0 + f64::from(*n))]).collect();
    let top = points.iter().map(|p| p[1]).fold(1.0, f64::max) * 1.05;
    let plot =
        still(Plot::new("histogram of the weld").height(HEIGHT)).show_axes([true, false]).show_grid([true, false]);
    let weak = ui.visuals().weak_text_color();
    let text = ui.visuals().text_color();
    let (mode, sigma) = (h.mode, h.sigma);
    let shown = plot.show(ui, |p: &mut PlotUi<'_>| {
        p.set_plot_bounds(PlotBounds::from_min_max([0.0, 0.0], [WHITE, top]));
        p.line(Line::new("levels", points).color(text).width(1.2).fill(0.0).allow_hover(false));
        let dashed = |at: f64, color: Color32| {
            VLine::new("mode", at).color(color).style(LineStyle::dashed_dense()).allow_hover(false)
        };
        p.vline(dashed(mode, theme::ACCENT));
        p.vline(dashed(mode - sigma, weak));
        p.vline(dashed(mode + sigma, weak));
        p.vline(VLine::new("threshold", level).color(theme::ATTENTION).width(3.0).allow_hover(false));
    });
    let line_x = shown.transform.position_from_point(&PlotPoint::new(level, 0.0)).x;
    let response = shown.response;
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, say!(weld_panel_histogram)));
    let key = response.id.with("held");
    let pointer_x = |ui: &egui::Ui| ui.input(|i| i.pointer.press_origin()).map(|p| p.x);
    if response.drag_started() {
        let is_held = pointer_x(ui).is_some_and(|x| (x - line_x).abs() <= REACH);
        ui.data_mut(|d| d.insert_temp(key, is_held));
    }
    let is_held = ui.data(|d| d.get_temp::<bool>(key)).unwrap_or_default();
    if response.dragged() && is_held {
        // Not `PlotUi::pointer_coordinate`, which lags a frame behind a drag.
        if let Some(at) = response.interact_pointer_pos() {
            let level = shown.transform.value_from_position(at).x.clamp(0.0, WHITE);
            actions.drag(by_hand(level), GESTURE);
        }
    }
    let is_near = response.hover_pos().is_some_and(|p| (p.x - line_x).abs() <= REACH);
    if is_near || response.dragged() && is_held {
        ui.ctx().set_cursor_icon(egui::CursorIcon::ResizeHorizontal);
    }
    let [mode, sigma] = [mode, sigma].map(|x| fixed(x, 1));
    response.on_hover_text(say!(weld_panel_histogram_tip));
    ui.label(say!(weld_panel_mode, mode, sigma));
}

fn by_hand(level: f64) -> Edit {
    Edit::Grind(Box::new(WeldEdit::Threshold(Some((level * 10.0).round() * 0.1))))
}

/// The threshold as a number, and whether it follows from the histogram.
fn threshold(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let given = context.document.job().weld.threshold;
    let found = context.weld.masked().map(|m| m.threshold);
    let row = ui.horizontal_wrapped(|ui| {
        ui.label(say!(weld_panel_threshold));
        let mut level = given.or(found).unwrap_or(0.5 * WHITE);
        let entry = Entry { speed: 0.2, decimals: 1, ..Entry::new(0.0..=WHITE, String::new()) };
        let drawn = entry.show(ui, &mut level);
        drawn.response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, say!(weld_panel_threshold_level)));
        if drawn.response.changed() {
            actions.drag(by_hand(level), GESTURE);
        }
        let follows = egui::Button::selectable(given.is_none(), say!(weld_panel_threshold_found));
        if ui.add(follows).on_hover_text(say!(weld_panel_threshold_found_tip)).clicked() && given.is_some() {
            actions.grind(WeldEdit::Threshold(None));
        }
        let by_hand_button = egui::Button::selectable(given.is_some(), say!(weld_panel_threshold_given));
        if ui.add(by_hand_button).clicked() && given.is_none() {
            actions.edit(by_hand(level));
        }
        drawn
    });
    refused(ui, [&row.inner]);
}
