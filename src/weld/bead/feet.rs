//! The feet of an image's points on the parent surface.

use crate::weld::parent::{Foot, ParentSurface};
use crate::weld::points::PixelPoint;
use crate::weld::raster::{Mask, Raster};
use rayon::prelude::*;

/// A point, and its foot.
pub(super) type Found<'p> = (&'p PixelPoint, Foot);

/// The feet of points, in their order.
pub(super) fn feet<'p>(surface: &ParentSurface, points: &[&'p PixelPoint]) -> Vec<Found<'p>> {
    points.par_iter().map(|p| (*p, surface.foot(&p.point))).collect()
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
