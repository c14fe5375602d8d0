//! The motion as curves over time: joints within their limits, their speeds, the pose of the flange,
//! the distance from a singular pose and from what stands in the cell. A cursor is where the
//! simulation is; a drag moves both.

mod curves;
pub(super) mod diagram;
mod scale;

use super::super::actions::Actions;
use super::super::context::Context;
use curves::{clearance_diagram, diagrams};
use diagram::Diagram;
use eframe::egui::{self, vec2};
use scale::{InSight, SHORTEST_S};

pub(in super::super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some(data) = context.derived.playback_data() else { return };
    let Some(timeline) = &data.timeline else { return };
    let sight = in_sight(timeline.total_s(), context, actions);
    let list = diagrams(timeline, &data.curves);
    let clearance = context.clearance();
    let last = clearance_diagram(clearance.map(|c| &**c));
    let whole = ui.available_width() - list.len() as f32 * ui.spacing().item_spacing.x;
    let width = whole / (list.iter().map(Diagram::share).sum::<f32>() + last.share());
    ui.horizontal_top(|ui| {
        for d in &list {
            beside(ui, width * d.share(), |ui| d.ui(ui, &data.curves, sight, actions));
        }
        let looked_at = clearance.map_or(&[][..], |c| &c.samples);
        beside(ui, width * last.share(), |ui| last.ui(ui, looked_at, sight, actions));
    });
}

/// A diagram beside the others, so wide.
fn beside(ui: &mut egui::Ui, width: f32, draw: impl FnOnce(&mut egui::Ui)) {
    let size = vec2(width, ui.available_height());
    ui.allocate_ui(size, |ui| {
        ui.set_width(size.x);
        ui.vertical(draw);
    });
}

/// The stretch of time in sight; while playing it follows.
fn in_sight(total_s: f64, context: Context<'_>, actions: &mut Actions) -> InSight {
    let playback = &context.session.playback;
    let now_s = playback.time_s;
    let mut span_s = context.session.plot_span;
    if let Some([from, to]) = &mut span_s
        && playback.is_playing
        && !(*from..=*to).contains(&now_s)
    {
        (*from, *to) = (now_s, now_s + (*to - *from));
        actions.session(move |s| s.plot_span = span_s);
    }
    InSight { span_s: span_s.unwrap_or([0.0, total_s.max(SHORTEST_S)]), now_s, total_s }
}
