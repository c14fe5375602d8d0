//! The passes: what each grinds down to, what those before left, and the images after the next one. A pass that waits for
//! the operator's word says so here.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::dialogs::Purpose;
use super::super::super::theme;
use super::super::numbers;
use crate::document::WeldEdit;
use crate::document::parameter::Group;
use crate::planning::welded::GroundPassReport;
use crate::text::{Sentence as _, fixed, id, say};
use crate::weld::passes::GrindingPass;
use eframe::egui::{self, Grid, RichText, ScrollArea};

/// The table of passes is as high as this before it scrolls.
const TABLE: f32 = 150.0;

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some(report) = context.weld.report() else { return };
    theme::heading(ui, &say!(weld_panel_passes));
    numbers::of_job(ui, Group::WeldPasses, context, actions);
    let goes_on = context.document.job().weld.goes_on;
    if let Some(held) = &report.held {
        ui.label(RichText::new(theme::capital(&held.sentence())).color(ui.visuals().error_fg_color));
        if ui.button(say!(weld_panel_go_on)).on_hover_text(say!(weld_panel_go_on_tip)).clicked() {
            actions.grind(WeldEdit::GoesOn(true));
        }
    } else if goes_on {
        ui.label(RichText::new(say!(weld_panel_goes_on)).color(ui.visuals().warn_fg_color));
        if ui.button(say!(weld_panel_hold)).clicked() {
            actions.grind(WeldEdit::GoesOn(false));
        }
    }
    if !report.schedule.is_empty() {
        ui.label(say!(weld_panel_passes_left, passes = report.schedule.len()));
        schedule(ui, &report.schedule);
    }
    if !report.history.is_empty() {
        ui.label(say!(weld_panel_history));
        history(ui, &report.history);
    }
    let can = context.planned_height_mm().is_some();
    let next = ui.add_enabled(can, egui::Button::new(say!(weld_panel_next_images)));
    let next = next.on_hover_text(say!(weld_panel_next_images_tip));
    if next.on_disabled_hover_text(say!(weld_panel_no_next_images)).clicked() {
        actions.ask(Purpose::NextGray);
    }
}

/// Each pass: the height that it grinds down to, what it takes off, and the area that is left above.
fn schedule(ui: &mut egui::Ui, passes: &[GrindingPass]) {
    ScrollArea::vertical().id_salt("passes of the weld").max_height(TABLE).show(ui, |ui| {
        let head = [say!(weld_panel_pass), say!(weld_panel_level), say!(weld_panel_infeed), say!(weld_panel_left_area)];
        table(
            ui,
            "schedule",
            head,
            passes
                .iter()
                .enumerate()
                .map(|(i, p)| [id_text(i), fixed(p.level_mm, 2), fixed(p.infeed_mm, 2), fixed(p.area_mm2, 0)]),
        );
    });
}

/// Each pass that was ground: the height before it, the planned one and the measured one after.
fn history(ui: &mut egui::Ui, passes: &[GroundPassReport]) {
    let head = [say!(weld_panel_pass), say!(weld_panel_before), say!(weld_panel_planned), say!(weld_panel_left)];
    table(
        ui,
        "history",
        head,
        passes
            .iter()
            .enumerate()
            .map(|(i, p)| [id_text(i), fixed(p.before_mm, 2), fixed(p.planned_mm, 2), fixed(p.left_mm, 2)]),
    );
}

fn id_text(at: usize) -> String {
    say!(weld_panel_number, number = id(at + 1))
}

fn table(ui: &mut egui::Ui, key: &str, head: [String; 4], rows: impl Iterator<Item = [String; 4]>) {
    Grid::new(("passes of the weld", key)).striped(true).spacing([14.0, 3.0]).show(ui, |ui| {
        for title in head {
            ui.label(RichText::new(title).strong());
        }
        ui.end_row();
        for row in rows {
            for cell in row {
                ui.label(cell);
            }
            ui.end_row();
        }
    });
}
