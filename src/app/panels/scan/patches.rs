//! How far the part is off its model, and its patches: those where material is missing are ticked to be worked, and a
//! click goes to each.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::theme;
use crate::document::model::{PatchChoice, ScanLines, ScanWork};
use crate::document::scan_edit::ScanEdit;
use crate::planning::scanned::{ComparedScan, DeviationReport, Scanned, WornPart};
use crate::scan::deviation::{Patch, PatchKind};
use crate::text::{deviation_summary, fixed, id, say};
use eframe::egui::{self, Role, WidgetInfo};
use std::sync::Arc;

/// Rows of the list that are shown at most: the deepest.
const ROWS: usize = 24;

pub(super) fn ui(ui: &mut egui::Ui, scanned: &Scanned, context: Context<'_>, actions: &mut Actions) {
    let Some(compared) = &scanned.compared else { return };
    theme::heading(ui, &say!(scan_panel_deviation));
    for line in deviation_summary(&DeviationReport::new(compared, context.document.job().scan.min_depth_mm)) {
        ui.label(theme::capital(&line));
    }
    what_is_worked(ui, context, actions);
    let are_worked = context.is_worked_by_scan();
    let worn = scanned.worn.as_deref();
    for (at, patch) in compared.patches.patches.iter().enumerate().take(ROWS) {
        ui.horizontal(|ui| {
            match (patch.kind, worn) {
                (PatchKind::Missing, Some(worn)) if are_worked => {
                    tick(ui, number(compared, at), (compared, worn), context, actions)
                }
                _ => {
                    ui.add_space(22.0);
                }
            }
            row(ui, at, patch, (compared, worn), context, actions);
        });
        let layers = worn.and_then(|worn| worn.layers.get(at)).map_or(&[][..], Vec::as_slice);
        if let Some(last) = layers.last() {
            let told = say!(deviation_layers, layers = layers.len(), last = fixed(last.height_mm, 3));
            ui.label(theme::capital(&told));
        }
    }
    if compared.patches.patches.len() > ROWS {
        let count = compared.patches.patches.len() - ROWS;
        ui.label(say!(scan_panel_smaller, count));
    }
}

/// Whether patches are worked or the surfaces that the job chooses.
fn what_is_worked(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let mut work = context.document.job().scan.work;
    let before = work;
    ui.horizontal_wrapped(|ui| {
        ui.label(say!(scan_panel_work));
        ui.radio_value(&mut work, ScanWork::Patches, say!(scan_panel_work_patches));
        ui.radio_value(&mut work, ScanWork::Surfaces, say!(scan_panel_work_surfaces))
            .on_hover_text(say!(scan_panel_work_surfaces_tip));
    });
    if work != before {
        actions.scan(ScanEdit::Work(work));
    }
    let mut lines = context.document.job().scan.lines;
    let before = lines;
    ui.horizontal_wrapped(|ui| {
        ui.label(say!(scan_panel_lines));
        ui.radio_value(&mut lines, ScanLines::Facets, say!(scan_panel_lines_model));
        ui.radio_value(&mut lines, ScanLines::Points, say!(scan_panel_lines_points))
            .on_hover_text(say!(scan_panel_lines_points_tip));
    });
    if lines != before {
        actions.scan(ScanEdit::Lines(lines));
    }
}

/// The place of a patch among those where material is missing: only these are surfaces.
fn number(compared: &ComparedScan, at: usize) -> usize {
    compared.patches.patches[..at].iter().filter(|p| p.kind == PatchKind::Missing).count()
}

/// Whether a patch is worked, and the box that says so.
fn tick(
    ui: &mut egui::Ui,
    number: usize,
    (compared, worn): (&Arc<ComparedScan>, &WornPart),
    context: Context<'_>,
    actions: &mut Actions,
) {
    let worked = worn.surfaces.worked.as_deref().unwrap_or_default();
    let is_worked = |of: usize| worn.patches.get(of).is_some_and(|p| p.iter().any(|s| worked.contains(&s.surface)));
    let mut on = is_worked(number);
    let check = ui.checkbox(&mut on, "").on_hover_text(say!(scan_panel_work_tip));
    check.widget_info(|| {
        let told = say!(scan_panel_work_name, patch = id(number + 1));
        WidgetInfo::selected(Role::CheckBox, true, on, told)
    });
    if !check.changed() {
        return;
    }
    let missing: Vec<&Patch> = compared.patches.patches.iter().filter(|p| p.kind == PatchKind::Missing).collect();
    let wanted: Vec<bool> = (0..missing.len()).map(|i| if i == number { on } else { is_worked(i) }).collect();
    let places = || missing.iter().zip(&wanted).filter(|(_, on)| **on).map(|(p, _)| p.deepest_at.coords.into());
    let choice = if wanted.iter().all(|on| *on) { PatchChoice::All } else { PatchChoice::At(places().collect()) };
    if context.document.job().scan.patches != choice {
        actions.scan(ScanEdit::Patches(choice));
    }
}

/// Its colour and measures; a click goes there.
fn row(
    ui: &mut egui::Ui,
    at: usize,
    patch: &Patch,
    (compared, worn): (&Arc<ComparedScan>, Option<&WornPart>),
    context: Context<'_>,
    actions: &mut Actions,
) {
    let (depth, area, volume) = (fixed(patch.depth_mm, 2), fixed(patch.area_mm2, 1), fixed(patch.volume_mm3, 2));
    let is_missing = patch.kind == PatchKind::Missing;
    let pieces = worn.filter(|_| is_missing).and_then(|w| w.patches.get(number(compared, at)));
    let surface = pieces.and_then(|p| p.first()).map(|piece| piece.surface.0);
    if let (Some(n), Some(picture)) = (surface, &context.derived.picture) {
        theme::swatch(ui, picture.swatch(n, context.clean_list().contains(&n)));
    }
    let text = match is_missing {
        true => say!(scan_panel_missing, patch = id(number(compared, at) + 1), depth, area, volume),
        false => say!(scan_panel_surplus, depth, area, volume),
    };
    if ui.link(text).on_hover_text(say!(scan_panel_show)).clicked() {
        surface.into_iter().for_each(|n| actions.reveal(n));
        actions.look_at(patch.centre, patch.area_mm2.sqrt().max(2.0));
    }
}
