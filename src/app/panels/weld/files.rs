//! The files of a weld: its images with the camera, where the camera stood, and the tool.

use super::super::super::actions::Actions;
use super::super::super::command::Command;
use super::super::super::context::Context;
use super::super::super::dialogs::Purpose;
use super::super::super::theme;
use super::super::super::toggle::Toggle;
use crate::document::WeldEdit;
use crate::document::model::WeldFiles;
use crate::text::say;
use eframe::egui::{self, RichText, Role, WidgetInfo};
use std::path::Path;

/// Width of the column of names.
const NAMES: f32 = 76.0;

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let weld = &context.document.job().weld;
    if !weld.is_there() {
        if ui.button(Command::OpenWeld.name()).on_hover_text(say!(weld_panel_open_tip)).clicked() {
            actions.command(Command::OpenWeld);
        }
        return;
    }
    let images = &weld.images;
    let rows = [
        (say!(weld_panel_gray), &images.gray.file),
        (say!(weld_panel_depth), &images.depth.file),
        (say!(weld_panel_camera), &images.camera.file),
    ];
    for (title, file) in rows {
        ui.horizontal(|ui| {
            theme::name(ui, &title, NAMES);
            ui.add(egui::Label::new(name_of(file)).truncate()).on_hover_text(file);
        });
    }
    ui.horizontal_wrapped(|ui| {
        let shows = Command::Toggle(Toggle::WeldImages);
        let button = egui::Button::selectable(context.is_shown(shows), RichText::new(say!(weld_panel_images)).strong());
        let tip = say!(weld_panel_images_tip, keys = shows.keys_text(ui.ctx()));
        if ui.add(button.frame_when_inactive(true)).on_hover_text(tip).clicked() {
            actions.command(shows);
        }
        if ui.button(say!(weld_panel_other)).on_hover_text(say!(weld_panel_open_tip)).clicked() {
            actions.command(Command::OpenWeld);
        }
        // A part that is itself the depth image would stay behind as a file that is none.
        if !context.document.job().is_on_depth_image()
            && ui.button(say!(weld_panel_take_away)).on_hover_text(say!(weld_panel_take_away_tip)).clicked()
        {
            actions.grind(WeldEdit::Images(WeldFiles::default()));
        }
    });
    let hand_eye = [say!(weld_panel_hand_eye), say!(weld_panel_hand_eye_tip), say!(weld_panel_hand_eye_none)];
    if optional(ui, hand_eye, &weld.hand_eye, Purpose::HandEye, actions) {
        actions.grind(WeldEdit::HandEye(String::new()));
    }
    let tool = [say!(weld_panel_tool), say!(weld_panel_tool_tip), say!(weld_panel_tool_none)];
    if optional(ui, tool, &weld.tool, Purpose::GrindingTool, actions) {
        actions.grind(WeldEdit::Tool(String::new()));
    }
}

/// A file that need not be there; whether it is taken away.
fn optional(
    ui: &mut egui::Ui,
    [title, tip, none]: [String; 3],
    file: &str,
    purpose: Purpose,
    actions: &mut Actions,
) -> bool {
    let mut gone = false;
    ui.horizontal(|ui| {
        theme::name(ui, &title, NAMES).on_hover_text(&tip);
        let choose = ui.button(say!(weld_panel_choose)).on_hover_text(&tip);
        choose.widget_info(|| WidgetInfo::labeled(Role::Button, true, say!(weld_panel_choose_name, what = &title)));
        if choose.clicked() {
            actions.ask(purpose);
        }
        if file.is_empty() {
            ui.add(egui::Label::new(RichText::new(&none).weak()).truncate()).on_hover_text(&none);
            return;
        }
        let remove = ui.small_button("×").on_hover_text(say!(weld_panel_remove_name, what = &title));
        remove.widget_info(|| WidgetInfo::labeled(Role::Button, true, say!(weld_panel_remove_name, what = &title)));
        gone = remove.clicked();
        ui.add(egui::Label::new(name_of(file)).truncate()).on_hover_text(file);
    });
    gone
}

fn name_of(file: &str) -> String {
    Path::new(file).file_name().map_or_else(|| file.to_owned(), |n| n.to_string_lossy().into_owned())
}
