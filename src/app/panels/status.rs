//! The status line: what is being done, what was found, what was said last.

use super::super::{App, theme};
use crate::planning::PlannedJob;
use crate::planning::report::{Grade, Severity, first_things_first};
use crate::program::Timeline;
use crate::progress::{Activity, Progress};
use crate::text::{Naming, Sentence as _, fixed, grouped, notice_line, say};
use eframe::egui::{self, ProgressBar, RichText};
use std::time::Duration;

/// Progress is shown anew after this time.
const SHOWN_AGAIN: Duration = Duration::from_millis(100);

/// Findings that are told on hover.
const WORST: usize = 3;

/// The worst findings with what helps, then what the moves with the laser on keep clear.
fn worst(of: &PlannedJob) -> Vec<String> {
    let (report, naming) = (&of.report, Naming::of(&of.job));
    let mut lines: Vec<String> = first_things_first(report, &of.job, &[])
        .iter()
        .filter(|notice| notice.severity() <= Severity::NotDone)
        .take(WORST)
        .map(|notice| notice_line(notice, &naming))
        .collect();
    if let Some(proof) = report.proof.as_ref().filter(|p| p.proven > 0) {
        let margin = if proof.margin_mm > 0.0 { format!(", by {:.2} mm", proof.margin_mm) } else { String::new() };
        let least = report.min_clearance_mm.map_or_else(String::new, |mm| format!(", least clearance {mm:.2} mm"));
        let moves = grouped(proof.proven as u64);
        lines.push(format!("On {moves} moves with the laser on nothing can be touched{margin}{least}"));
    }
    lines
}

impl App {
    /// What can be cancelled, and its share done: planning, else a search for what would help.
    pub(in super::super) fn progress(&self) -> Option<(Activity, f32)> {
        let planning = self.derived.pipeline.progress();
        let works = [planning, self.exporting.progress(), self.search(), self.dose_progress()];
        works.into_iter().flatten().find_map(Progress::now)
    }

    /// Ends that.
    pub(in super::super) fn cancel(&mut self) {
        if self.derived.pipeline.progress().is_some() {
            self.derived.pipeline.cancel();
        } else if self.exporting.is_running() {
            self.exporting.cancel();
        } else if self.search().is_some() {
            self.end_search();
        } else {
            self.derived.dose.cancel();
        }
    }

    /// What is not proven and what is left out, then what is proven; the worst of it on hover.
    fn standing(&self, ui: &mut egui::Ui) {
        // Of what is out of date nothing is called proven.
        let Some(of) = self.plan() else { return };
        let Some(standing) = of.report.standing() else { return };
        let color = match standing.grade() {
            Grade::Unproven | Grade::Nothing => theme::WRONG,
            Grade::LeftOut => theme::ATTENTION,
            Grade::Free => theme::ACCENT,
        };
        let label = ui.label(RichText::new(standing.sentence()).color(color));
        label.on_hover_ui(|ui| {
            ui.label(worst(of).join("\n"));
        });
    }

    pub(in super::super) fn status(&mut self, ui: &mut egui::Ui) {
        ui.horizontal(|ui| {
            if let Some((activity, share)) = self.progress() {
                let text = say!(progress, activity = activity.sentence(), percent = fixed(f64::from(share) * 100.0, 0));
                ui.add(ProgressBar::new(share).desired_width(190.0).text(text));
                if ui.small_button("Cancel").clicked() {
                    self.cancel();
                }
                // The work goes on while the hand is still.
                ui.ctx().request_repaint_after(SHOWN_AGAIN);
            }
            if let Some(report) = self.derived.plan().map(|of| &of.report) {
                let r = report;
                let time_s = self.timeline().map_or(r.time_s, Timeline::total_s);
                self.standing(ui);
                ui.label(format!("{} passes · {} targets", grouped(r.passes as u64), grouped(r.points as u64)));
                if r.corrected > 0 {
                    ui.label(RichText::new(format!("{} corrected", r.corrected)).color(theme::ATTENTION));
                }
                ui.label(format!("{:.1} mm · {}", r.work_mm, super::clock(time_s)));
                if !self.derived.is_current(&self.document) {
                    ui.label(RichText::new("out of date").color(theme::ATTENTION)).on_hover_text("Ctrl+R plans again");
                }
            }
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                ui.add(egui::Label::new(RichText::new(&self.session.said).weak()).truncate());
            });
        });
    }
}
