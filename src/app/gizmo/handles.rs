//! The handles on the screen: where arrows and rings are seen, which one the pointer is on, and their look.

use crate::view::{AXIS_COLORS, Camera, ViewSize};
use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, vec2};
use nalgebra::{Isometry3, Point3, Vector3};
use std::f64::consts::TAU;

/// Length of an arrow on the screen, and radius of a ring, points.
const ARROW: f64 = 78.0;
const RING: f64 = 56.0;
/// The pointer is on a handle this near to it, points.
const CATCH: f32 = 7.0;
/// Pieces that a ring is drawn of.
const PIECES: usize = 48;
/// A handle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) struct Handle {
    /// The axis that it moves along or turns about: 0, 1 or 2.
    pub axis: usize,
    /// Which of both.
    pub way: Way,
}

/// How a handle moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum Way {
    /// Along its axis.
    Along,
    /// Around it.
    Around,
}

/// A handle as a line on the screen.
pub(super) struct Placed {
    handle: Handle,
    line: Vec<Pos2>,
}

/// All handles of something that stands at a pose of the scene.
pub(super) fn placed(pose: &Isometry3<f64>, rect: Rect, camera: &Camera, per_point: f64) -> Vec<Placed> {
    let size = ViewSize::new(f64::from(rect.width()) * per_point, f64::from(rect.height()) * per_point);
    let origin = Point3::from(pose.translation.vector);
    let mm_per_point = per_point / camera.px_per_mm(&origin, size);
    let on_screen = |at: Vector3<f64>| {
        let (x, y, _) = camera.project(&(pose * Point3::from(at * mm_per_point)), size)?;
        Some(rect.min + vec2((x / per_point) as f32, (y / per_point) as f32))
    };
    let arrow = |axis: usize| {
        let line = [0.0, ARROW].map(|length| on_screen(Vector3::ith(axis, length)));
        line.into_iter().collect::<Option<Vec<_>>>()
    };
    let ring = |axis: usize| {
        let at = |piece: usize| {
            let rad = TAU * piece as f64 / PIECES as f64;
            let (u, v) = (Vector3::ith((axis + 1) % 3, libm::cos(rad)), Vector3::ith((axis + 2) % 3, libm::sin(rad)));
            on_screen((u + v) * RING)
        };
        (0..=PIECES).map(at).collect::<Option<Vec<_>>>()
    };
    let handle = |way, axis, line: Option<Vec<Pos2>>| Some(Placed { handle: Handle { axis, way }, line: line? });
    let arrows = (0..3).filter_map(|axis| handle(Way::Along, axis, arrow(axis)));
    arrows.chain((0..3).filter_map(|axis| handle(Way::Around, axis, ring(axis)))).collect()
}

/// The handle that is nearest to a place, within reach of the pointer; arrows before rings.
pub(super) fn at(pos: Pos2, placed: &[Placed]) -> Option<Handle> {
    let away = |p: &Placed| {
        // Near the middle all arrows meet: there none is meant.
        let pairs = p
            .line
            .windows(2)
            .map(|w| if p.handle.way == Way::Along { [w[0].lerp(w[1], 0.25), w[1]] } else { [w[0], w[1]] });
        pairs.map(|w| distance(pos, w)).fold(f32::INFINITY, f32::min)
    };
    let near = |way: Way| {
        let all = placed.iter().filter(|p| p.handle.way == way).map(|p| (away(p), p.handle));
        all.filter(|(far, _)| *far <= CATCH).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, handle)| handle)
    };
    near(Way::Along).or_else(|| near(Way::Around))
}

fn distance(pos: Pos2, [a, b]: [Pos2; 2]) -> f32 {
    let (along, off) = (b - a, pos - a);
    let share = if along.length_sq() > 0.0 { (off.dot(along) / along.length_sq()).clamp(0.0, 1.0) } else { 0.0 };
    (pos - (a + along * share)).length()
}

/// Draws all handles, the one that is held or under the pointer brighter and wider.
pub(super) fn draw(painter: &Painter, placed: &[Placed], lit: Option<Handle>) {
    for Placed { handle, line } in placed {
        let is_lit = lit == Some(*handle);
        let color = if is_lit { Color32::WHITE } else { AXIS_COLORS[handle.axis] };
        let width = if is_lit { 4.0 } else { 2.5 };
        painter.add(Shape::line(line.clone(), Stroke::new(width + 2.0, Color32::from_black_alpha(120))));
        painter.add(Shape::line(line.clone(), Stroke::new(width, color)));
        if let (Way::Along, [.., from, to]) = (handle.way, &line[..]) {
            let along = (*to - *from).normalized();
            let (side, tip) = (vec2(-along.y, along.x) * 5.0, *to + along * 9.0);
            painter.add(Shape::convex_polygon(vec![*to + side, *to - side, tip], color, Stroke::NONE));
            let letter = ["x", "y", "z"][handle.axis];
            let font = eframe::egui::FontId::proportional(13.0);
            painter.text(tip + along * 8.0, eframe::egui::Align2::CENTER_CENTER, letter, font, color);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pointer_finds_what_it_is_on() {
        let rect = Rect::from_min_size(Pos2::new(100.0, 50.0), vec2(800.0, 600.0));
        let camera = Camera::default();
        let pose = Isometry3::from_parts(camera.target.coords.into(), nalgebra::UnitQuaternion::identity());
        let all = placed(&pose, rect, &camera, 1.0);
        assert_eq!(all.len(), 6);
        for p in &all {
            let middle = p.line[p.line.len() * 2 / 3];
            let end = if p.handle.way == Way::Along { p.line[1] } else { middle };
            let found = at(end, &all).expect("a handle");
            // Where a ring is crossed by an arrow, that comes first.
            assert!(found == p.handle || found.way == Way::Along, "{found:?} where {:?} is", p.handle);
        }
        assert_eq!(at(rect.min, &all), None);
    }
}
