//! Changes that give lines to a surface which has none, as buttons below what is said of it.

use super::super::super::actions::Actions;
use super::super::super::theme;
use crate::planning::PlannedJob;
use crate::planning::report::Notice;
use crate::text::{NamedSentence as _, Naming, Sentence as _};
use eframe::egui;

/// The buttons of a finding; each change stands below the surface that it was sought for.
pub(super) fn ui(ui: &mut egui::Ui, notice: &Notice, of: &PlannedJob, actions: &mut Actions) {
    let Notice::NoLines { surface, .. } = notice else { return };
    for cure in of.cures.iter().filter(|cure| cure.surfaces.first() == Some(surface)) {
        let tip = theme::capital(&cure.sentence_with(&Naming::of(&of.job)));
        if ui.button(theme::capital(&cure.change.sentence())).on_hover_text(tip).clicked() {
            actions.edit(cure.edit.clone());
        }
    }
}
