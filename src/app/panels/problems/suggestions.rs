//! Suggestions: changes that were tried, and make targets possible that the robot refuses. Each is a button, and what it
//! brings stands beside it with how much of it was tried.

use super::super::super::actions::Actions;
use super::super::super::command::Command;
use super::super::super::context::Context;
use super::super::super::theme;
use super::super::menu::told_why;
use crate::planning::PlannedJob;
use crate::planning::advice::Suggestion;
use crate::text::{Sentence as _, say};
use eframe::egui::{self, RichText};

/// Nothing where the robot refuses nothing.
pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
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
            better_setup(ui, context, actions);
        }
        Some(Ok(list)) => {
            let sampled = list.iter().find(|s| matches!(s, Suggestion::Sampled { .. }));
            let sampled = sampled.map(|s| s.sentence()).unwrap_or_default();
            for suggestion in list {
                row(ui, suggestion, &sampled, planned, actions);
            }
            better_setup(ui, context, actions);
        }
    }
}

fn row(ui: &mut egui::Ui, suggestion: &Suggestion, sampled: &str, of: &PlannedJob, actions: &mut Actions) {
    let (name, brings) = match suggestion {
        Suggestion::SetupChange(suggested) => (suggested.change.sentence(), suggested.gains()),
        Suggestion::Slower { .. } => (suggestion.sentence(), String::new()),
        // It stands beside each of the others.
        Suggestion::Sampled { .. } => return,
    };
    match suggestion.edit(&of.job, &of.setup) {
        Some(edit) => {
            let button = ui.add(egui::Button::new(theme::capital(&name)).wrap());
            if button.on_hover_text(say!(problems_help_undo)).clicked() {
                actions.edit(edit);
            }
        }
        None => {
            ui.add(egui::Label::new(theme::capital(&name)).wrap());
        }
    }
    if !brings.is_empty() {
        ui.add(egui::Label::new(RichText::new(format!("{brings} {sampled}").trim_end()).weak()).wrap());
    }
}

/// The search for a better set-up, where single changes are not enough.
fn better_setup(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let command = Command::BetterSetup;
    let button = egui::Button::new(command.name());
    let response = ui.add_enabled(context.is_enabled(command), button).on_hover_text(say!(cell_panel_better_tip));
    if told_why(response, command, context).clicked() {
        actions.command(command);
    }
}
