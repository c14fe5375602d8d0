//! Draws the strip: what is blocked, the chosen tilt, the pins, and the current target.

use super::super::super::theme;
use super::palette::{color, dimmed};
use super::strip_scale::StripScale;
use crate::pose::Pin;
use crate::pose::access::{AccessColumn, AccessStrip};
use crate::text::{fixed, say};
use eframe::egui::{self, Color32, Pos2, Rect, Stroke, StrokeKind, pos2, vec2};

pub(super) fn draw_strip(ui: &egui::Ui, scale: &StripScale, strip: &AccessStrip, pins: &[Pin], at: usize) {
    let painter = ui.painter_at(scale.rect);
    painter.rect_filled(scale.rect, 0, ui.visuals().extreme_bg_color);
    cells(&painter, scale, strip);
    let line = ui.visuals().strong_text_color();
    let zero = [scale.at(0.0, 0.0), scale.at(scale.length_mm, 0.0)];
    painter.line_segment(zero, Stroke::new(0.7, line.gamma_multiply(0.5)));
    for piece in strip.columns.chunk_by(|a, b| a.chosen.is_some() && b.chosen.is_some()) {
        let chosen = |c: &AccessColumn| Some(scale.at(c.at_mm, strip.over.of(c.chosen?)));
        let points: Vec<Pos2> = piece.iter().filter_map(chosen).collect();
        painter.line(points, Stroke::new(2.5, Color32::BLACK));
    }
    if let Some(c) = strip.columns.iter().min_by_key(|c| c.point.abs_diff(at)) {
        let x = scale.x(c.at_mm);
        painter.line_segment([pos2(x, scale.rect.top()), pos2(x, scale.rect.bottom())], Stroke::new(1.0, line));
    }
    for p in pins {
        let at = scale.at(p.at_mm, strip.over.of(p.tilt));
        painter.circle(at, 6.0, theme::ACCENT, Stroke::new(1.5, Color32::WHITE));
    }
    painter.rect_stroke(scale.rect, 0, Stroke::new(1.0, line.gamma_multiply(0.3)), StrokeKind::Inside);
    let font = egui::FontId::proportional(12.0);
    let most = say!(access_most, angle = fixed(scale.most_deg, 0));
    painter.text(scale.rect.left_top() + vec2(3.0, 2.0), egui::Align2::LEFT_TOP, most, font.clone(), line);
    let end = say!(access_length, length = fixed(scale.length_mm, 1));
    painter.text(scale.rect.right_bottom() - vec2(3.0, 2.0), egui::Align2::RIGHT_BOTTOM, end, font, line);
}

/// What is free and what is blocked, column by column.
fn cells(painter: &egui::Painter, scale: &StripScale, strip: &AccessStrip) {
    let cell = scale.rect.height() / (2 * strip.half + 1) as f32;
    let edges = |i: usize| {
        let mid = |a: usize, b: usize| 0.5 * (strip.columns[a].at_mm + strip.columns[b].at_mm);
        let left = if i == 0 { 0.0 } else { mid(i - 1, i) };
        let right = if i + 1 == strip.columns.len() { scale.length_mm } else { mid(i, i + 1) };
        (scale.x(left), scale.x(right))
    };
    for (i, c) in strip.columns.iter().enumerate() {
        let (left, right) = edges(i);
        for (k, access) in c.cells.iter().enumerate() {
            let Some(access) = access else { continue };
            let y = scale.rect.bottom() - (k as f32 + 0.5) * cell;
            let middle = pos2(0.5 * (left + right), y);
            let size = vec2(right - left + 0.5, cell + 0.5);
            painter.rect_filled(Rect::from_center_size(middle, size), 0, dimmed(color(*access)));
        }
    }
}
