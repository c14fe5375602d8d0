//! The feet of an image's points on the parent surface.

use super::model::BeadPoint;
use crate::weld::parent::{Foot, ParentSurface};
use crate::weld::points::PixelPoint;
use crate::weld::raster::{Mask, Raster};
use nalgebra::Point3;
use rayon::prelude::*;

/// A point, and its foot.
pub(super) type Found<'p> = (&'p PixelPoint, Foot);

/// The feet of points, in their order.
pub(super) fn feet<'p>(surface: &ParentSurface, points: &[&'p PixelPoint]) -> Vec<Found<'p>> {
    points.par_iter().map(|p| (*p, surface.foot(&p.point))).collect()
}

/// The foot of each point in the camera's frame, its local place, and its height; without those that have none.
pub(super) fn local_feet(found: &[Found<'_>]) -> Vec<(Point3<f64>, [f64; 2], f64)> {
    found.iter().filter(|(_, f)| f.is_converged).map(|(_, f)| (f.foot, f.local, f.height_mm)).collect()
}

/// The points of a bead with this outline.
pub(super) fn bead_points(found: &[Found<'_>], outline: &Mask) -> Vec<BeadPoint> {
    let inside = found.iter().filter(|(p, f)| f.is_converged && is_in(outline, p));
    let point = |(p, f): &Found<'_>| BeadPoint { pixel: p.pixel, point: p.point, foot: f.foot, height_mm: f.height_mm };
    inside.map(point).collect()
}

/// Heights by pixels; not a number where none was measured.
pub(super) fn height_raster(like: &Mask, found: &[Found<'_>]) -> Raster<f32> {
    let mut values = vec![f32::NAN; like.values.len()];
    for (p, foot) in found {
        let [u, v] = p.pixel.map(|c| c as usize);
        if let Some(into) = values.get_mut(v * like.width + u) {
            *into = foot.height_mm as f32;
        }
    }
    Raster { width: like.width, height: like.height, values }
}

/// Whether the pixel of a point belongs to a mask.
pub(super) fn is_in(mask: &Mask, p: &PixelPoint) -> bool {
    let [u, v] = p.pixel.map(|c| c as usize);
    mask.at(u, v) == Some(&true)
}
