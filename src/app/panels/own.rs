//! Borders and centres that single surfaces have of their own, and the way back to those of recipe or job.

use super::super::{App, theme};
use super::fields::{NAMES, SURFACE, back};
use crate::document::Edit;
use crate::document::recipe_table::place;
use crate::part::SurfaceId;
use crate::path::Strategy;
use crate::text::Sentence;
use eframe::egui::{self, RichText};

/// Surfaces that are told, at most.
const TOLD: usize = 6;

impl App {
    /// What single surfaces start from, as far as their strategies ask for it; it is set by a right click on them.
    pub(super) fn own_starts(&mut self, ui: &mut egui::Ui) {
        let job = self.document.job();
        let told = |id: SurfaceId| {
            let (own, strategy) = (job.settings.of(id), job.of_surface(id).layers.strategy);
            match strategy {
                Strategy::Offset => own.border.map(|b| (b.sentence(), Edit::SurfaceBorder(id, None))),
                Strategy::Spiral => own.centre_mm.map(|at| (place(at), Edit::SurfaceCentre(id, None))),
                Strategy::Planes | Strategy::Adaptive | Strategy::Cross => None,
            }
        };
        let having = job.settings.having(|s| s.border.is_some() || s.centre_mm.is_some());
        let rows: Vec<_> = having.into_iter().filter_map(|id| Some((id, told(id)?))).collect();
        let mut gone = None;
        for (id, (text, edit)) in rows.iter().take(TOLD) {
            ui.horizontal(|ui| {
                theme::name(ui, &format!("Surface {id} from"), NAMES);
                ui.label(text).on_hover_text("Of its own, whatever recipe and job say");
                if back(ui, SURFACE, &format!("start of {id}"), "") {
                    gone = Some(edit.clone());
                }
            });
        }
        if rows.len() > TOLD {
            ui.label(RichText::new(format!("and {} more surfaces of their own", rows.len() - TOLD)).small());
        }
        if let Some(edit) = gone {
            self.edit(edit);
        }
    }
}
