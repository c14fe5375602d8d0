//! The status line: what is being done, what was found, what was said last.

use super::super::{App, theme};
use crate::planning::report::{Grade, grouped};
use crate::program::Timeline;
use crate::progress::{Activity, Progress};
use crate::text::{Sentence as _, fixed, say};
use eframe::egui::{self, ProgressBar, RichText};
use std::time::Duration;

/// Progress is shown anew after this time.
const SHOWN_AGAIN: Duration = Duration::from_millis(100);

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

    /// What is left out, and what is proven of the moves with the laser on.
    fn standing(&self, ui: &mut egui::Ui) {
        // Of what is out of date nothing is called proven.
        let Some(report) = self.plan().map(|of| &of.report) else { return };
        let (Some(standing), Some(proof)) = (report.standing(), &report.proof) else { return };
        let color = match standing.grade {
            Grade::Unproven | Grade::Nothing => theme::WRONG,
            Grade::LeftOut => theme::ATTENTION,
            Grade::Free => theme::ACCENT,
        };
        let label = ui.label(RichText::new(standing.text).color(color));
        if proof.proven > 0 {
            let margin = if proof.margin_mm > 0.0 { format!(", by {:.2} mm", proof.margin_mm) } else { String::new() };
            let least = report.min_clearance_mm.map_or_else(String::new, |mm| format!(", least clearance {mm:.2} mm"));
            let moves = grouped(proof.proven);
            label.on_hover_text(format!("On {moves} moves with the laser on nothing can be touched{margin}{least}"));
        }
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
                ui.label(format!("{} passes · {} targets", grouped(r.passes), grouped(r.points)));
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
