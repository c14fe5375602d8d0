//! What the view reports to its owner in each frame, in physical pixels.

use super::camera::Camera;
use super::error::ViewError;
use super::lens::ViewSize;
use super::standard_view::StandardView;
use eframe::egui::{self, Pos2, Rect, Response, emath::GuiRounding as _, vec2};
use nalgebra::{Point2, Point3};

/// What happened in this frame. Pixels are physical, from the view's top-left corner.
#[derive(Debug, Clone)]
pub struct ViewportResponse {
    /// Left click. The second click of a double click is only reported as that.
    pub clicked_px: Option<Point2<f64>>,
    /// Where the brush is, while the left button is down and the view has a brush.
    pub painted_px: Option<Point2<f64>>,
    /// Two corners of a box that was drawn.
    pub boxed_px: Option<[Point2<f64>; 2]>,
    /// Left double click.
    pub double_clicked_px: Option<Point2<f64>>,
    /// Right click, unless the mouse was moved in between.
    pub secondary_clicked_px: Option<Point2<f64>>,
    /// Where the mouse is, while it is over the view and not over the cube or dragging.
    pub hover_px: Option<Point2<f64>>,
    /// A drag is going on; hover effects should wait.
    pub dragging: bool,
    /// The camera is not where it was in the last frame.
    pub camera_changed: bool,
    /// Keys held meanwhile (Ctrl toggles, Shift adds).
    pub modifiers: egui::Modifiers,
    /// The face of the view cube that was clicked; the view already glides there.
    pub view_chosen: Option<StandardView>,
    /// Size of the view, for the camera's methods.
    pub size: ViewSize,
    /// Why there is no picture.
    pub failure: Option<ViewError>,
    /// For a context menu, a tooltip, or the place of labels (in points).
    pub response: Response,
}

impl ViewportResponse {
    /// Where a point of the scene is seen, in points of the window; `None` behind the eye.
    pub fn on_screen(&self, camera: &Camera, at: &Point3<f64>) -> Option<Pos2> {
        let (x, y, _) = camera.project(at, self.size)?;
        let per_point = f64::from(self.response.ctx.pixels_per_point());
        Some(self.response.rect.min + vec2((x / per_point) as f32, (y / per_point) as f32))
    }
}

/// The widget's rectangle on whole pixels.
pub(super) struct PixelRect {
    pub rect: Rect,
    pub px_per_point: f64,
    pub size: ViewSize,
}

impl PixelRect {
    pub fn new(rect: Rect, pixels_per_point: f32) -> Self {
        let rect = rect.round_to_pixels(pixels_per_point);
        let px = |points: f32| f64::from((points * pixels_per_point).round());
        let size = ViewSize::new(px(rect.width()), px(rect.height()));
        Self { rect, px_per_point: f64::from(pixels_per_point), size }
    }

    pub fn to_px(&self, pos: Pos2) -> Point2<f64> {
        let offset = pos - self.rect.min;
        Point2::new(f64::from(offset.x), f64::from(offset.y)) * self.px_per_point
    }
}
