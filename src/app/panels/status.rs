//! The status line: what is being done, what was found, what was said last.

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use crate::planning::PlannedJob;
use crate::planning::report::{Grade, Severity};
use crate::program::Timeline;
use crate::text::{Naming, Sentence as _, clock, fixed, notice_line, say};
use eframe::egui::{self, ProgressBar, RichText};
use std::time::Duration;

/// How often the progress is shown anew.
const SHOWN_AGAIN: Duration = Duration::from_millis(100);

/// Findings that are shown on hover, at most.
const WORST: usize = 3;

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    ui.horizontal(|ui| {
        progress(ui, context, actions);
        plan(ui, context);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.add(egui::Label::new(RichText::new(&context.session.said).weak()).truncate());
        });
    });
}

fn progress(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some((activity, share)) = context.progress() else { return };
    let text = say!(progress, activity = activity.sentence(), percent = fixed(f64::from(share) * 100.0, 0));
    ui.add(ProgressBar::new(share).desired_width(190.0).text(text));
    if ui.small_button(say!(status_cancel)).clicked() {
        actions.command(Command::Cancel);
    }
    // The work goes on while the hand is still.
    ui.ctx().request_repaint_after(SHOWN_AGAIN);
}

/// The newest plan in figures; it may be out of date, and says so.
fn plan(ui: &mut egui::Ui, context: Context<'_>) {
    let Some(report) = context.derived.plan().map(|of| &of.report) else { return };
    plan_status(ui, context);
    ui.label(say!(status_size, passes = report.passes, targets = report.points));
    if report.corrected > 0 {
        let text = say!(status_corrected, count = report.corrected);
        ui.label(RichText::new(text).color(ui.visuals().warn_fg_color));
    }
    let time_s = context.timeline().map_or(report.time_s, Timeline::total_s);
    ui.label(say!(status_work, length_mm = fixed(report.work_mm, 1), time = clock(time_s)));
    if context.derived.is_plan_out_of_date(context.document) {
        let text = RichText::new(say!(status_out_of_date)).color(ui.visuals().warn_fg_color);
        ui.label(text).on_hover_text(say!(status_out_of_date_tip));
    }
}

/// What is not proven and what is left out, then what is proven; the worst of it on hover. Of what is out of date
/// nothing is called proven.
fn plan_status(ui: &mut egui::Ui, context: Context<'_>) {
    let Some(of) = context.plan() else { return };
    let Some(status) = of.report.status() else { return };
    let visuals = ui.visuals();
    let color = match status.grade() {
        Grade::Unproven | Grade::Nothing => visuals.error_fg_color,
        Grade::LeftOut => visuals.warn_fg_color,
        Grade::Free => visuals.hyperlink_color,
    };
    ui.label(RichText::new(status.sentence()).color(color)).on_hover_ui(|ui| {
        ui.label(worst(of).join("\n"));
    });
}

/// The worst findings with what helps, then what the moves with the laser on keep clear.
fn worst(of: &PlannedJob) -> Vec<String> {
    let (report, naming) = (&of.report, Naming::of(&of.job));
    let mut lines: Vec<String> = of
        .notices
        .iter()
        .filter(|notice| notice.severity() <= Severity::NotDone)
        .take(WORST)
        .map(|notice| notice_line(notice, &naming))
        .collect();
    if let Some(proof) = report.proof.as_ref().filter(|p| p.proven > 0) {
        let mut line = match proof.margin_mm > 0.0 {
            true => say!(status_proven_by, moves = proof.proven, margin_mm = fixed(proof.margin_mm, 2)),
            false => say!(status_proven, moves = proof.proven),
        };
        if let Some(mm) = report.min_clearance_mm {
            line = say!(status_with_clearance, line, clearance_mm = fixed(mm, 2));
        }
        lines.push(line);
    }
    lines
}
