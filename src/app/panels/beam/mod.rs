//! The tool: head, tilt, optics with the spot they give, clamps on the part, and the dose.

mod clamps;
pub(super) mod dose;
mod head;
mod optics;
mod tilt;

use super::super::actions::Actions;
use super::super::context::Context;
use super::numbers;
use crate::document::parameter::Group;
use crate::pose::Correction;
use crate::text::say;
use eframe::egui;

/// Head, clamps, optics and tilt, under the numbers of the beam.
pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    head::ui(ui, context, actions);
    let job = context.document.job();
    let clearance = job.path.correction == Correction::Clearance;
    if clearance || !job.beam.head.is_empty() {
        numbers::of_job(ui, Group::Tilt, context, actions);
    }
    if clearance {
        egui::CollapsingHeader::new(say!(tool_tilt)).id_salt("tilt").show(ui, |ui| {
            numbers::of_job(ui, Group::TiltRates, context, actions);
            tilt::ui(ui, context, actions);
        });
    }
    egui::CollapsingHeader::new(say!(tool_optics)).id_salt("optics").show(ui, |ui| optics::ui(ui, context, actions));
    clamps(ui, context, actions);
}

/// What stands on the part.
pub(super) fn clamps(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    egui::CollapsingHeader::new(say!(tool_clamps)).id_salt("clamps").show(ui, |ui| clamps::ui(ui, context, actions));
}
