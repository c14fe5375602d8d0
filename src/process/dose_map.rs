//! The dose on all samples of the surface, and which passes it comes from at a point.

use super::landed::{J_CM2, landed};
use super::light::Light;
use super::lit_facets::NearPiece;
use super::parameters::Thresholds;
use super::samples::DoseSample;
use super::shade::{LastShade, Shade, SurfacePoint};
use crate::beam::Obstacle;
use crate::part::Part;
use nalgebra::{Point3, Vector3};
use std::collections::BTreeMap;

/// The dose on all samples.
#[derive(Clone, Debug)]
pub struct DoseMap {
    /// Facet by facet.
    pub samples: Vec<DoseSample>,
    /// Their corners, mm, part frame.
    pub corners: Vec<[f32; 3]>,
    /// Where the samples of each facet begin; one more than there are facets.
    pub(super) starts: Vec<u32>,
    /// Greatest width of a sample in the light, corner to corner, mm.
    pub sample_mm: f64,
    /// The part was so large that samples are larger than a quarter of the spot.
    pub coarsened: bool,
    /// Which doses are too little and too much.
    pub thresholds: Thresholds,
    /// Thresholds of facets whose surfaces have their own, by facet.
    pub(super) own: BTreeMap<u32, Thresholds>,
    /// The surfaces that are to be cleaned.
    pub chosen: Vec<u32>,
    /// The light that it was made by.
    pub light: Light,
}

/// What one pass leaves at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotHit {
    /// Number of the pass.
    pub pass: u32,
    /// When most of it lands, s from the program's start.
    pub at_s: f64,
    /// Angle between light and normal, degrees, weighed by energy.
    pub angle_deg: f64,
    /// What lands, J/cm².
    pub j_cm2: f64,
}

impl DoseMap {
    /// The samples of a facet: none where it has no area.
    pub fn of_facet(&self, facet: u32) -> &[DoseSample] {
        let at = |f: usize| self.starts.get(f).map_or(self.samples.len(), |s| *s as usize);
        &self.samples[at(facet as usize)..at(facet as usize + 1)]
    }

    /// The corners of a sample, counter-clockwise seen from the side that is worked on.
    pub fn corners_of(&self, sample: &DoseSample) -> &[[f32; 3]] {
        let first = sample.first_corner as usize;
        self.corners.get(first..first + usize::from(sample.corner_count)).unwrap_or_default()
    }

    /// Which passes come to a point of a facet, when, and at what angle, in the order of the program.
    pub fn hits_at(
        &self,
        part: &Part,
        clamps: &[Obstacle],
        facet: u32,
        q: &Point3<f64>,
        normal: &Vector3<f64>,
    ) -> Vec<SpotHit> {
        let shade = Shade::new(part, clamps);
        let (at, mut last) = (SurfacePoint { p: *q, facet }, LastShade::default());
        let mut hits: Vec<(SpotHit, f64)> = Vec::new();
        for piece in 0..self.light.pieces.len() as u32 {
            let near = NearPiece { piece, clear: false };
            let Some(l) = landed(&self.light, &shade, &near, &at, normal, &mut last) else { continue };
            if l.j_mm2 <= 0.0 {
                continue;
            }
            let j_cm2 = l.j_mm2 * J_CM2;
            match hits.last_mut().filter(|(h, _)| h.pass == l.pass) {
                Some((h, most)) => {
                    h.angle_deg = (h.angle_deg * h.j_cm2 + l.angle_deg * j_cm2) / (h.j_cm2 + j_cm2);
                    h.j_cm2 += j_cm2;
                    if j_cm2 > *most {
                        (h.at_s, *most) = (l.at_s, j_cm2);
                    }
                }
                None => {
                    let hit = SpotHit { pass: l.pass, at_s: l.at_s, angle_deg: l.angle_deg, j_cm2 };
                    hits.push((hit, j_cm2));
                }
            }
        }
        hits.into_iter().map(|(h, _)| h).collect()
    }
}
