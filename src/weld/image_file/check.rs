//! Images on which nothing can be found, and pairs that do not belong together.

use crate::weld::raster::{DepthImage, GreyImage};
use thiserror::Error;

/// A level from which on a pixel is white.
const WHITE: f32 = 254.5;
/// An image with more white pixels, as a share of all, is saturated. A gloss band takes a tenth; where half is white the
/// skin itself is, and nothing can be brighter.
const MOST_WHITE: f64 = 0.5;

/// Why nothing can be found on an image.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ImageFault {
    /// It has no pixels.
    #[error("no pixels")]
    NoPixels,
    /// All pixels have one level.
    #[error("all at {level}")]
    OneLevel {
        /// Which, 0 to 255.
        level: f32,
    },
    /// The skin is white.
    #[error("{share} white")]
    Saturated {
        /// White pixels as a share of all, 0 to 1.
        share: f64,
    },
    /// No pixel has a depth.
    #[error("no depth")]
    NoDepth,
    /// The two images have different sizes.
    #[error("grey {grey:?}, depth {depth:?}")]
    SizesDiffer {
        /// Width and height of the grey image.
        grey: [usize; 2],
        /// Those of the depth image.
        depth: [usize; 2],
    },
}

/// # Errors
/// Nothing can be found on a grey image.
pub fn check_grey(image: &GreyImage) -> Result<(), ImageFault> {
    let Some(first) = image.values.first() else { return Err(ImageFault::NoPixels) };
    if image.values.iter().all(|x| x == first) {
        return Err(ImageFault::OneLevel { level: *first });
    }
    let white = image.values.iter().filter(|x| **x >= WHITE).count();
    let share = white as f64 / image.values.len() as f64;
    if share > MOST_WHITE { Err(ImageFault::Saturated { share }) } else { Ok(()) }
}

/// # Errors
/// A depth image has no depth.
pub fn check_depth(image: &DepthImage) -> Result<(), ImageFault> {
    if image.is_empty() {
        return Err(ImageFault::NoPixels);
    }
    let has_depth = image.values.iter().any(|d| d.is_finite() && *d > 0.0);
    if has_depth { Ok(()) } else { Err(ImageFault::NoDepth) }
}

/// # Errors
/// [`ImageFault::SizesDiffer`]: pixels of the one are not those of the other.
pub fn check_pair(grey: &GreyImage, depth: &DepthImage) -> Result<(), ImageFault> {
    let (grey, depth) = (grey.size(), depth.size());
    if grey == depth { Ok(()) } else { Err(ImageFault::SizesDiffer { grey, depth }) }
}
