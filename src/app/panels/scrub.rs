//! The time as a strip: when the laser is on, what is left out, and where the simulation is.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::playback_data::Mark;
use super::super::theme;
use super::going_on;
use super::problems::why_left_out;
use crate::program::Timeline;
use crate::text::{id, say};
use eframe::egui::{self, Color32, Rect, Sense, Stroke, pos2, vec2};

const HEIGHT: f32 = 26.0;
/// A mark is hit by the pointer this far to each side, points.
const CATCH: f32 = 4.0;

pub(super) fn ui(ui: &mut egui::Ui, width: f32, context: Context<'_>, actions: &mut Actions) {
    let Some(timeline) = context.timeline() else { return };
    let total_s = timeline.total_s().max(1e-9);
    let (rect, response) = ui.allocate_exact_size(vec2(width, HEIGHT), Sense::click_and_drag());
    let time_s = context.session.playback.time_s;
    response.widget_info(|| egui::WidgetInfo::slider(true, time_s, say!(scrub_name)));
    let track = rect.shrink2(vec2(2.0, 6.0));
    let x_of = |t: f64| track.left() + (t / total_s) as f32 * track.width();
    paint_track(ui, track, timeline, x_of);
    let marks = mark_places(context, x_of);
    for (x, _) in &marks {
        let tick = Rect::from_min_max(pos2(x - 1.0, rect.top() + 1.0), pos2(x + 1.0, rect.bottom() - 1.0));
        ui.painter().rect_filled(tick, 1, theme::WRONG);
    }
    paint_head(ui, rect, x_of(time_s));
    going_on::menu(&response, context, actions);
    let pointer = response.hover_pos().or(response.interact_pointer_pos());
    let caught = pointer.and_then(|p| {
        let near = marks.iter().filter(|(x, _)| (x - p.x).abs() <= CATCH);
        near.min_by(|a, b| (a.0 - p.x).abs().total_cmp(&(b.0 - p.x).abs())).map(|(_, m)| *m)
    });
    if let (Some(mark), false) = (caught, response.dragged()) {
        response.clone().on_hover_text_at_pointer(why(&mark, context));
    }
    match (caught, response.interact_pointer_pos()) {
        (Some(mark), _) if response.clicked() => actions.go_to_target(mark.first),
        (_, Some(p)) if response.clicked() || response.dragged() || response.secondary_clicked() => {
            actions.go_to_time(f64::from((p.x - track.left()) / track.width()) * total_s);
        }
        _ => {}
    }
}

/// The marks with their places; of those that share a point, the first.
fn mark_places(context: Context<'_>, x_of: impl Fn(f64) -> f32) -> Vec<(f32, Mark)> {
    let (Some(data), Some(timeline)) = (context.derived.playback_data(), context.timeline()) else { return Vec::new() };
    let mut out: Vec<(f32, Mark)> = Vec::new();
    for mark in &data.marks {
        let at_s = mark.after.and_then(|n| timeline.stops().get(n)).map_or(0.0, |s| s.at_s);
        let x = x_of(at_s);
        match out.last_mut() {
            Some((last, m)) if x - *last < 1.5 => m.count += mark.count,
            _ => out.push((x, *mark)),
        }
    }
    out
}

/// What is left out at a mark, and for what cause.
fn why(mark: &Mark, context: Context<'_>) -> String {
    let (pass, point) = mark.first;
    let cause = why_left_out(context, mark.first);
    say!(scrub_mark, count = mark.count, pass = id(pass), point = id(point), cause)
}

fn paint_track(ui: &egui::Ui, track: Rect, timeline: &Timeline, x_of: impl Fn(f64) -> f32) {
    let painter = ui.painter();
    painter.rect_filled(track, 3, ui.visuals().widgets.inactive.bg_fill);
    // Stretches closer than a point are one: a program may have thousands.
    let mut run: Option<(f32, f32)> = None;
    let fill = |(from, to): (f32, f32)| {
        let rect = Rect::from_min_max(pos2(from, track.top()), pos2(to.max(from + 1.0), track.bottom()));
        painter.rect_filled(rect, 0, theme::ACCENT);
    };
    for [from, to] in timeline.lit_stretches() {
        let (from, to) = (x_of(from), x_of(to));
        match &mut run {
            Some(run) if from - run.1 < 0.75 => run.1 = to,
            _ => run.replace((from, to)).into_iter().for_each(fill),
        }
    }
    run.into_iter().for_each(fill);
}

fn paint_head(ui: &egui::Ui, rect: Rect, x: f32) {
    let color = ui.visuals().strong_text_color();
    let painter = ui.painter();
    painter.vline(x, rect.y_range(), Stroke::new(2.0, color));
    let top = rect.top();
    let handle = vec![pos2(x - 5.0, top), pos2(x + 5.0, top), pos2(x, top + 7.0)];
    painter.add(egui::Shape::convex_polygon(handle, color, Stroke::new(1.0, Color32::from_black_alpha(120))));
}
