//! What lies over the picture: the axes triad in the lower-left corner and the view cube in the
//! upper-right one. Painted with egui, so they stay sharp at any scale and cost no redrawing.

use super::camera::Camera;
use super::standard_view::StandardView;
use eframe::egui::{self, Align2, Color32, FontId, Pos2, Rect, Sense, Shape, Stroke, Vec2};
use nalgebra::{Matrix3, Vector3};

/// Distance of triad and cube from the edges of the view, in points.
const INSET: f32 = 12.0;
/// Half the space diagonal of the cube, and the length of the triad's axes, in points.
const CUBE_REACH: f32 = 46.0;
const TRIAD_REACH: f32 = 34.0;
/// Faces turned further away than this carry no label: it would not be read anyway.
const LABEL_FACING: f64 = 0.38;

/// x red, y green, z blue: bright enough for a dark background, dark enough for a light one.
pub const AXIS_COLORS: [Color32; 3] =
    [Color32::from_rgb(226, 74, 66), Color32::from_rgb(78, 178, 72), Color32::from_rgb(70, 128, 240)];

/// Words of the cube, given by its owner.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct CubeLabels {
    /// Accessible name of the whole cube.
    pub name: String,
    /// Front, back, left, right, top, bottom.
    pub faces: [String; 6],
}

/// What was done to the cube.
#[derive(Debug, Clone, Copy, Default)]
pub struct CubeResponse {
    /// The view whose face was clicked.
    pub chosen: Option<StandardView>,
    /// A drag of the cube turns the camera by so many points.
    pub orbit: Vec2,
}

/// Draws the directions of x, y and z.
pub fn triad(painter: &egui::Painter, view: Rect, camera: &Camera) {
    let origin = view.left_bottom() + Vec2::new(1.0, -1.0) * (INSET + TRIAD_REACH);
    let eye_from_scene = camera.axes().transpose();
    let mut axes: Vec<_> = (0..3).map(|axis| (axis, eye_from_scene.column(axis).into_owned())).collect();
    // Far ones first; the sort is stable, so a tie always falls the same way.
    axes.sort_by(|(_, a), (_, b)| a.z.total_cmp(&b.z));
    for (axis, direction) in axes {
        let tip = origin + on_screen(&direction) * TRIAD_REACH * 0.8;
        let color = AXIS_COLORS[axis];
        painter.line_segment([origin, tip], Stroke::new(2.5, color));
        // An axis along the view is a dot; its letter would hide it.
        if direction.xy().norm() > 0.15 {
            let letter = origin + on_screen(&direction) * TRIAD_REACH * 1.08;
            let name = ["X", "Y", "Z"][axis];
            painter.text(letter, Align2::CENTER_CENTER, name, FontId::proportional(12.0), color);
        } else {
            painter.circle_filled(origin, 3.0, color);
        }
    }
}

/// Draws the cube and reports what is done to it.
pub fn view_cube(ui: &egui::Ui, view: Rect, camera: &Camera, labels: &CubeLabels) -> CubeResponse {
    let center = view.right_top() + Vec2::new(-1.0, 1.0) * (INSET + CUBE_REACH);
    let area = Rect::from_center_size(center, Vec2::splat(2.0 * CUBE_REACH));
    // A view too small for both keeps its picture.
    if area.width() * 2.5 > view.width() || area.height() * 2.0 > view.height() {
        return CubeResponse::default();
    }
    let response = ui.interact(area, ui.scope_id().with("view cube"), Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, labels.name.clone()));
    let faces: Vec<Face> = Face::visible(camera, center);
    let pointed = response.hover_pos().and_then(|pos| faces.iter().find(|face| face.holds(pos)));
    for face in &faces {
        let hot = pointed.is_some_and(|pointed| pointed.view == face.view);
        face.paint(ui, hot, &labels.faces[face.label]);
    }
    CubeResponse {
        chosen: pointed.filter(|_| response.clicked()).map(|face| face.view),
        orbit: if response.dragged() { response.drag_delta() } else { Vec2::ZERO },
    }
}

/// One face of the cube as it is seen.
struct Face {
    view: StandardView,
    /// Index into the labels.
    label: usize,
    corners: [Pos2; 4],
    middle: Pos2,
    /// 1 when seen squarely, 0 from the side.
    facing: f64,
}

impl Face {
    /// The faces turned to the viewer; a cube hides none of them behind another.
    fn visible(camera: &Camera, center: Pos2) -> Vec<Self> {
        let eye_from_scene = camera.axes().transpose();
        let views = StandardView::ALL.iter().filter(|view| **view != StandardView::Iso);
        views
            .enumerate()
            .map(|(label, &view)| Self::seen(view, label, &eye_from_scene, center))
            .filter(|face| face.facing > 0.02)
            .collect()
    }

    fn seen(view: StandardView, label: usize, eye: &Matrix3<f64>, center: Pos2) -> Self {
        // A face looks to where the camera of its view stands.
        let mut looking = Camera::default();
        looking.look(view);
        let axes = looking.axes();
        let half_edge = CUBE_REACH / 3.0_f32.sqrt();
        let place = |in_scene: Vector3<f64>| center + on_screen(&(eye * in_scene)) * half_edge;
        let normal = axes.column(2).into_owned();
        let corner = |right: f64, up: f64| place(normal + axes.column(0) * right + axes.column(1) * up);
        Self {
            view,
            label,
            corners: [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)],
            middle: place(normal),
            facing: (eye * normal).z,
        }
    }

    /// Inside, if to the same side of all edges.
    fn holds(&self, pos: Pos2) -> bool {
        let side = |from: Pos2, to: Pos2| {
            let (edge, offset) = (to - from, pos - from);
            edge.x * offset.y - edge.y * offset.x <= 0.0
        };
        (0..4).all(|i| side(self.corners[i], self.corners[(i + 1) % 4]))
    }

    fn paint(&self, ui: &egui::Ui, hot: bool, label: &str) {
        let visuals = ui.visuals();
        // Shaded like the part: the squarer, the lighter.
        let shade = 0.72 + 0.28 * self.facing as f32;
        let (base, text) = if hot {
            (visuals.selection.bg_fill, visuals.selection.stroke.color)
        } else if visuals.dark_mode {
            (Color32::from_rgb(104, 114, 130), Color32::from_gray(240))
        } else {
            (Color32::from_rgb(236, 239, 244), Color32::from_gray(40))
        };
        let fill = Color32::from_rgba_unmultiplied(
            (f32::from(base.r()) * shade) as u8,
            (f32::from(base.g()) * shade) as u8,
            (f32::from(base.b()) * shade) as u8,
            225,
        );
        let rim = Stroke::new(1.0, Color32::from_black_alpha(110));
        ui.painter().add(Shape::convex_polygon(self.corners.to_vec(), fill, rim));
        if self.facing > LABEL_FACING {
            let size = 9.5 + 3.0 * self.facing as f32;
            let font = FontId::proportional(size);
            ui.painter().text(self.middle, Align2::CENTER_CENTER, label, font, text);
        }
    }
}

/// Eye's frame to egui's: y down, depth dropped.
fn on_screen(in_eye: &Vector3<f64>) -> Vec2 {
    Vec2::new(in_eye.x as f32, -in_eye.y as f32)
}

/// The box that selects what is in it.
pub(super) fn selection_box(painter: &egui::Painter, drawn: egui::Rect) {
    let color = egui::Color32::from_rgb(90, 170, 255);
    painter.rect(drawn, 0, color.gamma_multiply(0.15), egui::Stroke::new(1.0, color), egui::StrokeKind::Inside);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_standard_view_sees_its_own_face_in_the_middle() {
        let center = Pos2::new(100.0, 80.0);
        for view in &StandardView::ALL[1..] {
            let mut camera = Camera::default();
            camera.look(*view);
            let faces = Face::visible(&camera, center);
            assert_eq!(faces.len(), 1, "{view:?} sees one face");
            assert_eq!(faces[0].view, *view);
            assert!(faces[0].holds(center));
            assert!(!faces[0].holds(center + Vec2::splat(CUBE_REACH)));
        }
        let faces = Face::visible(&Camera::default(), center);
        let seen: Vec<_> = faces.iter().map(|face| face.view).collect();
        assert_eq!(seen, [StandardView::Front, StandardView::Right, StandardView::Top]);
        let below = faces.iter().find(|face| face.holds(center + Vec2::new(-12.0, 12.0)));
        assert_eq!(below.map(|face| face.view), Some(StandardView::Front), "front is left");
    }
}
