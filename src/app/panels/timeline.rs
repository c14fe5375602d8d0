//! Stepping through the plan: with a robot over time, without one over passes and points; also play, and the numbers of
//! the target.

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use super::super::theme;
use super::going_on;
use super::problems::why_left_out;
use super::scrub;
use crate::part::rpy;
use crate::planning::Plan;
use crate::pose::{Target, TargetState};
use crate::program::{Breakdown, Timeline};
use crate::text::{Sentence as _, clock, fixed, id, say};
use eframe::egui::{self, RichText, Slider};

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some(of) = context.derived.plan() else {
        ui.label(RichText::new(why_empty(ui.ctx(), context)).weak());
        return;
    };
    if of.plan.passes.is_empty() {
        ui.label(RichText::new(say!(timeline_no_line)).weak());
        return;
    }
    match context.timeline() {
        Some(timeline) => time_row(ui, timeline, context, actions),
        None => pass_row(ui, &of.plan, context, actions),
    }
    target_numbers(ui, context, actions);
}

/// Why there is nothing to step through.
fn why_empty(ctx: &egui::Context, context: Context<'_>) -> String {
    let is_cancelled = context.derived.error(context.document).is_some_and(|e| e.is_cancelled());
    match (context.clean_list().is_empty(), context.planning_error(), context.progress()) {
        (true, ..) => say!(timeline_nothing_chosen),
        _ if is_cancelled => say!(timeline_stopped, keys = Command::Plan.keys_text(ctx)),
        (false, Some(_), _) => say!(timeline_no_plan),
        (false, None, Some((activity, share))) => {
            say!(timeline_planning_at, activity = activity.sentence(), percent = fixed(f64::from(share) * 100.0, 0))
        }
        (false, None, None) => say!(timeline_planning),
    }
}

/// Play, time, speed, and what takes how much of the time.
fn time_row(ui: &mut egui::Ui, timeline: &Timeline, context: Context<'_>, actions: &mut Actions) {
    // In a narrow window what does not fit goes into another row.
    ui.horizontal_wrapped(|ui| {
        play_button(ui, context, actions);
        let width = (ui.available_size_before_wrap().x - 330.0).max(80.0);
        scrub::ui(ui, width, context, actions);
        let (now_s, total_s) = (context.session.playback.time_s, timeline.total_s());
        let text = say!(timeline_times, now = clock(now_s), total = clock(total_s));
        ui.monospace(RichText::new(text).strong()).on_hover_text(say!(timeline_times_tip));
        play_speed(ui, context, actions);
    });
    let left_out = context.derived.playback_data().into_iter().flat_map(|m| &m.marks).map(|m| m.count).sum();
    ui.horizontal_wrapped(|ui| time_shares(ui, &timeline.breakdown(), left_out));
}

fn time_shares(ui: &mut egui::Ui, b: &Breakdown, left_out: usize) {
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
    if left_out > 0 {
        let [r, g, b, _] = theme::WRONG.to_array();
        theme::swatch(ui, [r, g, b]);
        ui.label(RichText::new(say!(timeline_left_out, count = left_out)).color(ui.visuals().error_fg_color));
    }
}

fn play_button(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let text = if context.session.playback.is_playing { say!(timeline_pause) } else { say!(timeline_play) };
    if ui.button(text).on_hover_text(Command::Play.keys_text(ui.ctx())).clicked() {
        actions.command(Command::Play);
    }
}

fn play_speed(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let (mut speed, mut repeats) = (context.session.playback.speed, context.session.playback.repeats);
    let field = egui::DragValue::new(&mut speed).range(0.1..=20.0).speed(0.05).prefix(say!(timeline_speed_prefix));
    let response = ui.add(field).on_hover_text(say!(timeline_speed_tip));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, say!(timeline_speed_name)));
    if response.changed() {
        actions.session(move |s| s.playback.speed = speed);
    }
    if ui.checkbox(&mut repeats, say!(timeline_loop)).changed() {
        actions.session(move |s| s.playback.repeats = repeats);
    }
}

fn pass_row(ui: &mut egui::Ui, plan: &Plan, context: Context<'_>, actions: &mut Actions) {
    let last_pass = plan.passes.len().saturating_sub(1);
    let at = context.session.playback.at;
    let mut pass = at.0.min(last_pass);
    let last_point = plan.passes.get(pass).map_or(0, |p| p.targets.len().saturating_sub(1));
    let mut point = at.1.min(last_point);
    let shown = (pass, point);
    ui.horizontal_wrapped(|ui| {
        play_button(ui, context, actions);
        ui.label(say!(timeline_pass));
        // What is left beside the numbers, for two sliders.
        ui.spacing_mut().slider_width = ((ui.available_size_before_wrap().x - 330.0) * 0.5).max(40.0);
        let slider = Slider::new(&mut pass, 0..=last_pass);
        let response = ui.add(slider);
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Slider, true, say!(timeline_pass_name)));
        going_on::menu(&response, context, actions);
        ui.label(say!(timeline_point));
        let slider = Slider::new(&mut point, 0..=last_point);
        ui.add(slider).widget_info(|| egui::WidgetInfo::labeled(egui::Role::Slider, true, say!(timeline_point_name)));
        play_speed(ui, context, actions);
    });
    let wanted = (pass, if pass == shown.0 { point } else { 0 });
    if wanted != at {
        actions.session(move |s| s.playback.at = wanted);
    }
}

fn target_numbers(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some(t) = context.target() else { return };
    let visuals = ui.visuals();
    let (word, color) = match t.state {
        TargetState::Free => (say!(timeline_free), visuals.hyperlink_color),
        TargetState::Corrected => (say!(timeline_corrected), visuals.warn_fg_color),
        TargetState::Blocked => (say!(timeline_blocked), visuals.error_fg_color),
    };
    let (pass, point) = context.session.playback.at;
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(word).strong().color(color));
        ui.label(say!(timeline_place, pass = id(pass), point = id(point)));
        ui.label(match (context.has_weld(), t.laser) {
            (false, true) => say!(timeline_laser_on),
            (false, false) => say!(timeline_laser_off),
            (true, true) => say!(timeline_grinding),
            (true, false) => say!(timeline_not_grinding),
        });
        ui.label(say!(timeline_tilt, angle = fixed(t.tilt_deg(), 2)));
        let [x, y, z] = [t.p.x, t.p.y, t.p.z].map(|c| fixed(c, 3));
        ui.monospace(say!(timeline_xyz, x, y, z));
        if !context.session.is_narrow {
            flange(ui, t, context);
        }
        going_on::chip(ui, context, actions);
        if t.state == TargetState::Blocked {
            ui.label(RichText::new(why_left_out(context, (pass, point))).color(ui.visuals().error_fg_color));
        }
    });
}

/// Where the flange is; without a robot, where it would have to be.
fn flange(ui: &mut egui::Ui, t: &Target, context: Context<'_>) {
    let Some(Ok(setup)) = context.derived.pipeline.setup() else { return };
    let flange = context
        .moment()
        .map_or_else(|| setup.flange_for(&t.frame(context.process_settings().defocus_mm)), |m| m.base_from_flange);
    let angles_deg = rpy::from_rotation(&flange.rotation.to_rotation_matrix());
    let [rz, ry, rx] = angles_deg.map(|a| fixed(a, 2));
    let [x, y, z] = <[f64; 3]>::from(flange.translation.vector).map(|c| fixed(c, 1));
    let text = say!(timeline_flange, x, y, z, rz, ry, rx);
    ui.monospace(text).on_hover_text(say!(timeline_flange_tip));
}
