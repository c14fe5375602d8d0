//! A scale of colours from end to end, with the numbers at its marks under it.

use crate::text::fixed;
use eframe::egui::{self, Align2, Color32, FontId, Rect, Role, Sense, WidgetInfo, pos2, vec2};

const BAR: f32 = 14.0;
const HEIGHT: f32 = 32.0;
const NUMBERS: f32 = 12.0;
/// Equal steps between marks.
const STEPS: usize = 4;

/// The bar; `color` of a number within the range, `told`: its accessible name.
pub(super) fn bar(ui: &mut egui::Ui, width: f32, [low, high]: [f64; 2], color: impl Fn(f64) -> [u8; 3], told: &str) {
    let (rect, response) = ui.allocate_exact_size(vec2(width, HEIGHT), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, told));
    let painter = ui.painter();
    let pieces = (width as usize / 2).max(1);
    for k in 0..pieces {
        let [from, to] = [k, k + 1].map(|k| rect.left() + rect.width() * k as f32 / pieces as f32);
        let [r, g, b] = color(low + (high - low) * (k as f64 + 0.5) / pieces as f64);
        let piece = Rect::from_min_max(pos2(from, rect.top()), pos2(to, rect.top() + BAR));
        painter.rect_filled(piece, 0, Color32::from_rgb(r, g, b));
    }
    // As many digits as tell the marks apart.
    let decimals = usize::from(high - low < 20.0) + usize::from(high - low < 2.0);
    for k in 0..=STEPS {
        let share = k as f64 / STEPS as f64;
        let x = rect.left() + rect.width() * share as f32;
        let align = match k {
            0 => Align2::LEFT_TOP,
            STEPS => Align2::RIGHT_TOP,
            _ => Align2::CENTER_TOP,
        };
        let text = fixed(low + (high - low) * share, decimals);
        painter.text(
            pos2(x, rect.top() + BAR + 2.0),
            align,
            text,
            FontId::proportional(NUMBERS),
            ui.visuals().text_color(),
        );
    }
}
