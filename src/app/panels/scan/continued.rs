//! Damage across which the surface around goes on: where there is no model, what is left of the part tells what is
//! missing. The damage is what was painted as left out; the surface is selected in the view.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::scan_tool::around;
use super::left_out::selected_bounds;
use super::tool_button::hint;
use crate::document::model::{ContinuedDamage, ContinuedKind};
use crate::document::scan_edit::ScanEdit;
use crate::planning::scanned::Scanned;
use crate::text::{fixed, id, say};
use crate::view::Bounds;
use eframe::egui;

const KINDS: [ContinuedKind; 5] = [
    ContinuedKind::Plane,
    ContinuedKind::Cylinder,
    ContinuedKind::Revolved,
    ContinuedKind::Extruded,
    ContinuedKind::Smooth,
];

pub(super) fn ui(ui: &mut egui::Ui, scanned: &Scanned, context: Context<'_>, actions: &mut Actions) {
    let scan = &context.document.job().scan;
    // A part with a model has its surfaces there.
    let is_scan = context.derived.part.as_ref().is_some_and(|part| part.figures.meshed.is_some());
    if scan.continued.is_empty() && (scan.left_out.is_empty() || !is_scan) {
        return;
    }
    ui.label(say!(scan_continue));
    list(ui, scanned, &scan.continued, actions);
    if scan.left_out.is_empty() {
        return;
    }
    let selected = selected_bounds(context);
    if selected.is_none() {
        hint(ui, say!(scan_continue_hint));
    }
    ui.horizontal_wrapped(|ui| {
        for by in KINDS {
            let button = ui.add_enabled(selected.is_some(), egui::Button::new(name(by)).small());
            if let (true, Some(Bounds { min, max })) =
                (button.on_hover_text(say!(scan_continue_tip)).clicked(), selected)
            {
                let damage = ContinuedDamage { by, damaged: scan.left_out.clone(), sound: vec![around(min, max, 0.0)] };
                actions.scan(ScanEdit::Continued([&scan.continued[..], &[damage]].concat()));
            }
        }
    });
}

/// What goes on, how well it fits, and how sure it is.
fn list(ui: &mut egui::Ui, scanned: &Scanned, all: &[ContinuedDamage], actions: &mut Actions) {
    let found = scanned.laid.as_ref().map_or(&[][..], |laid| &laid.model.continued);
    let mut gone = None;
    for (i, damage) in all.iter().enumerate() {
        ui.horizontal_wrapped(|ui| {
            if ui.small_button("×").on_hover_text(say!(scan_continue_remove)).clicked() {
                gone = Some(i);
            }
            ui.label(match found.get(i) {
                None => name(damage.by),
                Some(f) => {
                    let [rms, gap, spread] =
                        [(f.rms_mm, 3), (f.gap_mm, 1), (f.spread_mm, 3)].map(|(mm, n)| fixed(mm, n));
                    say!(scan_continue_found, number = id(i + 1), kind = name(damage.by), rms, gap, spread)
                }
            });
        });
    }
    if let Some(i) = gone {
        let rest = all.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, damage)| damage.clone());
        actions.scan(ScanEdit::Continued(rest.collect()));
    }
}

fn name(of: ContinuedKind) -> String {
    match of {
        ContinuedKind::Plane => say!(scan_continue_plane),
        ContinuedKind::Cylinder => say!(scan_continue_cylinder),
        ContinuedKind::Revolved => say!(scan_continue_revolved),
        ContinuedKind::Extruded => say!(scan_continue_extruded),
        ContinuedKind::Smooth => say!(scan_continue_smooth),
    }
}
