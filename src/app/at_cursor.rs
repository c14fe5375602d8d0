//! A label beside the cursor, over all panels: what is under it, or what it drags.

use eframe::egui::{self, Color32};

/// A text beside the cursor.
pub(super) fn text(ctx: &egui::Context, pointer: egui::Pos2, text: String) {
    let at = pointer + egui::vec2(16.0, 10.0);
    let painter = ctx.layer_painter(egui::LayerId::new(egui::Order::Tooltip, egui::Id::unique("cursor")));
    let galley = painter.layout_no_wrap(text, egui::FontId::proportional(13.0), Color32::WHITE);
    let rect = egui::Rect::from_min_size(at, galley.size()).expand2(egui::vec2(5.0, 3.0));
    painter.rect_filled(rect, 4, Color32::from_black_alpha(190));
    painter.galley(at, galley, Color32::WHITE);
}
