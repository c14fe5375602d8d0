//! The legend of the achieved spacing, in a corner of the view: the scale, and buttons that go to the narrowest and the
//! widest place.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::toggle::Toggle;
use super::dose::bar;
use crate::picture::spacing::{SpacingSample, SpacingScale};
use crate::text::{fixed, id, say, spacing_labels};
use eframe::egui::{self, Align, Area, Direction, Id, Layout, Rect, RichText, Sense, UiBuilder, vec2};

const WIDTH: f32 = 200.0;

/// The legend over a view, while the spacing is shown.
pub(in super::super) fn ui(ui: &egui::Ui, view: Rect, context: Context<'_>, actions: &mut Actions) {
    let show = &context.session.show;
    let is_shown = show.is_on(Toggle::Spacing) && !show.is_on(Toggle::SectionPlane);
    if !is_shown || context.derived.plan_on_part().is_none() {
        return;
    }
    let at = view.left_top() + vec2(10.0, 10.0);
    Area::new(Id::unique("achieved spacing")).fixed_pos(at).show(ui.ctx(), |ui| {
        egui::Frame::popup(ui.style()).show(ui, |ui| {
            ui.set_width(WIDTH);
            ui.label(RichText::new(say!(spacing_legend)).strong());
            match context.spacing_picture().and_then(|s| s.scale.as_ref()) {
                Some(scale) => legend(ui, scale, actions),
                None => {
                    ui.label(say!(spacing_legend_none));
                }
            }
        });
    });
}

fn legend(ui: &mut egui::Ui, scale: &SpacingScale, actions: &mut Actions) {
    bar(ui, WIDTH, || say!(spacing_legend_scale), |share| share);
    thirds(ui, spacing_labels(scale));
    let sides = [say!(spacing_legend_closer), say!(spacing_legend_wanted), say!(spacing_legend_farther)];
    thirds(ui, sides);
    let [(least, on_least), (greatest, on_greatest)] =
        [&scale.least, &scale.greatest].map(|p| (fixed(p.mm, 2), id(p.surface)));
    let links = [
        (say!(spacing_legend_least, mm = least, surface = on_least), &scale.least),
        (say!(spacing_legend_greatest, mm = greatest, surface = on_greatest), &scale.greatest),
    ];
    for (text, place) in links {
        if ui.link(text).on_hover_text(say!(problems_go)).clicked() {
            look_at(place, actions);
        }
    }
    if scale.wanted_mm.is_none() {
        ui.label(RichText::new(say!(spacing_legend_percent)).weak());
    }
}

/// Selects the surface of a place, and goes there.
fn look_at(place: &SpacingSample, actions: &mut Actions) {
    actions.reveal(place.surface);
    actions.look_at(place.at, (10.0 * place.mm).max(3.0));
}

/// Words under the ends and the middle of the scale.
fn thirds(ui: &mut egui::Ui, words: [String; 3]) {
    let (rect, _) = ui.allocate_exact_size(vec2(WIDTH, 16.0), Sense::hover());
    let layouts = [
        Layout::left_to_right(Align::Center),
        Layout::centered_and_justified(Direction::LeftToRight),
        Layout::right_to_left(Align::Center),
    ];
    for (word, layout) in words.into_iter().zip(layouts) {
        ui.scope_builder(UiBuilder::new().max_rect(rect).layout(layout), |ui| ui.label(word));
    }
}
