//! How far within an outline, or without it, a place of the part lies: the distance from the border of a mask, the steps of
//! its pixels smoothed, carried onto the part by the camera.

use super::camera::DepthCamera;
use super::masking::smoothing::smoothed;
use super::pixel_distance::distances_px;
use super::raster::{Mask, Raster};
use nalgebra::Point3;

/// Distances of pixels from the border of a mask: above 0 within it, below 0 without, px.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OutlineDistance(Raster<f32>);

/// Steps of pixels are smoothed by so much, standard deviation, px: a rim of 60 pixels radius moves by 0.04, and a tool that
/// runs along it has no corners to brake for.
const SMOOTHING_PX: f64 = 2.2;
/// A border runs half a pixel beside the middles of the pixels along it.
const HALF_PX: f32 = 0.5;

impl OutlineDistance {
    /// The distances from the border of a mask. A mask without pixels has none but below 0, one that is full none but above.
    pub fn of(mask: &Mask) -> OutlineDistance {
        let without = distances_px(mask);
        let within = distances_px(&mask.map(|on| !on));
        let signed = mask.values.iter().zip(within.values.iter().zip(&without.values));
        let values = signed.map(|(on, (within, without))| if *on { within - HALF_PX } else { HALF_PX - without });
        let stepped = Raster { width: mask.width, height: mask.height, values: values.collect() };
        OutlineDistance(smoothed(&stepped, SMOOTHING_PX))
    }

    /// The distance of a place in the camera's frame, mm; `None`: it is not in the image.
    pub fn at_mm(&self, place: &Point3<f64>, camera: &DepthCamera) -> Option<f64> {
        let [u, v] = camera.pixel_of(place)?;
        let px = self.between(u, v)?;
        Some(px * place.z / (camera.fx * camera.fy).sqrt())
    }

    /// Between the middles of four pixels the distance goes over evenly.
    fn between(&self, u: f64, v: f64) -> Option<f64> {
        let (left, above) = (u.floor(), v.floor());
        if !(left >= 0.0 && above >= 0.0) {
            return None;
        }
        let at = |right: usize, below: usize| {
            self.0.at(left as usize + right, above as usize + below).map(|px| f64::from(*px))
        };
        let (s, t) = (u - left, v - above);
        let row = |below: usize| Some(at(0, below)? * (1.0 - s) + at(1, below)? * s);
        Some(row(0)? * (1.0 - t) + row(1)? * t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_border_of_a_disc_lies_at_its_radius() {
        let values = (0..60 * 80).map(|i| {
            let (u, v) = (f64::from(i % 80) - 40.0, f64::from(i / 80) - 30.0);
            u * u + v * v <= 20.0 * 20.0
        });
        let disc = OutlineDistance::of(&Mask { width: 80, height: 60, values: values.collect() });
        let camera = DepthCamera { units_per_mm: 1.0, ..DepthCamera::pinhole(200.0, 200.0, 40.0, 30.0) };
        for (r, turn) in [(8.0, 0.0), (10.3, 0.4), (19.0, 2.0), (21.5, 4.0), (26.0, 5.5)] {
            let (u, v) = (r * libm::cos(turn), r * libm::sin(turn));
            // 400 mm away two pixels are 4 mm.
            let place = Point3::new(u * 2.0, v * 2.0, 400.0);
            let found = disc.at_mm(&place, &camera).expect("in the image");
            assert!((found - (20.0 - r) * 2.0).abs() < 1.5, "{found} at {r}");
        }
        assert_eq!(disc.at_mm(&Point3::new(-90.0, 0.0, 400.0), &camera), None);
    }
}
