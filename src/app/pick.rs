//! The 3D view as a panel: clicks, hover, its context menu, and what stands at the cursor.

use super::actions::Actions;
use super::context::Context;
use super::dose::Clicked;
use super::gizmo::state::Gizmo;
use super::scan_tool::{self, ScanTool};
use super::session::PointerTool;
use super::sight::seeing;
use super::toggle::Toggle;
use super::{App, at_cursor, gizmo, panels};
use crate::document::Edit;
use crate::part::Shape;
use crate::text::Sentence as _;
use crate::view::{Bounds, Camera, StandardView, ViewportResponse};
use eframe::egui;
use nalgebra::{Point2, Point3, Vector3};

impl App {
    /// The central panel.
    pub(super) fn view(&mut self, ui: &mut egui::Ui) {
        self.panel(|context, actions| panels::toolbar::ui(ui, context, actions));
        self.panel(|context, actions| panels::file_banner::ui(ui, context, actions));
        self.panel(|context, actions| panels::better_setup::ui(ui, context, actions));
        self.fit_if_pending();
        self.fit_to_tool();
        self.viewport.brush = self.session.scan_tool.as_ref().is_some_and(ScanTool::paints)
            || self.session.tool == PointerTool::Paint
            || self.is_on_handle(ui);
        self.viewport.navigation = self.session.navigation;
        self.scene = self.build_scene(ui.visuals().dark_mode);
        let (scene, part) = (self.scene.clone(), self.derived.part.clone());
        let part_from_scene = self.context().scene_from_part().inverse();
        let pick = |origin: Point3<f64>, dir: Vector3<f64>| {
            let (from, along) = (part_from_scene * origin, part_from_scene * dir);
            let hit = part.as_ref()?.bvh.nearest_hit(&from, &along, 0.0, f64::INFINITY)?;
            Some(origin + dir * hit.t_mm)
        };
        let response = self.viewport.show_with_pick(ui, &scene, &pick);
        self.panel(|context, actions| panels::spacing::ui(ui, response.response.rect, context, actions));
        self.panel(|context, actions| panels::path_legend::ui(ui, response.response.rect, context, actions));
        self.panel(|context, _| panels::scan::legend::ui(ui, response.response.rect, context));
        self.panel(|context, _| panels::weld::legend::ui(ui, response.response.rect, context));
        if let Some(why) = &response.failure {
            ui.painter().text(
                response.response.rect.center(),
                egui::Align2::CENTER_CENTER,
                why.sentence(),
                egui::FontId::proportional(14.0),
                ui.visuals().warn_fg_color,
            );
        }
        let camera = self.viewport.camera;
        if self.session.scan_tool.is_some() {
            self.panel(|context, actions| scan_tool::pointer(&response, &camera, context, actions));
            scan_tool::brush_circle(ui, &response, &camera, self.context());
        } else {
            let on_gizmo = self.session.gizmo.as_ref().is_some_and(Gizmo::is_held);
            self.panel(|context, actions| gizmo::ui(ui, &response, &camera, context, actions));
            if !on_gizmo {
                self.panel(|context, actions| pointer(&response, &camera, context, actions));
            }
        }
        panels::measured::ui(ui, &response, &camera, self.context());
        panels::scan::marks::ui(ui, &response, &camera, self.context());
        let menu = response.response.clone();
        if !egui::Popup::is_any_open(ui.ctx()) {
            cursor_text(ui, self.context());
        }
        if response.secondary_clicked_px.is_some() || menu.context_menu_opened() {
            menu.context_menu(|ui| self.panel(|context, actions| panels::view_menu::ui(ui, context, actions)));
        }
    }

    /// Whether the pointer is on a handle, or holds one: then it moves no camera.
    fn is_on_handle(&self, ui: &egui::Ui) -> bool {
        let Some(gizmo) = &self.session.gizmo else { return false };
        let at = ui.input(|i| i.pointer.latest_pos());
        let rect = ui.available_rect_before_wrap();
        let per_point = f64::from(ui.pixels_per_point());
        let on = |at| self.context().handle_at(at, rect, &self.viewport.camera, per_point);
        gizmo.is_held() || at.and_then(on).is_some()
    }

    fn fit_if_pending(&mut self) {
        if self.session.fit_pending && self.context().is_in_cell() {
            self.fit_cell();
        } else if let (true, Some(part)) = (self.session.fit_pending, &self.derived.part) {
            let (min, max) = part.mesh.bounds();
            // Beams and frames stand out of the part.
            let out = Vector3::repeat(self.document.job().beam.defocus_mm.abs());
            self.viewport.set_scene_bounds(Bounds { min: min - out, max: max + out });
            self.viewport.reset(Bounds { min, max });
            if self.document.job().is_on_depth_image() {
                // As the camera sees it: x to the right, y down, z into the picture.
                self.viewport.look(StandardView::Bottom);
                self.viewport.fit(Bounds { min, max });
            }
            self.session.fit_pending = false;
        }
    }

    /// Fits the camera to one surface.
    pub(super) fn focus_surface(&mut self, n: u32) {
        let (Some(part), Some(s)) = (&self.derived.part, self.derived.surfaces.get(n)) else { return };
        let place = self.context().scene_from_part();
        let mesh = &part.mesh;
        let bounds = Bounds::around(s.facets.iter().flat_map(|&f| mesh.corners(f as usize)).map(|p| place * p));
        let largest = s.facets.iter().max_by(|a, b| mesh.areas[**a as usize].total_cmp(&mesh.areas[**b as usize]));
        if let (Some(bounds), Some(&facet)) = (bounds, largest) {
            let [a, b, c] = mesh.corners(facet as usize);
            self.glide_to_see(&Point3::from((a.coords + b.coords + c.coords) / 3.0), bounds);
        }
    }

    /// Glides until the box fills the view, from where a place of the part is seen.
    pub(super) fn glide_to_see(&mut self, in_part: &Point3<f64>, bounds: Bounds) {
        let place = self.context().scene_from_part();
        let now = self.viewport.camera;
        let camera = self.derived.part.as_ref().map(|part| seeing(&now, &part.bvh, in_part, &place));
        match (camera.filter(|camera| *camera != now), self.viewport.size()) {
            (Some(mut camera), Some(size)) => {
                camera.fit(&bounds, size);
                self.viewport.glide_to(camera);
            }
            _ => self.viewport.fit(bounds),
        }
    }
}

/// What the pointer does in the view.
fn pointer(r: &ViewportResponse, camera: &Camera, context: Context<'_>, actions: &mut Actions) {
    let picked = |px: Point2<f64>| context.picked_at(camera.ray_through(px, r.size));
    let hover_place = r.hover_px.and_then(picked);
    if hover_place.is_some() || context.session.hover_place.is_some() {
        let hovered = hover_place.and_then(|(facet, _)| context.surface_of(facet));
        actions.session(move |s| {
            s.hover_place = hover_place;
            s.hovered = hovered.or(s.hovered);
        });
    }
    if let Some(px) = r.clicked_px {
        click(picked(px), r.modifiers, context, actions);
    }
    if let Some(px) = r.painted_px.filter(|_| context.session.tool == PointerTool::Paint)
        && let Some(n) = picked(px).and_then(|(facet, _)| context.surface_of(facet))
        && !context.session.selected.contains(&n)
    {
        actions.session(move |s| {
            s.selected.insert(n);
            s.scroll_to = Some(n);
        });
    }
    if let Some(corners) = r.boxed_px {
        let inside = context.surfaces_in_box(camera, r.size, corners);
        let adds = r.modifiers.shift || r.modifiers.command;
        actions.session(move |s| {
            if !adds {
                s.selected.clear();
            }
            s.scroll_to = inside.first().copied();
            s.selected.extend(inside);
        });
    }
    if let Some(px) = r.double_clicked_px {
        match picked(px).and_then(|(facet, _)| context.surface_of(facet)) {
            Some(n) => {
                actions.reveal(n);
                actions.focus(n);
            }
            None => actions.session(|s| s.fit_pending = true),
        }
    }
    if let Some(px) = r.secondary_clicked_px {
        let place = picked(px);
        let surface = place.and_then(|(facet, _)| context.surface_of(facet));
        actions.session(move |s| {
            s.menu_place = place;
            if let Some(n) = surface.filter(|n| !s.selected.contains(n)) {
                s.selected = [n].into();
            }
        });
    }
}

/// A click on a facet and a point of the part, or on nothing: selects, or does what the tool is for.
fn click(place: Option<(u32, Point3<f64>)>, modifiers: egui::Modifiers, context: Context<'_>, actions: &mut Actions) {
    let placement = &context.document.job().part.placement;
    let placed = match (context.session.tool, place, &context.derived.part) {
        (PointerTool::Select, ..) => {
            if let Some((facet, point)) = place.filter(|_| context.session.show.is_on(Toggle::Dose))
                && let Some(clicked) = context.dose_at(facet, point)
            {
                actions.session(|s| s.clicked = Some(clicked));
            }
            if let Some((_, point)) = place.filter(|_| context.session.show.is_on(Toggle::ScanSection)) {
                actions.session(move |s| s.section.at_mm = Some(point[s.section.axis]));
            }
            let surface = place.and_then(|(facet, _)| context.surface_of(facet));
            actions.session(move |s| {
                s.select(surface, modifiers);
                s.scroll_to = surface;
            });
            return;
        }
        (_, None, _) | (_, _, None) => return,
        (PointerTool::Paint, ..) => return,
        (PointerTool::Measure, Some(picked), Some(_)) => {
            actions.session(move |s| {
                if s.measured.len() > 1 {
                    s.measured.clear();
                }
                s.measured.push(picked);
            });
            return;
        }
        (PointerTool::PutClamp(i), Some((facet, point)), Some(part)) => {
            let shape = context.surface_of(facet).and_then(|n| context.derived.shape(n));
            let at = origin_for(shape, &part.mesh, facet, &point);
            gizmo::put_clamp(context, i, &at, &part.mesh.normals[facet as usize], actions);
            actions.session(|s| s.tool = PointerTool::Select);
            return;
        }
        (PointerTool::LayFlat, Some((facet, point)), Some(part)) => {
            placement.with_face_down(&point, &part.mesh.normals[facet as usize])
        }
        (PointerTool::PickOrigin, Some((facet, point)), Some(part)) => {
            let shape = context.surface_of(facet).and_then(|n| context.derived.shape(n));
            placement.with_origin_at(&origin_for(shape, &part.mesh, facet, &point))
        }
    };
    actions.edit(Edit::Place(placed));
    actions.session(|s| s.tool = PointerTool::Select);
}

impl Context<'_> {
    /// Facet and point of the part, in its own frame, that a ray of the scene meets; hidden surfaces are ignored.
    pub(super) fn picked_at(self, (origin, dir): (Point3<f64>, Vector3<f64>)) -> Option<(u32, Point3<f64>)> {
        let show = &self.session.show;
        if show.is_on(Toggle::SectionPlane) {
            return None;
        }
        let part = self.derived.part.as_ref()?;
        let hidden_too = if show.is_on(Toggle::HideChosen) { self.clean_list() } else { Vec::new() };
        let part_from_scene = self.scene_from_part().inverse();
        let (mut origin, dir) = (part_from_scene * origin, part_from_scene * dir);
        // A ray that starts far behind everything: parallel cameras may stand inside the part.
        for _ in 0..64 {
            let hit = part.bvh.nearest_hit(&origin, &dir, 0.0, f64::INFINITY)?;
            let facet = part.mesh.side_towards(hit.facet, &dir);
            let surface = self.surface_of(facet)?;
            let point = origin + dir * hit.t_mm;
            let is_hidden =
                self.is_cut_away(&point) || self.session.hidden.contains(&surface) || hidden_too.contains(&surface);
            if !is_hidden {
                return Some((facet, point));
            }
            origin = point + dir * 1e-6 * part.mesh.diagonal();
        }
        None
    }

    /// What lands at a place of the part, if the dose is known.
    fn dose_at(self, facet: u32, point: Point3<f64>) -> Option<Clicked> {
        self.dose()?.at(self.plan()?, facet, point)
    }

    /// The surface that a facet belongs to.
    pub fn surface_of(self, facet: u32) -> Option<u32> {
        self.derived.surfaces.of_facet.get(facet as usize).copied()
    }
}

fn cursor_text(ui: &egui::Ui, context: Context<'_>) {
    let hovered = context.session.hover_place.and_then(|(facet, _)| context.surface_of(facet));
    let Some(surface) = hovered else { return };
    let Some(pointer) = ui.ctx().pointer_hover_pos() else { return };
    let label = context.derived.label(context.document.job(), surface);
    at_cursor::text(ui.ctx(), pointer, format!("{surface}  {label}"));
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
