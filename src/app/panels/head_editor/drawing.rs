//! A head from the side, to scale: its pieces, the cone of light, the focus and the surface below it.

use crate::beam::{HeadPart, Optics};
use crate::picture::LIGHT;
use crate::text::{fixed, say};
use eframe::egui::{self, Color32, FontId, Pos2, Rect, Stroke, pos2, vec2};

/// Size of the drawing, points.
const SIZE: egui::Vec2 = vec2(210.0, 330.0);
/// Room for numbers beside it, points.
const NUMBERS: f32 = 46.0;
/// Numbers stand no closer than this, points.
const APART: f32 = 13.0;

/// Draws it; heights from the focus, the surface `defocus_mm` below.
pub(super) fn ui(ui: &mut egui::Ui, parts: &[HeadPart], optics: &Optics, defocus_mm: f64) {
    let (rect, response) = ui.allocate_exact_size(SIZE, egui::Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, say!(head_drawing)));
    let shown: Vec<&HeadPart> = parts.iter().filter(|p| p.to_mm > p.from_mm).collect();
    let mut heights: Vec<f64> = shown.iter().flat_map(|p| [p.from_mm, p.to_mm]).chain([0.0, -defocus_mm]).collect();
    heights.sort_by(f64::total_cmp);
    let (low, high) = (heights[0], heights[heights.len() - 1]);
    let half_mm = shown.iter().map(|p| p.r0_mm.max(p.r1_mm)).fold(0.5 * optics.aperture_mm, f64::max);
    let sheet = Sheet::of(rect, (low, high.max(low + 1.0)), half_mm);
    let visuals = ui.visuals();
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 3.0, visuals.extreme_bg_color);
    let y = sheet.at(0.0, -defocus_mm).y;
    let surface = [pos2(rect.left(), y), pos2(rect.right() - NUMBERS, y)];
    painter.line_segment(surface, Stroke::new(2.0, visuals.weak_text_color()));
    // The light, from the lens to the focus and on to the surface.
    let [r, g, b] = LIGHT;
    let light = Color32::from_rgb(r, g, b);
    let top_mm = high.min(optics.lens_to_focus_mm);
    let wide = |t: f64| 0.5 * optics.aperture_mm * t.abs() / optics.lens_to_focus_mm;
    for side in [-1.0, 1.0] {
        let ends = [(side * wide(top_mm), top_mm), (-side * wide(defocus_mm), -defocus_mm)];
        painter.line_segment(ends.map(|(x, t)| sheet.at(x, t)), Stroke::new(1.0, light));
    }
    for p in &shown {
        let corners = [(-p.r0_mm, p.from_mm), (p.r0_mm, p.from_mm), (p.r1_mm, p.to_mm), (-p.r1_mm, p.to_mm)];
        let corners = corners.map(|(x, t)| sheet.at(x, t)).to_vec();
        let fill = visuals.widgets.inactive.bg_fill.gamma_multiply(0.8);
        painter.add(egui::Shape::convex_polygon(corners, fill, Stroke::new(1.0, visuals.text_color())));
    }
    painter.circle_filled(sheet.at(0.0, 0.0), 2.5, light);
    let mut last = f32::INFINITY;
    for t in heights {
        let y = sheet.at(0.0, t).y;
        if last - y >= APART {
            let at = pos2(rect.right() - 4.0, y);
            let (align, font) = (egui::Align2::RIGHT_CENTER, FontId::proportional(12.0));
            painter.text(at, align, fixed(t, 0), font, visuals.text_color());
            last = y;
        }
    }
}

/// Where millimetres lie in the drawing: the axis upright, the same scale both ways.
struct Sheet {
    axis: Pos2,
    points_per_mm: f32,
}

impl Sheet {
    fn of(rect: Rect, (low, high): (f64, f64), half_mm: f64) -> Sheet {
        let room = Rect::from_min_max(rect.min, pos2(rect.max.x - NUMBERS, rect.max.y)).shrink(10.0);
        let scale = (room.height() / (high - low) as f32).min(0.5 * room.width() / half_mm.max(0.5) as f32);
        let unused = room.height() - scale * (high - low) as f32;
        Sheet { axis: pos2(room.center().x, room.bottom() - 0.5 * unused + scale * low as f32), points_per_mm: scale }
    }

    fn at(&self, x_mm: f64, t_mm: f64) -> Pos2 {
        self.axis + vec2(x_mm as f32, -t_mm as f32) * self.points_per_mm
    }
}
