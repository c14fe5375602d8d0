//! Solids of revolution about z, for what has no CAD: links, nozzle, plates. They are made once;
//! moving one only changes where it stands.

use super::palette::Rgb;
use crate::part::{Hasher, angle};
use crate::view::MeshItem;
use nalgebra::{Isometry3, Point3, Translation3, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

/// Facets around: a link of 300 pixels shows no corners.
const AROUND: usize = 64;
/// Rings of a hemisphere.
const RINGS: usize = 10;

/// A solid in its own frame, mm.
#[derive(Clone, Debug)]
pub struct ColoredSolid {
    geometry_key: u64,
    positions: Arc<Vec<[f32; 3]>>,
    colors_key: u64,
    facet_colors: Arc<Vec<[u8; 4]>>,
}

impl ColoredSolid {
    /// Turns a profile of radius and height about z; it runs upwards along the outside.
    pub fn turned(profile: &[[f64; 2]], [r, g, b]: Rgb, alpha: u8) -> ColoredSolid {
        let ring = |[radius, z]: [f64; 2], k: usize| {
            let (sin, cos) = libm::sincos(TAU * (k % AROUND) as f64 / AROUND as f64);
            [(radius * cos) as f32, (radius * sin) as f32, z as f32]
        };
        let mut positions = Vec::new();
        for w in profile.windows(2) {
            for k in 0..AROUND {
                let [a, b, c, d] = [ring(w[0], k), ring(w[0], k + 1), ring(w[1], k + 1), ring(w[1], k)];
                // No facets without area where the profile meets the axis.
                if w[0][0] > 0.0 {
                    positions.extend([a, b, c]);
                }
                if w[1][0] > 0.0 {
                    positions.extend([a, c, d]);
                }
            }
        }
        let numbers: Vec<f64> = profile.iter().flatten().copied().collect();
        let facet_colors = vec![[r, g, b, alpha]; positions.len() / 3];
        ColoredSolid {
            geometry_key: Hasher::default().f64s(&numbers).finish().0 as u64,
            positions: Arc::new(positions),
            colors_key: u64::from(u32::from_be_bytes([r, g, b, alpha])),
            facet_colors: Arc::new(facet_colors),
        }
    }

    /// A rod from z = 0 to z = length, either end flat or a hemisphere that reaches beyond it.
    pub fn rod(radius_mm: f64, length_mm: f64, domes: [bool; 2], color: Rgb) -> ColoredSolid {
        let quarter = |z: f64, sense: f64| {
            (0..=RINGS).map(move |k| {
                let (sin, cos) = libm::sincos(FRAC_PI_2 * k as f64 / RINGS as f64);
                // The pole lies on the axis exactly.
                [if k == RINGS { 0.0 } else { radius_mm * cos }, z + sense * radius_mm * sin]
            })
        };
        let mut low: Vec<[f64; 2]> = match domes[0] {
            true => quarter(0.0, -1.0).collect(),
            false => vec![[radius_mm, 0.0], [0.0, 0.0]],
        };
        low.reverse();
        match domes[1] {
            true => low.extend(quarter(length_mm, 1.0)),
            false => low.extend([[radius_mm, length_mm], [0.0, length_mm]]),
        }
        ColoredSolid::turned(&low, color, 255)
    }

    /// The solid at a place.
    pub fn at(&self, scene_from_item: Isometry3<f64>) -> MeshItem {
        MeshItem {
            geometry_key: self.geometry_key,
            positions: self.positions.clone(),
            colors_key: self.colors_key,
            facet_colors: self.facet_colors.clone(),
            edges: None,
            scene_from_item,
        }
    }
}

/// Place of a solid whose z leads from one point towards another.
pub fn along(from: &Point3<f64>, to: &Point3<f64>) -> Isometry3<f64> {
    let z = angle::unit(to - from).unwrap_or_else(Vector3::z);
    Isometry3::from_parts(Translation3::from(from.coords), angle::rotation_between(&Vector3::z(), &z))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Volume by the divergence theorem: positive only if facets face outwards.
    fn volume(solid: &ColoredSolid) -> f64 {
        let v = |p: [f32; 3]| Vector3::from(p).cast::<f64>();
        solid.positions.chunks_exact(3).map(|c| v(c[0]).dot(&v(c[1]).cross(&v(c[2]))) / 6.0).sum()
    }

    #[test]
    fn solids_face_outwards_and_have_their_volume() {
        let pi = std::f64::consts::PI;
        let near = |solid: ColoredSolid, mm3: f64| {
            let off = volume(&solid) / mm3 - 1.0;
            assert!((-0.012..0.0).contains(&off), "inscribed, so a little less: {off}");
        };
        near(ColoredSolid::rod(20.0, 100.0, [false, false], [0; 3]), pi * 400.0 * 100.0);
        near(ColoredSolid::rod(20.0, 100.0, [true, true], [0; 3]), pi * 400.0 * 100.0 + 4.0 / 3.0 * pi * 8000.0);
        near(ColoredSolid::turned(&[[0.0, 0.0], [30.0, 0.0], [0.0, 60.0]], [0; 3], 255), pi * 900.0 * 20.0);
    }

    #[test]
    fn along_leads_there() {
        let (from, to) = (Point3::new(1.0, 2.0, 3.0), Point3::new(-4.0, 0.0, 9.0));
        let place = along(&from, &to);
        let length = (to - from).norm();
        assert!((place * Point3::new(0.0, 0.0, length) - to).norm() < 1e-9);
        let down = along(&from, &(from - Vector3::z()));
        assert!((down * Vector3::z() + Vector3::z()).norm() < 1e-9);
    }
}
