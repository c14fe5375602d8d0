//! Images of a weld as colours, pixel by pixel: grey levels, depths in false colours, masks that are laid over both.

use super::colormap::viridis;
use super::palette::Rgb;
use crate::weld::masking::AreaMap;
use crate::weld::raster::{DepthImage, GreyImage, Mask, Raster};

/// A pixel without depth.
pub const NO_DEPTH: Rgb = [24, 26, 30];
/// Over what belongs to a mask; half of the image shines through.
const MASK: [u8; 4] = [255, 120, 0, 130];
/// Over areas, the first one first; the last for all that come after. Apart to colour-blind eyes.
const AREAS: [[u8; 4]; 4] = [[255, 120, 0, 130], [0, 158, 255, 130], [214, 50, 160, 130], [250, 222, 70, 130]];
/// Depths looked at for the ends of the scale.
const LOOKED_AT: usize = 20_000;

/// What the false colours of depths stand for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthScale {
    /// The nearest and the farthest depth that is told apart, mm.
    pub range_mm: [f64; 2],
    /// Units of the image to a millimetre.
    units_per_mm: f64,
}

impl DepthScale {
    /// From depth to depth of an image, but for a hundredth at each end: single flying pixels would take all colours.
    pub fn of(depth: &DepthImage, units_per_mm: f64) -> DepthScale {
        let there = |d: &f32| d.is_finite() && *d > 0.0;
        let step = depth.values.len().div_ceil(LOOKED_AT).max(1);
        let mut some: Vec<f32> = depth.values.iter().step_by(step).copied().filter(there).collect();
        some.sort_by(f32::total_cmp);
        let at = |share: f64| some.get((share * some.len().saturating_sub(1) as f64).round() as usize);
        let ends = [0.01, 0.99].map(|share| at(share).map_or(0.0, |d| f64::from(*d) / units_per_mm));
        let range_mm = if ends[1] > ends[0] { ends } else { [ends[0], ends[0] + 1.0] };
        DepthScale { range_mm, units_per_mm }
    }

    /// The depth of a pixel, mm; `None`: it has none.
    pub fn mm(&self, depth: f32) -> Option<f64> {
        (depth.is_finite() && depth > 0.0).then(|| f64::from(depth) / self.units_per_mm)
    }

    /// The colour of a depth: what is near is light.
    pub fn color(&self, mm: f64) -> Rgb {
        let [near, far] = self.range_mm;
        viridis((far - mm) / (far - near))
    }
}

/// Grey levels as colours.
pub fn gray_pixels(image: &GreyImage) -> Raster<[u8; 4]> {
    // The cast takes what is no number as 0.
    image.map(|level| {
        let level = level.round() as u8;
        [level, level, level, 255]
    })
}

/// Depths in false colours.
pub fn depth_pixels(depth: &DepthImage, scale: &DepthScale) -> Raster<[u8; 4]> {
    depth.map(|d| opaque(scale.mm(*d).map_or(NO_DEPTH, |mm| scale.color(mm))))
}

/// A mask, clear where nothing belongs to it.
pub fn mask_pixels(mask: &Mask) -> Raster<[u8; 4]> {
    mask.map(|on| if *on { MASK } else { [0; 4] })
}

/// Areas, each in a colour of its own.
pub fn areas_pixels(areas: &AreaMap) -> Raster<[u8; 4]> {
    areas.labels.map(|label| label.checked_sub(1).map_or([0; 4], |place| area_color(place as usize)))
}

/// The colour of the area at a place of the list.
pub fn area_color(place: usize) -> [u8; 4] {
    AREAS.get(place).or(AREAS.last()).copied().unwrap_or_default()
}

fn opaque([r, g, b]: Rgb) -> [u8; 4] {
    [r, g, b, 255]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_is_light_and_a_hole_is_dark() {
        let values = (0..1000).map(|i| 3000.0 + i as f32).chain([0.0, f32::NAN, 60_000.0]).collect();
        let depth = Raster { width: 1003, height: 1, values };
        let scale = DepthScale::of(&depth, 10.0);
        assert!((scale.range_mm[0] - 301.0).abs() < 0.2 && (scale.range_mm[1] - 399.0).abs() < 0.2, "{scale:?}");
        let pixels = depth_pixels(&depth, &scale);
        let gray = |i: usize| pixels.values[i][..3].iter().map(|x| u32::from(*x)).sum::<u32>();
        assert!(gray(100) > gray(500) && gray(500) > gray(900));
        assert_eq!([pixels.values[1000], pixels.values[1001]], [opaque(NO_DEPTH); 2]);
        assert_eq!(scale.mm(3000.0), Some(300.0));
    }

    #[test]
    fn levels_beyond_white_are_white_and_no_number_is_black() {
        let image = Raster { width: 4, height: 1, values: vec![-3.0, 99.6, 300.0, f32::NAN] };
        assert_eq!(gray_pixels(&image).values.iter().map(|p| p[0]).collect::<Vec<_>>(), [0, 100, 255, 0]);
    }

    #[test]
    fn a_mask_lets_the_image_shine_through_and_is_clear_elsewhere() {
        let mask = Raster { width: 2, height: 1, values: vec![true, false] };
        let pixels = mask_pixels(&mask);
        assert!((1..255).contains(&pixels.values[0][3]) && pixels.values[1][3] == 0);
        let colors: Vec<_> = (0..3).map(area_color).collect();
        assert!(colors[0] != colors[1] && colors[1] != colors[2]);
    }
}
