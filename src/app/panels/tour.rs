//! The guided tour, in a corner of the view: what to do next, and the ways on and out.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::theme;
use super::super::tour::state::{Tour, TourStep};
use crate::text::say;
use eframe::egui::{self, Align2, Color32, Id, RichText, vec2};

/// What is to be done in a step.
fn words(step: TourStep) -> String {
    match step {
        TourStep::Turn => say!(tour_turn),
        TourStep::Choose => say!(tour_choose),
        TourStep::Space => say!(tour_space),
        TourStep::Watch => say!(tour_watch),
        TourStep::Robot => say!(tour_robot),
        TourStep::Export => say!(tour_export),
        TourStep::Done => say!(tour_done),
    }
}

pub(in super::super) fn ui(ctx: &egui::Context, context: Context<'_>, actions: &mut Actions) {
    let Some(Tour { step, .. }) = context.session.tour.as_ref() else { return };
    let (step, last) = (*step, TourStep::ALL.len() - 1);
    let at = TourStep::ALL.iter().position(|s| *s == step).unwrap_or(0);
    let area = egui::Window::new(say!(tour_title)).id(Id::unique("tour")).collapsible(false).resizable(false);
    area.anchor(Align2::CENTER_BOTTOM, vec2(0.0, -150.0)).show(ctx, |ui| {
        ui.set_width(380.0);
        if step != TourStep::Done {
            ui.label(RichText::new(say!(tour_step, step = at + 1, of = last)).weak());
        }
        ui.label(words(step));
        ui.add_space(4.0);
        ui.horizontal(|ui| {
            let end = if step == TourStep::Done { say!(tour_close) } else { say!(tour_end) };
            let button = match step {
                TourStep::Done => egui::Button::new(RichText::new(end).color(Color32::WHITE)).fill(theme::ACCENT),
                _ => egui::Button::new(end),
            };
            if ui.add(button).clicked() {
                actions.session(|s| s.tour = None);
            }
        });
    });
}
