//! Where lengths and angles of the strip stand on the screen.

use crate::pose::access::AccessStrip;
use eframe::egui::{Pos2, Rect, pos2};

/// Length along, degrees up.
pub(super) struct StripScale {
    /// The strip on the screen, points.
    pub rect: Rect,
    /// Length of the line, mm.
    pub length_mm: f64,
    /// The angle at the upper end, degrees.
    pub most_deg: f64,
}

impl StripScale {
    /// The scale of a strip that is drawn in a rectangle.
    pub fn new(rect: Rect, strip: &AccessStrip) -> StripScale {
        let length_mm = strip.columns.last().map_or(1.0, |c| c.at_mm).max(1e-6);
        StripScale { rect, length_mm, most_deg: (strip.half as f64 + 0.5) * strip.step_deg }
    }

    /// Where a length stands.
    pub fn x(&self, at_mm: f64) -> f32 {
        self.rect.left() + (at_mm / self.length_mm) as f32 * self.rect.width()
    }

    /// Where a length, mm, and an angle, degrees, stand.
    pub fn at(&self, at_mm: f64, deg: f64) -> Pos2 {
        pos2(self.x(at_mm), self.rect.center().y - (deg / self.most_deg) as f32 * 0.5 * self.rect.height())
    }

    /// Length, mm, and angle, degrees, at a point of the screen.
    pub fn place(&self, p: Pos2) -> (f64, f64) {
        let share = f64::from((p.x - self.rect.left()) / self.rect.width()).clamp(0.0, 1.0);
        let deg = f64::from((self.rect.center().y - p.y) / (0.5 * self.rect.height())) * self.most_deg;
        (share * self.length_mm, deg.clamp(-self.most_deg, self.most_deg))
    }
}
