//! Stepping through the plan: with a robot over its time, without over passes and points; play, and
//! the numbers of the target.

use super::super::command::Command;
use super::super::{App, theme};
use crate::part::rpy;
use crate::picture::palette::state;
use crate::planning::Plan;
use crate::pose::State;
use crate::program::Timeline;
use eframe::egui::{self, Color32, RichText, Slider};

impl App {
    pub(in super::super) fn timeline_panel(&mut self, ui: &mut egui::Ui) {
        let Some(of) = self.derived.plan().cloned() else {
            let text = match (self.clean_list().is_empty(), self.planning_error().is_some()) {
                (true, _) => "Move a surface to the list to clean: its path appears here",
                (false, true) => "There is no plan: see the problems",
                (false, false) => "The plan is being made",
            };
            ui.label(RichText::new(text).weak());
            return;
        };
        let plan = &of.plan;
        let passes = plan.passes.len();
        if passes == 0 {
            ui.label(RichText::new("No line crosses the chosen surfaces").weak());
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
            let text = format!("{} / {}", super::clock(self.session.playback.time_s), super::clock(total_s));
            ui.monospace(RichText::new(text).strong()).on_hover_text("Hours, minutes, seconds");
            self.play_speed(ui);
        });
        let Some(b) = self.timeline().map(Timeline::breakdown) else { return };
        ui.horizontal(|ui| {
            let legend = [("work", b.work_s, Some(theme::ACCENT)), ("travel", b.travel_s, None)];
            for (word, seconds, color) in legend.into_iter().chain([("waiting", b.waiting_s, None)]) {
                let [r, g, b, _] = color.unwrap_or(ui.visuals().widgets.inactive.bg_fill).to_array();
                if word != "waiting" {
                    theme::swatch(ui, [r, g, b]);
                }
                ui.label(word);
                ui.monospace(super::clock(seconds));
            }
            let left_out: usize = self.derived.motion().into_iter().flat_map(|m| &m.marks).map(|m| m.count).sum();
            if left_out > 0 {
                let [r, g, b, _] = theme::WRONG.to_array();
                theme::swatch(ui, [r, g, b]);
                ui.label(RichText::new(format!("{left_out} left out")).color(theme::WRONG));
            }
        });
    }

    fn play_button(&mut self, ui: &mut egui::Ui) {
        let text = if self.session.playback.is_playing { "Pause" } else { "▶ Play" };
        if ui.button(text).on_hover_text("Space").clicked() {
            self.run(Command::Play);
        }
    }

    fn play_speed(&mut self, ui: &mut egui::Ui) {
        let speed = egui::DragValue::new(&mut self.session.playback.speed).range(0.1..=20.0).speed(0.05).prefix("× ");
        ui.add(speed)
            .on_hover_text("Times the real speed")
            .widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, "play speed"));
        ui.checkbox(&mut self.session.playback.repeats, "loop");
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
            ui.label("Pass");
            // What is left beside the numbers, for two sliders.
            ui.spacing_mut().slider_width = ((ui.available_width() - 330.0) * 0.5).max(40.0);
            let slider = Slider::new(&mut pass, 0..=passes - 1);
            ui.add(slider).widget_info(|| egui::WidgetInfo::labeled(egui::Role::Slider, true, "pass"));
            ui.label("Point");
            let slider = Slider::new(&mut point, 0..=points.saturating_sub(1));
            ui.add(slider).widget_info(|| egui::WidgetInfo::labeled(egui::Role::Slider, true, "point"));
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
            State::Free => ("free", [90, 140, 230]),
            State::Corrected => ("corrected", state::CORRECTED),
            State::Blocked => ("blocked", [240, 70, 70]),
        };
        let (pass, point) = self.session.playback.at;
        ui.horizontal_wrapped(|ui| {
            ui.label(RichText::new(word).strong().color(Color32::from_rgb(r, g, b)));
            ui.label(format!("pass {pass} · point {point}"));
            ui.label(format!("laser {}", if t.laser { "on" } else { "off" }));
            ui.label(format!("tilt {:.2}°", t.tilt_deg()));
            ui.monospace(format!("x {:.3}  y {:.3}  z {:.3}", t.p.x, t.p.y, t.p.z));
            if let Some(Ok(setup)) = self.derived.pipeline.setup() {
                // Where the arm is; without one, where the flange would have to be.
                let flange = self
                    .moment()
                    .map_or_else(|| setup.flange_for(&t.frame(self.work().defocus_mm)), |m| m.base_from_flange);
                // Rounded, and + 0 so that no −0.00 is shown.
                let [rz, ry, rx] = rpy::from_rotation(&flange.rotation.to_rotation_matrix())
                    .map(|a| (a * 100.0).round() / 100.0 + 0.0);
                let v = flange.translation.vector;
                let text = format!("flange {:.1} {:.1} {:.1} mm  RZ {rz:.2}° RY {ry:.2}° RX {rx:.2}°", v.x, v.y, v.z);
                ui.monospace(text).on_hover_text("Pose of the flange in the robot's base");
            }
            if t.state == State::Blocked {
                ui.label(RichText::new(self.why_blocked((pass, point))).color(theme::WRONG));
            }
        });
    }
}
