//! From pixels with a depth to points (P4, Eq. 5): z = d / s, x and y along the pixel's ray.

use super::camera::DepthCamera;
use super::raster::{DepthImage, Mask};
use nalgebra::Point3;

/// A pixel and what it shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelPoint {
    /// u and v.
    pub pixel: [u32; 2],
    /// Where it is, camera frame, mm.
    pub point: Point3<f64>,
}

/// The points of the pixels that have a depth and a ray, row by row; with a mask only of those that belong to it.
pub fn points(depth: &DepthImage, camera: &DepthCamera, mask: Option<&Mask>) -> Vec<PixelPoint> {
    let taken = |u: usize, v: usize| mask.is_none_or(|m| m.at(u, v) == Some(&true));
    let point = |([u, v], units): ([usize; 2], &f32)| {
        let z = camera.depth_mm(*units).filter(|_| taken(u, v))?;
        let pixel = [u32::try_from(u).ok()?, u32::try_from(v).ok()?];
        let ray = camera.ray(u as f64, v as f64)?;
        Some(PixelPoint { pixel, point: Point3::from(ray * z) })
    };
    depth.pixels().filter_map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::weld::raster::Raster;

    #[test]
    fn only_masked_pixels_with_a_depth_become_points() {
        let camera = DepthCamera { units_per_mm: 2.0, ..DepthCamera::pinhole(10.0, 20.0, 1.0, 1.0) };
        let depth = Raster::new(3, 2, vec![0.0, 80.0, 100.0, f32::NAN, 60.0, -5.0]).expect("six");
        let all = points(&depth, &camera, None);
        let found: Vec<_> = all.iter().map(|p| (p.pixel, p.point)).collect();
        let expected = [
            ([1, 0], Point3::new(0.0, -2.0, 40.0)),
            ([2, 0], Point3::new(5.0, -2.5, 50.0)),
            ([1, 1], Point3::new(0.0, 0.0, 30.0)),
        ];
        assert_eq!(found, expected);
        let mask = Raster::new(3, 2, vec![true, false, true, true, false, true]).expect("six");
        assert_eq!(points(&depth, &camera, Some(&mask)), [all[1]]);
        assert!(points(&depth, &camera, Some(&Mask::default())).is_empty());
    }
}
