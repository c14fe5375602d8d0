//! The legend of the achieved spacing, in a corner of the view: scale, and the two places to go to.

use super::super::App;
use super::dose::bar;
use crate::picture::spacing::Place;
use crate::view::Bounds;
use eframe::egui::{self, Align, Area, Id, Layout, Rect, RichText, vec2};
use nalgebra::Vector3;

const WIDTH: f32 = 200.0;

impl App {
    pub(in super::super) fn spacing_legend(&mut self, ui: &egui::Ui, view: Rect) {
        if !self.session.show.spacing || self.session.show.section || self.derived.plan.is_none() {
            return;
        }
        let scale = self.spacing_scale().cloned();
        let at = view.left_top() + vec2(10.0, 10.0);
        Area::new(Id::unique("achieved spacing")).fixed_pos(at).show(ui.ctx(), |ui| {
            egui::Frame::popup(ui.style()).show(ui, |ui| {
                ui.set_width(WIDTH);
                ui.label(RichText::new("Achieved spacing").strong());
                let Some(scale) = scale else {
                    ui.label("no two lines lie side by side");
                    return;
                };
                bar(ui, WIDTH, "scale of the spacing", |share| share);
                let [low, wanted, high] = scale.labels();
                ui.horizontal(|ui| {
                    let third = |ui: &mut egui::Ui, layout: Layout, text: &str| {
                        let size = vec2(WIDTH / 3.0 - 5.0, 14.0);
                        ui.allocate_ui_with_layout(size, layout, |ui| {
                            ui.set_min_width(size.x);
                            ui.label(RichText::new(text).small());
                        });
                    };
                    third(ui, Layout::left_to_right(Align::Center), &low);
                    third(ui, Layout::top_down(Align::Center), &wanted);
                    third(ui, Layout::right_to_left(Align::Center), &high);
                });
                ui.label(RichText::new("closer · as wanted · farther apart").small().weak());
                for (word, place) in [("least", scale.least), ("greatest", scale.greatest)] {
                    let text = format!("{word} {:.2} mm on surface {}", place.mm, place.surface);
                    if ui.link(text).on_hover_text("Go there").clicked() {
                        self.look_at_place(&place);
                    }
                }
                if scale.wanted_mm.is_none() {
                    ui.label(RichText::new("per cent of what each surface wants").small().weak());
                }
            });
        });
    }

    fn look_at_place(&mut self, place: &Place) {
        self.session.selected = [place.surface].into();
        self.session.scroll_to = Some(place.surface);
        let (at, out) = (self.scene_from_part() * place.at, Vector3::repeat((10.0 * place.mm).max(3.0)));
        self.viewport.fit(Bounds { min: at - out, max: at + out });
    }
}
