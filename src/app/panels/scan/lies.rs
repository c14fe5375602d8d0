//! Where the scan lies on the model: how well it does, what slides, which other positions there are; and whether the job
//! keeps the position or looks for it.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::theme;
use super::{left_out, pairs};
use crate::document::scan_edit::ScanEdit;
use crate::planning::scanned::{LaidScan, RegistrationReport, RivalReport, Scanned};
use crate::scan::transform_file::{numbers, rigid, rows};
use crate::text::{Sentence as _, fixed, how_it_lies, id, say};
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
                ui.label(RichText::new(say!(scan_panel_in_doubt)).color(ui.visuals().warn_fg_color));
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
    typed(ui, laid, actions);
}

/// The position as sixteen numbers, to be copied, or pasted from another program.
fn typed(ui: &mut egui::Ui, laid: &LaidScan, actions: &mut Actions) {
    let header = egui::CollapsingHeader::new(say!(scan_panel_matrix)).default_open(false);
    header.show(ui, |ui| {
        let key = ui.scope_id().with("matrix");
        let shown = || rows(&laid.model_from_scan).chunks(4).map(line).collect::<Vec<_>>().join("\n");
        let mut text = ui.data(|d| d.get_temp::<String>(key)).unwrap_or_else(shown);
        let field = ui.add(egui::TextEdit::multiline(&mut text).desired_rows(4).code_editor());
        field.widget_info(|| egui::WidgetInfo::labeled(egui::Role::MultilineTextInput, true, say!(scan_panel_matrix)));
        let given = numbers(&text).ok_or_else(|| say!(scan_panel_no_matrix));
        let given =
            given.and_then(|n| rigid(&n).map(|_| n).map_err(|fault| say!(scan_matrix, fault = fault.sentence())));
        if field.changed() {
            ui.data_mut(|d| d.insert_temp(key, text));
        }
        match given {
            Err(why) => drop(ui.label(RichText::new(theme::capital(&why)).color(ui.visuals().warn_fg_color))),
            Ok(given) => {
                if ui.small_button(say!(scan_panel_take_matrix)).clicked() {
                    ui.data_mut(|d| d.remove::<String>(key));
                    actions.scan(ScanEdit::Transform(Some(given)));
                }
            }
        }
    });
}

/// A row of the matrix, with as many digits as tell a hundredth of a micrometre on a metre.
fn line(row: &[f64]) -> String {
    row.iter().map(|x| fixed(*x, 8)).collect::<Vec<_>>().join(" ")
}

fn take_rival(ui: &mut egui::Ui, at: usize, rival: &RivalReport, actions: &mut Actions) {
    ui.label(RichText::new(theme::capital(&rival.sentence())).color(ui.visuals().warn_fg_color));
    let take = ui.small_button(say!(scan_panel_take_rival));
    let told = || say!(scan_panel_take_rival_name, rival = id(at + 1));
    take.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, told()));
    if take.clicked() {
        actions.scan(ScanEdit::Transform(Some(rival.model_from_scan)));
    }
}
