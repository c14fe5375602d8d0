//! The panel of the job, group by group: lines, beam and tool, recipes, targets, surfaces, part, dose, cell.

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use super::super::theme;
use super::entry::{Entry, refused};
use super::menu::told_why;
use super::{beam, cell, export, library, lines, numbers, placement, recipe, scan, weld};
use crate::document::parameter::Group;
use crate::document::{Edit, Parameter};
use crate::pose::Correction;
use crate::text::{choices, say};
use eframe::egui;

/// What a grinding tool has of the beam's numbers.
const SPEEDS: [&Parameter; 2] = [Parameter::named("beam.speed_mm_s"), Parameter::named("beam.air_speed_mm_s")];

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    // Always in sight: what is wrong, and what all the rest is for.
    egui::Panel::bottom("export").show(ui, |ui| export::ui(ui, context, actions));
    egui::ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
        // A scan tells what is worked, and is what one looks at first; without one it is rarely asked for.
        let has_scan = context.document.job().scan.is_there();
        let has_weld = context.has_weld();
        if has_weld {
            weld::ui(ui, context, actions);
        }
        if has_scan {
            scan::ui(ui, context, actions);
        }
        if has_weld {
            // Its strategies stand with the weld, and without light speeds are what is left of the beam.
            theme::heading(ui, &say!(laying_heading));
            numbers::of_job(ui, Group::Spacing, context, actions);
            theme::heading(ui, &say!(parameters_speed));
            numbers::chosen_of_job(ui, SPEEDS, context, actions);
            beam::clamps(ui, context, actions);
        } else {
            lines::ui(ui, context, actions);
            theme::heading(ui, &say!(parameters_beam));
            numbers::of_job(ui, Group::Beam, context, actions);
            correction(ui, context, actions);
            beam::ui(ui, context, actions);
        }
        recipe::ui(ui, context, actions);
        library::ui(ui, context, actions);
        egui::CollapsingHeader::new(say!(parameters_targets)).id_salt("targets").show(ui, |ui| {
            numbers::of_job(ui, Group::Targets, context, actions);
        });
        theme::heading(ui, &say!(parameters_surfaces));
        numbers::of_job(ui, Group::Crease, context, actions);
        egui::CollapsingHeader::new(say!(parameters_more_surfaces)).id_salt("more on surfaces").show(ui, |ui| {
            numbers::of_job(ui, Group::Islands, context, actions);
            split(ui, context, actions);
        });
        egui::CollapsingHeader::new(say!(parameters_part))
            .id_salt("part")
            .show(ui, |ui| placement::ui(ui, context, actions));
        if !has_scan {
            scan::ui(ui, context, actions);
        }
        if !has_weld {
            weld::ui(ui, context, actions);
            beam::dose::ui(ui, context, actions);
        }
        cell::ui(ui, context, actions);
    });
}

fn correction(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let now = context.document.job().path.correction;
    ui.horizontal(|ui| {
        let label = theme::name(ui, &say!(parameters_correction), 130.0);
        label.on_hover_text(say!(parameters_correction_tip));
        for c in Correction::ALL {
            let button = ui.selectable_label(now == c, choices::correction(c));
            let told = || say!(parameters_correction_name, correction = choices::correction(c));
            button.widget_info(|| egui::WidgetInfo::selected(egui::Role::RadioButton, true, now == c, told()));
            if button.clicked() {
                actions.edit(Edit::Correction(c));
            }
        }
    });
}

/// Splits the selected surface at an angle.
fn split(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let row = ui.horizontal(|ui| {
        let button = egui::Button::new(say!(parameters_split));
        let response = ui.add_enabled(context.is_enabled(Command::Split), button);
        if told_why(response, Command::Split, context).clicked() {
            actions.command(Command::Split);
        }
        let mut angle_deg = context.session.split_angle_deg;
        let drawn = Entry::new(0.1..=180.0, say!(unit_deg)).show(ui, &mut angle_deg);
        let told = || say!(parameters_split_angle);
        drawn.response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, told()));
        if drawn.response.changed() {
            actions.session(move |s| s.split_angle_deg = angle_deg);
        }
        drawn
    });
    refused(ui, [&row.inner]);
}
