//! Pixels above a level.

use crate::weld::raster::{GreyImage, Mask};

/// The pixels above a level.
pub fn above(image: &GreyImage, level: f64) -> Mask {
    let level = level as f32;
    image.map(|x| *x > level)
}
