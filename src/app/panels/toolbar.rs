//! The bar above the view: what the view shows, and what the next click in it does.

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use super::super::session::PointerTool;
use super::super::toggle::Toggle;
use super::menu::{tip, told_why};
use crate::text::say;
use eframe::egui::{self, RichText};

/// Below this the toggles would fill more than two lines: they go into a menu.
const NARROW: f32 = 480.0;

const TOGGLES: [Toggle; 9] = [
    Toggle::PathLines,
    Toggle::PoseFrames,
    Toggle::Beams,
    Toggle::ConnectingMoves,
    Toggle::BeforeCorrection,
    Toggle::SectionPlane,
    Toggle::HideChosen,
    Toggle::PlainPart,
    Toggle::Cut,
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
            if context.session.show.is_on(Toggle::Cut) {
                cut(ui, context, actions);
            }
            let what = match context.session.tool {
                PointerTool::Select => return,
                PointerTool::PickOrigin => say!(toolbar_pick_origin),
                PointerTool::LayFlat => say!(toolbar_lay_flat),
                PointerTool::Measure => say!(toolbar_measure),
                PointerTool::Paint => say!(toolbar_paint),
                PointerTool::PutClamp(_) => say!(toolbar_put_clamp),
            };
            ui.label(RichText::new(what).color(ui.visuals().warn_fg_color));
        });
    });
}

/// Across which axis the part is cut, where, and which side stays.
fn cut(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let (now, mut cut) = (context.session.cut, context.session.cut);
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let button = ui.selectable_label(cut.axis == axis, name);
        let told = || say!(toolbar_cut_axis, axis = name);
        button.widget_info(|| egui::WidgetInfo::selected(egui::Role::RadioButton, true, now.axis == axis, told()));
        if button.clicked() {
            cut.axis = axis;
        }
    }
    ui.spacing_mut().slider_width = 110.0;
    let slider = ui.add(egui::Slider::new(&mut cut.share, 0.0..=1.0).show_value(false));
    slider.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Slider, true, say!(toolbar_cut_place)));
    if ui.selectable_label(cut.is_flipped, say!(toolbar_cut_other)).clicked() {
        cut.is_flipped = !cut.is_flipped;
    }
    if cut != now {
        actions.session(move |s| s.cut = cut);
    }
}

fn toggles(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let of_scan = [Toggle::Scan, Toggle::DeviationOnModel, Toggle::ScanSection];
    let of_scan = of_scan.into_iter().filter(|_| context.document.job().scan.is_there());
    let of_weld = [Toggle::WeldImages, Toggle::WeldPoints].into_iter().filter(|_| context.has_weld());
    for command in TOGGLES.into_iter().chain(of_scan).chain(of_weld).map(Command::Toggle) {
        let button = egui::Button::selectable(context.is_shown(command), command.name());
        let response = told_why(ui.add_enabled(context.is_enabled(command), button), command, context);
        if response.on_hover_text(tip(command, ui.ctx())).clicked() {
            actions.command(command);
        }
    }
}
