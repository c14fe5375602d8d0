//! What the beads of job and recipe have in common: the title of the group, and whether a bead is laid at all.

use super::super::fields::{Change, Owner, back, name};
use crate::document::Job;
use crate::process::bead::Bead;
use crate::text::{exact, say};
use eframe::egui::{self, CollapsingHeader, Role, WidgetInfo};

/// The least width and height that can be set here, mm; the checkbox sets none at all.
pub(super) const LEAST_MM: f64 = 0.01;

/// The group, closed where nothing is laid, and open once something is.
pub(super) fn header(owner: Owner, job: &Job) -> CollapsingHeader {
    let bead = &job.bead;
    let is_laid = job.section_of_bead().is_some();
    let (width, height) = (exact(bead.width_mm), exact(bead.height_mm));
    let title = match job.layer_count() {
        _ if !is_laid => say!(bead_panel_none),
        1 => say!(bead_panel_one_layer, width, height),
        layers => say!(bead_panel_layers, width, height, layers),
    };
    CollapsingHeader::new(title).id_salt((owner, "bead", is_laid)).default_open(is_laid)
}

/// Whether a bead is laid; `to`: the job that a recipe can go back to in this.
pub(super) fn laid(ui: &mut egui::Ui, owner: Owner, job: &Job, to: Option<&Job>) -> Option<Change<bool>> {
    let now = job.section_of_bead().is_some();
    let mut wanted = None;
    ui.horizontal(|ui| {
        name(ui, &say!(bead_panel_metal), to.is_some());
        let mut on = now;
        let check = ui.checkbox(&mut on, say!(bead_panel_lay)).on_hover_text(say!(bead_panel_lay_tip));
        let told = || owner.told(say!(bead_panel_lay));
        check.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, on, told()));
        if check.changed() {
            wanted = Some(Change::To(on));
        }
        if let Some(to) = to {
            let bead = to.section_of_bead();
            let size = |b: Bead| say!(bead_panel_size, width = exact(b.width_mm()), height = exact(b.height_mm()));
            let said = bead.map_or_else(|| say!(bead_panel_back_none), size);
            if back(ui, owner, &say!(bead_panel_name), &said) {
                wanted = Some(Change::Back);
            }
        }
    });
    wanted
}
