//! The skin as facets: where no model of the part is at hand, the surfaces of the parent metal around all areas become one
//! sheet, seen from the camera. It has no bead on it; where two areas are near each other their surfaces pass over into each
//! other, by how near they are.

use super::camera::DepthCamera;
use super::parent::{ParentSurface, REACH_MM};
use super::pixel_distance::distances_px;
use super::raster::{Mask, Raster};
use crate::part::raw_part::RawFacet;
use nalgebra::{Point3, Vector3};

/// Nodes of the sheet are so far apart, mm: on a skin of 300 mm radius a facet lies 0.007 mm off, on one of 1500 mm 0.0013.
/// Beads are cut finer.
const PITCH_MM: f64 = 4.0;
/// A ray meets a surface when a step moves it by less, mm.
const MET_MM: f64 = 1e-9;
const MOST_STEPS: usize = 40;

/// An area and the surface of the parent metal around it.
#[derive(Clone, Copy, Debug)]
pub struct AreaOnParent<'a> {
    /// Its pixels.
    pub outline: &'a Mask,
    /// The surface.
    pub parent: &'a ParentSurface,
}

/// Facets of the skin around areas, in the camera's frame, mm, outward towards the camera. Empty without areas.
pub fn skin(camera: &DepthCamera, areas: &[AreaOnParent<'_>]) -> Vec<RawFacet> {
    let Some(first) = areas.first() else { return Vec::new() };
    let (width, height) = (first.outline.width, first.outline.height);
    let depth_mm = (first.parent.camera_from_local.translation.vector.z).abs();
    let step = ((PITCH_MM * camera.fx / depth_mm) as usize).max(1);
    let reach: Vec<(&ParentSurface, Raster<f32>)> =
        areas.iter().map(|area| (area.parent, distances_px(area.outline))).collect();
    let node = |column: usize, row: usize| {
        let (u, v) = (column * step, row * step);
        let ray = camera.ray(u as f64, v as f64)?;
        let (mut sum, mut weights) = (0.0, 0.0);
        for (parent, distances) in &reach {
            let Some(z_mm) = met(parent, &ray) else { continue };
            let away_mm = f64::from(*distances.at(u, v)?) * z_mm / camera.fx;
            let weight = (1.0 - away_mm / REACH_MM).max(0.0);
            sum += weight * weight * z_mm;
            weights += weight * weight;
        }
        (weights > 0.0).then(|| Point3::from(ray * (sum / weights)).coords.map(|c| c as f32).into())
    };
    let (columns, rows) = (width.div_ceil(step), height.div_ceil(step));
    let nodes: Vec<Option<[f32; 3]>> =
        (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row))).map(|(c, r)| node(c, r)).collect();
    let mut facets = Vec::new();
    for row in 1..rows {
        for column in 1..columns {
            let at = |back: usize, up: usize| nodes[(row - up) * columns + column - back];
            // Down, then right: outward is towards the camera, which looks along z with y down.
            let triangles = [[at(1, 1), at(1, 0), at(0, 1)], [at(0, 1), at(1, 0), at(0, 0)]];
            facets.extend(triangles.into_iter().filter_map(|[a, b, c]| Some([a?, b?, c?])));
        }
    }
    facets
}

/// How deep a ray of the camera meets a surface, mm; `None`: it does not, or beyond where the surface holds.
fn met(parent: &ParentSurface, ray: &Vector3<f64>) -> Option<f64> {
    let local_from_camera = parent.camera_from_local.inverse();
    let (from, along) = (local_from_camera * Point3::origin(), local_from_camera * ray);
    let mut z_mm = -from.z / along.z;
    for _ in 0..MOST_STEPS {
        let p = from + along * z_mm;
        let slope = parent.gradient(p.x, p.y);
        let rate = along.z - slope.x * along.x - slope.y * along.y;
        let step = (p.z - parent.height_mm(p.x, p.y)) / rate;
        z_mm -= step;
        if step.abs() < MET_MM {
            let p = from + along * z_mm;
            return parent.holds_at([p.x, p.y]).then_some(z_mm).filter(|z| *z > 0.0);
        }
    }
    None
}
