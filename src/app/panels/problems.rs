//! What is blocked or missed, grouped by surface and by what is in the way; a click goes there.

use super::super::{App, theme};
use crate::job::report::Problem;
use crate::view::Bounds;
use eframe::egui::{self, RichText};
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Why a target is not done, as people say it.
pub(super) fn because(problem: &Problem) -> String {
    let what = match problem.cause {
        "beam" => "the beam hits",
        "head" => "the laser head hits",
        "obstacle" => "the arm or its load hits an obstacle",
        "robot" => "the arm would hit itself or the part",
        "reach" => "out of the robot's reach",
        "limit" => "a joint would leave its limits",
        "speed" => "a joint would have to be too fast",
        "singularity" => "too near to a singular pose",
        other => other,
    };
    let by = problem.by_surface.map(|n| format!(" surface {n}")).unwrap_or_default();
    let facet = problem.by_facet.map(|f| format!(" (facet {f})")).unwrap_or_default();
    let rest = if by.is_empty() && what.ends_with("hits") { " something" } else { "" };
    format!("{what}{by}{facet}{rest}")
}

impl App {
    pub(in super::super) fn problems(&mut self, ui: &mut egui::Ui) {
        if let Some((_, why)) = self.derived.plan_error.clone() {
            theme::heading(ui, "Problems");
            ui.label(RichText::new(why).color(theme::WRONG));
            return;
        }
        let Some((plan, report)) = self.derived.plan.clone() else { return };
        // Neighbouring targets share their cause: one row for a surface and what blocks it.
        let mut groups: BTreeMap<(u32, &str, Option<u32>), Vec<&Problem>> = BTreeMap::new();
        for p in &report.problems {
            groups.entry((p.surface, p.cause, p.by_surface)).or_default().push(p);
        }
        let title = if groups.is_empty() { "Problems: none".into() } else { format!("Problems ({})", groups.len()) };
        theme::heading(ui, &title);
        for ((surface, _, by), list) in &groups {
            let row = report.surfaces.iter().find(|s| s.surface == *surface);
            let text = match (list[0].pass, by, row) {
                (None, _, Some(row)) => {
                    format!(
                        "surface {surface}: {:.1} mm² missed by the planes; try direction auto",
                        row.missed_area_mm2
                    )
                }
                (_, Some(by), _) => format!("surface {surface}: {} targets blocked by surface {by}", list.len()),
                _ => format!("surface {surface}: {} targets blocked", list.len()),
            };
            let color = if list[0].pass.is_none() { theme::ATTENTION } else { theme::WRONG };
            let link = ui.add(egui::Button::new(RichText::new(text).color(color)).frame(false).wrap());
            if link.on_hover_text("Go there").clicked() {
                self.go_to(list[0], &plan);
            }
        }
    }

    /// Shows a problem: its target with the beam, or the surface that is missed.
    fn go_to(&mut self, problem: &Problem, plan: &crate::job::Plan) {
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
