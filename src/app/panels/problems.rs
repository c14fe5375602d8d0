//! What is blocked or missed, grouped by surface and by what is in the way; a click goes there.

use super::super::{App, theme};
use crate::part::SurfaceId;
use crate::path::Strategy;
use crate::planning::advice::Help;
use crate::planning::remark::Remark;
use crate::planning::report::{Notice, Problem};
use crate::text::{NamedSentence as _, Naming, Sentence as _};
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
        (Some(surface), Some(facet)) => format!("the beam hits surface {surface} (facet {facet})"),
        _ => "the beam hits something".into(),
    }
}

/// What became of targets for a cause.
fn refused(cause: &str) -> &str {
    match cause {
        "robot" => "refused: the arm or the part would hit something",
        "head" => "refused: the head would be hit",
        "obstacle" => "refused: an obstacle would be hit",
        "reach" => "refused: out of the robot's reach",
        "limit" => "refused: a joint would leave its limits",
        "speed" => "refused: a joint would be too fast",
        "singularity" => "refused: the arm would be singular",
        _ => "blocked",
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
            theme::heading(ui, "Problems");
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
            _ if self.plan().is_none() => "Problems: out of date".into(),
            0 => "Problems: none".into(),
            count => format!("Problems ({count})"),
        };
        theme::heading(ui, &title);
        for ((surface, _, by), list) in &groups {
            let row = report.surfaces.iter().find(|s| s.surface == *surface);
            let text = match (list[0].pass, by, row) {
                (None, _, Some(row)) => {
                    let why = if self.is_by_planes(*surface) { "planes; try direction auto" } else { "lines" };
                    format!("surface {surface}: {:.1} mm² missed by the {why}", row.missed_area_mm2)
                }
                (_, Some(by), _) => {
                    let ours = if list[0].cause.word() == "head" { ", which the head would hit" } else { "" };
                    format!("surface {surface}: {} targets blocked by surface {by}{ours}", list.len())
                }
                _ => format!("surface {surface}: {} targets {}", list.len(), refused(list[0].cause.word())),
            };
            let why = list[0].why.as_ref().map_or_else(String::new, |why| format!("{}\n", why.sentence()));
            let color = if list[0].pass.is_none() { theme::ATTENTION } else { theme::WRONG };
            let link = ui.add(egui::Button::new(RichText::new(text).color(color)).frame(false).wrap());
            if link.on_hover_text(format!("{why}Go there")).clicked() {
                self.go_to(list[0], plan);
            }
        }
        for (surface, remark) in remarks {
            let notice = Notice::Remark { surface, remark };
            let text = RichText::new(notice.sentence_with(&naming)).color(theme::ATTENTION);
            if ui.add(egui::Button::new(text).frame(false).wrap()).on_hover_text("Show it").clicked() {
                self.session.selected = [surface.0].into();
                self.session.scroll_to = Some(surface.0);
                self.focus_surface(surface.0);
            }
        }
        self.what_would_help(ui);
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
        theme::heading(ui, "What would help");
        match self.advice() {
            None => {
                ui.label(RichText::new("looking for what would help…").weak());
            }
            Some(Err(_)) => {
                ui.label(RichText::new("the search was cancelled; Ctrl+R plans and looks again").weak());
            }
            Some(Ok([])) => {
                let text = "No single change that was tried; look for a better set-up, under Cell";
                ui.label(RichText::new(text).weak());
            }
            Some(Ok(list)) => {
                for help in list {
                    let text = match help {
                        Help::Sampled { .. } => RichText::new(help.sentence()).small().weak(),
                        _ => RichText::new(format!("• {}", capital(&help.sentence()))),
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
        found.next().map_or_else(|| "left out".into(), because)
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
