//! The page before an export: where the program goes, its size and time, what is not done, what is assumed, and what is
//! replaced.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::questions::{ExportReview, Reply};
use super::super::theme;
use crate::planning::PlannedJob;
use crate::planning::export::FileConflict;
use crate::planning::report::Severity;
use crate::program::Timeline;
use crate::text::{Naming, Sentence as _, assumed, clock, fixed, id, listed, notice_line, say};
use eframe::egui::{self, Color32, Grid, RichText, ScrollArea};

/// Findings that are told one by one, at most.
const TOLD: usize = 8;

/// Draws it; what the operator decided.
pub(super) fn ui(
    ui: &mut egui::Ui,
    review: &ExportReview,
    context: Context<'_>,
    actions: &mut Actions,
) -> Option<Reply> {
    ui.heading(match (context.going_on_from(), review.dry_run) {
        (_, true) => say!(export_page_dry_run),
        (Some(pass), false) => say!(export_page_from_pass, pass = id(pass)),
        (None, false) => say!(export_page_heading),
    });
    let height = (ui.ctx().content_rect().height() - 190.0).clamp(160.0, 460.0);
    ScrollArea::vertical().max_height(height).show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        if let Some(of) = context.plan() {
            figures(ui, review, of, context);
            section(ui, &say!(export_page_not_done), &not_done(of, context));
        }
        let rows = assumed(&review.assumed).into_iter().map(|row| row.join(": ")).collect::<Vec<_>>();
        section(ui, &say!(export_page_assumed), &rows);
        section(ui, &say!(export_page_replaced), &replaced(review));
        conflicts(ui, review);
    });
    let mut writes_page = context.session.writes_page;
    if ui.checkbox(&mut writes_page, say!(cell_panel_page)).on_hover_text(say!(cell_panel_page_tip)).changed() {
        actions.session(move |s| s.writes_page = writes_page);
    }
    buttons(ui, review, context)
}

fn figures(ui: &mut egui::Ui, review: &ExportReview, of: &PlannedJob, context: Context<'_>) {
    let report = &of.report;
    let robot = of.setup.robot.as_ref().map_or_else(|| say!(cell_panel_no_robot), |robot| robot.name.clone());
    let time_s = context.timeline().map_or(report.time_s, Timeline::total_s);
    let rows = [
        (say!(export_page_folder), review.dir.display().to_string()),
        (say!(cell_panel_program_for), of.job.cell.dialect.clone()),
        (say!(cell_panel_robot), robot),
        (say!(export_page_size), say!(status_size, passes = report.passes, targets = report.points)),
        (say!(export_page_time), say!(status_work, length_mm = fixed(report.work_mm, 1), time = clock(time_s))),
    ];
    Grid::new("export figures").num_columns(2).show(ui, |ui| {
        for (name, value) in rows {
            ui.label(RichText::new(name).weak());
            ui.add(egui::Label::new(value).wrap());
            ui.end_row();
        }
    });
}

/// What of the list to clean the program leaves, the worst first, and what was put aside.
fn not_done(of: &PlannedJob, context: Context<'_>) -> Vec<String> {
    let naming = Naming::of(&of.job);
    let worst = of.notices.iter().filter(|notice| notice.severity() <= Severity::NotDone);
    let mut rows: Vec<String> = worst.map(|notice| theme::capital(&notice_line(notice, &naming))).collect();
    if rows.len() > TOLD {
        let more = rows.len() - TOLD;
        rows.truncate(TOLD);
        rows.push(say!(export_page_more, count = more));
    }
    let later = context.later_list().len();
    if later > 0 {
        rows.push(say!(export_page_later, count = later));
    }
    if rows.is_empty() { vec![say!(export_page_all_done)] } else { rows }
}

fn replaced(review: &ExportReview) -> Vec<String> {
    match &review.standing[..] {
        [] => vec![say!(export_page_nothing_replaced)],
        names => vec![listed(names.iter().cloned())],
    }
}

/// What may be replaced only by the operator's word.
fn conflicts(ui: &mut egui::Ui, review: &ExportReview) {
    if review.conflicts.is_empty() {
        return;
    }
    let color = ui.visuals().warn_fg_color;
    ui.label(RichText::new(say!(export_page_conflicts)).color(color));
    for conflict in &review.conflicts {
        ui.label(RichText::new(say!(export_page_row, what = conflict.sentence())).color(color));
    }
}

fn section(ui: &mut egui::Ui, heading: &str, rows: &[String]) {
    theme::heading(ui, heading);
    for row in rows {
        ui.add(egui::Label::new(say!(export_page_row, what = row)).wrap());
    }
}

fn buttons(ui: &mut egui::Ui, review: &ExportReview, context: Context<'_>) -> Option<Reply> {
    ui.add_space(6.0);
    let mut reply = None;
    ui.horizontal(|ui| {
        let text = if review.conflicts.is_empty() { say!(export_page_export) } else { say!(export_page_replace) };
        let why = match context.plan() {
            None => Some(say!(cell_panel_not_planned)),
            _ if !review.conflicts.iter().all(FileConflict::can_be_overwritten) => Some(say!(export_page_folder_there)),
            _ => None,
        };
        let button = egui::Button::new(RichText::new(text).strong().color(Color32::WHITE)).fill(theme::ACCENT);
        let button = ui.add_enabled(why.is_none(), button);
        if button.on_disabled_hover_text(why.unwrap_or_default()).clicked() {
            reply = Some(Reply::Overwrite);
        }
        if ui.button(say!(ask_export_other)).clicked() {
            reply = Some(Reply::OtherFolder);
        }
        if ui.button(say!(ask_cancel)).clicked() {
            reply = Some(Reply::Cancel);
        }
    });
    reply
}
