//! The questions as small windows: what is asked, and a button for each answer.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::questions::{Question, Reply};
use super::export_page;
use crate::document::CarriedOver;
use crate::document::journal::LeftBehind;
use crate::text::{carried_lines, hour_and_minute, say};
use eframe::egui::{self, Id, Modal, RichText, ScrollArea};
use std::path::Path;
use std::time::{SystemTime, UNIX_EPOCH};

/// The question that waits, if there is one.
pub(in super::super) fn ui(ctx: &egui::Context, context: Context<'_>, actions: &mut Actions) {
    // A file is being picked or read for it.
    if !context.answers.is_empty() || context.reading.is_looking() {
        return;
    }
    let Some(question) = context.question else { return };
    let shown = Modal::new(Id::unique("question")).show(ctx, |ui| {
        ui.set_width((ctx.content_rect().width() - 60.0).clamp(320.0, 540.0));
        match question {
            Question::PartChanged { looked, .. } => part_changed(ui, &looked.file, looked.carried.as_deref()),
            Question::PartGone { file, .. } => part_gone(ui, file),
            Question::Restore(found) => restore(ui, found),
            Question::SaveOver(path) => save_over(ui, path, context.document.file() == Some(path)),
            Question::Export(review) => export_page::ui(ui, review, context, actions),
        }
    });
    if let Some(reply) = shown.inner.or(shown.should_close().then_some(Reply::Cancel)) {
        actions.reply(reply);
    }
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}

fn buttons(ui: &mut egui::Ui, rows: Vec<(String, Reply)>) -> Option<Reply> {
    ui.add_space(8.0);
    let mut reply = None;
    ui.horizontal(|ui| {
        for (at, (text, own)) in rows.into_iter().enumerate() {
            let text = if at == 0 { RichText::new(text).strong() } else { RichText::new(text) };
            if ui.button(text).clicked() {
                reply = Some(own);
            }
        }
    });
    reply
}

fn part_changed(ui: &mut egui::Ui, file: &Path, carried: Option<&CarriedOver>) -> Option<Reply> {
    ui.heading(say!(ask_part_changed));
    ui.label(say!(ask_part_changed_file, file = shown(file)));
    ui.add_space(4.0);
    let carried = carried?;
    let verdict = match (&carried.motion, carried.is_complete()) {
        (Some(_), _) => say!(ask_part_moved),
        (None, true) => say!(ask_part_found),
        (None, false) => say!(ask_part_lost),
    };
    ui.label(RichText::new(verdict).strong());
    ScrollArea::vertical().max_height(220.0).show(ui, |ui| {
        for line in carried_lines(carried) {
            ui.label(line);
        }
    });
    ui.label(RichText::new(say!(ask_part_undo)).weak());
    let rows = vec![
        (say!(ask_part_use), Reply::UsePart),
        (say!(ask_part_other), Reply::OtherFile),
        (say!(ask_cancel), Reply::Cancel),
    ];
    buttons(ui, rows)
}

fn part_gone(ui: &mut egui::Ui, file: &Path) -> Option<Reply> {
    ui.heading(say!(ask_part_gone));
    ui.label(say!(ask_part_gone_file, file = shown(file)));
    buttons(ui, vec![(say!(ask_part_other), Reply::OtherFile), (say!(ask_cancel), Reply::Cancel)])
}

fn restore(ui: &mut egui::Ui, found: &LeftBehind) -> Option<Reply> {
    ui.heading(say!(ask_restore));
    ui.label(say!(ask_restore_why));
    ui.add_space(4.0);
    let mut reply = None;
    for (at, leftover) in found.leftovers.iter().enumerate() {
        let job = leftover.job_file().map_or_else(|| say!(ask_restore_not_saved), shown);
        ui.separator();
        ui.label(RichText::new(leftover.part_name()).strong());
        ui.label(say!(ask_restore_row, job, when = when(leftover.edited_s())));
        ui.horizontal(|ui| {
            if ui.button(say!(ask_restore_yes)).clicked() {
                reply = Some(Reply::Restore(at));
            }
            if ui.button(say!(ask_restore_no)).clicked() {
                reply = Some(Reply::Discard(at));
            }
        });
    }
    ui.separator();
    reply.or(buttons(ui, vec![(say!(ask_restore_later), Reply::Cancel)]))
}

fn save_over(ui: &mut egui::Ui, path: &Path, is_own: bool) -> Option<Reply> {
    if is_own {
        ui.heading(say!(ask_job_changed));
        ui.label(say!(ask_job_changed_file, file = shown(path)));
        ui.label(RichText::new(say!(ask_backup)).weak());
        let rows = vec![
            (say!(ask_save_as), Reply::SaveAs),
            (say!(ask_overwrite), Reply::Overwrite),
            (say!(ask_reload), Reply::Reload),
            (say!(ask_cancel), Reply::Cancel),
        ];
        return buttons(ui, rows);
    }
    ui.heading(say!(ask_job_exists));
    ui.label(say!(ask_job_exists_file, file = shown(path)));
    ui.label(RichText::new(say!(ask_backup)).weak());
    let rows = vec![
        (say!(ask_save_as), Reply::SaveAs),
        (say!(ask_overwrite), Reply::Overwrite),
        (say!(ask_cancel), Reply::Cancel),
    ];
    buttons(ui, rows)
}

/// A time as people say it, and as a clock shows it.
fn when(edited_s: u64) -> String {
    let now_s = SystemTime::now().duration_since(UNIX_EPOCH).map_or(edited_s, |d| d.as_secs());
    let ago_s = now_s.saturating_sub(edited_s);
    let time = hour_and_minute(edited_s);
    match ago_s {
        0..90 => say!(ask_when_now, time),
        90..5400 => say!(ask_when_minutes, count = (ago_s + 30) / 60, time),
        5400..129_600 => say!(ask_when_hours, count = (ago_s + 1800) / 3600, time),
        _ => say!(ask_when_days, count = (ago_s + 43_200) / 86_400, time),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_said_as_it_is_now() {
        let now_s = SystemTime::now().duration_since(UNIX_EPOCH).expect("after 1970").as_secs();
        assert!(when(now_s).starts_with("just now ("));
        assert!(when(now_s - 600).starts_with("10 minutes ago ("));
        assert!(when(now_s - 3 * 3600).starts_with("3 hours ago ("));
        assert!(when(now_s - 4 * 86_400).starts_with("4 days ago ("));
        assert!(when(14 * 3600 + 32 * 60).ends_with("(14:32 UTC)"));
    }
}
