//! Where the scan lies on the model: how well it does, what slides, which other positions there are; and whether the job
//! keeps the position or looks for it.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::theme;
use super::{left_out, pairs};
use crate::document::scan_edit::ScanEdit;
use crate::planning::scanned::{LaidScan, RegistrationReport, RivalReport, Scanned};
use crate::scan::transform_file::rows;
use crate::text::{Sentence as _, how_it_lies, id, say};
use eframe::egui::{self, RichText};

pub(super) fn ui(ui: &mut egui::Ui, scanned: &Scanned, context: Context<'_>, actions: &mut Actions) {
    theme::heading(ui, &say!(scan_panel_lies));
    if let Some(laid) = &scanned.laid {
        position(ui, laid, context, actions);
    }
    // Where it lies nowhere these are what helps.
    if scanned.cleaned.is_some() {
        pairs::ui(ui, scanned, context, actions);
        left_out::ui(ui, context, actions);
    }
}

/// How well it lies, and whether the job keeps the position.
fn position(ui: &mut egui::Ui, laid: &LaidScan, context: Context<'_>, actions: &mut Actions) {
    match &laid.registration {
        None => drop(ui.label(say!(scan_panel_given))),
        Some(found) => {
            let mut report = RegistrationReport::new(found);
            let is_in_doubt = report.is_in_doubt();
            let (same, others): (Vec<_>, Vec<_>) = report.rivals.into_iter().partition(|r| r.same_by_symmetry);
            report.rivals = same;
            for line in how_it_lies(&report) {
                ui.label(theme::capital(&line));
            }
            for (i, rival) in others.iter().enumerate() {
                take_rival(ui, i, rival, actions);
            }
            if is_in_doubt {
                ui.label(RichText::new(say!(scan_panel_in_doubt)).color(theme::ATTENTION));
            }
        }
    }
    ui.horizontal_wrapped(|ui| {
        let keep = ui.add_enabled(laid.registration.is_some(), egui::Button::new(say!(scan_panel_keep)).small());
        if keep.on_hover_text(say!(scan_panel_keep_tip)).clicked() {
            actions.scan(ScanEdit::Transform(Some(rows(&laid.model_from_scan))));
        }
        let is_given = context.document.job().scan.transform.is_some();
        let again = ui.add_enabled(is_given, egui::Button::new(say!(scan_panel_look_again)).small());
        if again.on_hover_text(say!(scan_panel_look_again_tip)).clicked() {
            actions.scan(ScanEdit::Transform(None));
        }
    });
}

fn take_rival(ui: &mut egui::Ui, at: usize, rival: &RivalReport, actions: &mut Actions) {
    ui.label(RichText::new(theme::capital(&rival.sentence())).color(theme::ATTENTION));
    let take = ui.small_button(say!(scan_panel_take_rival));
    let told = || say!(scan_panel_take_rival_name, rival = id(at + 1));
    take.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, told()));
    if take.clicked() {
        actions.scan(ScanEdit::Transform(Some(rival.model_from_scan)));
    }
}
