//! The program as it would be written; the line that is being done is lit and kept in sight.

use super::super::{App, theme};
use crate::text::say;
use eframe::egui::{self, RichText, ScrollArea, Sense, TextStyle};

impl App {
    pub(in super::super) fn program_text(&mut self, ui: &mut egui::Ui) {
        let Some(motion) = self.derived.motion().cloned() else { return };
        let current = motion.current_line(self.session.playback.time_s, self.session.playback.at);
        // The file follows the simulation, until another is looked at.
        let moved = current.is_some() && current != self.session.text_line;
        if let (true, Some((file, _))) = (moved, current) {
            self.session.text_file = file;
        }
        self.session.text_file = self.session.text_file.min(motion.text.len().saturating_sub(1));
        let is_current = self.plan().is_some();
        theme::heading(ui, &if is_current { say!(program_panel_heading) } else { say!(program_panel_out_of_date) });
        let name = motion.text.get(self.session.text_file).map_or("", |f| f.name.as_str());
        if motion.text.len() <= 1 {
            ui.monospace(name);
        } else {
            // A long program has dozens of files.
            ui.horizontal(|ui| {
                let label = ui.label(say!(program_panel_files, count = motion.text.len()));
                let combo = egui::ComboBox::from_id_salt("program file").selected_text(name).show_ui(ui, |ui| {
                    for (number, file) in motion.text.iter().enumerate() {
                        ui.selectable_value(&mut self.session.text_file, number, &file.name);
                    }
                });
                combo.response.labelled_by(label.id);
            });
        }
        let Some(file) = motion.text.get(self.session.text_file) else {
            let why = motion.why_none.clone().unwrap_or_else(|| say!(program_panel_none));
            ui.label(RichText::new(why).color(theme::WRONG));
            return;
        };
        let height = ui.text_style_height(&TextStyle::Monospace);
        let lit = current.filter(|c| c.0 == self.session.text_file).map(|c| c.1);
        let mut area = ScrollArea::both().auto_shrink([false, false]).id_salt(("program", self.session.text_file));
        if let (true, Some(line)) = (moved, lit) {
            let seen = &self.session.text_rows;
            if !(seen.start + 2..seen.end.saturating_sub(2)).contains(&line) {
                let whole = height + ui.spacing().item_spacing.y;
                let middle = 0.4 * ui.available_height();
                area = area.vertical_scroll_offset((line as f32 * whole - middle).max(0.0));
            }
            self.session.text_line = current;
        }
        let mut clicked = None;
        let digits = file.count().to_string().len();
        area.show_rows(ui, height, file.count(), |ui, rows| {
            self.session.text_rows = rows.clone();
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
        if let Some(row) = clicked {
            self.go_to_line((self.session.text_file, row));
        }
    }

    /// Goes to the move that a line is, or the next one after it.
    fn go_to_line(&mut self, place: (usize, usize)) {
        let Some(motion) = self.derived.motion().cloned() else { return };
        let Some(number) = motion.move_of_line(place) else { return };
        match &motion.timeline {
            Some(t) => self.go_to_time(t.stops().get(number).map_or(0.0, |s| s.at_s)),
            None => {
                let target = motion.move_to.iter().find(|(_, n)| **n >= number).map(|(target, _)| *target);
                target.into_iter().for_each(|t| self.go_to_target(t));
            }
        }
    }
}
