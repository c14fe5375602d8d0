//! The files of a scan, and the unit that they are in.

use super::super::super::actions::Actions;
use super::super::super::command::Command;
use super::super::super::context::Context;
use crate::document::model::{ScanFile, ScanTogether};
use crate::document::scan_edit::ScanEdit;
use crate::part::Units;
use crate::scan::transform_file::rows;
use crate::text::{choices, say};
use eframe::egui;
use std::path::Path;

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let scan = &context.document.job().scan;
    let mut gone = None;
    for (i, f) in scan.files.iter().enumerate() {
        ui.horizontal(|ui| {
            let name = Path::new(&f.file).file_name().map_or_else(|| f.file.clone(), |n| n.to_string_lossy().into());
            if ui.small_button("×").on_hover_text(say!(scan_panel_remove)).clicked() {
                gone = Some(i);
            }
            ui.add(egui::Label::new(name).truncate()).on_hover_text(&f.file);
        });
    }
    if let Some(i) = gone {
        let mut rest = scan.files.clone();
        rest.remove(i);
        actions.scan(ScanEdit::Files(rest, scan.units));
    }
    let open = if scan.is_there() { say!(scan_panel_add) } else { Command::OpenScan.name() };
    if ui.button(open).on_hover_text(say!(scan_panel_open_tip)).clicked() {
        actions.command(Command::OpenScan);
    }
    if !scan.is_there() {
        own_scan(ui, context, actions);
        return;
    }
    if scan.files.len() > 1 {
        together(ui, scan.together, actions);
    }
    ui.horizontal(|ui| {
        ui.label(say!(scan_panel_units));
        for units in Units::ALL {
            let button = ui.selectable_label(scan.units == units, choices::units(units));
            let told = || say!(scan_panel_units_name, units = choices::units(units));
            button
                .widget_info(|| egui::WidgetInfo::selected(egui::Role::RadioButton, true, scan.units == units, told()));
            if button.clicked() && scan.units != units {
                actions.scan(ScanEdit::Files(scan.files.clone(), units));
            }
        }
    });
}

/// Whether several files share a frame, or are brought together by what they show alike.
fn together(ui: &mut egui::Ui, now: ScanTogether, actions: &mut Actions) {
    let mut wanted = now;
    ui.horizontal_wrapped(|ui| {
        ui.radio_value(&mut wanted, ScanTogether::Shared, say!(scan_panel_shared));
        ui.radio_value(&mut wanted, ScanTogether::Overlap, say!(scan_panel_overlap))
            .on_hover_text(say!(scan_panel_overlap_tip));
    });
    if wanted != now {
        actions.scan(ScanEdit::Together(wanted));
    }
}

/// A part that is a scan can be worked from its points alone: there need be no other model.
fn own_scan(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let is_scan = context.derived.part.as_ref().is_some_and(|part| part.figures.meshed.is_some());
    let of = &context.document.job().part;
    if is_scan && ui.button(say!(scan_panel_own)).on_hover_text(say!(scan_panel_own_tip)).clicked() {
        let file = ScanFile { file: of.file.clone(), sha256: of.sha256.clone() };
        actions.scan(ScanEdit::OwnScan(file, rows(&of.placement.isometry())));
    }
}
