//! A weld that is ground, group by group: its files, the mask, the areas and how they are ground, the bead and its passes,
//! the strategies side by side, roughness. Its images have a window of their own (`images`).

mod areas;
mod bead;
mod canvas;
mod files;
pub(in super::super) mod images;
pub(in super::super) mod legend;
mod mask;
mod passes;
mod roughness;
mod scale;
mod strategy;
mod times;

use super::super::actions::Actions;
use super::super::context::Context;
use crate::document::{Edit, WeldEdit};
use crate::text::say;
use eframe::egui::{self, CollapsingHeader};

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let is_there = context.has_weld();
    let header = CollapsingHeader::new(say!(weld_panel)).id_salt(("weld", is_there)).default_open(is_there);
    header.show(ui, |ui| {
        files::ui(ui, context, actions);
        if !is_there {
            return;
        }
        mask::ui(ui, context, actions);
        areas::ui(ui, context, actions);
        strategy::ui(ui, context, actions);
        passes::ui(ui, context, actions);
        bead::ui(ui, context);
        times::ui(ui, context, actions);
        roughness::ui(ui, context, actions);
    });
}

impl Actions {
    /// Changes the weld, as a step of its own.
    fn grind(&mut self, edit: WeldEdit) {
        self.edit(Edit::Grind(Box::new(edit)));
    }
}
