//! The outline of a bead as pixels: those whose centres lie within it as the camera sees it.
//!
//! The outline stands on the parent surface, so where the camera looks past a steep flank the pixels on that flank do not
//! count.

use crate::weld::camera::DepthCamera;
use crate::weld::raster::Mask;
use nalgebra::Point3;

/// Fills a closed line of points in the camera's frame.
pub(super) fn filled(line: &[Point3<f64>], camera: &DepthCamera, width: usize, height: usize) -> Mask {
    let corners: Vec<[f64; 2]> = line.iter().filter_map(|p| camera.pixel_of(p)).collect();
    let mut values = vec![false; width * height];
    let mut crossings = Vec::new();
    for (v, row) in values.chunks_mut(width.max(1)).enumerate() {
        let v = v as f64;
        crossings.clear();
        for (k, [ua, va]) in corners.iter().enumerate() {
            let [ub, vb] = corners[(k + 1) % corners.len()];
            if (*va <= v) != (vb <= v) {
                crossings.push(ua + (ub - ua) * (v - va) / (vb - va));
            }
        }
        crossings.sort_by(f64::total_cmp);
        for pair in crossings.chunks_exact(2) {
            let from = pair[0].ceil().max(0.0) as usize;
            let end = (pair[1].ceil().max(0.0) as usize).min(width);
            if let Some(inside) = row.get_mut(from..end) {
                inside.fill(true);
            }
        }
    }
    Mask { width, height, values }
}

/// Whether a mask has pixels at the rim of its image.
pub(in crate::weld) fn touches_rim(mask: &Mask) -> bool {
    let (width, height) = (mask.width, mask.height);
    let is_rim = |i: usize| {
        let (u, v) = (i % width, i / width);
        u == 0 || v == 0 || u + 1 == width || v + 1 == height
    };
    mask.values.iter().enumerate().any(|(i, on)| *on && is_rim(i))
}
