//! Suggestions: changes that were tried, and make targets possible that the robot refuses.

use super::super::super::command::Command;
use super::super::super::context::Context;
use super::super::super::theme;
use crate::planning::advice::Suggestion;
use crate::text::{Sentence as _, say};
use eframe::egui::{self, RichText};

/// Nothing where the robot refuses nothing.
pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>) {
    let Some(planned) = context.refusing_plan() else { return };
    theme::heading(ui, &say!(problems_help));
    match context.derived.suggestions.suggestions(planned.key) {
        None => {
            ui.label(RichText::new(say!(problems_help_looking)).weak());
        }
        Some(Err(_)) => {
            let keys = Command::Plan.keys_text(ui.ctx());
            ui.label(RichText::new(say!(problems_help_cancelled, keys)).weak());
        }
        Some(Ok([])) => {
            ui.label(RichText::new(say!(problems_help_none)).weak());
        }
        Some(Ok(list)) => list.iter().for_each(|suggestion| row(ui, suggestion)),
    }
}

fn row(ui: &mut egui::Ui, suggestion: &Suggestion) {
    let text = match suggestion {
        Suggestion::Sampled { .. } => RichText::new(suggestion.sentence()).small().weak(),
        _ => RichText::new(say!(problems_help_row, advice = theme::capital(&suggestion.sentence()))),
    };
    ui.add(egui::Label::new(text).wrap());
}
