//! Signed distances and patches of scans with known truth: planes, rounds, needles, sheets, and wear by formula.

use super::*;
use crate::part::{Mesh, Placement, Units};
use crate::sample::{solids, stl_bytes};
use nalgebra::Vector3;

mod distances;
mod wear;

/// Numbers that look random, the same each time (Steele and others, splitmix64, 2014).
struct Draw(u64);

impl Draw {
    fn even(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ z >> 31) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Normally distributed (Box and Muller).
    fn normal(&mut self) -> f64 {
        let (u, v) = (1.0 - self.even(), self.even());
        (-2.0 * libm::log(u)).sqrt() * libm::cos(std::f64::consts::TAU * v)
    }

    /// A point of a mesh, even over its area, and its facet.
    fn on(&mut self, mesh: &Mesh, up_to: &[f64]) -> (Point3<f64>, usize) {
        let at = self.even() * up_to.last().copied().unwrap_or_default();
        let f = up_to.partition_point(|a| *a < at).min(up_to.len() - 1);
        let [a, b, c] = mesh.corners(f);
        let (mut u, mut v) = (self.even(), self.even());
        if u + v > 1.0 {
            (u, v) = (1.0 - u, 1.0 - v);
        }
        (a + (b - a) * u + (c - a) * v, f)
    }
}

fn part_of(triangles: &[[[f64; 3]; 3]]) -> Part {
    Part::from_bytes(&stl_bytes(&triangles.to_vec()), Units::Mm, &Placement::default(), &[]).expect("a part")
}

/// Areas of the facets, summed up.
fn sums(mesh: &Mesh) -> Vec<f64> {
    let mut sum = 0.0;
    mesh.areas
        .iter()
        .map(|a| {
            sum += a;
            sum
        })
        .collect()
}

fn measured(part: &Part, points: &[Point3<f64>]) -> (Cloud, Deviation) {
    let cloud = Cloud::of_points(points);
    let rules = DeviationRules { within_mm: 5.0 };
    let deviation = Deviation::new(part, &cloud, &rules, &Progress::default()).expect("nobody cancels");
    (cloud, deviation)
}

/// A square sheet in the plane z = 0 about the origin, of two facets.
fn sheet(side: f64) -> Vec<[[f64; 3]; 3]> {
    let h = 0.5 * side;
    let [a, b, c, d] = [[-h, -h, 0.0], [h, -h, 0.0], [h, h, 0.0], [-h, h, 0.0]];
    vec![[a, b, c], [a, c, d]]
}
