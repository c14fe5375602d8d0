//! The defect's pixels in the grey image (P4, 3): light evened out, smoothed, a threshold from the histogram's main mode,
//! opening and closing, strokes of the brush, connected areas by area × contrast, and the edges of those areas alone.
//!
//! P4 takes the histogram of the whole image as it is; under uneven light that finds nothing, so the background is taken
//! off first. Beads and ground places are brighter than the skin around them; what is darker is not looked for. Which of
//! the areas is a bead, and exactly where it ends, the depth tells better than the light: the outline here is about a
//! pixel too far out, since the threshold lies at the foot of the flank, and scratches that touch a bead go with it. Every step is kept, to be shown.

pub mod areas;
pub mod edges;
pub mod histogram;
pub mod light;
pub mod morphology;
pub mod painted;
mod rules;
pub mod smoothing;
#[cfg(test)]
mod tests;
pub mod threshold;

pub use areas::{AreaMap, DefectArea};
pub use histogram::GreyHistogram;
pub use painted::BrushStroke;
pub use rules::MaskRules;

use super::raster::{GreyImage, Mask};
use crate::progress::{Cancelled, Progress};
use thiserror::Error;

/// What was made of a grey image, step by step.
#[derive(Clone, Debug, PartialEq)]
pub struct MaskedImage {
    /// Levels less those of the background, 100 for skin without a fault.
    pub evened: GreyImage,
    /// The evened levels without noise.
    pub smoothed: GreyImage,
    /// Its levels, and what was read from them.
    pub histogram: GreyHistogram,
    /// The level that counts: from the histogram, or by hand.
    pub threshold: f64,
    /// Pixels above it.
    pub above_threshold: Mask,
    /// Those without specks and scratches.
    pub opened: Mask,
    /// With small holes filled.
    pub closed: Mask,
    /// With the strokes of the brush.
    pub painted: Mask,
    /// Its connected areas that are large enough.
    pub areas: AreaMap,
    /// Edges in and around those areas.
    pub edges: Mask,
}

/// Why there is no mask.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum MaskError {
    /// The image has no pixels, or more or fewer values than pixels.
    #[error("image of {size:?} with {values} values")]
    NoImage {
        /// Width and height.
        size: [usize; 2],
        /// How many values it has.
        values: usize,
    },
    /// The work was cancelled.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for MaskError {
    fn from(_: Cancelled) -> MaskError {
        MaskError::Cancelled
    }
}

/// Finds the bright areas of an image. That there is none is no error.
///
/// # Errors
/// It is no image, or the work was cancelled.
pub fn masked(grey: &GreyImage, rules: &MaskRules, progress: &Progress) -> Result<MaskedImage, MaskError> {
    if grey.is_empty() || !grey.is_whole() {
        return Err(MaskError::NoImage { size: grey.size(), values: grey.values.len() });
    }
    let evened = light::evened(grey, rules.even_light_px, progress)?;
    let smoothed = smoothing::smoothed(&evened, rules.smoothing_px);
    progress.check()?;
    let histogram = GreyHistogram::of(&smoothed, rules.sigmas);
    let threshold = rules.threshold.unwrap_or(histogram.threshold);
    let above_threshold = threshold::above(&smoothed, threshold);
    let opened = morphology::opened(&above_threshold, rules.opening_px, progress)?;
    let closed = morphology::closed(&opened, rules.closing_px, progress)?;
    let painted = painted::painted(&closed, &rules.painted);
    progress.check()?;
    let areas = areas::areas(&painted, &smoothed, threshold, rules.least_area_px as usize);
    progress.check()?;
    let edges = edges::edges(&smoothed, &areas.mask_of_all(), progress)?;
    Ok(MaskedImage { evened, smoothed, histogram, threshold, above_threshold, opened, closed, painted, areas, edges })
}
