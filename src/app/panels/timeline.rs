//! Stepping through the plan: with a robot over its time, without over passes and points; play, and
//! the numbers of the target.

use super::super::command::Command;
use super::super::{App, theme};
use crate::part::rpy;
use crate::picture::palette::state;
use crate::planning::Plan;
use crate::pose::TargetState;
use crate::program::Timeline;
use crate::text::{clock, fixed, id, say};
use eframe::egui::{self, Color32, RichText, Slider};

impl App {
    pub(in super::super) fn timeline_panel(&mut self, ui: &mut egui::Ui) {
        let Some(of) = self.derived.plan().cloned() else {
            let text = match (self.clean_list().is_empty(), self.planning_error().is_some()) {
                (true, _) => say!(timeline_nothing_chosen),
                (false, true) => say!(timeline_no_plan),
                (false, false) => say!(timeline_planning),
            };
            ui.label(RichText::new(text).weak());
            return;
        };
        let plan = &of.plan;
        let passes = plan.passes.len();
        if passes == 0 {
            ui.label(RichText::new(say!(timeline_no_line)).weak());
            return;
        }
        if self.timeline().is_some() {
            self.time_row(ui);
        } else {
            self.pass_row(ui, plan);
        }
        self.target_numbers(ui);
    }

    /// Play, time, speed, and what the time goes into.
    fn time_row(&mut self, ui: &mut egui::Ui) {
        ui.horizontal(|ui| {
            self.play_button(ui);
            let width = (ui.available_width() - 330.0).max(80.0);
            self.scrub(ui, width);
            let Some(total_s) = self.timeline().map(Timeline::total_s) else { return };
            let text = say!(timeline_times, now = clock(self.session.playback.time_s), total = clock(total_s));
            ui.monospace(RichText::new(text).strong()).on_hover_text(say!(timeline_times_tip));
            self.play_speed(ui);
        });
        let Some(b) = self.timeline().map(Timeline::breakdown) else { return };
        ui.horizontal(|ui| {
            let travel_color = ui.visuals().widgets.inactive.bg_fill;
            let legend = [
                (say!(timeline_work), b.work_s, Some(theme::ACCENT)),
                (say!(timeline_travel), b.travel_s, Some(travel_color)),
                (say!(timeline_waiting), b.waiting_s, None),
            ];
            for (word, seconds, color) in legend {
                if let Some([r, g, b, _]) = color.map(|c| c.to_array()) {
                    theme::swatch(ui, [r, g, b]);
                }
                ui.label(word);
                ui.monospace(clock(seconds));
            }
            let left_out: usize = self.derived.motion().into_iter().flat_map(|m| &m.marks).map(|m| m.count).sum();
            if left_out > 0 {
                let [r, g, b, _] = theme::WRONG.to_array();
                theme::swatch(ui, [r, g, b]);
                ui.label(RichText::new(say!(timeline_left_out, count = left_out)).color(theme::WRONG));
            }
        });
    }

    fn play_button(&mut self, ui: &mut egui::Ui) {
        let text = if self.session.playback.is_playing { say!(timeline_pause) } else { say!(timeline_play) };
        if ui.button(text).on_hover_text(Command::Play.keys_text(ui.ctx())).clicked() {
            self.run(Command::Play);
        }
    }

    fn play_speed(&mut self, ui: &mut egui::Ui) {
        let speed = egui::DragValue::new(&mut self.session.playback.speed)
            .range(0.1..=20.0)
            .speed(0.05)
            .prefix(say!(timeline_speed_prefix));
        ui.add(speed)
            .on_hover_text(say!(timeline_speed_tip))
            .widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, say!(timeline_speed_name)));
        ui.checkbox(&mut self.session.playback.repeats, say!(timeline_loop));
    }

    fn pass_row(&mut self, ui: &mut egui::Ui, plan: &Plan) {
        let passes = plan.passes.len();
        let (mut pass, mut point) = self.session.playback.at;
        pass = pass.min(passes - 1);
        let points = plan.passes[pass].targets.len();
        point = point.min(points.saturating_sub(1));
        let shown = (pass, point);
        ui.horizontal(|ui| {
            self.play_button(ui);
            ui.label(say!(timeline_pass));
            // What is left beside the numbers, for two sliders.
            ui.spacing_mut().slider_width = ((ui.available_width() - 330.0) * 0.5).max(40.0);
            let slider = Slider::new(&mut pass, 0..=passes - 1);
            ui.add(slider)
                .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Slider, true, say!(timeline_pass_name)));
            ui.label(say!(timeline_point));
            let slider = Slider::new(&mut point, 0..=points.saturating_sub(1));
            ui.add(slider)
                .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Slider, true, say!(timeline_point_name)));
            self.play_speed(ui);
        });
        if (pass, point) != shown {
            self.session.playback.at = (pass, if pass == shown.0 { point } else { 0 });
        } else {
            self.session.playback.at = shown;
        }
    }

    fn target_numbers(&self, ui: &mut egui::Ui) {
        let Some(t) = self.target() else { return };
        let (word, [r, g, b]) = match t.state {
            TargetState::Free => (say!(timeline_free), [90, 140, 230]),
            TargetState::Corrected => (say!(timeline_corrected), state::CORRECTED),
            TargetState::Blocked => (say!(timeline_blocked), [240, 70, 70]),
        };
        let (pass, point) = self.session.playback.at;
        ui.horizontal_wrapped(|ui| {
            ui.label(RichText::new(word).strong().color(Color32::from_rgb(r, g, b)));
            ui.label(say!(timeline_place, pass = id(pass), point = id(point)));
            ui.label(if t.laser { say!(timeline_laser_on) } else { say!(timeline_laser_off) });
            ui.label(say!(timeline_tilt, angle = fixed(t.tilt_deg(), 2)));
            let [x, y, z] = [t.p.x, t.p.y, t.p.z].map(|c| fixed(c, 3));
            ui.monospace(say!(timeline_xyz, x, y, z));
            if let Some(Ok(setup)) = self.derived.pipeline.setup() {
                // Where the arm is; without one, where the flange would have to be.
                let flange = self
                    .moment()
                    .map_or_else(|| setup.flange_for(&t.frame(self.work().defocus_mm)), |m| m.base_from_flange);
                let angles_deg = rpy::from_rotation(&flange.rotation.to_rotation_matrix());
                let [rz, ry, rx] = angles_deg.map(|a| fixed(a, 2));
                let [x, y, z] = <[f64; 3]>::from(flange.translation.vector).map(|c| fixed(c, 1));
                let text = say!(timeline_flange, x, y, z, rz, ry, rx);
                ui.monospace(text).on_hover_text(say!(timeline_flange_tip));
            }
            if t.state == TargetState::Blocked {
                ui.label(RichText::new(self.why_blocked((pass, point))).color(theme::WRONG));
            }
        });
    }
}
