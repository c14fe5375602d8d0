//! The map of one place: each direction in the colour of what stands in its way.

use super::super::super::access::Place;
use super::super::super::context::Context;
use super::super::super::theme;
use super::palette::{BY_BEAM, BY_CLAMP, BY_HEAD, FORBIDDEN, FREE, color};
use crate::pose::access::{Access, AccessMap};
use crate::pose::{Blocker, Tilt};
use crate::text::{Sentence as _, fixed, id, percent, say};
use eframe::egui::{self, Color32, Pos2, Rect, RichText, Sense, Stroke, vec2};

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>) {
    let Some((place, map)) = context.access.map() else {
        ui.label(say!(access_no_place));
        return;
    };
    let percent = percent(map.free_share(), 0);
    let title = if place.hovered { say!(access_under_cursor, percent) } else { say!(access_at_target, percent) };
    ui.label(RichText::new(title).strong());
    ui.horizontal_top(|ui| {
        let side = (ui.available_height() - 4.0).clamp(80.0, 400.0);
        let (rect, response) = ui.allocate_exact_size(vec2(side, side), Sense::hover());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, say!(access_map)));
        draw_map(ui, rect, map, place);
        let pointed = response.hover_pos().map(|at| tilt_at(rect, map, at));
        let told = pointed.and_then(|t| Some((t, map.cell(t)?)));
        if let Some((tilt, cell)) = told {
            let surfaces = &context.derived.surfaces;
            response.on_hover_text(said(tilt, cell, &|f| surfaces.of_facet.get(f as usize).copied()));
        }
        ui.vertical(|ui| legend(ui, map, place));
    });
}

/// Lead is up, lean is right, as seen against the normal along the travel.
fn tilt_at(rect: Rect, map: &AccessMap, at: Pos2) -> Tilt {
    let deg = rect.width() as f64 / map.side() as f64 / map.step_deg;
    let off = at - rect.center();
    Tilt { lead_deg: -f64::from(off.y) / deg, lean_deg: f64::from(off.x) / deg }
}

fn on_map(rect: Rect, map: &AccessMap, t: Tilt) -> Pos2 {
    let deg = rect.width() as f64 / map.side() as f64 / map.step_deg;
    rect.center() + vec2((t.lean_deg * deg) as f32, (-t.lead_deg * deg) as f32)
}

fn draw_map(ui: &egui::Ui, rect: Rect, map: &AccessMap, place: &Place) {
    let painter = ui.painter_at(rect);
    let cell = rect.width() / map.side() as f32;
    for (i, access) in map.cells.iter().enumerate() {
        let Some(access) = access else { continue };
        let middle = on_map(rect, map, map.tilt(i));
        painter.rect_filled(Rect::from_center_size(middle, vec2(cell + 0.5, cell + 0.5)), 0, color(*access));
    }
    let line = ui.visuals().strong_text_color();
    // Rings at 15°, 30°, …, and the normal in the middle.
    let unit = cell / map.step_deg as f32;
    let mut ring = 15.0f32;
    while f64::from(ring) <= map.half as f64 * map.step_deg + 1e-6 {
        painter.circle_stroke(rect.center(), ring * unit, Stroke::new(0.7, line.gamma_multiply(0.5)));
        ring += 15.0;
    }
    let (h, v) = (vec2(5.0, 0.0), vec2(0.0, 5.0));
    painter.line_segment([rect.center() - h, rect.center() + h], Stroke::new(1.5, line));
    painter.line_segment([rect.center() - v, rect.center() + v], Stroke::new(1.5, line));
    if let Some(chosen) = place.chosen {
        let at = on_map(rect, map, chosen);
        painter.circle(at, 5.0, Color32::WHITE, Stroke::new(2.0, Color32::BLACK));
    }
    let font = egui::FontId::proportional(12.0);
    painter.text(rect.center_top(), egui::Align2::CENTER_TOP, say!(access_lead), font, line);
}

fn said(tilt: Tilt, cell: Access, surface_of: &dyn Fn(u32) -> Option<u32>) -> String {
    let what = match cell {
        Access::Free => say!(access_free),
        Access::Forbidden => say!(access_not_allowed),
        Access::Blocked(b) => blocked(&b, surface_of),
    };
    say!(access_tilt, lead = fixed(tilt.lead_deg, 0), lean = fixed(tilt.lean_deg, 0), what)
}

fn blocked(b: &Blocker, surface_of: &dyn Fn(u32) -> Option<u32>) -> String {
    let blocker = b.sentence();
    match b.obstruction.facet().and_then(surface_of) {
        Some(surface) => say!(access_blocked_by_surface, blocker, surface = id(surface)),
        None => blocker,
    }
}

fn legend(ui: &mut egui::Ui, map: &AccessMap, place: &Place) {
    let has = |c: Color32| map.cells.iter().flatten().any(|a| color(*a) == c);
    let rows = [
        (FREE, say!(access_free)),
        (BY_BEAM, say!(access_by_beam)),
        (BY_HEAD, say!(access_by_head)),
        (BY_CLAMP, say!(access_by_clamp)),
        (FORBIDDEN, say!(access_forbidden)),
    ];
    for (c, name) in rows.into_iter().filter(|(c, _)| has(*c)) {
        ui.horizontal(|ui| {
            theme::swatch(ui, [c.r(), c.g(), c.b()]);
            ui.label(RichText::new(name).small());
        });
    }
    ui.label(RichText::new(say!(access_normal)).small());
    let chosen = match place.chosen {
        Some(t) => say!(access_chosen, angle = fixed(t.angle_deg(), 1)),
        None if place.hovered => say!(access_no_target),
        None => say!(access_none_chosen),
    };
    ui.label(RichText::new(chosen).small());
    ui.label(RichText::new(say!(access_surface, surface = id(place.surface))).small());
}
