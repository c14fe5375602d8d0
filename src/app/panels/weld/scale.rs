//! A scale of colours from end to end, with the numbers at its marks under it.

use super::super::color_strip;
use crate::text::fixed;
use eframe::egui::{self, Align2, FontId, Role, Sense, WidgetInfo, pos2, vec2};

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
    color_strip::fill(painter, rect.with_max_y(rect.top() + BAR), |share| color(low + (high - low) * share));
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
