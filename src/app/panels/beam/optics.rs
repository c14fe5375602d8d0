//! The optics, the spot they give, and the ways to work with it.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::numbers;
use crate::beam::Optics;
use crate::document::Edit;
use crate::document::parameter::{Group, Parameter};
use crate::text::{exact, fixed, say};
use eframe::egui::{self, RichText};

/// From this relative difference on, the spot that the optics give counts as another than the one that is set.
const OTHER_SPOT: f64 = 0.05;
const SPOT: &Parameter = Parameter::named("beam.spot_mm");
const DEFOCUS: &Parameter = Parameter::named("beam.defocus_mm");

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    numbers::of_job(ui, Group::Optics, context, actions);
    let job = context.document.job();
    let (optics, beam) = (&job.optics, &job.beam);
    let (spot, (low, high)) = (optics.spot_mm(beam.defocus_mm), optics.tolerance_mm(beam.defocus_mm));
    ui.label(say!(tool_m_squared, value = fixed(optics.m_squared(), 2)));
    ui.label(say!(tool_spot, defocus = fixed(beam.defocus_mm, 1), spot = fixed(spot, 3)));
    ui.label(RichText::new(say!(tool_tolerance, from = fixed(low, 1), to = fixed(high, 1))).small());
    if (spot / beam.spot_mm - 1.0).abs() <= OTHER_SPOT {
        return;
    }
    let text = say!(tool_spot_is_set, spot = exact(beam.spot_mm));
    ui.label(RichText::new(text).color(ui.visuals().warn_fg_color));
    take(ui, optics, spot, beam.spot_mm, actions);
}

/// Buttons where the spot is not the one that the optics give: take that spot, or a defocus that gives the spot that is
/// set; mm.
fn take(ui: &mut egui::Ui, optics: &Optics, spot_mm: f64, set_mm: f64, actions: &mut Actions) {
    let thousandths = |mm: f64| (mm * 1000.0).round() / 1000.0;
    ui.horizontal_wrapped(|ui| {
        let take = ui.button(say!(tool_take_spot, spot = fixed(spot_mm, 2)));
        if take.on_hover_text(say!(tool_take_spot_tip)).clicked() {
            actions.edit(Edit::Set(SPOT.key, thousandths(spot_mm)));
        }
        let Some(defocus_mm) = optics.defocus_for(set_mm) else {
            ui.label(say!(tool_too_narrow));
            return;
        };
        for defocus_mm in [defocus_mm, -defocus_mm] {
            let side = if defocus_mm < 0.0 { say!(tool_focus_in_part) } else { say!(tool_focus_above) };
            let take = ui.button(say!(tool_take_defocus, defocus = fixed(defocus_mm, 1)));
            if take.on_hover_text(side).clicked() {
                actions.edit(Edit::Set(DEFOCUS.key, thousandths(defocus_mm)));
            }
        }
    });
}
