//! The questions as small windows: what is asked, and a button for each answer.

use super::super::App;
use super::super::dialogs::Purpose;
use super::super::questions::Question;
use crate::document::journal::LeftBehind;
use crate::document::{CarriedOver, IfChanged};
use crate::planning::export::FileConflict;
use crate::text::{Sentence, carried_lines, hour_and_minute, say};
use eframe::egui::{self, Id, Modal, RichText, ScrollArea};
use std::path::Path;
use std::time::{SystemTime, UNIX_EPOCH};

/// What was answered.
enum Answer {
    UsePart,
    OtherFile,
    Restore(usize),
    Discard(usize),
    Overwrite,
    SaveAs,
    Reload,
    OtherFolder,
    Cancel,
}

impl App {
    /// The question that waits, if there is one.
    pub(in super::super) fn questions(&mut self, ctx: &egui::Context) {
        // A file is being picked or read for it.
        if !self.answers.is_empty() || self.reading.is_looking() {
            return;
        }
        let Some(question) = &self.question else { return };
        let mut answer = None;
        let shown = Modal::new(Id::unique("question")).show(ctx, |ui| {
            ui.set_width(520.0);
            answer = match question {
                Question::PartChanged { looked, .. } => part_changed(ui, &looked.file, looked.carried.as_deref()),
                Question::PartGone { file, .. } => part_gone(ui, file),
                Question::Restore(found) => restore(ui, found),
                Question::SaveOver(path) => save_over(ui, path, self.document.file() == Some(path)),
                Question::ExportOver { dir, conflicts } => export_over(ui, dir, conflicts),
            };
        });
        if let Some(answer) = answer.or(shown.should_close().then_some(Answer::Cancel)) {
            self.answered(answer);
        }
    }

    fn answered(&mut self, answer: Answer) {
        // A file that is still to be picked leaves the question open.
        if let Answer::OtherFile = answer {
            self.ask_for_part();
            return;
        }
        match (answer, self.question.take()) {
            (Answer::UsePart, Some(Question::PartChanged { looked, opening })) => self.use_part(looked, opening),
            (Answer::Cancel, Some(Question::PartChanged { looked, opening: None })) => self.keep_part(&looked),
            (Answer::Restore(at), Some(Question::Restore(mut found))) if at < found.leftovers.len() => {
                // The others wait for the next start.
                let leftover = found.leftovers.remove(at);
                self.restore(leftover);
            }
            (Answer::Discard(at), Some(Question::Restore(mut found))) if at < found.leftovers.len() => {
                if let Err(why) = found.leftovers.remove(at).discard() {
                    self.session.error = Some(why.sentence());
                }
                self.question = (!found.leftovers.is_empty()).then_some(Question::Restore(found));
            }
            (Answer::Overwrite, Some(Question::SaveOver(path))) => self.save_into(path, IfChanged::Overwrite),
            (Answer::SaveAs, _) => self.ask(Purpose::SaveJob),
            (Answer::Reload, Some(Question::SaveOver(path))) => self.open(path),
            (Answer::Overwrite, Some(Question::ExportOver { dir, .. })) => self.export(dir, true),
            (Answer::OtherFolder, _) => self.ask(Purpose::Export),
            _ => self.session.after_guard = None,
        }
    }
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}

fn buttons(ui: &mut egui::Ui, rows: Vec<(String, Answer)>) -> Option<Answer> {
    ui.add_space(8.0);
    let mut answer = None;
    ui.horizontal(|ui| {
        for (at, (text, own)) in rows.into_iter().enumerate() {
            let text = if at == 0 { RichText::new(text).strong() } else { RichText::new(text) };
            if ui.button(text).clicked() {
                answer = Some(own);
            }
        }
    });
    answer
}

fn part_changed(ui: &mut egui::Ui, file: &Path, carried: Option<&CarriedOver>) -> Option<Answer> {
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
        (say!(ask_part_use), Answer::UsePart),
        (say!(ask_part_other), Answer::OtherFile),
        (say!(ask_cancel), Answer::Cancel),
    ];
    buttons(ui, rows)
}

fn part_gone(ui: &mut egui::Ui, file: &Path) -> Option<Answer> {
    ui.heading(say!(ask_part_gone));
    ui.label(say!(ask_part_gone_file, file = shown(file)));
    buttons(ui, vec![(say!(ask_part_other), Answer::OtherFile), (say!(ask_cancel), Answer::Cancel)])
}

fn restore(ui: &mut egui::Ui, found: &LeftBehind) -> Option<Answer> {
    ui.heading(say!(ask_restore));
    ui.label(say!(ask_restore_why));
    ui.add_space(4.0);
    let mut answer = None;
    for (at, leftover) in found.leftovers.iter().enumerate() {
        let job = leftover.job_file().map_or_else(|| say!(ask_restore_not_saved), shown);
        ui.separator();
        ui.label(RichText::new(leftover.part_name()).strong());
        ui.label(say!(ask_restore_row, job, when = when(leftover.edited_s())));
        ui.horizontal(|ui| {
            if ui.button(say!(ask_restore_yes)).clicked() {
                answer = Some(Answer::Restore(at));
            }
            if ui.button(say!(ask_restore_no)).clicked() {
                answer = Some(Answer::Discard(at));
            }
        });
    }
    ui.separator();
    answer.or(buttons(ui, vec![(say!(ask_restore_later), Answer::Cancel)]))
}

fn save_over(ui: &mut egui::Ui, path: &Path, is_own: bool) -> Option<Answer> {
    if is_own {
        ui.heading(say!(ask_job_changed));
        ui.label(say!(ask_job_changed_file, file = shown(path)));
        ui.label(RichText::new(say!(ask_backup)).weak());
        let rows = vec![
            (say!(ask_save_as), Answer::SaveAs),
            (say!(ask_overwrite), Answer::Overwrite),
            (say!(ask_reload), Answer::Reload),
            (say!(ask_cancel), Answer::Cancel),
        ];
        return buttons(ui, rows);
    }
    ui.heading(say!(ask_job_exists));
    ui.label(say!(ask_job_exists_file, file = shown(path)));
    ui.label(RichText::new(say!(ask_backup)).weak());
    let rows = vec![
        (say!(ask_save_as), Answer::SaveAs),
        (say!(ask_overwrite), Answer::Overwrite),
        (say!(ask_cancel), Answer::Cancel),
    ];
    buttons(ui, rows)
}

fn export_over(ui: &mut egui::Ui, dir: &Path, conflicts: &[FileConflict]) -> Option<Answer> {
    ui.heading(say!(ask_export_over));
    ui.label(say!(ask_export_over_folder, folder = shown(dir)));
    ScrollArea::vertical().max_height(200.0).show(ui, |ui| {
        for conflict in conflicts {
            ui.label(say!(ask_export_over_file, conflict = conflict.sentence()));
        }
    });
    let mut rows = vec![(say!(ask_export_other), Answer::OtherFolder)];
    if conflicts.iter().all(FileConflict::can_be_overwritten) {
        rows.push((say!(ask_overwrite), Answer::Overwrite));
    }
    rows.push((say!(ask_cancel), Answer::Cancel));
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
