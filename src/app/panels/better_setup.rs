//! A proposed set-up, over the view that previews it: how many targets it makes possible, its frames, Apply and Dismiss.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::suggestion_search::{BetterSetupPreview, OUT_OF_REACH, WITHIN};
use super::super::theme;
use super::frames;
use crate::cell::Mount;
use crate::text::{fixed, say};
use eframe::egui::{self, RichText};

/// A share as whole per cent; 100 stands only for all of it.
fn percent(share: f64) -> String {
    fixed((100.0 * share + 1e-9).floor(), 0)
}

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let is_better_setup_sought = context.derived.suggestions.is_better_setup_sought();
    let (better, none_found) = (context.better_setup(), context.has_no_better_setup());
    if !is_better_setup_sought && better.is_none() && !none_found {
        return;
    }
    egui::Frame::new().inner_margin(6).fill(ui.visuals().extreme_bg_color).show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        if is_better_setup_sought {
            ui.horizontal(|ui| {
                ui.spinner();
                ui.label(say!(proposal_looking)).on_hover_text(say!(proposal_cancel_tip));
            });
            return;
        }
        if none_found {
            ui.label(RichText::new(say!(proposal_none)).strong());
        }
        if let Some(better) = better {
            frames_of_better_setup(ui, better);
            if context.is_in_cell() {
                ui.label(RichText::new(say!(proposal_shown)).weak());
            }
        }
        answer(ui, better.is_some(), actions);
    });
}

fn frames_of_better_setup(ui: &mut egui::Ui, p: &BetterSetupPreview) {
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
}

/// Apply and Dismiss; where nothing was found, Dismiss alone.
fn answer(ui: &mut egui::Ui, there: bool, actions: &mut Actions) {
    ui.horizontal_wrapped(|ui| {
        if there {
            let apply = egui::Button::new(RichText::new(say!(proposal_apply)).strong());
            let apply = apply.fill(theme::ACCENT.gamma_multiply(0.6));
            if ui.add(apply).on_hover_text(say!(proposal_apply_tip)).clicked() {
                actions.apply_better_setup();
            }
        }
        if ui.button(say!(proposal_dismiss)).on_hover_text(say!(proposal_dismiss_tip)).clicked() {
            actions.dismiss_better_setup();
        }
        // What the dots of the preview mean.
        let legend = [(say!(proposal_within_reach), WITHIN), (say!(proposal_out_of_reach), OUT_OF_REACH)];
        for (word, color) in legend.into_iter().filter(|_| there) {
            ui.add_space(8.0);
            theme::swatch(ui, color);
            ui.label(word);
        }
    });
}
