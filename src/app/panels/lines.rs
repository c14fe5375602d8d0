//! How the job lays lines: the strategy and its settings, rim, joins and passes.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::theme;
use super::entry::{Entry, refused};
use super::fields::{self, Change, NAMES, Owner};
use super::{bead, laying, numbers, own};
use crate::document::parameter::Group;
use crate::document::{Edit, FirstPlane};
use crate::path::Strategy;
use crate::text::say;
use eframe::egui::{self, Role, WidgetInfo};

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    theme::heading(ui, &say!(laying_heading));
    let l = &context.document.job().layers;
    strategy(ui, context, actions);
    own::ui(ui, context, actions);
    numbers::of_job(ui, Group::Spacing, context, actions);
    if let Some(mm) = fields::overlap(ui, Owner::Job, context.document.job()) {
        actions.drag(Edit::Set(fields::SPACING.key, mm), "overlap");
    }
    if matches!(l.strategy, Strategy::Planes | Strategy::Cross) {
        offset(ui, context, actions);
    }
    if let Some(Change::To(order)) = laying::order(ui, Owner::Job, l.strategy, l.order, None) {
        actions.edit(Edit::Order(order));
    }
    egui::CollapsingHeader::new(say!(laying_rim)).id_salt("rim").show(ui, |ui| {
        numbers::of_job(ui, Group::Rim, context, actions);
    });
    bead::job::ui(ui, context, actions);
}

/// The strategy, and the settings that it alone has.
fn strategy(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let l = &context.document.job().layers;
    if let Some(Change::To(s)) = laying::strategy(ui, Owner::Job, l.strategy, None) {
        actions.edit(Edit::Strategy(s));
    }
    let by_planes = matches!(l.strategy, Strategy::Planes | Strategy::Adaptive | Strategy::Cross);
    if by_planes && let Some(Change::To(d)) = laying::direction(ui, Owner::Job, l.direction, None) {
        actions.drag(Edit::Direction(d), "direction");
    }
    match l.strategy {
        Strategy::Cross => numbers::of_job(ui, Group::Cross, context, actions),
        Strategy::Offset => {
            if let Some(Change::To(start)) = laying::border(ui, Owner::Job, l.border.into(), None) {
                actions.drag(Edit::Border(start.border()), "border");
            }
        }
        Strategy::Spiral => {
            if let Some(Change::To(inward)) = laying::inward(ui, Owner::Job, l.inward, None) {
                actions.edit(Edit::Inward(inward));
            }
            if laying::centre(ui, Owner::Job, l.centre_mm, l.centre_mm.is_some()) {
                actions.edit(Edit::Centre(None));
            }
        }
        Strategy::Planes | Strategy::Adaptive => {}
    }
}

/// Where the first plane lies.
fn offset(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let layers = &context.document.job().layers;
    let (now, spacing_mm) = (layers.offset_mm, layers.spacing_mm);
    let mut drawn = None;
    ui.horizontal(|ui| {
        theme::name(ui, &say!(laying_first_plane), NAMES);
        let mut centred = now == FirstPlane::Centred;
        if ui.checkbox(&mut centred, say!(laying_first_plane_centred)).changed() {
            actions.edit(Edit::Offset(if centred {
                FirstPlane::Centred
            } else {
                FirstPlane::FromLowest(0.5 * spacing_mm)
            }));
        }
        if let FirstPlane::FromLowest(mut mm) = now {
            let shown = Entry { speed: 0.01, ..Entry::new(0.0..=spacing_mm, say!(unit_mm)) }.show(ui, &mut mm);
            let response = shown.response.clone().on_hover_text(say!(laying_first_plane_tip));
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, say!(laying_first_plane_name)));
            if response.changed() {
                actions.drag(Edit::Offset(FirstPlane::FromLowest(mm)), "offset");
            }
            drawn = Some(shown);
        }
    });
    refused(ui, &drawn);
}
