//! The bead of a recipe, with ways back to the job's.

use super::super::fields::{self, Change, Owner};
use super::super::numbers;
use super::fill::fill;
use super::group::{LEAST_MM, header, laid};
use super::section::bead_section;
use crate::document::parameter::Group;
use crate::document::{Job, Parameter, Recipe};
use eframe::egui;

const LAYERS: &Parameter = Parameter::named("bead.layers");

/// The group; `own`: the job with the recipe. Changes the recipe, and says what was changed.
pub(in super::super) fn ui(ui: &mut egui::Ui, job: &Job, own: &Job, recipe: &mut Recipe) -> Option<&'static str> {
    let mut what = None;
    header(Owner::Recipe, own).show(ui, |ui| {
        let is_own = Parameter::of_group(Group::BeadSize).any(|p| recipe.values.contains_key(p.key));
        if let Some(change) = laid(ui, Owner::Recipe, own, is_own.then_some(job)) {
            take_laid(change, job, own, recipe);
            what = Some("recipe bead");
        }
        if own.section_of_bead().is_none() {
            return;
        }
        for p in Parameter::of_group(Group::BeadSize) {
            // To half a bead there is no way back.
            let can_go_back = recipe.values.contains_key(p.key) && job.section_of_bead().is_some();
            let to = can_go_back.then(|| job.number(p));
            match fields::number_from(ui, Owner::Recipe, p, LEAST_MM, own.number(p), to) {
                Some(Change::To(mm)) => recipe.values.insert(p.key.into(), mm),
                Some(Change::Back) => recipe.values.remove(p.key),
                None => continue,
            };
            what = Some(p.key);
        }
        for p in Parameter::of_group(Group::BeadLayers) {
            what = numbers::of_recipe(ui, job, own, recipe, p).or(what);
        }
        bead_section(ui, Owner::Recipe, own);
        if let Some((key, mm)) = fill(ui, Owner::Recipe, own) {
            recipe.values.insert(key.into(), mm);
            what = Some("recipe bead");
        }
    });
    what
}

/// Makes the recipe lay a bead, lay none, or do as the job does.
fn take_laid(change: Change<bool>, job: &Job, own: &Job, recipe: &mut Recipe) {
    match change {
        Change::To(on) => {
            let with = Job { bead: own.bead.with_bead(on, own.beam.spot_mm), ..own.clone() };
            for p in Parameter::of_group(Group::BeadSize) {
                recipe.values.insert(p.key.into(), with.number(p));
            }
            // No layers of nothing, the job's among them.
            if with.bead.layers != own.bead.layers {
                recipe.values.insert(LAYERS.key.into(), with.number(LAYERS));
            }
        }
        Change::Back => {
            for p in Parameter::of_group(Group::BeadSize) {
                recipe.values.remove(p.key);
            }
            if job.section_of_bead().is_none() {
                recipe.values.remove(LAYERS.key);
            }
        }
    }
}
