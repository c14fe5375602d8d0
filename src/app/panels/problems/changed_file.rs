//! A file of the scan or of the weld's images that is another one than the job was made with: one click takes it as it is
//! now.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use crate::document::Edit;
use crate::document::model::{JobScan, ScanFile};
use crate::document::scan_edit::ScanEdit;
use crate::document::weld_edit::WeldEdit;
use crate::planning::scanned::ScanError;
use crate::planning::welded::WeldError;
use crate::planning::{Failure, PlanningError};
use crate::text::say;
use eframe::egui;

/// The button, where that is what stands in the way.
pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let mut asks = |name: String, tip: String| ui.button(name).on_hover_text(tip).clicked();
    let edit = match context.derived.error(context.document) {
        Some(PlanningError::Scan(Failure::Refused(ScanError::Changed { file, sha256 }))) => {
            let taken = asks(say!(problems_use_changed_scan), say!(problems_use_changed_scan_tip));
            taken.then(|| Edit::Scan(Box::new(as_it_is(&context.document.job().scan, &file, &sha256))))
        }
        Some(PlanningError::Weld(Failure::Refused(WeldError::Changed { file, sha256 }))) => {
            let taken = asks(say!(problems_use_changed_image), say!(problems_use_changed_image_tip));
            taken.then(|| Edit::Grind(Box::new(WeldEdit::Changed { file, sha256 })))
        }
        _ => None,
    };
    if let Some(edit) = edit {
        actions.edit(edit);
    }
}

/// The files of a scan, this one as it is now.
fn as_it_is(scan: &JobScan, file: &str, sha256: &str) -> ScanEdit {
    let taken = |of: &ScanFile| match of.file == file {
        true => ScanFile { sha256: sha256.to_owned(), ..of.clone() },
        false => of.clone(),
    };
    ScanEdit::Files(scan.files.iter().map(taken).collect(), scan.units)
}
