//! The two lists of P1 Fig. 3: *Feature surfaces*, and *To clean* in the order of work; and what moves surfaces between
//! them.

mod row;
mod rows;
mod table;

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use super::super::theme;
use super::later;
use super::menu::told_why;
use crate::document::Edit;
use crate::part::SurfaceId;
use crate::text::say;
use eframe::egui::{self, RichText, Role, WidgetInfo};

/// Surfaces that are dragged from one list to the other.
struct Dragged {
    surfaces: Vec<SurfaceId>,
    from_clean: bool,
}

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    // The hover of this frame is set by the rows and by the view, which is drawn after.
    if context.session.hovered.is_some() {
        actions.session(|s| s.hovered = None);
    }
    let later = later::height(context);
    let height = ui.available_height() - later;
    list(ui, false, (height - 150.0) * 0.55, context, actions);
    between_lists(ui, context, actions);
    list(ui, true, ui.available_height() - later, context, actions);
    later::ui(ui, context, actions);
}

fn list(ui: &mut egui::Ui, is_clean: bool, height: f32, context: Context<'_>, actions: &mut Actions) {
    let rows = if is_clean { context.rows_to_clean() } else { context.rows_left() };
    let whole = if is_clean { context.clean_list().len() } else { context.not_to_clean().len() };
    theme::heading(ui, &if is_clean { say!(lists_to_clean) } else { say!(lists_feature_surfaces) });
    ui.horizontal(|ui| {
        filter(ui, is_clean, context, actions);
        ui.label(RichText::new(say!(lists_shown, shown = rows.len(), whole)).weak());
    });
    let (_, dropped) = ui.dnd_drop_zone::<Dragged, _>(egui::Frame::group(ui.style()), |ui| {
        let table = rows::List { rows: &rows, is_clean, context };
        ui.push_id(("list", is_clean), |ui| table.ui(ui, height - 90.0, actions));
    });
    if let Some(dragged) = dropped.filter(|_| !context.is_told_what_to_work()) {
        actions.edit(match (dragged.from_clean, is_clean) {
            // From the list itself: to the end of the order.
            (_, true) => Edit::Clean(dragged.surfaces.clone()),
            (true, false) => Edit::Unclean(dragged.surfaces.clone()),
            (false, false) => return,
        });
    }
}

fn filter(ui: &mut egui::Ui, is_clean: bool, context: Context<'_>, actions: &mut Actions) {
    let index = usize::from(is_clean);
    let mut text = context.session.filter[index].clone();
    let told = || if is_clean { say!(lists_filter_clean) } else { say!(lists_filter_surfaces) };
    let edit = egui::TextEdit::singleline(&mut text).hint_text(say!(lists_filter)).desired_width(120.0);
    let response = ui.add(edit);
    response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, told()));
    if response.changed() {
        actions.session(move |s| s.filter[index] = text);
    }
}

fn between_lists(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        let buttons = [
            (say!(lists_clean), Command::Clean),
            (say!(lists_back), Command::Unclean),
            (say!(lists_earlier), Command::CleanEarlier),
            (say!(lists_later), Command::CleanLater),
        ];
        for (text, command) in buttons {
            let tip = format!("{}  {}", command.name(), command.keys_text(ui.ctx()));
            let response = ui.add_enabled(context.is_enabled(command), egui::Button::new(text)).on_hover_text(tip);
            if told_why(response, command, context).clicked() {
                actions.command(command);
            }
        }
    });
}
