//! What people are to know of the plan, the worst first, and what would help; a click goes there.

mod changed_file;
mod cures;
mod suggestions;
mod why;

pub(super) use why::why_left_out;

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::theme;
use super::super::toggle::Toggle;
use super::file_banner;
use crate::planning::PlannedJob;
use crate::planning::report::{NothingReason, Notice, Severity};
use crate::text::{NamedSentence as _, Naming, Sentence as _, example, remedy, say};
use eframe::egui::{self, CollapsingHeader, Color32, RichText, ScrollArea};
use std::mem::discriminant;

/// A window lower than this opens with the problems folded: their number is told, and a click shows them.
const LOW: f32 = 600.0;
/// More problems of one kind than this are folded, but for the first.
const MOST_ALIKE: usize = 5;

pub(in super::super) fn ui(ui: &mut egui::Ui, height: f32, context: Context<'_>, actions: &mut Actions) {
    let (title, color) = title(context, ui.visuals());
    let title = match color {
        Some(color) => RichText::new(title).strong().color(color),
        None => RichText::new(title).strong(),
    };
    let is_high = ui.ctx().content_rect().height() >= LOW;
    let header = CollapsingHeader::new(title).id_salt("problems").default_open(is_high);
    header.show_unindented(ui, |ui| {
        // As high as its text, whatever height the panel had before.
        let area = ScrollArea::vertical().max_height(height).min_scrolled_height(height);
        area.auto_shrink([false, true]).show(ui, |ui| rows(ui, context, actions));
    });
}

/// Whether there are problems and how many, with the colour of the worst.
fn title(context: Context<'_>, visuals: &egui::Visuals) -> (String, Option<Color32>) {
    if context.planning_error().is_some() {
        return (say!(problems_heading), Some(visuals.error_fg_color));
    }
    let Some(of) = context.derived.plan() else {
        let found = context.file_findings().len();
        let title = if found == 0 { say!(problems_none) } else { say!(problems_count, count = found) };
        return (title, None);
    };
    // Those of a plan that is out of date say nothing of the one to come.
    if context.plan().is_none() {
        return (say!(problems_out_of_date), Some(visuals.warn_fg_color));
    }
    let wrong: Vec<&Notice> = rows_of(of).filter(|n| n.severity() != Severity::Found).collect();
    match wrong.first() {
        None => (say!(problems_none), None),
        Some(worst) => (say!(problems_count, count = wrong.len()), color(worst, visuals)),
    }
}

/// That all is left out is told by the rows of what is left out.
fn rows_of(of: &PlannedJob) -> impl Iterator<Item = &Notice> {
    of.notices.iter().filter(|n| !matches!(n, Notice::NothingPlanned(NothingReason::AllBlocked { .. })))
}

fn rows(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    if let Some(why) = context.planning_error() {
        ui.label(RichText::new(why).color(ui.visuals().error_fg_color));
        changed_file::ui(ui, context, actions);
        return;
    }
    let Some(of) = context.derived.plan() else {
        found_in_file(ui, context, actions);
        return;
    };
    let (found, wrong): (Vec<_>, Vec<_>) = rows_of(of).partition(|n| n.severity() == Severity::Found);
    let mut told = |ui: &mut egui::Ui, notice: &Notice| {
        row(ui, notice, of, actions);
        if context.plan().is_some() {
            cures::ui(ui, notice, of, actions);
        }
    };
    for (number, alike) in wrong.chunk_by(|a, b| discriminant(*a) == discriminant(*b)).enumerate() {
        let (shown, more) = alike.split_at(if alike.len() > MOST_ALIKE { MOST_ALIKE - 1 } else { alike.len() });
        shown.iter().for_each(|notice| told(ui, notice));
        if !more.is_empty() {
            let header = CollapsingHeader::new(say!(problems_alike, count = more.len())).id_salt(("alike", number));
            header.show(ui, |ui| more.iter().for_each(|notice| told(ui, notice)));
        }
    }
    suggestions::ui(ui, context, actions);
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
    actions.session(|s| {
        s.show.set(Toggle::SectionPlane, false);
        s.camera_before_section = None;
    });
    if let Some(t) = of.plan.passes.get(pass).and_then(|p| p.targets.get(point)) {
        // Wide enough to see the beam and what it hits.
        actions.look_at(t.p, of.job.beam.defocus_mm.abs().max(10.0));
    }
}
