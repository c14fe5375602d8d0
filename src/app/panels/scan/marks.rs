//! Numbers and labels over the view: of picked pairs, and of what is off the model.

use super::super::super::context::Context;
use super::super::super::scan_tool::ScanTool;
use super::labels::signed;
use crate::text::say;
use crate::view::{Camera, ViewportResponse};
use eframe::egui::{self, Align2, Color32, FontId, Stroke, vec2};
use nalgebra::Point3;

/// From the point to its text, points of the display.
const ASIDE: egui::Vec2 = vec2(16.0, -14.0);

pub(in super::super::super) fn ui(ui: &egui::Ui, view: &ViewportResponse, camera: &Camera, context: Context<'_>) {
    let painter = ui.painter_at(view.response.rect);
    for (at, text) in marks(context) {
        let Some(point) = view.on_screen(camera, &at) else { continue };
        let galley = painter.layout_no_wrap(text, FontId::proportional(13.0), Color32::WHITE);
        let rect = Align2::LEFT_BOTTOM.anchor_size(point + ASIDE, galley.size()).expand2(vec2(4.0, 2.0));
        painter.line_segment([point, rect.left_bottom()], Stroke::new(1.2, Color32::WHITE));
        painter.circle_filled(point, 2.5, Color32::WHITE);
        painter.rect_filled(rect, 3, Color32::from_black_alpha(200));
        painter.galley(rect.min + vec2(4.0, 2.0), galley, Color32::WHITE);
    }
}

/// Places in the scene, and what stands there.
fn marks(context: Context<'_>) -> Vec<(Point3<f64>, String)> {
    let place = context.scene_from_part();
    if let Some(ScanTool::Pairs(draft)) = context.scan_tool() {
        let Some(scan) = context.scene_from_scan() else { return Vec::new() };
        let next = (draft.pairs.len() + 1).to_string();
        let whole = draft.pairs.iter().enumerate().flat_map(|(i, p)| {
            [
                (scan * Point3::from(p.scan_mm), (i + 1).to_string()),
                (place * Point3::from(p.model_mm), (i + 1).to_string()),
            ]
        });
        let halves = draft.scan_mm.map(|p| (scan * Point3::from(p), next.clone()));
        let halves = halves.into_iter().chain(draft.model_mm.map(|p| (place * Point3::from(p), next)));
        return whole.chain(halves).collect();
    }
    let is_alone = context.scan_tool().is_some_and(ScanTool::moves_scan);
    let labels = context.session.labels.iter().filter(|_| !is_alone);
    labels.map(|label| (place * label.at, say!(scan_labels_mark, off = signed(label.off_mm)))).collect()
}
