//! Borders and centres that single surfaces have of their own, and the way back to those of recipe or job.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::theme;
use super::fields::{NAMES, Owner, back};
use crate::document::Edit;
use crate::part::SurfaceId;
use crate::path::Strategy;
use crate::text::{Sentence as _, choices, id as number, say};
use eframe::egui::{self, RichText};

/// Surfaces that are listed, at most.
const TOLD: usize = 6;

/// What single surfaces start from, as far as their strategies ask for it; it is set by a right click on them.
pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let job = context.document.job();
    let told = |id: SurfaceId| {
        let (own, strategy) = (job.settings.of(id), job.of_surface(id).layers.strategy);
        match strategy {
            Strategy::Offset => own.border.map(|b| (b.sentence(), Edit::SurfaceBorder(id, None))),
            Strategy::Spiral => own.centre_mm.map(|at| (choices::place(at), Edit::SurfaceCentre(id, None))),
            Strategy::Planes | Strategy::Adaptive | Strategy::Cross => None,
        }
    };
    let having = job.settings.having(|s| s.border.is_some() || s.centre_mm.is_some());
    let rows: Vec<_> = having.into_iter().filter_map(|id| Some((id, told(id)?))).collect();
    for (id, (text, edit)) in rows.iter().take(TOLD) {
        ui.horizontal(|ui| {
            theme::name(ui, &say!(own_from, surface = number(id)), NAMES);
            ui.label(text).on_hover_text(say!(own_tip));
            if back(ui, Owner::Surface, &say!(own_start, surface = number(id)), "") {
                actions.edit(edit.clone());
            }
        });
    }
    if rows.len() > TOLD {
        ui.label(RichText::new(say!(own_more, count = rows.len() - TOLD)).small());
    }
}
