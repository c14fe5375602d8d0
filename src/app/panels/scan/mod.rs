//! The scan of the part as it is, group by group: its files, what cleaning does, where it lies on the model, what is
//! worn, and where it stands in the cell. Its colours in the view are explained by `legend`.

mod cleaning;
mod continued;
mod cuts;
mod figures;
mod files;
mod labels;
mod left_out;
pub(in super::super) mod legend;
mod lies;
pub(in super::super) mod marks;
mod pairs;
mod patches;
mod place;
mod placing;
pub(in super::super) mod section;
mod tool_button;

use super::super::actions::Actions;
use super::super::context::Context;
use super::numbers;
use crate::document::Edit;
use crate::document::parameter::Group;
use crate::document::scan_edit::ScanEdit;
use crate::text::say;
use eframe::egui::{self, CollapsingHeader};

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let is_there = context.document.job().scan.is_there();
    let header = CollapsingHeader::new(say!(scan_panel)).id_salt(("scan", is_there)).default_open(is_there);
    header.show(ui, |ui| {
        files::ui(ui, context, actions);
        if !is_there {
            return;
        }
        let scanned = context.derived.pipeline.scanned();
        cleaning::ui(ui, scanned.as_ref(), context, actions);
        numbers::of_job(ui, Group::Scan, context, actions);
        let Some(scanned) = scanned else { return };
        lies::ui(ui, &scanned, context, actions);
        continued::ui(ui, &scanned, context, actions);
        patches::ui(ui, &scanned, context, actions);
        if scanned.compared.is_some() {
            labels::ui(ui, context, actions);
            figures::ui(ui, &scanned, context);
        }
        placing::ui(ui, context, actions);
    });
}

impl Actions {
    /// Changes the scan, as a step of its own.
    fn scan(&mut self, edit: ScanEdit) {
        self.edit(Edit::Scan(Box::new(edit)));
    }
}
