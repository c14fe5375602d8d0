//! The legend of a bead's points, in a corner of the view.

use super::super::super::context::Context;
use super::super::super::toggle::Toggle;
use super::scale;
use crate::picture::weld::height_color;
use crate::text::say;
use eframe::egui::{self, Area, Id, Rect, RichText, vec2};

const WIDTH: f32 = 200.0;

/// The legend over a view, while the points are shown.
pub(in super::super::super) fn ui(ui: &egui::Ui, view: Rect, context: Context<'_>) {
    let show = &context.session.show;
    let is_shown = show.is_on(Toggle::WeldPoints) && !show.is_on(Toggle::SectionPlane) && context.has_weld();
    let Some(highest_mm) = context.weld.highest_mm().filter(|_| is_shown) else { return };
    Area::new(Id::unique("bead heights")).fixed_pos(view.left_top() + vec2(10.0, 10.0)).show(ui.ctx(), |ui| {
        egui::Frame::popup(ui.style()).show(ui, |ui| {
            ui.set_width(WIDTH);
            ui.label(RichText::new(say!(weld_panel_legend)).strong());
            let color = |mm| height_color(mm, highest_mm);
            scale::bar(ui, WIDTH, [0.0, highest_mm], color, &say!(weld_panel_height_scale));
        });
    });
}
