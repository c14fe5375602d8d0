//! The laser head: its file, and its measures.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::dialogs::Purpose;
use super::super::super::theme;
use super::super::head_editor::state::HeadDraft;
use super::super::numbers;
use crate::beam::Head;
use crate::document::Edit;
use crate::document::parameter::Group;
use crate::text::say;
use eframe::egui::{self, RichText};
use std::path::Path;

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let file = &context.document.job().beam.head;
    let shown = Path::new(file).file_name().map(|n| n.to_string_lossy().into_owned());
    let shown = shown.unwrap_or_else(|| say!(tool_head_none));
    ui.horizontal(|ui| {
        theme::name(ui, &say!(tool_head), 130.0).on_hover_text(say!(tool_head_tip));
        if ui.button(say!(tool_open_head)).on_hover_text(say!(tool_open_head_tip)).clicked() {
            actions.ask(Purpose::Head);
        }
        if ui.button(say!(tool_edit_head)).on_hover_text(say!(tool_edit_head_tip)).clicked() {
            let head = match context.derived.pipeline.setup() {
                Some(Ok(setup)) => setup.tool.head.as_ref(),
                _ => None,
            };
            let draft = HeadDraft::of(head);
            actions.session(|s| s.head_draft = Some(draft));
        }
        if !file.is_empty() && ui.small_button("×").on_hover_text(say!(tool_remove_head)).clicked() {
            actions.edit(Edit::Head(String::new()));
        }
    });
    ui.horizontal(|ui| {
        theme::name(ui, "", 130.0);
        ui.add(egui::Label::new(shown).truncate());
    });
    if file.is_empty() {
        return;
    }
    numbers::of_job(ui, Group::Head, context, actions);
    let Some(Ok(setup)) = context.derived.pipeline.setup() else { return };
    if let Some(Head::Solid(..)) = &setup.tool.head {
        ui.label(RichText::new(say!(tool_head_of_facets)).small());
    }
}
