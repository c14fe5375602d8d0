//! The colours of a scale from end to end. Numbers under it are for whoever draws it.

use eframe::egui::{Color32, Painter, Rect, pos2};

/// Pieces of one colour are so wide, points.
const PIECE: usize = 2;

/// Fills a rectangle from left to right; `color`: that of a share of the scale, 0 to 1.
pub(super) fn fill(painter: &Painter, rect: Rect, color: impl Fn(f64) -> [u8; 3]) {
    let pieces = (rect.width().round() as usize / PIECE).max(1);
    for k in 0..pieces {
        let [from, to] = [k, k + 1].map(|k| rect.left() + rect.width() * k as f32 / pieces as f32);
        let [r, g, b] = color((k as f64 + 0.5) / pieces as f64);
        let piece = Rect::from_min_max(pos2(from, rect.top()), pos2(to, rect.bottom()));
        painter.rect_filled(piece, 0, Color32::from_rgb(r, g, b));
    }
}
