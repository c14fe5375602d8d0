//! The tilt along the current line, with what is blocked; pins that are dragged bend it.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::draw_strip::draw_strip;
use super::strip_scale::StripScale;
use crate::document::Edit;
use crate::part::SurfaceId;
use crate::pose::access::{AccessColumn, AccessStrip, TiltPart};
use crate::pose::{Correction, Pin};
use crate::text::say;
use eframe::egui::{self, Pos2, RichText, Sense, vec2};

/// A pin is grabbed within this distance of the pointer.
const GRAB: f32 = 9.0;

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let pins = pins(context);
    ui.horizontal(|ui| head(ui, pins.is_empty(), context, actions));
    let Some(strip) = context.access.strip() else { return };
    let size = vec2(ui.available_width(), (ui.available_height() - 4.0).max(60.0));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, say!(access_strip_image)));
    let scale = StripScale::new(rect, strip);
    draw_strip(ui, &scale, strip, &pins, context.session.playback.at.1);
    let Some(pointer) = response.interact_pointer_pos() else {
        if context.session.pin_dragged.is_some() {
            actions.session(|s| s.pin_dragged = None);
        }
        return;
    };
    if response.clicked() {
        if let Some(point) = nearest(strip, &scale, pointer) {
            actions.go_to_target((context.session.playback.at.0, point));
        }
    } else if context.document.job().path.correction == Correction::Clearance {
        bend(&response, &scale, pointer, pins, context, actions);
    }
}

/// Chooses which part of the tilt is shown, and tells how to bend it.
fn head(ui: &mut egui::Ui, no_pins: bool, context: Context<'_>, actions: &mut Actions) {
    ui.label(RichText::new(say!(access_strip)).strong());
    for (over, name) in [(TiltPart::Lead, say!(access_lead)), (TiltPart::Lean, say!(access_lean))] {
        if ui.selectable_label(context.session.strip_over == over, name).clicked() {
            actions.session(move |s| s.strip_over = over);
        }
    }
    if context.document.job().path.correction != Correction::Clearance {
        ui.label(RichText::new(say!(access_needs_clearance)).small());
    } else if no_pins {
        ui.label(RichText::new(say!(access_drag)).small());
    } else if ui.button(say!(access_remove_pins)).clicked() {
        set_pins(Vec::new(), context, actions);
    }
}

/// The target of the column under the pointer.
fn nearest(strip: &AccessStrip, scale: &StripScale, pointer: Pos2) -> Option<usize> {
    let off = |c: &&AccessColumn| (scale.x(c.at_mm) - pointer.x).abs();
    strip.columns.iter().min_by(|x, y| off(x).total_cmp(&off(y))).map(|c| c.point)
}

/// Makes or moves the pin under the pointer.
fn bend(
    response: &egui::Response,
    scale: &StripScale,
    pointer: Pos2,
    mut pins: Vec<Pin>,
    context: Context<'_>,
    actions: &mut Actions,
) {
    let over = context.session.strip_over;
    let (Some((_, line)), Some(strip)) = (context.current_line(), context.access.strip()) else { return };
    let (at_mm, deg) = scale.place(pointer);
    let mut taken = context.session.pin_dragged;
    if response.drag_started() {
        let near = |p: &Pin| scale.at(p.at_mm, over.of(p.tilt)).distance(pointer) <= GRAB;
        taken = Some(pins.iter().position(near).unwrap_or_else(|| {
            pins.push(Pin { line, at_mm, tilt: strip.chosen_at(at_mm).unwrap_or_default() });
            pins.len() - 1
        }));
        actions.session(move |s| s.pin_dragged = taken);
    }
    if response.dragged()
        && let Some(pin) = taken.and_then(|i| pins.get_mut(i))
    {
        (pin.at_mm, pin.tilt) = (at_mm, over.with(pin.tilt, deg));
        set_pins(pins, context, actions);
    }
}

/// The pins of the current line.
fn pins(context: Context<'_>) -> Vec<Pin> {
    let Some((surface, line)) = context.current_line() else { return Vec::new() };
    let settings = &context.document.job().settings;
    settings.of(SurfaceId(surface)).pins.iter().filter(|p| p.line == line).copied().collect()
}

/// Replaces the pins of the current line.
fn set_pins(pins: Vec<Pin>, context: Context<'_>, actions: &mut Actions) {
    let Some((surface, line)) = context.current_line() else { return };
    let surface = SurfaceId(surface);
    let others = context.document.job().settings.of(surface).pins.iter().filter(|p| p.line != line);
    let all = others.copied().chain(pins).collect();
    actions.drag(Edit::Pins(surface, all), "pins");
}
