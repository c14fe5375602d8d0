//! The colours of path lines, over the view: each entry shows and hides what has its colour.

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use super::super::theme;
use super::super::toggle::Toggle;
use crate::picture::palette::{Rgb, state};
use crate::text::say;
use eframe::egui::{self, Area, Id, Rect, RichText, Role, WidgetInfo, vec2};

/// Room that it takes at the lower edge of the view, and of the triad beside it.
const HEIGHT: f32 = 34.0;
const TRIAD: f32 = 96.0;

/// The legend over a view, while lines of a plan are shown.
pub(in super::super) fn ui(ui: &egui::Ui, view: Rect, context: Context<'_>, actions: &mut Actions) {
    let shown = context.path_look();
    let is_there = context.derived.plan_on_part().is_some_and(|of| !of.plan.passes.is_empty());
    if !is_there || !(shown.lines || shown.beams) || view.width() < 440.0 {
        return;
    }
    let at = view.left_bottom() + vec2(TRIAD, -HEIGHT);
    Area::new(Id::unique("path legend")).fixed_pos(at).show(ui.ctx(), |ui| {
        egui::Frame::popup(ui.style()).inner_margin(3).show(ui, |ui| {
            ui.horizontal(|ui| {
                let states = [
                    (say!(timeline_free), state::FREE),
                    (say!(timeline_corrected), state::CORRECTED),
                    (say!(timeline_blocked), state::BLOCKED),
                ];
                for (i, (word, color)) in states.into_iter().enumerate() {
                    if entry(ui, &word, color, !shown.hidden[i]) {
                        actions.session(move |s| s.hidden_states[i] = !s.hidden_states[i]);
                    }
                }
                let air = Command::Toggle(Toggle::ConnectingMoves);
                if entry(ui, &say!(legend_laser_off), state::AIR, context.is_shown(air)) {
                    actions.command(air);
                }
            });
        });
    });
}

/// A colour with its word, struck out while it is hidden; whether it was clicked.
fn entry(ui: &mut egui::Ui, word: &str, color: Rgb, is_shown: bool) -> bool {
    theme::swatch(ui, color);
    let text = if is_shown { RichText::new(word) } else { RichText::new(word).weak().strikethrough() };
    let button = ui.add(egui::Button::new(text).frame(false)).on_hover_text(say!(legend_tip));
    let told = || say!(legend_entry, what = word);
    button.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, is_shown, told()));
    button.clicked()
}
