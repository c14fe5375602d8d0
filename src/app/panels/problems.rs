//! What is blocked or missed, grouped by surface and by what is in the way; a click goes there.

use super::super::{App, Command, Toggle, theme};
use crate::part::SurfaceId;
use crate::path::Strategy;
use crate::planning::advice::Help;
use crate::planning::remark::Remark;
use crate::planning::report::{NotDone, Notice, Problem};
use crate::text::{NamedSentence as _, Naming, Sentence as _, fixed, id, left_out, say};
use crate::view::Bounds;
use eframe::egui::{self, RichText};
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Why a target is not done, as people say it.
fn because(problem: &Problem) -> String {
    if let Some(why) = &problem.why {
        return why.sentence();
    }
    match (problem.by_surface, problem.by_facet) {
        (Some(surface), Some(facet)) => say!(problems_beam_hits, surface = id(surface), facet = id(facet)),
        _ => say!(problems_beam_hits_something),
    }
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
            groups.entry((p.surface, p.cause.word(), p.by_surface)).or_default().push(p);
        }
        let naming = Naming::of(&of.job);
        let remarks: Vec<(SurfaceId, Remark)> = plan.remarks().collect();
        let title = match groups.len() + remarks.len() {
            // Those of a plan that is out of date say nothing of the one to come.
            _ if self.plan().is_none() => say!(problems_out_of_date),
            0 => say!(problems_none),
            count => say!(problems_count, count),
        };
        theme::heading(ui, &title);
        for ((surface, _, by), list) in &groups {
            let row = report.surfaces.iter().find(|s| s.surface == *surface);
            let text = match (list[0].cause, row) {
                (NotDone::Blocked(cause), _) => {
                    let by = by.map(|n| naming.surface(SurfaceId(n)));
                    left_out(&naming.surface(SurfaceId(*surface)), cause, by, list.len())
                }
                (NotDone::Missed, row) => self.missed(*surface, row.map_or(0.0, |row| row.missed_area_mm2)),
            };
            let tip = match &list[0].why {
                Some(why) => say!(problems_why_and_go, why = why.sentence()),
                None => say!(problems_go),
            };
            let color = if list[0].pass.is_none() { theme::ATTENTION } else { theme::WRONG };
            let link = ui.add(egui::Button::new(RichText::new(text).color(color)).frame(false).wrap());
            if link.on_hover_text(tip).clicked() {
                self.go_to(list[0], plan);
            }
        }
        for (surface, remark) in remarks {
            let notice = Notice::Remark { surface, remark };
            let text = RichText::new(notice.sentence_with(&naming)).color(theme::ATTENTION);
            if ui.add(egui::Button::new(text).frame(false).wrap()).on_hover_text(say!(problems_show)).clicked() {
                self.session.selected = [surface.0].into();
                self.session.scroll_to = Some(surface.0);
                self.focus_surface(surface.0);
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
                let keys = Command::Plan.keys_text(ui.ctx());
                ui.label(RichText::new(say!(problems_help_cancelled, keys)).weak());
            }
            Some(Ok([])) => {
                ui.label(RichText::new(say!(problems_help_none)).weak());
            }
            Some(Ok(list)) => {
                for help in list {
                    let text = match help {
                        Help::Sampled { .. } => RichText::new(help.sentence()).small().weak(),
                        _ => RichText::new(say!(problems_help_row, advice = capital(&help.sentence()))),
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
        self.session.show.set(Toggle::SectionPlane, false);
        if let Some(t) = plan.passes.get(pass).and_then(|p| p.targets.get(point)) {
            // Wide enough to see the beam and what it hits.
            let reach = Vector3::repeat(self.document.job().beam.defocus_mm.abs().max(10.0));
            let p = self.scene_from_part() * t.p;
            self.viewport.fit(Bounds { min: p - reach, max: p + reach });
        }
    }
}
