//! The bar above the view: what the view shows, and what the next click in it does.

use super::super::actions::Actions;
use super::super::command::{Command, Toggle};
use super::super::context::Context;
use super::super::session::PointerTool;
use super::menu::told_why;
use crate::text::say;
use eframe::egui::{self, RichText};

/// Below this the toggles would fill more than two lines: they go into a menu.
const NARROW: f32 = 480.0;

const TOGGLES: [Toggle; 8] = [
    Toggle::PathLines,
    Toggle::PoseFrames,
    Toggle::Beams,
    Toggle::ConnectingMoves,
    Toggle::BeforeCorrection,
    Toggle::SectionPlane,
    Toggle::HideChosen,
    Toggle::PlainPart,
];

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    egui::Frame::new().inner_margin(4).fill(ui.visuals().panel_fill).show(ui, |ui| {
        ui.horizontal_wrapped(|ui| {
            let width = ui.available_width();
            ui.set_min_width(width);
            if width < NARROW {
                let menu = ui.menu_button(say!(toolbar_show), |ui| toggles(ui, context, actions));
                menu.response.on_hover_text(say!(toolbar_show_tip));
            } else {
                toggles(ui, context, actions);
            }
            let what = match context.session.tool {
                PointerTool::Select => return,
                PointerTool::PickOrigin => say!(toolbar_pick_origin),
                PointerTool::LayFlat => say!(toolbar_lay_flat),
            };
            ui.label(RichText::new(what).color(ui.visuals().warn_fg_color));
        });
    });
}

fn toggles(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let of_scan = [Toggle::Scan, Toggle::DeviationOnModel, Toggle::ScanSection];
    let of_scan = of_scan.into_iter().filter(|_| context.document.job().scan.is_there());
    let of_weld = [Toggle::WeldImages, Toggle::WeldPoints].into_iter().filter(|_| context.has_weld());
    for command in TOGGLES.into_iter().chain(of_scan).chain(of_weld).map(Command::Toggle) {
        let button = egui::Button::selectable(context.is_shown(command), command.name());
        let response = told_why(ui.add_enabled(context.is_enabled(command), button), command, context);
        if response.on_hover_text(command.keys_text(ui.ctx())).clicked() {
            actions.command(command);
        }
    }
}
