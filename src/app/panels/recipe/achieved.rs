//! The spacing that was achieved, and the remarks on the surface's lines.

use super::super::super::context::Context;
use crate::part::SurfaceId;
use crate::text::{Sentence as _, fixed, id, say};
use eframe::egui::{self, RichText};

/// Surfaces whose spacing is shown, at most.
const TOLD: usize = 4;

pub(super) fn ui(ui: &mut egui::Ui, selected: &[SurfaceId], context: Context<'_>) {
    let Some(of) = context.derived.plan() else { return };
    let (plan, job) = (&of.plan, &of.job);
    for s in plan.surfaces.iter().filter(|s| selected.contains(&SurfaceId(s.toolpath.surface))).take(TOLD) {
        let n = SurfaceId(s.toolpath.surface);
        let told = |what: String| match selected.len() {
            0..=1 => what,
            _ => say!(recipe_panel_of_surface, surface = id(n), what),
        };
        if let Some(a) = &s.toolpath.achieved {
            let wanted = job.of_surface(n).layers.spacing_mm;
            let (least, greatest) = (fixed(a.min_mm, 2), fixed(a.max_mm, 2));
            ui.label(told(say!(recipe_panel_spacing, least, greatest, wanted = fixed(wanted, 2))));
        }
        for (_, remark) in plan.remarks().filter(|r| r.0 == n) {
            ui.label(RichText::new(told(remark.sentence())).small().color(ui.visuals().warn_fg_color));
        }
    }
}
