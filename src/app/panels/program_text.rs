//! The program as it would be written; the current line is highlighted and kept in sight.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::playback_data::{PlaybackData, TextFile};
use super::super::program_view::ProgramView;
use super::super::theme;
use crate::text::say;
use eframe::egui::{self, RichText, ScrollArea, Sense, TextStyle};

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some(data) = context.derived.playback_data() else { return };
    let playback = &context.session.playback;
    let current = data.current_line(playback.time_s, playback.at);
    let mut view = context.session.program_view.clone();
    let moved = view.follow(current, data.text.len());
    let is_current = context.plan().is_some();
    theme::heading(ui, &if is_current { say!(program_panel_heading) } else { say!(program_panel_out_of_date) });
    file_choice(ui, &data.text, &mut view.file);
    if let Some(file) = data.text.get(view.file) {
        let lit = current.filter(|c| c.0 == view.file).map(|c| c.1);
        let wanted = lit.filter(|_| moved);
        if let Some(row) = lines(ui, file, lit, wanted, &mut view) {
            go_to_line(data, (view.file, row), actions);
        }
        if wanted.is_some() {
            view.line = current;
        }
    } else {
        let why = data.why_none.clone().unwrap_or_else(|| say!(program_panel_none));
        ui.label(RichText::new(why).color(ui.visuals().error_fg_color));
    }
    if view != context.session.program_view {
        actions.session(|s| s.program_view = view);
    }
}

/// The name of the file, and a choice of others: a long program has dozens.
fn file_choice(ui: &mut egui::Ui, files: &[TextFile], chosen: &mut usize) {
    let name = files.get(*chosen).map_or("", |f| f.name.as_str());
    if files.len() <= 1 {
        ui.monospace(name);
        return;
    }
    ui.horizontal(|ui| {
        let label = ui.label(say!(program_panel_files, count = files.len()));
        let combo = egui::ComboBox::from_id_salt("program file").selected_text(name).show_ui(ui, |ui| {
            for (number, file) in files.iter().enumerate() {
                ui.selectable_value(chosen, number, &file.name);
            }
        });
        combo.response.labelled_by(label.id);
    });
}

/// The lines in sight, one of them highlighted; scrolls to the row that is wanted, and returns the row that was clicked.
fn lines(
    ui: &mut egui::Ui,
    file: &TextFile,
    lit: Option<usize>,
    wanted: Option<usize>,
    view: &mut ProgramView,
) -> Option<usize> {
    let height = ui.text_style_height(&TextStyle::Monospace);
    let mut area = ScrollArea::both().auto_shrink([false, false]).id_salt(("program", view.file));
    if let Some(line) = wanted.filter(|line| !view.shows(*line)) {
        let whole = height + ui.spacing().item_spacing.y;
        let middle = 0.4 * ui.available_height();
        area = area.vertical_scroll_offset((line as f32 * whole - middle).max(0.0));
    }
    let mut clicked = None;
    let digits = file.count().to_string().len();
    area.show_rows(ui, height, file.count(), |ui, rows| {
        view.rows = rows.clone();
        ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
        for row in rows {
            let text = format!("{:>digits$}  {}", row + 1, file.line(row));
            let mut text = RichText::new(text).monospace();
            if lit == Some(row) {
                text = text.strong().background_color(ui.visuals().selection.bg_fill);
            }
            if ui.add(egui::Label::new(text).sense(Sense::click()).selectable(false)).clicked() {
                clicked = Some(row);
            }
        }
    });
    clicked
}

/// Goes to the move that a line is, or the next one after it.
fn go_to_line(data: &PlaybackData, place: (usize, usize), actions: &mut Actions) {
    let Some(number) = data.move_of_line(place) else { return };
    match &data.timeline {
        Some(t) => actions.go_to_time(t.stops().get(number).map_or(0.0, |s| s.at_s)),
        None => {
            let target = data.move_to.iter().find(|(_, n)| **n >= number).map(|(target, _)| *target);
            target.into_iter().for_each(|t| actions.go_to_target(t));
        }
    }
}
