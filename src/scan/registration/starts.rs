//! From where the search sets out: turns all over, the scan's middle on the model's, and shifted along its main axis.
//!
//! No features and no axes of the scan: plane faces have none of the former, and half a scan has others than the whole.

use crate::part::Mesh;
use nalgebra::{Matrix3, Point3, SymmetricEigen, UnitQuaternion, Vector3};
use std::f64::consts::{PI, TAU};

/// Directions of the turned z axis, and turns about each: no turn is further than 24° from one of them.
const DIRECTIONS: usize = 72;
const TURNS: usize = 16;
/// Shifts along the model's axes, as shares of its extent there. A scan of half a part has its middle up to a quarter off;
/// without these 3 of 9 camshaft poses with half missing end up half a turn wrong.
const SHIFT: f64 = 0.15;
/// An axis with less than this share of the diagonal needs no shift: 15 % of it are less than a third of the first width.
const SHIFTED_FROM: f64 = 0.3;

/// The turns: Fibonacci directions, equal turns about each.
pub(in crate::scan) fn turns() -> Vec<UnitQuaternion<f64>> {
    let golden = PI * (3.0 - 5.0f64.sqrt());
    let mut out = Vec::with_capacity(DIRECTIONS * TURNS);
    for i in 0..DIRECTIONS {
        let z = 1.0 - (2 * i + 1) as f64 / DIRECTIONS as f64;
        let (r, angle) = ((1.0 - z * z).sqrt(), golden * i as f64);
        let axis = Vector3::new(r * libm::cos(angle), r * libm::sin(angle), z);
        // No direction is exactly −z, so a shortest turn there exists.
        let there = UnitQuaternion::rotation_between(&Vector3::z(), &axis).unwrap_or_default();
        out.extend(
            (0..TURNS)
                .map(|k| there * UnitQuaternion::from_scaled_axis(Vector3::z() * (TAU * k as f64 / TURNS as f64))),
        );
    }
    out
}

/// Where the skin of a model lies.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::scan) struct Skin {
    /// Its middle by area.
    pub(in crate::scan) middle: Point3<f64>,
    /// Its axes, each as long as its extent there, mm.
    pub(in crate::scan) axes: [Vector3<f64>; 3],
}

impl Skin {
    /// By the moments of its facets (exact: of a triangle with corners a, b, c and area A,
    /// ∫ x xᵀ = A/12 (a aᵀ + b bᵀ + c cᵀ + (a + b + c)(a + b + c)ᵀ)).
    pub(in crate::scan) fn of(mesh: &Mesh) -> Skin {
        let (lo, _) = mesh.bounds();
        let (mut area, mut first, mut second) = (0.0, Vector3::zeros(), Matrix3::zeros());
        for f in 0..mesh.facets.len() {
            let corners = mesh.corners(f).map(|p| p - lo);
            let sum = corners[0] + corners[1] + corners[2];
            let squares = corners.iter().fold(sum * sum.transpose(), |s, c| s + c * c.transpose());
            area += mesh.areas[f];
            first += sum * (mesh.areas[f] / 3.0);
            second += squares * (mesh.areas[f] / 12.0);
        }
        Skin::by_moments(lo, area, first, second, &mesh.vertices)
    }

    /// Of points that lie evenly on it.
    pub(in crate::scan) fn of_points(points: &[Point3<f64>]) -> Skin {
        let from = points.first().copied().unwrap_or_else(Point3::origin);
        let (mut first, mut second) = (Vector3::zeros(), Matrix3::zeros());
        for d in points.iter().map(|p| p - from) {
            first += d;
            second += d * d.transpose();
        }
        Skin::by_moments(from, points.len() as f64, first, second, points)
    }

    /// By the moments about a place, and the extent of some points.
    fn by_moments(
        from: Point3<f64>,
        whole: f64,
        first: Vector3<f64>,
        second: Matrix3<f64>,
        points: &[Point3<f64>],
    ) -> Skin {
        let share = if whole > 0.0 { 1.0 / whole } else { 0.0 };
        let middle = first * share;
        let spread = SymmetricEigen::new(second * share - middle * middle.transpose());
        let axes = [0, 1, 2].map(|k| {
            let axis: Vector3<f64> = spread.eigenvectors.column(k).into_owned();
            let along = points.iter().map(|v| (v - from).dot(&axis));
            let (least, most) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), x| (l.min(x), m.max(x)));
            axis * (most - least).max(0.0)
        });
        Skin { middle: from + middle, axes }
    }

    /// Where the scan's middle may lie: on the skin's, and to both sides of it along each long axis.
    pub(in crate::scan) fn middles(&self, diagonal_mm: f64) -> Vec<Point3<f64>> {
        let long = self.axes.iter().filter(|a| a.norm() >= SHIFTED_FROM * diagonal_mm);
        let sides = long.flat_map(|a| [self.middle - a * SHIFT, self.middle + a * SHIFT]);
        std::iter::once(self.middle).chain(sides).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::parts_for_tests::part_of;
    use super::*;
    use crate::sample::solids;

    #[test]
    fn every_turn_is_near_one_of_them() {
        let all = turns();
        assert_eq!(all.len(), 1152);
        for i in 0..500 {
            let x = |k: f64| libm::sin(f64::from(i) * k);
            let turn = UnitQuaternion::from_scaled_axis(Vector3::new(x(1.3), x(2.1), x(3.7)) * 3.0);
            let nearest = all.iter().map(|t| t.angle_to(&turn)).fold(f64::INFINITY, f64::min);
            assert!(nearest.to_degrees() < 24.0, "{}", nearest.to_degrees());
        }
    }

    #[test]
    fn the_middle_of_a_cylinders_skin_is_its_own_and_its_axis_the_long_one() {
        let part = part_of(&solids::cylinder(5.0, 40.0, 48));
        let skin = Skin::of(&part.mesh);
        assert!((skin.middle - Point3::new(0.0, 0.0, 20.0)).norm() < 1e-5, "{}", skin.middle);
        let longest =
            skin.axes.iter().fold(Vector3::zeros(), |l: Vector3<f64>, a| if a.norm() > l.norm() { *a } else { l });
        assert!((longest.z.abs() - 40.0).abs() < 1e-6 && longest.xy().norm() < 1e-6, "{longest}");
        let middles = skin.middles(part.mesh.diagonal());
        let heights: Vec<i64> = middles.iter().map(|m| m.z.round() as i64).collect();
        assert!(heights == [20, 14, 26] || heights == [20, 26, 14], "{heights:?}");
    }
}
