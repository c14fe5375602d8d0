//! The tilt rule of the selected surface.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::theme;
use super::super::entry::{Entry, refused};
use crate::document::Edit;
use crate::part::SurfaceId;
use crate::pose::tilt::{TiltRule, TiltSide};
use crate::text::{id, say};
use eframe::egui::{self, RichText};

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let selected = &context.session.selected;
    let Some(&surface) = selected.first().filter(|_| selected.len() == 1) else {
        ui.label(RichText::new(say!(tool_tilt_select)).small());
        return;
    };
    let before = &context.document.job().settings.of(SurfaceId(surface)).tilt;
    let mut rule = before.clone();
    ui.label(RichText::new(say!(tool_tilt_surface, surface = id(surface))).strong());
    angles(ui, &mut rule);
    forbidden(ui, &mut rule);
    if rule != *before {
        actions.drag(Edit::Tilt(SurfaceId(surface), rule), "tilt");
    }
}

fn angles(ui: &mut egui::Ui, rule: &mut TiltRule) {
    let numbers = [
        (say!(tool_lead), say!(tool_lead_tip), -75.0, &mut rule.preferred.lead_deg),
        (say!(tool_lean), say!(tool_lean_tip), -75.0, &mut rule.preferred.lean_deg),
        (say!(tool_least_tilt), say!(tool_least_tilt_tip), 0.0, &mut rule.least_deg),
    ];
    for (name, tip, least, value) in numbers {
        let row = ui.horizontal(|ui| {
            let label = theme::name(ui, &name, 130.0).on_hover_text(tip);
            let drawn = Entry { decimals: 1, ..Entry::new(least..=75.0, say!(unit_deg)) }.show(ui, value);
            drawn.response.clone().labelled_by(label.id);
            drawn
        });
        refused(ui, [&row.inner]);
    }
}

/// Sides that the beam never tilts to.
fn forbidden(ui: &mut egui::Ui, rule: &mut TiltRule) {
    let sides = [
        (TiltSide::Lead, say!(tool_ahead)),
        (TiltSide::Lag, say!(tool_behind)),
        (TiltSide::Left, say!(tool_left)),
        (TiltSide::Right, say!(tool_right)),
    ];
    ui.horizontal_wrapped(|ui| {
        theme::name(ui, &say!(tool_never_to), 60.0).on_hover_text(say!(tool_never_to_tip));
        for (side, name) in sides {
            let on = rule.forbidden.contains(&side);
            if ui.selectable_label(on, name).clicked() {
                rule.forbidden.retain(|s| *s != side);
                if !on {
                    rule.forbidden.push(side);
                    rule.forbidden.sort();
                }
            }
        }
    });
}
