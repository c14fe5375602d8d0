//! The empty window: drop a part, open a sample, or go on with a recent job.

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use crate::sample::SAMPLES;
use crate::text::{about_sample, say};
use eframe::egui::{self, RichText, vec2};
use std::path::Path;

/// Width of a picture, points.
const WIDTH: f32 = 150.0;

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    ui.vertical_centered(|ui| {
        ui.add_space((ui.available_height() * 0.16).max(20.0));
        ui.label(RichText::new(say!(start_name)).size(34.0).strong());
        ui.add_space(4.0);
        ui.label(RichText::new(say!(start_claim)).size(16.0).weak());
        ui.add_space(22.0);
        let frame = egui::Frame::group(ui.style()).inner_margin(26);
        frame.show(ui, |ui| {
            ui.set_width(460.0);
            ui.vertical_centered(|ui| {
                ui.label(RichText::new(say!(start_drop)).size(20.0));
                ui.add_space(6.0);
                if ui.button(RichText::new(say!(start_open)).size(16.0)).clicked() {
                    actions.command(Command::Open);
                }
                if ui.button(Command::OpenWeld.name()).clicked() {
                    actions.command(Command::OpenWeld);
                }
            });
        });
        ui.add_space(14.0);
        ui.label(RichText::new(say!(start_steps)).size(14.0));
        ui.add_space(8.0);
        let tour = egui::Button::new(RichText::new(say!(start_tour)).size(14.5));
        if ui.add(tour).on_hover_text(say!(start_tour_tip)).clicked() {
            actions.tour();
        }
        ui.add_space(12.0);
        ui.label(RichText::new(say!(start_samples)).strong());
        for s in SAMPLES {
            if ui.link(s.name.replace('_', " ")).on_hover_text(about_sample(s.part)).clicked() {
                actions.sample(s.name);
            }
        }
        recent(ui, context, actions);
    });
}

/// Files that were opened or saved last, with the view as it was when they were left.
fn recent(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    if context.recent.is_empty() {
        return;
    }
    ui.add_space(12.0);
    ui.label(RichText::new(say!(start_recent)).strong());
    let mut opened = None;
    egui::ScrollArea::horizontal().id_salt("recent").show(ui, |ui| {
        ui.horizontal_top(|ui| {
            let gap = ui.spacing().item_spacing.x;
            let all = context.recent.len() as f32 * (WIDTH + gap) - gap;
            ui.add_space(((ui.available_width() - all) * 0.5).max(0.0));
            for path in context.recent {
                ui.vertical(|ui| {
                    ui.set_width(WIDTH);
                    if row(ui, path, context) {
                        opened = Some(path.clone());
                    }
                });
            }
        });
    });
    if let Some(path) = opened {
        actions.open(path);
    }
}

/// A file with its picture, if there is one; whether it was clicked.
fn row(ui: &mut egui::Ui, path: &Path, context: Context<'_>) -> bool {
    let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    if context.thumbnails.of(path).is_none() {
        // As high as a picture, so that the names stand in a row.
        let (rect, _) = ui.allocate_exact_size(vec2(WIDTH, WIDTH * 2.0 / 3.0), egui::Sense::hover());
        ui.painter().rect_filled(rect, 4, ui.visuals().faint_bg_color);
    }
    let picture = context.thumbnails.of(path).is_some_and(|texture| {
        let image = egui::Image::new(texture).max_width(WIDTH).corner_radius(4).sense(egui::Sense::click());
        let response = ui.add(image).on_hover_text(path.display().to_string());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, say!(start_picture, file = &name)));
        response.clicked()
    });
    ui.add(egui::Link::new(&name)).on_hover_text(path.display().to_string()).clicked() || picture
}
