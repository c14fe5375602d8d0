//! A scan's file that is another one than the job was made with: one click takes it as it is now.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use crate::document::Edit;
use crate::document::model::ScanFile;
use crate::document::scan_edit::ScanEdit;
use crate::planning::scanned::ScanError;
use crate::planning::{Failure, PlanningError};
use crate::text::say;
use eframe::egui;

/// The button, where that is what stands in the way.
pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some(PlanningError::Scan(Failure::Refused(ScanError::Changed { file, sha256 }))) =
        context.derived.error(context.document)
    else {
        return;
    };
    if ui.button(say!(problems_use_changed_scan)).on_hover_text(say!(problems_use_changed_scan_tip)).clicked() {
        let scan = &context.document.job().scan;
        let taken =
            |f: &ScanFile| if f.file == file { ScanFile { sha256: sha256.clone(), ..f.clone() } } else { f.clone() };
        let edit = ScanEdit::Files(scan.files.iter().map(taken).collect(), scan.units);
        actions.edit(Edit::Scan(Box::new(edit)));
    }
}
