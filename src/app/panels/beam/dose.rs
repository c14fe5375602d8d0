//! Profile of the spot, and thresholds of the dose.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::theme;
use super::super::numbers;
use crate::document::Edit;
use crate::document::parameter::Group;
use crate::process::Profile;
use crate::text::{choices, say};
use eframe::egui;

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    egui::CollapsingHeader::new(say!(tool_dose)).id_salt("dose").default_open(true).show(ui, |ui| {
        let now = context.document.job().dose.profile;
        ui.horizontal(|ui| {
            theme::name(ui, &say!(tool_profile), 90.0).on_hover_text(say!(tool_profile_tip));
            for p in Profile::ALL {
                if ui.selectable_label(now == p, choices::profile(p)).clicked() {
                    actions.edit(Edit::Profile(p));
                }
            }
        });
        if now == Profile::Line {
            numbers::of_job(ui, Group::ScannedLine, context, actions);
        }
        numbers::of_job(ui, Group::Dose, context, actions);
    });
}
