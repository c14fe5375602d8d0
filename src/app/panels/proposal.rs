//! A better set-up over the view that previews it: what it is worth, its frames, Apply and Dismiss.

use super::super::{App, remedy, theme};
use super::frames;
use crate::cell::Mount;
use eframe::egui::{self, RichText};

/// What the dots of the preview mean.
const LEGEND: [(&str, [u8; 3]); 2] = [("within reach", remedy::WITHIN), ("out of reach", remedy::OUT_OF_REACH)];

/// A share as whole per cent; 100 is said of all and nothing less.
fn percent(share: f64) -> f64 {
    (100.0 * share + 1e-9).floor()
}

impl App {
    pub(in super::super) fn proposal_strip(&mut self, ui: &mut egui::Ui) {
        if !self.is_proposing() && self.proposal().is_none() && !self.has_no_proposal() {
            return;
        }
        egui::Frame::new().inner_margin(6).fill(ui.visuals().extreme_bg_color).show(ui, |ui| {
            ui.set_min_width(ui.available_width());
            if self.is_proposing() {
                ui.horizontal(|ui| {
                    ui.spinner();
                    ui.label("Looking for a better set-up…").on_hover_text("Cancel is in the status line");
                });
                return;
            }
            if self.has_no_proposal() {
                ui.label(RichText::new("No better set-up was found").strong());
            }
            self.proposed_frames(ui);
            self.answer(ui);
        });
    }

    fn proposed_frames(&self, ui: &mut egui::Ui) {
        let Some(p) = self.proposal() else { return };
        let (before, after) = (percent(p.found.share_before), percent(p.found.share_after));
        let [left, refused] = p.refused;
        let text =
            format!("{left} targets refused instead of {refused} · {after} % within reach instead of {before} %");
        ui.label(RichText::new(text).strong().size(15.0)).on_hover_text(
            "The plan was made with these frames to count what is refused; reach was looked at on targets evenly \
             over the work, which the dots show",
        );
        let held = match p.setup.mount {
            Mount::PartInHand => "Part on the flange",
            Mount::ToolInHand => "Part in the base",
        };
        let mut rows = vec![(held, &p.found.part)];
        if p.setup.mount == Mount::PartInHand {
            rows.push(("Laser in the base", &p.found.base_from_laser));
        }
        for (name, frame) in rows {
            ui.horizontal_wrapped(|ui| {
                theme::name(ui, name, 130.0);
                ui.monospace(frames::said(frame));
            });
        }
        if self.is_in_cell() {
            ui.label(RichText::new("The cell is shown as it would stand").weak());
        }
    }

    fn answer(&mut self, ui: &mut egui::Ui) {
        let there = self.proposal().is_some();
        ui.horizontal_wrapped(|ui| {
            if there {
                let apply = egui::Button::new(RichText::new("Apply").strong()).fill(theme::ACCENT.gamma_multiply(0.6));
                let tip = "Writes these frames into the job and plans again; Undo takes them back";
                if ui.add(apply).on_hover_text(tip).clicked() {
                    self.apply_proposal();
                }
            }
            if ui.button("Dismiss").on_hover_text("Esc").clicked() {
                self.dismiss_proposal();
            }
            for (word, color) in LEGEND.into_iter().filter(|_| there) {
                ui.add_space(8.0);
                theme::swatch(ui, color);
                ui.label(word);
            }
        });
    }
}
