//! The job's bead.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::fields::{self, Change, Owner, name};
use super::super::numbers;
use super::fill::fill;
use super::group::{LEAST_MM, header, laid};
use super::section::bead_section;
use crate::document::model::BeadParameters;
use crate::document::parameter::Group;
use crate::document::{Edit, Parameter};
use crate::text::say;
use eframe::egui;

/// The group; open where a bead is laid.
pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let job = context.document.job();
    header(Owner::Job, job).show(ui, |ui| {
        if let Some(Change::To(on)) = laid(ui, Owner::Job, job, None) {
            actions.edit(Edit::Bead(job.bead.with_bead(on, job.beam.spot_mm)));
        }
        if job.section_of_bead().is_none() {
            return;
        }
        for p in Parameter::of_group(Group::BeadSize) {
            if let Some(Change::To(mm)) = fields::number_from(ui, Owner::Job, p, LEAST_MM, job.number(p), None) {
                actions.number(p, mm);
            }
        }
        numbers::of_job(ui, Group::BeadLayers, context, actions);
        ui.horizontal(|ui| {
            name(ui, &say!(bead_panel_second), job.bead.alternate);
            let mut alternate = job.bead.alternate;
            let check = ui.checkbox(&mut alternate, say!(bead_panel_across));
            if check.on_hover_text(say!(bead_panel_across_tip)).changed() {
                actions.edit(Edit::Bead(BeadParameters { alternate, ..job.bead.clone() }));
            }
        });
        bead_section(ui, Owner::Job, job);
        if let Some((key, mm)) = fill(ui, Owner::Job, job) {
            actions.edit(Edit::Set(key, mm));
        }
    });
}
