//! The 3D view as a panel: clicks, hover, its context menu, and what stands at the cursor.

use super::App;
use super::command::Command;
use super::session::Tool;
use crate::document::Edit;
use crate::part::Shape;
use crate::text::Sentence as _;
use crate::view::{Bounds, ViewportResponse};
use eframe::egui::{self, Color32, RichText};
use nalgebra::{Point2, Point3, Vector3};

/// Below this the toggles would fill more than two lines: they go into a menu.
const NARROW: f32 = 480.0;

impl App {
    /// The central panel.
    pub(super) fn view(&mut self, ui: &mut egui::Ui) {
        self.toolbar(ui);
        self.proposal_strip(ui);
        self.fit_if_pending();
        self.scene = self.build_scene(ui.visuals().dark_mode);
        let (scene, part) = (self.scene.clone(), self.derived.part.clone());
        let part_from_scene = self.scene_from_part().inverse();
        let pick = |origin: Point3<f64>, dir: Vector3<f64>| {
            let (from, along) = (part_from_scene * origin, part_from_scene * dir);
            let hit = part.as_ref()?.bvh.nearest_hit(&from, &along, 0.0, f64::INFINITY)?;
            Some(origin + dir * hit.t_mm)
        };
        let response = self.viewport.show_with_pick(ui, &scene, &pick);
        self.spacing_legend(ui, response.response.rect);
        if let Some(why) = &response.failure {
            ui.painter().text(
                response.response.rect.center(),
                egui::Align2::CENTER_CENTER,
                why.sentence(),
                egui::FontId::proportional(14.0),
                ui.visuals().warn_fg_color,
            );
        }
        self.take_pointer(&response);
        self.cursor_text(ui);
        let menu = response.response.clone();
        if response.secondary_clicked_px.is_some() || menu.context_menu_opened() {
            menu.context_menu(|ui| self.view_menu(ui));
        }
    }

    fn toolbar(&mut self, ui: &mut egui::Ui) {
        egui::Frame::new().inner_margin(4).fill(ui.visuals().panel_fill).show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                let width = ui.available_width();
                ui.set_min_width(width);
                if width < NARROW {
                    ui.menu_button("Show ▼", |ui| self.toggles(ui)).response.on_hover_text("What the view shows");
                } else {
                    self.toggles(ui);
                }
                if self.session.tool != Tool::Select {
                    let what = match self.session.tool {
                        Tool::PickOrigin => "Click where the origin should be · Esc ends",
                        _ => "Click the face to lay down · Esc ends",
                    };
                    ui.label(RichText::new(what).color(super::theme::ATTENTION));
                }
            });
        });
    }

    fn toggles(&mut self, ui: &mut egui::Ui) {
        use Command as C;
        for command in [C::Lines, C::Frames, C::Beams, C::Air, C::Before, C::Section, C::HideChosen, C::Plain] {
            let on = self.is_shown(command);
            let enabled = self.is_enabled(command);
            let name = super::panels::name_of(command);
            let keys = super::panels::keys_of(ui.ctx(), command);
            let button = egui::Button::selectable(on, name);
            if ui.add_enabled(enabled, button).on_hover_text(keys).clicked() {
                let ctx = ui.ctx().clone();
                self.run(command, &ctx);
            }
        }
    }

    /// Whether a toggle of the view is on.
    pub(super) fn is_shown(&self, command: Command) -> bool {
        let s = &self.session.show;
        match command {
            Command::Lines => s.lines,
            Command::Frames => s.frames,
            Command::Beams => s.beams,
            Command::Air => s.air,
            Command::Before => s.before,
            Command::Plain => s.plain,
            Command::HideChosen => s.hide_chosen,
            Command::Section => s.section,
            Command::Cell => s.cell,
            Command::Plots => s.plots,
            Command::Text => s.text,
            Command::ToolBodies => s.tool,
            Command::Access => s.access,
            Command::Dose => s.dose,
            Command::Spacing => s.spacing,
            _ => false,
        }
    }

    fn fit_if_pending(&mut self) {
        if self.session.fit_pending && self.is_in_cell() {
            self.fit_cell();
        } else if let (true, Some(part)) = (self.session.fit_pending, &self.derived.part) {
            let (min, max) = part.mesh.bounds();
            // Beams and frames stand out of the part.
            let out = Vector3::repeat(self.document.job().beam.defocus_mm.abs());
            self.viewport.set_scene_bounds(Bounds { min: min - out, max: max + out });
            self.viewport.reset(Bounds { min, max });
            self.session.fit_pending = false;
        }
    }

    /// Facet and point of the part, in its own frame, under a pixel; hidden surfaces are seen through.
    fn picked_at(&self, px: Point2<f64>, r: &ViewportResponse) -> Option<(u32, Point3<f64>)> {
        if self.session.show.section {
            return None;
        }
        let part = self.derived.part.as_ref()?;
        let clean = self.clean_list();
        let (origin, dir) = self.viewport.camera.ray_through(px, r.size);
        let part_from_scene = self.scene_from_part().inverse();
        let (mut origin, dir) = (part_from_scene * origin, part_from_scene * dir);
        // A ray that starts far behind everything: parallel cameras may stand inside the part.
        for _ in 0..64 {
            let hit = part.bvh.nearest_hit(&origin, &dir, 0.0, f64::INFINITY)?;
            let surface = *self.derived.surfaces.of_facet.get(hit.facet as usize)?;
            let hidden =
                self.session.hidden.contains(&surface) || self.session.show.hide_chosen && clean.contains(&surface);
            let point = origin + dir * hit.t_mm;
            if !hidden {
                return Some((hit.facet, point));
            }
            origin = point + dir * 1e-6 * part.mesh.diagonal();
        }
        None
    }

    fn surface_at(&self, px: Option<Point2<f64>>, r: &ViewportResponse) -> Option<u32> {
        let (facet, _) = self.picked_at(px?, r)?;
        self.derived.surfaces.of_facet.get(facet as usize).copied()
    }

    /// The surface of the place under the cursor.
    fn hovered_surface(&self) -> Option<u32> {
        let (facet, _) = self.session.hover_place?;
        self.derived.surfaces.of_facet.get(facet as usize).copied()
    }

    fn take_pointer(&mut self, r: &ViewportResponse) {
        self.session.hover_place = r.hover_px.and_then(|px| self.picked_at(px, r));
        if let Some(n) = self.hovered_surface() {
            self.session.hovered = Some(n);
        }
        if let Some(px) = r.clicked_px {
            match (self.session.tool, self.picked_at(px, r)) {
                (Tool::Select, found) => {
                    if let (true, Some((facet, point))) = (self.session.show.dose, found) {
                        self.click_dose(facet, point);
                    }
                    let n = found.and_then(|(f, _)| self.derived.surfaces.of_facet.get(f as usize).copied());
                    self.select(n, r.modifiers);
                    self.session.scroll_to = n;
                }
                (tool, Some((facet, point))) => self.use_tool(tool, facet, &point),
                _ => {}
            }
        }
        if let Some(px) = r.double_clicked_px {
            match self.surface_at(Some(px), r) {
                Some(n) => {
                    self.session.selected = [n].into();
                    self.session.scroll_to = Some(n);
                    self.focus_surface(n);
                }
                None => self.session.fit_pending = true,
            }
        }
        if let Some(px) = r.secondary_clicked_px {
            self.session.menu_place = self.picked_at(px, r);
        }
        if let Some(px) = r.secondary_clicked_px
            && let Some(n) = self.surface_at(Some(px), r)
            && !self.session.selected.contains(&n)
        {
            self.session.selected = [n].into();
        }
    }

    /// Selects as lists do: Ctrl toggles, Shift adds.
    pub(super) fn select(&mut self, surface: Option<u32>, modifiers: egui::Modifiers) {
        let selected = &mut self.session.selected;
        match surface {
            Some(n) if modifiers.command && selected.contains(&n) => {
                selected.remove(&n);
            }
            Some(n) if modifiers.shift || modifiers.command => {
                selected.insert(n);
            }
            Some(n) => *selected = [n].into(),
            None if !modifiers.command && !modifiers.shift => selected.clear(),
            None => {}
        }
        self.session.anchor = surface;
    }

    /// Fits the camera to one surface.
    pub(super) fn focus_surface(&mut self, n: u32) {
        let (Some(part), Some(s)) = (&self.derived.part, self.derived.surfaces.get(n)) else { return };
        let place = self.scene_from_part();
        if let Some(b) = Bounds::around(s.facets.iter().flat_map(|&f| part.mesh.corners(f as usize)).map(|p| place * p))
        {
            self.viewport.fit(b);
        }
    }

    fn use_tool(&mut self, tool: Tool, facet: u32, point: &Point3<f64>) {
        let Some(part) = self.derived.part.clone() else { return };
        let surface = self.derived.surfaces.of_facet.get(facet as usize).copied();
        let edit = match tool {
            Tool::LayFlat => {
                let normal = part.mesh.normals[facet as usize];
                self.document.job().part.placement.with_face_down(point, &normal)
            }
            _ => {
                let at = origin_for(surface.and_then(|n| self.derived.shape(n)), &part.mesh, facet, point);
                self.document.job().part.placement.with_origin_at(&at)
            }
        };
        self.edit(Edit::Place(edit));
        self.session.tool = Tool::Select;
    }

    fn cursor_text(&self, ui: &egui::Ui) {
        let Some(surface) = self.hovered_surface() else { return };
        let Some(pointer) = ui.ctx().pointer_hover_pos() else { return };
        let label = self.derived.label(self.document.job(), surface);
        text_at(ui.ctx(), pointer, format!("{surface}  {label}"));
    }

    fn view_menu(&mut self, ui: &mut egui::Ui) {
        use Command as C;
        let place = self.spiral_place();
        let button = ui.add_enabled(place.is_some(), egui::Button::new("Spiral centre here"));
        if button.on_disabled_hover_text("For surfaces with the strategy spiral").clicked() {
            self.put_spiral_centre();
            ui.close();
        }
        let border = self.border_place();
        let button = ui.add_enabled(border.is_some(), egui::Button::new("Offset from this border"));
        let button = match border.and_then(|(surface, index)| self.border_words(surface, index)) {
            Some(words) => button.on_hover_text(words),
            None => button,
        };
        if button.on_disabled_hover_text("For surfaces with the strategy offset that have a border").clicked() {
            self.start_from_border();
            ui.close();
        }
        for command in [
            C::Clean,
            C::Unclean,
            C::Hide,
            C::Isolate,
            C::ShowAll,
            C::SelectSameShape,
            C::SelectNeighbours,
            C::FlipSurface,
            C::Fit,
        ] {
            let button = egui::Button::new(super::panels::name_of(command));
            if ui.add_enabled(self.is_enabled(command), button).clicked() {
                let ctx = ui.ctx().clone();
                self.run(command, &ctx);
                ui.close();
            }
        }
    }
}

/// A text beside the cursor.
pub(super) fn text_at(ctx: &egui::Context, pointer: egui::Pos2, text: String) {
    let at = pointer + egui::vec2(16.0, 10.0);
    let painter = ctx.layer_painter(egui::LayerId::new(egui::Order::Tooltip, egui::Id::unique("cursor")));
    let galley = painter.layout_no_wrap(text, egui::FontId::proportional(13.0), Color32::WHITE);
    let rect = egui::Rect::from_min_size(at, galley.size()).expand2(egui::vec2(5.0, 3.0));
    painter.rect_filled(rect, 4, Color32::from_black_alpha(190));
    painter.galley(at, galley, Color32::WHITE);
}

/// Where the origin goes for a picked place: the middle of a hole or sphere, a corner or an edge's
/// middle if one is near, else the point itself.
fn origin_for(shape: Option<&Shape>, mesh: &crate::part::Mesh, facet: u32, point: &Point3<f64>) -> Point3<f64> {
    match shape {
        Some(Shape::Cylinder { centre, axis, .. }) => return centre + axis * (point - centre).dot(axis),
        Some(Shape::Sphere { centre, .. }) => return *centre,
        Some(Shape::Cone { apex, axis, .. }) => return apex + axis * (point - apex).dot(axis),
        _ => {}
    }
    let c = mesh.corners(facet as usize);
    let near = 0.02 * mesh.diagonal();
    let corner = c.iter().find(|v| (*v - point).norm() < near);
    let edge = (0..3).map(|k| nalgebra::center(&c[k], &c[(k + 1) % 3])).find(|v| (v - point).norm() < near);
    corner.copied().or(edge).unwrap_or(*point)
}
