//! A better set-up over the view that previews it: what it is worth, its frames, Apply and Dismiss.

use super::super::{App, remedy, theme};
use super::frames;
use crate::cell::Mount;
use crate::text::{fixed, say};
use eframe::egui::{self, RichText};

/// A share as whole per cent; 100 is said of all and nothing less.
fn percent(share: f64) -> String {
    fixed((100.0 * share + 1e-9).floor(), 0)
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
                    ui.label(say!(proposal_looking)).on_hover_text(say!(proposal_cancel_tip));
                });
                return;
            }
            if self.has_no_proposal() {
                ui.label(RichText::new(say!(proposal_none)).strong());
            }
            self.proposed_frames(ui);
            self.answer(ui);
        });
    }

    fn proposed_frames(&self, ui: &mut egui::Ui) {
        let Some(p) = self.proposal() else { return };
        let (before, after) = (percent(p.found.share_before), percent(p.found.share_after));
        let [left, refused] = p.refused;
        let text = say!(proposal_worth, left, refused, after, before);
        ui.label(RichText::new(text).strong().size(15.0)).on_hover_text(say!(proposal_worth_tip));
        let held = match p.setup.mount {
            Mount::PartInHand => say!(frames_part_on_flange),
            Mount::ToolInHand => say!(frames_part_in_base),
        };
        let mut rows = vec![(held, &p.found.part)];
        if p.setup.mount == Mount::PartInHand {
            rows.push((say!(frames_laser_in_base), &p.found.base_from_laser));
        }
        for (name, frame) in rows {
            ui.horizontal_wrapped(|ui| {
                theme::name(ui, &name, 130.0);
                ui.monospace(frames::said(frame));
            });
        }
        if self.is_in_cell() {
            ui.label(RichText::new(say!(proposal_shown)).weak());
        }
    }

    fn answer(&mut self, ui: &mut egui::Ui) {
        let there = self.proposal().is_some();
        ui.horizontal_wrapped(|ui| {
            if there {
                let apply = egui::Button::new(RichText::new(say!(proposal_apply)).strong());
                let apply = apply.fill(theme::ACCENT.gamma_multiply(0.6));
                if ui.add(apply).on_hover_text(say!(proposal_apply_tip)).clicked() {
                    self.apply_proposal();
                }
            }
            if ui.button(say!(proposal_dismiss)).on_hover_text(say!(proposal_dismiss_tip)).clicked() {
                self.dismiss_proposal();
            }
            // What the dots of the preview mean.
            let legend =
                [(say!(proposal_within_reach), remedy::WITHIN), (say!(proposal_out_of_reach), remedy::OUT_OF_REACH)];
            for (word, color) in legend.into_iter().filter(|_| there) {
                ui.add_space(8.0);
                theme::swatch(ui, color);
                ui.label(word);
            }
        });
    }
}
