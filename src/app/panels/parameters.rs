//! The settings of the job, in tabs: lines and recipes, beam, part and surfaces, robot, dose, and scan or weld where there
//! is one. Below them stand problems and the export.

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use super::super::shown::Tab;
use super::super::theme;
use super::entry::{Entry, refused};
use super::menu::told_why;
use super::{beam, cell, dose, export, library, lines, lists, numbers, placement, recipe, scan, weld};
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
    tabs(ui, context, actions);
    let tab = context.tab();
    if tab == Tab::Lists {
        lists::ui(ui, context, actions);
        return;
    }
    egui::ScrollArea::vertical().id_salt(tab).auto_shrink([false, false]).show(ui, |ui| match tab {
        Tab::Lists => {}
        Tab::Path => path(ui, context, actions),
        Tab::Beam => of_beam(ui, context, actions),
        Tab::Part => part(ui, context, actions),
        Tab::Robot => cell::ui(ui, context, actions),
        Tab::Dose => {
            beam::dose::ui(ui, context, actions);
            dose::ui(ui, context, actions);
        }
        Tab::Scan => scan::ui(ui, context, actions),
        Tab::Weld => weld::ui(ui, context, actions),
    });
}

fn tabs(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    ui.add_space(2.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        for tab in context.tabs() {
            let is_on = context.tab() == tab;
            let button = ui.add(egui::Button::selectable(is_on, tab.name()));
            let told = || say!(tab_name, tab = tab.name());
            button.widget_info(|| egui::WidgetInfo::selected(egui::Role::Tab, true, is_on, told()));
            if button.clicked() {
                actions.session(move |s| s.tab = Some(tab));
            }
        }
    });
    ui.separator();
}

/// How lines are laid on all surfaces, and by recipes on some.
fn path(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    if context.has_weld() {
        // Its strategies stand with the weld.
        theme::heading(ui, &say!(laying_heading));
        numbers::of_job(ui, Group::Spacing, context, actions);
    } else {
        lines::ui(ui, context, actions);
    }
    recipe::ui(ui, context, actions);
    library::ui(ui, context, actions);
    egui::CollapsingHeader::new(say!(parameters_targets)).id_salt("targets").show(ui, |ui| {
        numbers::of_job(ui, Group::Targets, context, actions);
    });
}

/// Beam and head; of a grinding tool its speeds.
fn of_beam(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    if context.has_weld() {
        theme::heading(ui, &say!(parameters_speed));
        numbers::chosen_of_job(ui, SPEEDS, context, actions);
        beam::clamps(ui, context, actions);
    } else {
        theme::heading(ui, &say!(parameters_beam));
        numbers::of_job(ui, Group::Beam, context, actions);
        correction(ui, context, actions);
        beam::ui(ui, context, actions);
    }
}

/// The part and its surfaces, and what can be measured of it.
fn part(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    theme::heading(ui, &say!(parameters_surfaces));
    numbers::of_job(ui, Group::Crease, context, actions);
    egui::CollapsingHeader::new(say!(parameters_more_surfaces)).id_salt("more on surfaces").show(ui, |ui| {
        numbers::of_job(ui, Group::Islands, context, actions);
        split(ui, context, actions);
    });
    let header = egui::CollapsingHeader::new(say!(parameters_part)).id_salt("part").default_open(true);
    header.show(ui, |ui| placement::ui(ui, context, actions));
    if !context.has_scan() {
        scan::ui(ui, context, actions);
    }
    if !context.has_weld() {
        weld::ui(ui, context, actions);
    }
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
