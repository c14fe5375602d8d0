//! Balls, boxes, planes and sections as lines: what a brush went over, and what cuts a scan.

use super::palette::{Rgb, scan};
use crate::part::Hasher;
use crate::view::{Depth, LineItem, LineSegment};
use nalgebra::{Isometry3, Point3, Unit, Vector3};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Sides of a circle: round to the eye at the size of a hand.
const SIDES: usize = 32;
const WIDTH_PX: f32 = 1.6;

/// Lines of regions, in one colour, in the frame that they are given in.
#[derive(Clone, Debug, Default)]
pub struct RegionLines {
    pieces: Vec<[Point3<f64>; 2]>,
}

impl RegionLines {
    /// A ball, as a circle across each axis.
    pub fn ball(&mut self, centre: Point3<f64>, radius_mm: f64) {
        for axis in 0..3 {
            let [u, v] = [1, 2].map(|k| Vector3::ith((axis + k) % 3, radius_mm));
            let at = |k: usize| {
                let (sin, cos) = libm::sincos(TAU * k as f64 / SIDES as f64);
                centre + u * cos + v * sin
            };
            self.pieces.extend((0..SIDES).map(|k| [at(k), at(k + 1)]));
        }
    }

    /// A box along the axes, by its edges.
    pub fn cuboid(&mut self, min: Point3<f64>, max: Point3<f64>) {
        let corner = |i: usize| Point3::from(Vector3::from_fn(|k, _| if i >> k & 1 == 0 { min[k] } else { max[k] }));
        for i in 0..8 {
            self.pieces.extend((0..3).filter(|k| i >> k & 1 == 0).map(|k| [corner(i), corner(i | 1 << k)]));
        }
    }

    /// A square of a plane with its diagonals, and its normal, which points to what is kept.
    pub fn plane(&mut self, through: Point3<f64>, normal: Unit<Vector3<f64>>, half_mm: f64) {
        let aside = if normal.x.abs() < 0.9 { Vector3::x() } else { Vector3::y() };
        let u = normal.cross(&aside).normalize() * half_mm;
        let v = normal.cross(&u);
        let corners = [u + v, v - u, -u - v, u - v].map(|d| through + d);
        self.pieces.extend((0..4).map(|k| [corners[k], corners[(k + 1) % 4]]));
        self.pieces.extend([[corners[0], corners[2]], [corners[1], corners[3]]]);
        self.pieces.push([through, through + normal.into_inner() * (0.5 * half_mm)]);
    }

    /// A line through points.
    pub fn line(&mut self, points: &[Point3<f64>]) {
        self.pieces.extend(points.windows(2).map(|w| [w[0], w[1]]));
    }

    /// What is to be drawn; seen through everything.
    pub fn item(&self, scene_from_item: Isometry3<f64>) -> LineItem {
        self.item_of_width(WIDTH_PX, scene_from_item)
    }

    /// What is to be drawn, so many pixels wide.
    pub fn item_of_width(&self, width_px: f32, scene_from_item: Isometry3<f64>) -> LineItem {
        let [r, g, b]: Rgb = scan::REGION;
        let single = |p: &Point3<f64>| [p.x as f32, p.y as f32, p.z as f32];
        let segment = |[a, b_]: &[Point3<f64>; 2]| LineSegment { a: single(a), b: single(b_), color: [r, g, b, 255] };
        let segments: Vec<LineSegment> = self.pieces.iter().map(segment).collect();
        let bits: Vec<u32> = segments.iter().flat_map(|s| s.a.into_iter().chain(s.b)).map(f32::to_bits).collect();
        LineItem {
            key: Hasher::default().u32s(&bits).finish().0 as u64,
            segments: Arc::new(segments),
            width_px,
            depth: Depth::OnTop,
            scene_from_item,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_lie_on_what_they_stand_for() {
        let (centre, normal) = (Point3::new(1.0, 2.0, 3.0), Unit::new_normalize(Vector3::new(1.0, -2.0, 0.5)));
        let mut ball = RegionLines::default();
        ball.ball(centre, 4.0);
        assert!(ball.pieces.iter().flatten().all(|p| ((p - centre).norm() - 4.0).abs() < 1e-9));
        let mut cuboid = RegionLines::default();
        cuboid.cuboid(Point3::origin(), Point3::new(1.0, 2.0, 3.0));
        let length: f64 = cuboid.pieces.iter().map(|[a, b]| (b - a).norm()).sum();
        assert!(cuboid.pieces.len() == 12 && (length - 24.0).abs() < 1e-12);
        let mut plane = RegionLines::default();
        plane.plane(centre, normal, 5.0);
        let (up, flat) = plane.pieces.split_last().expect("lines");
        assert!(flat.iter().flatten().all(|p| (p - centre).dot(&normal).abs() < 1e-9));
        assert!((up[1] - centre).dot(&normal) > 2.4);
    }
}
