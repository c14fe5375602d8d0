//! What is blocked or missed, grouped by surface and by what is in the way; a click goes there.

use super::super::{App, Command, theme};
use crate::part::SurfaceId;
use crate::path::Strategy;
use crate::planning::report::Problem;
use crate::text::{fixed, id, say};
use crate::view::Bounds;
use eframe::egui::{self, RichText};
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Why a target is not done, as people say it.
fn because(problem: &Problem) -> String {
    if let Some(detail) = &problem.detail {
        return detail.clone();
    }
    match (problem.by_surface, problem.by_facet) {
        (Some(surface), Some(facet)) => say!(problems_beam_hits, surface = id(surface), facet = id(facet)),
        _ => say!(problems_beam_hits_something),
    }
}

/// What became of targets for a cause.
fn refused(cause: &str) -> String {
    match cause {
        "robot" => say!(problems_refused_arm),
        "head" => say!(problems_refused_head),
        "obstacle" => say!(problems_refused_obstacle),
        "reach" => say!(problems_refused_reach),
        "limit" => say!(problems_refused_limit),
        "speed" => say!(problems_refused_speed),
        "singularity" => say!(problems_refused_singular),
        _ => say!(problems_blocked),
    }
}

/// Targets of a surface that share a cause, and the surface that is in the way.
fn blocked(surface: u32, cause: &str, by: Option<u32>, count: usize) -> String {
    let surface = id(surface);
    match by.map(id) {
        Some(by) if cause == "head" => say!(problems_head_blocked_by, count, surface, by),
        Some(by) => say!(problems_blocked_by, count, surface, by),
        None => say!(problems_targets, count, surface, why = refused(cause)),
    }
}

/// A remark on how lines lie, with the surface unless it names that itself.
fn remark_on(surface: u32, remark: &str) -> String {
    let names_it = remark.contains(&format!("surface {surface} "));
    if names_it { remark.into() } else { say!(problems_remark, surface = id(surface), remark) }
}

/// As a sentence begins.
fn capital(text: &str) -> String {
    let mut rest = text.chars();
    rest.next().map_or_else(String::new, |first| first.to_uppercase().chain(rest).collect())
}

impl App {
    pub(in super::super) fn problems(&mut self, ui: &mut egui::Ui) {
        if let Some(why) = self.planning_error() {
            theme::heading(ui, &say!(problems_heading));
            ui.label(RichText::new(why).color(theme::WRONG));
            return;
        }
        let Some(of) = self.derived.plan().cloned() else { return };
        let (plan, report) = (&of.plan, &of.report);
        // Neighbouring targets share their cause: one row for a surface and what blocks it.
        let mut groups: BTreeMap<(u32, &str, Option<u32>), Vec<&Problem>> = BTreeMap::new();
        for p in &report.problems {
            groups.entry((p.surface, p.cause, p.by_surface)).or_default().push(p);
        }
        let remarks: Vec<(u32, &str)> = plan.remarks().collect();
        let title = match groups.len() + remarks.len() {
            // Those of a plan that is out of date say nothing of the one to come.
            _ if self.plan().is_none() => say!(problems_out_of_date),
            0 => say!(problems_none),
            count => say!(problems_count, count),
        };
        theme::heading(ui, &title);
        for ((surface, _, by), list) in &groups {
            let row = report.surfaces.iter().find(|s| s.surface == *surface);
            let text = match (list[0].pass, by, row) {
                (None, _, Some(row)) => self.missed(*surface, row.missed_area_mm2),
                (_, by, _) => blocked(*surface, list[0].cause, *by, list.len()),
            };
            let tip = match list[0].detail.as_deref() {
                Some(why) => say!(problems_why_and_go, why),
                None => say!(problems_go),
            };
            let color = if list[0].pass.is_none() { theme::ATTENTION } else { theme::WRONG };
            let link = ui.add(egui::Button::new(RichText::new(text).color(color)).frame(false).wrap());
            if link.on_hover_text(tip).clicked() {
                self.go_to(list[0], plan);
            }
        }
        for (surface, remark) in remarks {
            let text = RichText::new(remark_on(surface, remark)).color(theme::ATTENTION);
            if ui.add(egui::Button::new(text).frame(false).wrap()).on_hover_text(say!(problems_show)).clicked() {
                self.session.selected = [surface].into();
                self.session.scroll_to = Some(surface);
                self.focus_surface(surface);
            }
        }
        self.what_would_help(ui);
    }

    /// Area that no line comes to.
    fn missed(&self, surface: u32, area_mm2: f64) -> String {
        let area = fixed(area_mm2, 1);
        match self.is_by_planes(surface) {
            true => say!(problems_missed_by_planes, surface = id(surface), area),
            false => say!(problems_missed_by_lines, surface = id(surface), area),
        }
    }

    /// Whether a surface's lines are cut by planes, which can be turned.
    fn is_by_planes(&self, surface: u32) -> bool {
        let strategy = self.document.job().of_surface(SurfaceId(surface)).layers.strategy;
        !matches!(strategy, Strategy::Offset | Strategy::Spiral)
    }

    /// Changes that were tried and make refused targets possible.
    fn what_would_help(&self, ui: &mut egui::Ui) {
        if !self.has_refusals() {
            return;
        }
        theme::heading(ui, &say!(problems_help));
        match self.advice() {
            None => {
                ui.label(RichText::new(say!(problems_help_looking)).weak());
            }
            Some(Err(_)) => {
                let keys = super::keys_of(ui.ctx(), Command::Plan);
                ui.label(RichText::new(say!(problems_help_cancelled, keys)).weak());
            }
            Some(Ok([])) => {
                ui.label(RichText::new(say!(problems_help_none)).weak());
            }
            Some(Ok(sentences)) => {
                for sentence in sentences {
                    // What is said in brackets is about the others.
                    let text = match sentence.starts_with('(') {
                        true => RichText::new(sentence).small().weak(),
                        false => RichText::new(say!(problems_help_row, advice = capital(sentence))),
                    };
                    ui.add(egui::Label::new(text).wrap());
                }
            }
        }
    }

    /// Why a target is not done.
    pub(super) fn why_blocked(&self, (pass, point): (usize, usize)) -> String {
        let problems = self.derived.plan().into_iter().flat_map(|of| &of.report.problems);
        let mut found = problems.filter(|p| p.pass == Some(pass) && p.point == Some(point));
        found.next().map_or_else(|| say!(problems_left_out), because)
    }

    /// Shows a problem: its target with the beam, or the surface that is missed.
    fn go_to(&mut self, problem: &Problem, plan: &crate::planning::Plan) {
        self.session.selected = [problem.surface].into();
        self.session.scroll_to = Some(problem.surface);
        let target = problem.pass.zip(problem.point);
        let Some((pass, point)) = target else {
            self.focus_surface(problem.surface);
            return;
        };
        self.go_to_target((pass, point));
        self.session.show.section = false;
        if let Some(t) = plan.passes.get(pass).and_then(|p| p.targets.get(point)) {
            // Wide enough to see the beam and what it hits.
            let reach = Vector3::repeat(self.document.job().beam.defocus_mm.abs().max(10.0));
            let p = self.scene_from_part() * t.p;
            self.viewport.fit(Bounds { min: p - reach, max: p + reach });
        }
    }
}
