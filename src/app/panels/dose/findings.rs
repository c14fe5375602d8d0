//! The dose at the place that was clicked, what stays unclean, and what lands on other surfaces; a click on a row goes
//! there.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::dose::DoseView;
use super::super::super::theme;
use super::figures::j_cm2;
use crate::document::Edit;
use crate::text::{NamedSentence as _, Naming, choices, clock, fixed, id, say};
use eframe::egui::{self, RichText};

/// Rows of a list that are shown at most.
const ROWS: usize = 12;

/// Which passes come to the place that was clicked last.
pub(super) fn clicked(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    theme::heading(ui, &say!(dose_panel_clicked));
    let Some(c) = &context.session.clicked else {
        ui.label(RichText::new(say!(dose_panel_click)).small());
        return;
    };
    let whole: f64 = c.hits.iter().map(|h| h.j_cm2).sum();
    let surface = context.surface_of(c.facet).unwrap_or(0);
    let (surface, place) = (id(surface), choices::place(c.p.coords.into()));
    ui.label(say!(dose_panel_place, surface, place, dose = j_cm2(whole)));
    if c.hits.is_empty() {
        ui.label(say!(dose_panel_no_beam));
    }
    for h in c.hits.iter().take(ROWS) {
        let (pass, time, angle) = (id(h.pass), clock(h.at_s), fixed(h.angle_deg, 0));
        let text = say!(dose_panel_hit, pass, time, angle, dose = j_cm2(h.j_cm2));
        if ui.link(RichText::new(text).small()).on_hover_text(say!(dose_panel_go_to_pass)).clicked() {
            actions.go_to_target((h.pass as usize, 0));
        }
    }
}

/// What no light comes to, which may go to a second list, and the gaps between lines, which may not.
pub(super) fn patches(ui: &mut egui::Ui, view: &DoseView, context: Context<'_>, actions: &mut Actions) {
    patch_list(ui, view, true, context, actions);
    if view.patches.iter().any(|p| p.cause.keeps_light_away()) {
        // What is put aside is cut out by facets, and with a scan those are not the ones of the part's file.
        let by_scan = context.is_worked_by_scan();
        let aside = if by_scan { None } else { Edit::aside(&view.patches, &view.surfaces) };
        let button = ui.add_enabled(aside.is_some(), egui::Button::new(say!(dose_panel_put_aside)));
        let button = if by_scan { button.on_disabled_hover_text(say!(scan_panel_keeps_surfaces)) } else { button };
        if button.on_hover_text(say!(dose_panel_put_aside_tip)).clicked()
            && let Some(edit) = aside
        {
            actions.edit(edit);
        }
    }
    patch_list(ui, view, false, context, actions);
}

fn patch_list(ui: &mut egui::Ui, view: &DoseView, without_light: bool, context: Context<'_>, actions: &mut Actions) {
    let told = view.patches.iter().zip(&view.report.not_cleanable);
    let list: Vec<_> = told.filter(|(p, _)| p.cause.keeps_light_away() == without_light).collect();
    if list.is_empty() {
        return;
    }
    let whole: f64 = list.iter().map(|(p, _)| p.area_mm2).sum();
    let area = fixed(0.01 * whole, 2);
    let title = if without_light { say!(dose_panel_not_cleanable, area) } else { say!(dose_panel_too_little, area) };
    theme::heading(ui, &title);
    for (p, told) in list.iter().take(ROWS) {
        let (area, surface) = (fixed(told.area_cm2, 2), id(told.surface));
        let why = told.sentence_with(&Naming::of(context.document.job()));
        let text = say!(dose_panel_patch, area, surface, why);
        if ui.link(RichText::new(text).small()).on_hover_text(say!(dose_panel_show)).clicked() {
            actions.reveal(p.surface);
            actions.look_at(p.centre, p.area_mm2.sqrt().max(2.0));
        }
    }
    if list.len() > ROWS {
        ui.label(RichText::new(say!(dose_panel_smaller, count = list.len() - ROWS)).small());
    }
}

/// What lands on surfaces that are not to be cleaned.
pub(super) fn collateral(ui: &mut egui::Ui, view: &DoseView, actions: &mut Actions) {
    if view.report.collateral.is_empty() {
        return;
    }
    theme::heading(ui, &say!(dose_panel_beside, area = fixed(view.report.collateral_mm2, 1)));
    let over = say!(dose_panel_beside_over, dose = j_cm2(view.report.collateral_j_cm2));
    ui.label(RichText::new(over).small());
    for c in view.report.collateral.iter().take(ROWS) {
        let (surface, area) = (id(c.surface), fixed(c.area_mm2, 1));
        let text = say!(dose_panel_beside_surface, surface, area, dose = j_cm2(c.greatest_j_cm2));
        if ui.link(RichText::new(text).small()).on_hover_text(say!(dose_panel_show)).clicked() {
            actions.reveal(c.surface);
            actions.focus(c.surface);
        }
    }
}
