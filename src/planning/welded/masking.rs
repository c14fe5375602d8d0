//! The mask of a weld as its job wants it.

use super::{ReadWeld, WeldError};
use crate::document::model::JobWeld;
use crate::progress::Progress;
use crate::weld::masking::{MaskRules, MaskedImage, masked};
use crate::weld::raster::GreyImage;

/// Masks the grey image. That nothing stands out from the skin is told when it is to be measured: until then its steps can
/// be looked at.
///
/// # Errors
/// It is no image, or the work was cancelled.
pub fn mask_weld(read: &ReadWeld, weld: &JobWeld, progress: &Progress) -> Result<MaskedImage, WeldError> {
    masked_by(&read.grey, weld, progress)
}

/// The mask of a grey image.
pub(super) fn masked_by(grey: &GreyImage, weld: &JobWeld, progress: &Progress) -> Result<MaskedImage, WeldError> {
    masked(grey, &rules(weld), progress).map_err(WeldError::Mask)
}

fn rules(weld: &JobWeld) -> MaskRules {
    MaskRules {
        even_light_px: weld.even_light_px.round() as u32,
        smoothing_px: weld.smoothing_px,
        sigmas: weld.sigmas,
        threshold: weld.threshold,
        opening_px: weld.opening_px.round() as u32,
        closing_px: weld.closing_px.round() as u32,
        least_area_px: weld.least_area_px.round() as u32,
        painted: weld.painted.clone(),
    }
}
