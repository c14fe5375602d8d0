//! Pairs of points that say where the scan lies: picked in the view, listed here with what each is off.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::scan_tool::{PairsDraft, ScanTool};
use super::super::super::theme;
use super::tool_button::{hint, tool_button};
use crate::document::scan_edit::ScanEdit;
use crate::planning::scanned::Scanned;
use crate::text::{fixed, id, say};
use eframe::egui::{self, RichText, Role, WidgetInfo};

/// Fewest pairs that tell a position.
const FEWEST: usize = 3;

pub(super) fn ui(ui: &mut egui::Ui, scanned: &Scanned, context: Context<'_>, actions: &mut Actions) {
    let of_job = &context.document.job().scan.pairs;
    let draft = match context.scan_tool() {
        Some(ScanTool::Pairs(draft)) => Some(draft),
        _ => None,
    };
    ui.horizontal_wrapped(|ui| {
        let begun = || ScanTool::Pairs(PairsDraft { pairs: of_job.clone(), ..PairsDraft::default() });
        tool_button(ui, [say!(scan_pairs_pick), say!(scan_pairs_pick)], draft.is_some(), actions, begun);
        if !of_job.is_empty() {
            ui.label(RichText::new(say!(scan_pairs_of_job, count = of_job.len())).weak());
            if ui.small_button(say!(scan_pairs_forget)).on_hover_text(say!(scan_pairs_forget_tip)).clicked() {
                actions.scan(ScanEdit::Pairs(Vec::new()));
                actions.session(|s| s.scan_tool = None);
            }
        }
    });
    let Some(draft) = draft else { return };
    hint(
        ui,
        match (draft.scan_mm, draft.model_mm) {
            (None, None) => say!(scan_pairs_hint),
            (Some(_), _) => say!(scan_pairs_hint_model),
            (None, Some(_)) => say!(scan_pairs_hint_scan),
        },
    );
    list(ui, scanned, draft, context, actions);
    let is_news = draft.pairs != *of_job || context.document.job().scan.transform.is_some();
    let lay = egui::Button::new(say!(scan_pairs_lay, count = draft.pairs.len()));
    let lay = ui.add_enabled(draft.pairs.len() >= FEWEST && is_news, lay);
    if lay.on_disabled_hover_text(say!(scan_pairs_too_few)).clicked() {
        actions.scan(ScanEdit::Pairs(draft.pairs.clone()));
        actions.session(|s| s.scan_tool = None);
    }
}

/// The pairs, each with what it is off: where the scan was laid by them, or by what they say among themselves.
fn list(ui: &mut egui::Ui, scanned: &Scanned, draft: &PairsDraft, context: Context<'_>, actions: &mut Actions) {
    let is_laid_by_them = draft.pairs == context.document.job().scan.pairs;
    let laid = scanned.laid.as_ref().filter(|_| is_laid_by_them).map(|l| l.model_from_scan);
    let off_mm = laid.or_else(|| draft.motion()).map(|motion| draft.residuals_mm(&motion));
    for at in 0..draft.pairs.len() {
        ui.horizontal(|ui| {
            let gone = ui.small_button("×").on_hover_text(say!(scan_pairs_remove));
            gone.widget_info(|| {
                WidgetInfo::labeled(Role::Button, true, say!(scan_pairs_remove_name, pair = id(at + 1)))
            });
            if gone.clicked() {
                actions.session(move |s| {
                    if let Some(ScanTool::Pairs(draft)) = &mut s.scan_tool {
                        draft.pairs.remove(at);
                    }
                });
            }
            ui.label(match off_mm.as_ref().and_then(|off| off.get(at)) {
                Some(mm) => say!(scan_pairs_row, pair = id(at + 1), off = fixed(*mm, 2)),
                None => say!(scan_pairs_row_open, pair = id(at + 1)),
            });
        });
    }
    if off_mm.is_some() {
        let text = if laid.is_some() { say!(scan_pairs_off_laid) } else { say!(scan_pairs_off_themselves) };
        ui.label(RichText::new(theme::capital(&text)).small().weak());
    }
}
