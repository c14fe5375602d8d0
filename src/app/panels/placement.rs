//! How the part's file is read: unit, turn and move, and what was found in the file.

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use super::super::theme;
use super::entry::{Entry, refused};
use super::numbers;
use crate::cell::frame::MOST_TURNS_DEG;
use crate::document::Edit;
use crate::document::job_file::FARTHEST_MM;
use crate::document::parameter::Group;
use crate::part::{PartFinding, Units, Weld};
use crate::text::{Sentence as _, choices, say};
use eframe::egui::{self, RichText};

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    units(ui, context, actions);
    weld(ui, context, actions);
    numbers::of_job(ui, Group::Part, context, actions);
    turn_and_move(ui, context, actions);
    for command in [Command::PickOrigin, Command::LayFlat] {
        if ui.button(command.name()).clicked() {
            actions.command(command);
        }
    }
    if let Some(part) = &context.derived.part {
        for finding in PartFinding::of(part) {
            ui.label(RichText::new(finding.sentence()).small());
        }
    }
}

fn units(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    ui.horizontal(|ui| {
        ui.label(say!(parameters_units));
        for u in Units::ALL {
            if ui.selectable_label(context.document.job().part.units == u, choices::units(u)).clicked() {
                actions.edit(Edit::Units(u));
            }
        }
    });
}

fn weld(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    ui.horizontal(|ui| {
        ui.label(say!(parameters_weld));
        for w in Weld::ALL {
            let chosen = context.document.job().part.weld == w;
            if ui.selectable_label(chosen, choices::weld(w)).on_hover_text(choices::about_weld(w)).clicked() {
                actions.weld(w);
            }
        }
    });
}

fn turn_and_move(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let mut placement = context.document.job().part.placement;
    let mut changed = false;
    let rows = [
        (say!(parameters_turn), say!(unit_deg), MOST_TURNS_DEG, &mut placement.rotation_deg),
        (say!(parameters_move), say!(unit_mm), FARTHEST_MM, &mut placement.translation_mm),
    ];
    for (name, unit, most, values) in rows {
        let mut drawn = Vec::new();
        ui.horizontal(|ui| {
            theme::name(ui, &name, 50.0);
            for (value, axis) in values.iter_mut().zip(["x", "y", "z"]) {
                let shown = Entry::new(-most..=most, unit.clone()).show(ui, value);
                let told = || say!(parameters_place_field, name = &name, axis);
                shown.response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, told()));
                changed |= shown.response.changed();
                drawn.push(shown);
            }
        });
        refused(ui, &drawn);
    }
    if changed {
        actions.drag(Edit::Place(placement), "place");
    }
}
