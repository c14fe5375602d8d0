//! How the job lays lines: the strategy, and what concerns it; rim, joins and passes.

use super::super::{App, quantity, theme};
use super::fields::{self, Change, JOB};
use crate::job::recipe_table::place;
use crate::job::{Edit, Offset};
use crate::path::Strategy;
use eframe::egui::{self, DragValue, RichText, Role, WidgetInfo};

impl App {
    pub(super) fn layers(&mut self, ui: &mut egui::Ui) {
        theme::heading(ui, "Layers");
        let l = self.document.job().layers.clone();
        if let Some(Change::To(s)) = fields::strategy(ui, JOB, l.strategy, None) {
            self.edit(Edit::Strategy(s));
        }
        let by_planes = matches!(l.strategy, Strategy::Planes | Strategy::Adaptive | Strategy::Cross);
        if by_planes && let Some(Change::To(d)) = fields::direction(ui, JOB, l.direction, None) {
            self.edit_dragging(&Edit::Direction(d), "direction");
        }
        match l.strategy {
            Strategy::Cross => self.numbers(ui, &["layers.cross_deg"]),
            Strategy::Offset => self.border(ui, l.border),
            Strategy::Spiral => self.spiral(ui, l.inward, l.centre_mm),
            Strategy::Planes | Strategy::Adaptive => {}
        }
        self.numbers(ui, &["layers.spacing_mm"]);
        if let Some(mm) = fields::overlap(ui, JOB, self.document.job()) {
            self.edit_dragging(&Edit::Set("layers.spacing_mm", mm), "overlap");
        }
        if matches!(l.strategy, Strategy::Planes | Strategy::Cross) {
            self.offset(ui);
        }
        if let Some(Change::To(order)) = fields::order(ui, JOB, l.strategy, l.order, None) {
            self.edit(Edit::Order(order));
        }
        egui::CollapsingHeader::new("Rim, joins, passes").show(ui, |ui| {
            self.numbers(ui, &["layers.inset_mm", "layers.ignore_holes_mm", "layers.join_mm", "layers.shortest_mm"]);
            self.numbers(ui, &["layers.seam_shift_mm", "layers.passes"]);
        });
    }

    fn border(&mut self, ui: &mut egui::Ui, now: Option<u32>) {
        ui.horizontal(|ui| {
            theme::name(ui, "Start from", fields::NAMES)
                .on_hover_text("The loops of the outline are counted from the longest, which is 0");
            let mut whole = now.is_none();
            if ui.checkbox(&mut whole, "whole outline").changed() {
                self.edit(Edit::Border((!whole).then_some(0)));
            }
            if let Some(mut number) = now {
                let response = ui.add(DragValue::new(&mut number).speed(0.05).range(0..=999).prefix("border "));
                response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, "border"));
                if response.changed() {
                    self.edit_dragging(&Edit::Border(Some(number)), "border");
                }
            }
        });
    }

    fn spiral(&mut self, ui: &mut egui::Ui, inward: bool, centre_mm: Option<[f64; 3]>) {
        ui.horizontal(|ui| {
            theme::name(ui, "Spiral runs", fields::NAMES);
            for (word, sense) in [("outwards", false), ("inwards", true)] {
                if ui.selectable_label(inward == sense, word).clicked() {
                    self.edit(Edit::Inward(sense));
                }
            }
        });
        ui.horizontal(|ui| {
            theme::name(ui, "Centre", fields::NAMES).on_hover_text("Right click on the part: Spiral centre here");
            ui.label(centre_mm.map_or_else(|| "middle of the surface".into(), place));
            if centre_mm.is_some() {
                let reset = ui.small_button("↺").on_hover_text("Back to the middle of the surface");
                reset.widget_info(|| WidgetInfo::labeled(Role::Button, true, "reset centre"));
                if reset.clicked() {
                    self.edit(Edit::Centre(None));
                }
            }
        });
        if centre_mm.is_none() {
            ui.label(RichText::new("Right click on the part to set it").small().weak());
        }
    }

    fn offset(&mut self, ui: &mut egui::Ui) {
        let now = self.document.job().layers.offset_mm;
        let spacing = self.document.job().layers.spacing_mm;
        ui.horizontal(|ui| {
            theme::name(ui, "First plane", fields::NAMES);
            let mut centred = now == Offset::Centred;
            if ui.checkbox(&mut centred, "centred").changed() {
                self.edit(Edit::Offset(if centred { Offset::Centred } else { Offset::FromLowest(0.5 * spacing) }));
            }
            if let Offset::FromLowest(mut mm) = now {
                let field = DragValue::new(&mut mm)
                    .speed(0.01)
                    .range(0.0..=spacing)
                    .suffix(" mm")
                    .custom_parser(quantity::read);
                let response =
                    ui.add(field).on_hover_text("Above the lowest point of the surfaces, at most one spacing");
                response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, "first offset"));
                if response.changed() {
                    self.edit_dragging(&Edit::Offset(Offset::FromLowest(mm)), "offset");
                }
            }
        });
    }

    /// The spiral's centre goes to the place that was right clicked.
    pub(in super::super) fn put_spiral_centre(&mut self) {
        let Some((surface, at)) = self.spiral_place() else { return };
        match self.document.job().recipe_of(surface).cloned() {
            Some(mut recipe) => {
                recipe.centre_mm = Some(at);
                self.edit(Edit::Recipe(Box::new(recipe), Vec::new()));
            }
            None => self.edit(Edit::Centre(Some(at))),
        }
    }

    /// The place that was right clicked, if the surface there is worked in a spiral.
    pub(in super::super) fn spiral_place(&self) -> Option<(u32, [f64; 3])> {
        let (facet, at) = self.session.menu_place?;
        let surface = *self.derived.surfaces.of_facet.get(facet as usize)?;
        let is_spiral = self.document.job().of_surface(surface).layers.strategy == Strategy::Spiral;
        is_spiral.then(|| (surface, at.coords.into()))
    }
}
