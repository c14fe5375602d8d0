//! What casts doubt on the part, above the view as soon as its file is open: the worst first, each with the click that
//! cures it. What was dismissed stays in the list of problems, with that click.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::file_findings::FileCure;
use super::super::theme;
use crate::part::{PartFinding, Units};
use crate::text::{Sentence as _, exact, say};
use eframe::egui::{self, RichText};

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let doubts = context.doubts();
    if doubts.is_empty() {
        return;
    }
    egui::Frame::new().inner_margin(6).fill(ui.visuals().extreme_bg_color).show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        for (row, finding) in doubts.iter().enumerate() {
            // Below the worst only what a click cures: the rest is in the list.
            if row > 0 && FileCure::of(finding).is_none() {
                continue;
            }
            ui.horizontal_wrapped(|ui| {
                ui.label(RichText::new(theme::capital(&finding.sentence())).strong().color(ui.visuals().warn_fg_color));
                cure(ui, finding, actions);
                if row == 0 && ui.button(say!(file_dismiss)).on_hover_text(say!(file_dismiss_tip)).clicked() {
                    let dismissed = doubts.clone();
                    actions.session(move |s| s.dismissed.extend(dismissed));
                }
            });
        }
    });
}

/// The button that cures a finding which was dismissed.
pub(super) fn of_dismissed(ui: &mut egui::Ui, finding: &PartFinding, context: Context<'_>, actions: &mut Actions) {
    if context.session.dismissed.contains(finding) {
        cure(ui, finding, actions);
    }
}

fn cure(ui: &mut egui::Ui, finding: &PartFinding, actions: &mut Actions) {
    let Some(cure) = FileCure::of(finding) else { return };
    let text = match cure {
        FileCure::Units(Units::Mm) => say!(file_treat_as_mm),
        FileCure::Units(Units::M) => say!(file_treat_as_m),
        FileCure::Units(Units::Inch) => say!(file_treat_as_inch),
        FileCure::Absorb(below_mm2) => say!(file_absorb, below = exact(below_mm2)),
    };
    if ui.button(text).clicked() {
        actions.cure(cure);
    }
}
