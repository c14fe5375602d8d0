//! The dose in numbers: shares of the chosen area, histogram, what lands on other surfaces, what stays unclean, and
//! which passes reach a clicked place.

mod figures;
mod findings;

pub(super) use figures::bar;

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use super::super::session::Coloring;
use super::super::theme;
use super::super::toggle::Toggle;
use crate::picture::dose::{DoseLook, legend};
use crate::text::say;
use eframe::egui;

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let is_shown = context.session.show.is_on(Toggle::Dose);
    let mut shows = is_shown;
    let why = context.why_not(Command::Toggle(Toggle::Dose));
    let check = ui.add_enabled(why.is_none(), egui::Checkbox::new(&mut shows, say!(dose_panel_shown)));
    if check.on_disabled_hover_text(why.unwrap_or_default()).changed() {
        actions.command(Command::Toggle(Toggle::Dose));
    }
    if !is_shown || context.derived.plan().is_none() {
        return;
    }
    let coloring = context.session.coloring;
    ui.horizontal_wrapped(|ui| {
        theme::heading(ui, &say!(dose_panel_heading));
        let ways = [
            (Coloring::Dose, say!(dose_panel_by_dose)),
            (Coloring::Incidence, say!(dose_panel_by_incidence)),
            (Coloring::Surface, say!(dose_panel_by_surface)),
        ];
        for (way, name) in ways {
            if ui.selectable_label(coloring == way, name).clicked() {
                actions.session(move |s| s.coloring = way);
            }
        }
    });
    let Some(view) = context.dose() else {
        ui.horizontal(|ui| not_there(ui, context));
        return;
    };
    ui.vertical(|ui| {
        let look = if coloring == Coloring::Incidence { DoseLook::Incidence } else { DoseLook::Dose };
        figures::scale(ui, &legend(&view.map, look));
        figures::shares(ui, view);
        if look == DoseLook::Dose {
            figures::histogram(ui, view);
        }
        findings::clicked(ui, context, actions);
        findings::patches(ui, view, context, actions);
        findings::collateral(ui, view, actions);
    });
}

/// Why there is no dose to be shown.
fn not_there(ui: &mut egui::Ui, context: Context<'_>) {
    if context.derived.dose.progress().is_some() {
        ui.spinner();
        ui.label(say!(dose_panel_computing));
    } else if context.plan().is_none() {
        ui.label(say!(dose_panel_no_plan));
    } else {
        ui.label(say!(dose_panel_not_computed));
    }
}
