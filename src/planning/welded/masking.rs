//! The mask of a weld as its job wants it.

use super::{ReadWeld, WeldError};
use crate::document::model::JobWeld;
use crate::progress::Progress;
use crate::weld::masking::{MaskRules, MaskedImage, masked};
use crate::weld::raster::GreyImage;

/// Masks the grey image.
///
/// # Errors
/// Nothing stands out from the skin, or the work was cancelled.
pub fn mask_weld(read: &ReadWeld, weld: &JobWeld, progress: &Progress) -> Result<MaskedImage, WeldError> {
    match masked_by(&read.grey, weld, progress) {
        // Once a bead was ground down there may be nothing to see; where it was, is known.
        Err(WeldError::NoArea) if read.before.is_some() => {
            masked(&read.grey, &rules(weld), progress).map_err(WeldError::Mask)
        }
        made => made,
    }
}

/// The mask of a grey image, with one area at least.
pub(super) fn masked_by(grey: &GreyImage, weld: &JobWeld, progress: &Progress) -> Result<MaskedImage, WeldError> {
    let made = masked(grey, &rules(weld), progress).map_err(WeldError::Mask)?;
    if made.areas.list.is_empty() { Err(WeldError::NoArea) } else { Ok(made) }
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
