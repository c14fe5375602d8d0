//! What people are to know of the plan, the worst first, and what would help; a click goes there.

mod changed_file;
mod cures;
mod suggestions;
mod why;

pub(super) use why::why_left_out;

use super::super::actions::Actions;
use super::super::command::Toggle;
use super::super::context::Context;
use super::super::theme;
use super::file_banner;
use crate::planning::PlannedJob;
use crate::planning::report::{NothingReason, Notice, Severity};
use crate::text::{NamedSentence as _, Naming, Sentence as _, example, remedy, say};
use eframe::egui::{self, Color32, RichText};

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    if let Some(why) = context.planning_error() {
        theme::heading(ui, &say!(problems_heading));
        ui.label(RichText::new(why).color(ui.visuals().error_fg_color));
        changed_file::ui(ui, context, actions);
        return;
    }
    let Some(of) = context.derived.plan() else {
        found_in_file(ui, context, actions);
        return;
    };
    // That all is left out is told by the rows of what is left out.
    let is_row = |n: &&Notice| !matches!(n, Notice::NothingPlanned(NothingReason::AllBlocked { .. }));
    let rows = of.notices.iter().filter(is_row);
    let (found, wrong): (Vec<_>, Vec<_>) = rows.partition(|n| n.severity() == Severity::Found);
    let title = match wrong.len() {
        // Those of a plan that is out of date say nothing of the one to come.
        _ if context.plan().is_none() => say!(problems_out_of_date),
        0 => say!(problems_none),
        count => say!(problems_count, count),
    };
    theme::heading(ui, &title);
    for notice in &wrong {
        row(ui, notice, of, actions);
        if context.plan().is_some() {
            cures::ui(ui, notice, of, actions);
        }
    }
    suggestions::ui(ui, context);
    if !found.is_empty() {
        theme::heading(ui, &say!(problems_found));
        for notice in found {
            row(ui, notice, of, actions);
            if let Notice::InFile(finding) = notice {
                file_banner::of_dismissed(ui, finding, context, actions);
            }
        }
    }
}

/// What is to be known of the part's file while nothing is planned.
fn found_in_file(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let found = context.file_findings();
    if !found.is_empty() {
        theme::heading(ui, &say!(problems_found));
    }
    for finding in &found {
        ui.add(egui::Label::new(finding.sentence()).wrap());
        file_banner::of_dismissed(ui, finding, context, actions);
    }
}

/// A finding, which leads to its place where it has one; what helps is told on hover.
fn row(ui: &mut egui::Ui, notice: &Notice, of: &PlannedJob, actions: &mut Actions) {
    let sentence = notice.sentence_with(&Naming::of(&of.job));
    let text = match color(notice, ui.visuals()) {
        Some(color) => RichText::new(sentence).color(color),
        None => RichText::new(sentence),
    };
    let way = notice.surface().map(|_| match notice {
        Notice::Remark { .. } => say!(problems_show),
        _ => say!(problems_go),
    });
    let tip: Vec<String> = [example(notice), remedy(notice), way].into_iter().flatten().collect();
    let response = match notice.surface() {
        Some(_) => ui.add(egui::Button::new(text).frame(false).wrap()),
        None => ui.add(egui::Label::new(text).wrap()),
    };
    let response = if tip.is_empty() { response } else { response.on_hover_text(tip.join("\n")) };
    if response.clicked() {
        go_to(notice, of, actions);
    }
}

/// `None`: as other text.
fn color(notice: &Notice, visuals: &egui::Visuals) -> Option<Color32> {
    match notice.severity() {
        // What a line misses may be next to nothing.
        Severity::NotDone if matches!(notice, Notice::Missed { .. }) => Some(visuals.warn_fg_color),
        Severity::Unsafe | Severity::NotDone => Some(visuals.error_fg_color),
        Severity::NotAsWanted => Some(visuals.warn_fg_color),
        Severity::Found => None,
    }
}

/// Shows the place of a finding: its target with the beam, or its surface.
fn go_to(notice: &Notice, of: &PlannedJob, actions: &mut Actions) {
    let Some(surface) = notice.surface() else { return };
    actions.reveal(surface.0);
    let Some((pass, point)) = notice.target() else {
        actions.focus(surface.0);
        return;
    };
    actions.go_to_target((pass, point));
    actions.session(|s| s.show.set(Toggle::SectionPlane, false));
    if let Some(t) = of.plan.passes.get(pass).and_then(|p| p.targets.get(point)) {
        // Wide enough to see the beam and what it hits.
        actions.look_at(t.p, of.job.beam.defocus_mm.abs().max(10.0));
    }
}
