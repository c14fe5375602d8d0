//! The access map: from which directions a spot can be reached, and why not from the others; and the tilt
//! along a line with what is blocked, to be bent by hand.

use super::super::access::Place;
use super::super::{App, theme};
use crate::document::Edit;
use crate::part::SurfaceId;
use crate::pose::access::{Access, AccessMap, AccessStrip, TiltPart};
use crate::pose::{Blocker, Correction, Obstruction, Pin, Tilt, ToolBody};
use crate::text::{Sentence as _, fixed, id, percent, say};
use eframe::egui::{self, Color32, Pos2, Rect, RichText, Sense, Stroke, StrokeKind, pos2, vec2};

/// Free, told from the others by lightness as well.
const FREE: Color32 = Color32::from_rgb(126, 200, 196);
const BY_BEAM: Color32 = Color32::from_rgb(198, 90, 17);
const BY_HEAD: Color32 = Color32::from_rgb(122, 62, 132);
const BY_CLAMP: Color32 = Color32::from_rgb(70, 74, 82);
const FORBIDDEN: Color32 = Color32::from_rgb(150, 150, 150);
/// A pin is taken within this of the pointer.
const GRAB: f32 = 9.0;

fn color(a: Access) -> Color32 {
    match a {
        Access::Free => FREE,
        Access::Forbidden => FORBIDDEN,
        Access::Blocked(b) => match (b.obstruction, b.tool_body) {
            (Obstruction::Clamp(_), _) => BY_CLAMP,
            (_, ToolBody::Head) => BY_HEAD,
            (_, ToolBody::Beam) => BY_BEAM,
        },
    }
}

/// Darker, and still opaque: neighbours overlap.
fn dimmed(c: Color32) -> Color32 {
    let [r, g, b] = [c.r(), c.g(), c.b()].map(|x| (u16::from(x) * 3 / 4) as u8);
    Color32::from_rgb(r, g, b)
}

impl App {
    pub(in super::super) fn access_panel(&mut self, ui: &mut egui::Ui) {
        let height = ui.available_height();
        ui.horizontal_top(|ui| {
            ui.allocate_ui(vec2(height + 130.0, height), |ui| ui.vertical(|ui| self.map(ui)));
            ui.separator();
            ui.vertical(|ui| self.strip(ui));
        });
    }

    fn map(&mut self, ui: &mut egui::Ui) {
        let surfaces = self.derived.surfaces.clone();
        let Some((place, map)) = self.access_map() else {
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
            draw_map(ui, rect, map, &place);
            let pointed = response.hover_pos().map(|at| tilt_at(rect, map, at));
            let told = pointed.and_then(|t| Some((t, map.cell(t)?)));
            if let Some((tilt, cell)) = told {
                response.on_hover_text(said(tilt, cell, &|f| surfaces.of_facet.get(f as usize).copied()));
            }
            ui.vertical(|ui| legend(ui, map, &place));
        });
    }

    fn strip(&mut self, ui: &mut egui::Ui) {
        let over = self.session.strip_over;
        ui.horizontal(|ui| {
            ui.label(RichText::new(say!(access_strip)).strong());
            for (o, name) in [(TiltPart::Lead, say!(access_lead)), (TiltPart::Lean, say!(access_lean))] {
                if ui.selectable_label(over == o, name).clicked() {
                    self.session.strip_over = o;
                }
            }
            let job = self.document.job();
            let pins = self.pins();
            if job.path.correction != Correction::Clearance {
                ui.label(RichText::new(say!(access_needs_clearance)).small());
            } else if pins.is_empty() {
                ui.label(RichText::new(say!(access_drag)).small());
            } else if ui.button(say!(access_remove_pins)).clicked() {
                self.set_pins(Vec::new());
            }
        });
        let at = self.session.playback.at.1;
        let pins = self.pins();
        let Some(strip) = self.access_strip(over) else { return };
        let strip = strip.clone();
        let size = vec2(ui.available_width(), (ui.available_height() - 4.0).max(60.0));
        let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, say!(access_strip_image)));
        let frame = Frame::new(rect, &strip);
        draw_strip(ui, &frame, &strip, &pins, at);
        self.bend(&response, &frame, &strip, pins);
    }

    /// Drags make or move a pin, a click goes to the target.
    fn bend(&mut self, response: &egui::Response, frame: &Frame, strip: &AccessStrip, mut pins: Vec<Pin>) {
        let over = self.session.strip_over;
        let Some(pointer) = response.interact_pointer_pos() else {
            self.session.pin_dragged = None;
            return;
        };
        if response.clicked() {
            let nearest = strip.columns.iter().min_by(|x, y| {
                let off = |c: &crate::pose::access::AccessColumn| (frame.x(c.at_mm) - pointer.x).abs();
                off(x).total_cmp(&off(y))
            });
            if let Some(c) = nearest {
                self.go_to_target((self.session.playback.at.0, c.point));
            }
            return;
        }
        if self.document.job().path.correction != Correction::Clearance {
            return;
        }
        let Some((_, line)) = self.current_line() else { return };
        if response.drag_started() {
            let near = |p: &Pin| frame.at(p.at_mm, over.of(p.tilt)).distance(pointer) <= GRAB;
            self.session.pin_dragged = Some(pins.iter().position(near).unwrap_or_else(|| {
                let (at_mm, _) = frame.place(pointer);
                let tilt = strip.chosen_at(at_mm).unwrap_or_default();
                pins.push(Pin { line, at_mm, tilt });
                pins.len() - 1
            }));
        }
        if response.dragged()
            && let Some(pin) = self.session.pin_dragged.and_then(|i| pins.get_mut(i))
        {
            let (at_mm, deg) = frame.place(pointer);
            let tilt = over.with(pin.tilt, deg);
            (pin.at_mm, pin.tilt) = (at_mm, tilt);
            self.set_pins(pins);
        }
    }

    /// The pins of the current line.
    fn pins(&self) -> Vec<Pin> {
        let Some((surface, line)) = self.current_line() else { return Vec::new() };
        self.document.job().settings.of(SurfaceId(surface)).pins.iter().filter(|p| p.line == line).copied().collect()
    }

    fn set_pins(&mut self, pins: Vec<Pin>) {
        let Some((surface, line)) = self.current_line() else { return };
        let surface = SurfaceId(surface);
        let others = self.document.job().settings.of(surface).pins.iter().filter(|p| p.line != line);
        let all = others.copied().chain(pins).collect();
        self.edit_dragging(&Edit::Pins(surface, all), "pins");
    }
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
    let font = egui::FontId::proportional(11.0);
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
    let surface = match b.obstruction {
        Obstruction::Facet(facet) => surface_of(facet),
        Obstruction::Clamp(_) => None,
    };
    match surface {
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

/// Length along, degrees up.
struct Frame {
    rect: Rect,
    length_mm: f64,
    most_deg: f64,
}

impl Frame {
    fn new(rect: Rect, strip: &AccessStrip) -> Frame {
        let length_mm = strip.columns.last().map_or(1.0, |c| c.at_mm).max(1e-6);
        Frame { rect, length_mm, most_deg: (strip.half as f64 + 0.5) * strip.step_deg }
    }

    fn x(&self, at_mm: f64) -> f32 {
        self.rect.left() + (at_mm / self.length_mm) as f32 * self.rect.width()
    }

    fn at(&self, at_mm: f64, deg: f64) -> Pos2 {
        pos2(self.x(at_mm), self.rect.center().y - (deg / self.most_deg) as f32 * 0.5 * self.rect.height())
    }

    fn place(&self, p: Pos2) -> (f64, f64) {
        let share = f64::from((p.x - self.rect.left()) / self.rect.width()).clamp(0.0, 1.0);
        let deg = f64::from((self.rect.center().y - p.y) / (0.5 * self.rect.height())) * self.most_deg;
        (share * self.length_mm, deg.clamp(-self.most_deg, self.most_deg))
    }
}

fn draw_strip(ui: &egui::Ui, frame: &Frame, strip: &AccessStrip, pins: &[Pin], at: usize) {
    let painter = ui.painter_at(frame.rect);
    painter.rect_filled(frame.rect, 0, ui.visuals().extreme_bg_color);
    let cell = frame.rect.height() / (2 * strip.half + 1) as f32;
    let edges = |i: usize| {
        let mid = |a: usize, b: usize| 0.5 * (strip.columns[a].at_mm + strip.columns[b].at_mm);
        let left = if i == 0 { 0.0 } else { mid(i - 1, i) };
        let right = if i + 1 == strip.columns.len() { frame.length_mm } else { mid(i, i + 1) };
        (frame.x(left), frame.x(right))
    };
    for (i, c) in strip.columns.iter().enumerate() {
        let (left, right) = edges(i);
        for (k, access) in c.cells.iter().enumerate() {
            let Some(access) = access else { continue };
            let y = frame.rect.bottom() - (k as f32 + 0.5) * cell;
            let middle = pos2(0.5 * (left + right), y);
            let size = vec2(right - left + 0.5, cell + 0.5);
            painter.rect_filled(Rect::from_center_size(middle, size), 0, dimmed(color(*access)));
        }
    }
    let line = ui.visuals().strong_text_color();
    let zero = [frame.at(0.0, 0.0), frame.at(frame.length_mm, 0.0)];
    painter.line_segment(zero, Stroke::new(0.7, line.gamma_multiply(0.5)));
    for piece in strip.columns.chunk_by(|a, b| a.chosen.is_some() && b.chosen.is_some()) {
        let chosen = |c: &crate::pose::access::AccessColumn| Some(frame.at(c.at_mm, strip.over.of(c.chosen?)));
        let points: Vec<Pos2> = piece.iter().filter_map(chosen).collect();
        painter.line(points, Stroke::new(2.5, Color32::BLACK));
    }
    if let Some(c) = strip.columns.iter().min_by_key(|c| c.point.abs_diff(at)) {
        let x = frame.x(c.at_mm);
        painter.line_segment([pos2(x, frame.rect.top()), pos2(x, frame.rect.bottom())], Stroke::new(1.0, line));
    }
    for p in pins {
        let at = frame.at(p.at_mm, strip.over.of(p.tilt));
        painter.circle(at, 6.0, theme::ACCENT, Stroke::new(1.5, Color32::WHITE));
    }
    painter.rect_stroke(frame.rect, 0, Stroke::new(1.0, line.gamma_multiply(0.3)), StrokeKind::Inside);
    let font = egui::FontId::proportional(11.0);
    let most = say!(access_most, angle = fixed(frame.most_deg, 0));
    painter.text(frame.rect.left_top() + vec2(3.0, 2.0), egui::Align2::LEFT_TOP, most, font.clone(), line);
    let end = say!(access_length, length = fixed(frame.length_mm, 1));
    painter.text(frame.rect.right_bottom() - vec2(3.0, 2.0), egui::Align2::RIGHT_BOTTOM, end, font, line);
}
