//! What was measured, over the view: the picked places, the line between them, and its figures.

use super::super::context::Context;
use super::super::theme;
use crate::view::{Camera, ViewportResponse};
use eframe::egui::{self, Align2, Color32, FontId, Pos2, Stroke, vec2};

pub(in super::super) fn ui(ui: &egui::Ui, view: &ViewportResponse, camera: &Camera, context: Context<'_>) {
    let lines = context.measured();
    if lines.is_empty() {
        return;
    }
    let rect = view.response.rect;
    let painter = ui.painter_at(rect);
    let place = context.scene_from_part();
    let spots: Vec<Pos2> =
        context.session.measured.iter().filter_map(|(_, at)| view.on_screen(camera, &(place * at))).collect();
    if let [a, b] = spots[..] {
        painter.line_segment([a, b], Stroke::new(3.0, Color32::from_black_alpha(160)));
        painter.line_segment([a, b], Stroke::new(1.5, Color32::WHITE));
    }
    for spot in spots {
        painter.circle(spot, 4.0, theme::ACCENT, Stroke::new(1.5, Color32::WHITE));
    }
    let galley = painter.layout_no_wrap(lines.join("\n"), FontId::proportional(13.5), Color32::WHITE);
    let frame = Align2::LEFT_TOP.anchor_size(rect.left_top() + vec2(12.0, 12.0), galley.size());
    painter.rect_filled(frame.expand(6.0), 4, Color32::from_black_alpha(200));
    painter.galley(frame.min, galley, Color32::WHITE);
    let told = lines.join("; ");
    let response = ui.interact(frame, egui::Id::unique("measured"), egui::Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, told.clone()));
}
