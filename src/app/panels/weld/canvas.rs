//! An image with a mask over it that is shifted, enlarged and painted on. Both images of a weld are drawn by it, at the
//! same place and scale; a stroke that is being painted is seen on both.

use super::super::super::weld::{ImageHand, ImagesView};
use crate::weld::masking::BrushStroke;
use eframe::egui::{
    self, Color32, PointerButton, Pos2, Rect, Response, Role, Sense, Shape, Stroke, TextureHandle, Vec2, WidgetInfo,
    pos2, vec2,
};

/// A turn of the wheel enlarges by so much a point.
const ZOOM_PER_POINT: f64 = 0.004;
/// A stroke before it is done: what it adds, and what it takes away.
const ADDS: Color32 = Color32::from_rgba_premultiplied(110, 52, 0, 110);
const ERASES: Color32 = Color32::from_rgba_premultiplied(0, 50, 90, 110);

/// An image on the graphics card, and its mask.
pub(super) struct Pane<'a> {
    pub image: &'a TextureHandle,
    pub mask: Option<&'a TextureHandle>,
    /// Its accessible name.
    pub told: String,
}

/// What the hand did.
#[derive(Default)]
pub(super) struct CanvasOutput {
    /// The pixel under the cursor.
    pub hovered_px: Option<[f64; 2]>,
    /// A stroke that has ended.
    pub stroke: Option<BrushStroke>,
}

/// Where pixels are on the screen.
#[derive(Clone, Copy)]
struct Place {
    middle: Pos2,
    middle_px: [f64; 2],
    points_per_px: f64,
}

impl Place {
    fn screen(self, at: [f64; 2]) -> Pos2 {
        let [x, y] = [0, 1].map(|k| ((at[k] - self.middle_px[k]) * self.points_per_px) as f32);
        self.middle + vec2(x, y)
    }

    fn pixel(self, at: Pos2) -> [f64; 2] {
        let off = at - self.middle;
        let [u, v] = self.middle_px;
        [u + f64::from(off.x) / self.points_per_px, v + f64::from(off.y) / self.points_per_px]
    }
}

/// Draws an image of `size_px` as `shown` says, and changes `view` by what the hand does.
pub(super) fn ui(
    ui: &mut egui::Ui,
    size: Vec2,
    pane: &Pane<'_>,
    size_px: [usize; 2],
    shown: &ImagesView,
    view: &mut ImagesView,
) -> CanvasOutput {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &pane.told));
    let [width, height] = size_px.map(|n| n.max(1) as f64);
    let whole = (f64::from(rect.width()) / width).min(f64::from(rect.height()) / height);
    let points_per_px = whole * shown.zoom;
    let place = Place { middle: rect.center(), middle_px: shown.middle(size_px), points_per_px };
    draw(ui, rect, pane, place, [width, height], shown);
    let mut out = hand(ui, &response, place, size_px, view);
    if let Some(at) = response.hover_pos().filter(|at| rect.contains(*at)) {
        let px = place.pixel(at);
        out.hovered_px = Some(px);
        let (wheel, pinch) = ui.input(|i| (f64::from(i.smooth_scroll_delta().y), f64::from(i.zoom_delta())));
        let factor = libm::exp(ZOOM_PER_POINT * wheel) * pinch;
        if factor != 1.0 {
            view.zoom_at(px, factor, size_px);
        }
        if shown.hand != ImageHand::Pan {
            let radius = (shown.radius_px * points_per_px) as f32;
            ui.painter_at(rect).circle_stroke(at, radius, Stroke::new(1.5, Color32::WHITE));
        }
    }
    out
}

fn draw(ui: &egui::Ui, rect: Rect, pane: &Pane<'_>, place: Place, [width, height]: [f64; 2], shown: &ImagesView) {
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 0, Color32::from_gray(18));
    let image = Rect::from_min_max(place.screen([-0.5, -0.5]), place.screen([width - 0.5, height - 0.5]));
    let all = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    painter.image(pane.image.id(), image, all, Color32::WHITE);
    if let Some(mask) = pane.mask {
        painter.image(mask.id(), image, all, Color32::WHITE);
    }
    if let Some(stroke) = &shown.stroke {
        let color = if stroke.adds { ADDS } else { ERASES };
        let radius = (stroke.radius_px * place.points_per_px) as f32;
        let way: Vec<Pos2> = stroke.way_px.iter().map(|at| place.screen(*at)).collect();
        match way.as_slice() {
            [at] => drop(painter.circle_filled(*at, radius, color)),
            _ => drop(painter.add(Shape::line(way, Stroke::new(2.0 * radius, color)))),
        }
    }
}

/// Shifts and paints.
fn hand(ui: &egui::Ui, response: &Response, place: Place, size_px: [usize; 2], view: &mut ImagesView) -> CanvasOutput {
    let dragged = |button| response.dragged_by(button);
    let is_pan = view.hand == ImageHand::Pan;
    let adds = (view.hand == ImageHand::Add) != dragged(PointerButton::Secondary);
    let paints = !is_pan && (dragged(PointerButton::Primary) || dragged(PointerButton::Secondary));
    if paints {
        if let Some(at) = response.interact_pointer_pos() {
            let from = ui.input(|i| i.pointer.press_origin()).filter(|_| view.stroke.is_none());
            from.into_iter().chain([at]).for_each(|at| view.brush_to(place.pixel(at), adds));
        }
    } else if response.dragged() {
        let by = response.drag_delta();
        view.shift([by.x, by.y].map(|x| f64::from(x) / place.points_per_px), size_px);
    } else if !is_pan && (response.clicked() || response.secondary_clicked()) {
        // A dot.
        if let Some(at) = response.interact_pointer_pos() {
            view.stroke = None;
            view.brush_to(place.pixel(at), (view.hand == ImageHand::Add) != response.secondary_clicked());
            return CanvasOutput { stroke: view.stroke.take(), ..CanvasOutput::default() };
        }
    }
    let stroke = if response.drag_stopped() { view.stroke.take() } else { None };
    CanvasOutput { stroke, ..CanvasOutput::default() }
}
