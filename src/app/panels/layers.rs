//! How the job lays lines: the strategy, and what concerns it; rim, joins and passes.

use super::super::{App, quantity, theme};
use super::fields::{self, Change, NAMES, Owner};
use super::laying;
use crate::document::parameter::Group;
use crate::document::{Edit, Offset, StartFrom};
use crate::part::SurfaceId;
use crate::path::Strategy;
use crate::text::say;
use eframe::egui::{self, DragValue, Role, WidgetInfo};

impl App {
    pub(super) fn layers(&mut self, ui: &mut egui::Ui) {
        theme::heading(ui, &say!(laying_heading));
        let l = self.document.job().layers.clone();
        if let Some(Change::To(s)) = laying::strategy(ui, Owner::Job, l.strategy, None) {
            self.edit(Edit::Strategy(s));
        }
        let by_planes = matches!(l.strategy, Strategy::Planes | Strategy::Adaptive | Strategy::Cross);
        if by_planes && let Some(Change::To(d)) = laying::direction(ui, Owner::Job, l.direction, None) {
            self.edit_dragging(&Edit::Direction(d), "direction");
        }
        match l.strategy {
            Strategy::Cross => self.numbers(ui, Group::Cross),
            Strategy::Offset => {
                if let Some(Change::To(start)) = laying::border(ui, Owner::Job, l.border.into(), None) {
                    self.edit_dragging(&Edit::Border(start.border()), "border");
                }
            }
            Strategy::Spiral => {
                if let Some(Change::To(inward)) = laying::inward(ui, Owner::Job, l.inward, None) {
                    self.edit(Edit::Inward(inward));
                }
                if laying::centre(ui, Owner::Job, l.centre_mm, l.centre_mm.is_some()) {
                    self.edit(Edit::Centre(None));
                }
            }
            Strategy::Planes | Strategy::Adaptive => {}
        }
        self.own_starts(ui);
        self.numbers(ui, Group::Spacing);
        if let Some(mm) = fields::overlap(ui, Owner::Job, self.document.job()) {
            self.edit_dragging(&Edit::Set(fields::SPACING.key, mm), "overlap");
        }
        if matches!(l.strategy, Strategy::Planes | Strategy::Cross) {
            self.offset(ui);
        }
        if let Some(Change::To(order)) = laying::order(ui, Owner::Job, l.strategy, l.order, None) {
            self.edit(Edit::Order(order));
        }
        egui::CollapsingHeader::new(say!(laying_rim)).id_salt("rim").show(ui, |ui| {
            self.numbers(ui, Group::Rim);
        });
        self.bead(ui);
    }

    fn offset(&mut self, ui: &mut egui::Ui) {
        let now = self.document.job().layers.offset_mm;
        let spacing = self.document.job().layers.spacing_mm;
        ui.horizontal(|ui| {
            theme::name(ui, &say!(laying_first_plane), NAMES);
            let mut centred = now == Offset::Centred;
            if ui.checkbox(&mut centred, say!(laying_first_plane_centred)).changed() {
                self.edit(Edit::Offset(if centred { Offset::Centred } else { Offset::FromLowest(0.5 * spacing) }));
            }
            if let Offset::FromLowest(mut mm) = now {
                let field = DragValue::new(&mut mm)
                    .speed(0.01)
                    .range(0.0..=spacing)
                    .suffix(say!(unit_mm))
                    .custom_parser(quantity::read);
                let response = ui.add(field).on_hover_text(say!(laying_first_plane_tip));
                response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, say!(laying_first_plane_name)));
                if response.changed() {
                    self.edit_dragging(&Edit::Offset(Offset::FromLowest(mm)), "offset");
                }
            }
        });
    }

    /// The centre of the surface's spiral goes to the place that was right clicked.
    pub(in super::super) fn put_spiral_centre(&mut self) {
        let Some((surface, at)) = self.spiral_place() else { return };
        self.edit(Edit::SurfaceCentre(SurfaceId(surface), Some(at)));
    }

    /// The surface's offset lines start from the border nearest to the place that was right clicked.
    pub(in super::super) fn start_from_border(&mut self) {
        let Some((surface, index)) = self.border_place() else { return };
        self.edit(Edit::SurfaceBorder(SurfaceId(surface), Some(StartFrom::Border(index))));
    }

    /// The place that was right clicked, if the surface there is worked in a spiral.
    pub(in super::super) fn spiral_place(&self) -> Option<(u32, [f64; 3])> {
        let (facet, at) = self.session.menu_place?;
        let surface = *self.derived.surfaces.of_facet.get(facet as usize)?;
        let is_spiral = self.document.job().of_surface(SurfaceId(surface)).layers.strategy == Strategy::Spiral;
        is_spiral.then(|| (surface, at.coords.into()))
    }
}
