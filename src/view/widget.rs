//! The 3D view as an egui widget: turns gestures into camera moves and clicks into reports.
//!
//! Drags orbit and pan as [`Navigation`] says, the wheel zooms at the cursor, clicks are
//! reported in physical pixels from the view's top-left corner. What a click means (selection,
//! menu, focus) is the caller's business.

use super::bounds::Bounds;
use super::camera::Camera;
use super::detail::Detail;
use super::dragging::Dragging;
use super::error::ViewError;
use super::flight::Flight;
use super::lens::{Projection, ViewSize};
use super::motion::Motion;
use super::navigation::{DragKind, Navigation};
use super::overlay::{self, CubeLabels};
use super::renderer::Renderer;
use super::scene::Scene;
use super::standard_view::StandardView;
use super::viewport_response::{PixelRect, ViewportResponse};
use eframe::egui::{self, Response, Sense};
use eframe::{egui_glow, glow};
use nalgebra::{Point3, Vector3};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// Zoom per point of wheel travel: one notch (40 to 50 points) is about a sixth.
const ZOOM_PER_POINT: f64 = 0.0035;

/// Where a ray first meets the part, for zooming at what is under the cursor. Gets the origin
/// and direction that [`Camera::ray_through`] gives.
pub type Pick<'a> = &'a dyn Fn(Point3<f64>, Vector3<f64>) -> Option<Point3<f64>>;

/// The view's own state, kept between frames.
///
/// Camera moves ([`Self::look`], [`Self::fit`], …) start in the next [`Self::show`]; ask egui for
/// a repaint when nothing else does.
#[derive(Debug)]
pub struct Viewport {
    /// From where the scene is seen now. Set it to jump, call the methods to glide.
    pub camera: Camera,
    /// Words on the view cube; none until its owner gives them.
    pub labels: CubeLabels,
    /// Accessible name of the view; empty until its owner gives one.
    pub name: String,
    /// A left drag is a stroke of the owner's brush, reported as `painted_px`; with Ctrl held it orbits as ever.
    pub brush: bool,
    /// Which buttons move the camera.
    pub navigation: Navigation,
    dragging: Dragging,
    flight: Option<Flight>,
    motion: Motion,
    moves: Vec<CameraMove>,
    size: Option<ViewSize>,
    drawing: Option<Arc<Mutex<Drawing>>>,
}

/// A camera move that waits until the size of the view is known.
#[derive(Debug, Clone, Copy)]
enum CameraMove {
    Look(StandardView),
    Fit(Bounds),
    Focus(Point3<f64>),
    Go(Camera),
    Reset(Bounds),
}

/// What the paint callback shares with the widget.
#[derive(Debug)]
struct Drawing {
    renderer: Renderer,
    failure: Option<ViewError>,
}

impl Viewport {
    /// A view on this context (`cc.gl` of eframe's creation context).
    ///
    /// # Errors
    /// As [`Renderer::new`].
    pub fn new(gl: Arc<glow::Context>) -> Result<Self, ViewError> {
        let drawing = Drawing { renderer: Renderer::new(gl)?, failure: None };
        let drawing = Some(Arc::new(Mutex::new(drawing)));
        Ok(Self { drawing, ..Self::without_picture() })
    }

    /// A view that obeys the mouse but draws only its background: where there is no OpenGL, and
    /// for tests that need no picture.
    pub fn without_picture() -> Self {
        Self {
            camera: Camera::default(),
            labels: CubeLabels::default(),
            name: String::new(),
            brush: false,
            navigation: Navigation::default(),
            dragging: Dragging::default(),
            flight: None,
            motion: Motion::default(),
            moves: Vec::new(),
            size: None,
            drawing: None,
        }
    }

    /// Lets go of all OpenGL objects; call it in `App::on_exit`, while the context still lives.
    pub fn release(&mut self) {
        self.drawing = None;
    }

    /// What the view showed last; `None`: there is no picture.
    pub fn picture(&self) -> Option<image::RgbaImage> {
        let drawing = self.drawing.as_ref()?.lock().unwrap_or_else(PoisonError::into_inner);
        Some(drawing.renderer.read_rgba()).filter(|picture| picture.width() > 0)
    }

    /// Glides to a standard view; target and zoom stay.
    pub fn look(&mut self, view: StandardView) {
        self.moves.push(CameraMove::Look(view));
    }

    /// Glides until the box fills the view; the direction stays.
    pub fn fit(&mut self, bounds: Bounds) {
        self.moves.push(CameraMove::Fit(bounds));
    }

    /// Glides until the point is in the middle; direction and zoom stay.
    pub fn focus(&mut self, point: Point3<f64>) {
        self.moves.push(CameraMove::Focus(point));
    }

    /// Glides to any camera, for example one fitted to a problem and its beam.
    pub fn glide_to(&mut self, camera: Camera) {
        self.moves.push(CameraMove::Go(camera));
    }

    /// A glide is under way or about to start.
    pub fn is_gliding(&self) -> bool {
        self.flight.is_some() || !self.moves.is_empty()
    }

    /// Size of the view when it was last shown.
    pub fn size(&self) -> Option<ViewSize> {
        self.size
    }

    /// Jumps to the iso view of a new part.
    pub fn reset(&mut self, bounds: Bounds) {
        self.moves.push(CameraMove::Reset(bounds));
    }

    /// Says how far the scene reaches, for clip planes and zoom limits.
    pub fn set_scene_bounds(&mut self, bounds: Bounds) {
        self.camera.scene_bounds = bounds;
        if let Some(flight) = &self.flight {
            let destination = Camera { scene_bounds: bounds, ..*flight.destination() };
            self.flight = Some(flight.redirected(destination));
        }
    }

    /// Perspective or parallel.
    pub fn set_projection(&mut self, projection: Projection) {
        self.camera.projection = projection;
        if let Some(flight) = &self.flight {
            let destination = Camera { projection, ..*flight.destination() };
            self.flight = Some(flight.redirected(destination));
        }
    }

    /// Fills the room that is left with the view.
    pub fn show(&mut self, ui: &mut egui::Ui, scene: &Arc<Scene>) -> ViewportResponse {
        self.show_with_pick(ui, scene, &|_, _| None)
    }

    /// Shows the scene as [`Self::show`] does, and zooms at the point of the part under the cursor.
    pub fn show_with_pick(&mut self, ui: &mut egui::Ui, scene: &Arc<Scene>, pick: Pick<'_>) -> ViewportResponse {
        let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, self.name.clone()));
        let frame = PixelRect::new(rect, ui.pixels_per_point());
        let before = self.camera;
        self.size = Some(frame.size);
        self.start_moves(ui, frame.size);
        self.apply_gestures(ui, &response, &frame, pick);
        self.fly(ui);

        let thinned = self.thins(ui, scene);
        self.paint(ui, scene, &frame, thinned);
        let cube = overlay::view_cube(ui, rect, &self.camera, &self.labels);
        overlay::triad(&ui.painter_at(rect), rect, &self.camera);
        if let Some(view) = cube.chosen {
            self.look(view);
            ui.ctx().request_repaint();
        }
        if cube.orbit != egui::Vec2::ZERO {
            self.flight = None;
            self.camera.orbit(f64::from(cube.orbit.x), f64::from(cube.orbit.y));
            ui.ctx().request_repaint();
        }
        self.report(ui, response, &frame, before, cube.chosen)
    }

    /// Applies what was asked for to the camera at the end of all gliding, and sets off.
    fn start_moves(&mut self, ui: &egui::Ui, size: ViewSize) {
        if self.moves.is_empty() {
            return;
        }
        let mut to = self.flight.as_ref().map_or(self.camera, |flight| *flight.destination());
        let mut jump = ui.style().animation_time <= 0.0;
        for wanted in std::mem::take(&mut self.moves) {
            match wanted {
                CameraMove::Look(view) => to.look(view),
                CameraMove::Fit(bounds) => to.fit(&bounds, size),
                CameraMove::Focus(point) => to.target = point,
                CameraMove::Go(camera) => to = camera,
                CameraMove::Reset(bounds) => {
                    to = Camera { projection: to.projection, ..Camera::fitted(bounds, size) };
                    to.fit(&bounds, size);
                    jump = true;
                }
            }
        }
        if jump {
            self.camera = to;
            self.flight = None;
            self.motion.jump(&to);
        } else {
            self.flight = Some(Flight::new(self.camera, to, ui.input(|input| input.time)));
        }
    }

    fn fly(&mut self, ui: &egui::Ui) {
        if let Some(flight) = &self.flight {
            let (camera, landed) = flight.at(ui.input(|input| input.time));
            self.camera = camera;
            if landed {
                self.flight = None;
            } else {
                ui.ctx().request_repaint();
            }
        }
    }

    /// Moves the camera by the mouse. A hand on the mouse ends a glide where it is.
    fn apply_gestures(&mut self, ui: &egui::Ui, response: &Response, frame: &PixelRect, pick: Pick<'_>) {
        let delta = response.drag_delta();
        let (dx, dy) = (f64::from(delta.x), f64::from(delta.y));
        self.dragging.begin(ui, response, self.navigation, self.brush);
        if let Some(kind) = self.dragging.kind(response) {
            let scale = frame.px_per_point;
            match kind {
                DragKind::Orbit => self.camera.orbit(dx, dy),
                DragKind::Pan => self.camera.pan(dx * scale, dy * scale, frame.size),
                DragKind::Zoom => self.camera.zoom_about(self.camera.target, libm::exp(-dy * 2.0 * ZOOM_PER_POINT)),
                DragKind::Box => {}
            }
            self.flight = self.flight.take().filter(|_| kind == DragKind::Box);
        }
        let Some(cursor_px) = response.hover_pos().map(|pos| frame.to_px(pos)) else {
            return;
        };
        let factor = ui.input(|input| {
            let wheel = f64::from(input.smooth_scroll_delta().y) * ZOOM_PER_POINT;
            f64::from(input.zoom_delta()) * libm::exp(wheel)
        });
        if factor != 1.0 {
            self.flight = None;
            let (origin, dir) = self.camera.ray_through(cursor_px, frame.size);
            match pick(origin, dir) {
                Some(point) => self.camera.zoom_about(point, factor),
                None => self.camera.zoom_at(cursor_px, factor, frame.size),
            }
        }
    }

    fn paints(&self, ui: &egui::Ui) -> bool {
        self.brush && !ui.input(|input| input.modifiers.command)
    }

    /// Whether less is drawn in this frame because the camera moves; the one that shows the whole scene is asked for.
    fn thins(&mut self, ui: &egui::Ui, scene: &Scene) -> bool {
        let rest_in_s = self.motion.follow(&self.camera, ui.input(|input| input.time));
        let Some((rest_in_s, drawing)) = rest_in_s.zip(self.drawing.as_ref()) else { return false };
        let thins = drawing.lock().unwrap_or_else(PoisonError::into_inner).renderer.thins(scene);
        if thins {
            ui.ctx().request_repaint_after(Duration::from_secs_f64(rest_in_s));
        }
        thins
    }

    fn paint(&self, ui: &egui::Ui, scene: &Arc<Scene>, frame: &PixelRect, thinned: bool) {
        let Some(drawing) = &self.drawing else {
            let [r, g, b] = scene.background_bottom;
            ui.painter().rect_filled(frame.rect, 0.0, egui::Color32::from_rgb(r, g, b));
            return;
        };
        let (scene, drawing) = (Arc::clone(scene), Arc::clone(drawing));
        let (camera, size, rect) = (self.camera, frame.size, frame.rect);
        let callback = egui_glow::CallbackFn::new(move |info, _painter| {
            let mut drawing = drawing.lock().unwrap_or_else(PoisonError::into_inner);
            let size_px = [size.width_px as u32, size.height_px as u32];
            let detail = Detail { px_per_point: info.pixels_per_point, thinned };
            let drawn = drawing.renderer.draw_in_detail(&scene, &camera, size_px, detail);
            drawing.failure = drawn.err();
            // Not `info.viewport_in_pixels()`: that one shrinks at the window's edge.
            let left_px = (rect.min.x * info.pixels_per_point).round() as i32;
            let bottom_px = (rect.max.y * info.pixels_per_point).round() as i32;
            let from_bottom_px = info.screen_size_px[1] as i32 - bottom_px;
            let [width_px, height_px] = size_px.map(|px| px as i32);
            drawing.renderer.blit(left_px, from_bottom_px, width_px, height_px);
        });
        ui.painter().add(egui::PaintCallback { rect, callback: Arc::new(callback) });
    }

    fn report(
        &self,
        ui: &egui::Ui,
        response: Response,
        frame: &PixelRect,
        before: Camera,
        view_chosen: Option<StandardView>,
    ) -> ViewportResponse {
        let failure = self
            .drawing
            .as_ref()
            .and_then(|drawing| drawing.lock().unwrap_or_else(PoisonError::into_inner).failure.clone());
        let pointer_px = response.interact_pointer_pos().map(|pos| frame.to_px(pos));
        let double = response.double_clicked();
        let dragging = response.dragged();
        let drawn = self.dragging.drawn_box(ui, &response);
        if let Some((drawn, false)) = drawn {
            overlay::selection_box(&ui.painter_at(response.rect), drawn);
        }
        let boxed = drawn.filter(|(_, is_over)| *is_over);
        let is_pressed = response.is_pointer_button_down_on() && ui.input(|input| input.pointer.primary_down());
        let hover_px = response.hover_pos().filter(|_| response.hovered() && !dragging);
        ViewportResponse {
            clicked_px: pointer_px.filter(|_| response.clicked() && !double),
            painted_px: pointer_px.filter(|_| is_pressed && self.paints(ui)),
            boxed_px: boxed.map(|(drawn, _)| [drawn.min, drawn.max].map(|corner| frame.to_px(corner))),
            double_clicked_px: pointer_px.filter(|_| double),
            secondary_clicked_px: pointer_px.filter(|_| response.secondary_clicked()),
            hover_px: hover_px.map(|pos| frame.to_px(pos)),
            dragging,
            camera_changed: self.camera != before,
            modifiers: ui.input(|input| input.modifiers),
            view_chosen,
            size: frame.size,
            failure,
            response,
        }
    }
}
