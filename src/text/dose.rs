//! The dose of a plan in a few lines.

use super::{NamedSentence, Naming, fixed, say};
use crate::part::SurfaceId;
use crate::planning::dose::{DoseReport, PatchReport};
use crate::process::PatchCause;

/// Patches that are listed one by one, at most.
const PATCHES_TOLD: usize = 8;

/// Shares of the area, what lands on other surfaces, and what stays unclean.
pub fn dose_lines(dose: &DoseReport, naming: &Naming<'_>) -> Vec<String> {
    let percent = |share: f64| fixed(100.0 * share, 1);
    let [within, under, over, shaded] = [dose.within, dose.under, dose.over, dose.shaded].map(percent);
    let [low, high] = [dose.low_j_cm2, dose.high_j_cm2].map(|x| fixed(x, 0));
    let mut lines = vec![say!(dose_shares, within, low, high, under, over, shaded)];
    if !dose.collateral.is_empty() {
        let list: Vec<SurfaceId> = dose.collateral.iter().map(|c| SurfaceId(c.surface)).collect();
        let (area, most) = (fixed(dose.collateral_mm2, 1), fixed(dose.collateral_j_cm2, 0));
        lines.push(say!(dose_collateral, area, most, list = naming.surfaces(&list)));
    }
    lines.extend(dose.not_cleanable.iter().take(PATCHES_TOLD).map(|p| patch(p, naming)));
    if let Some(more) = dose.not_cleanable.len().checked_sub(PATCHES_TOLD).filter(|n| *n > 0) {
        lines.push(say!(dose_patches_more, patches = more));
    }
    lines
}

fn patch(p: &PatchReport, naming: &Naming<'_>) -> String {
    let [x, y, z] = p.centre_mm.map(|x| fixed(x, 1));
    let (area, surface, why) = (fixed(p.area_cm2, 2), naming.surface(SurfaceId(p.surface)), p.sentence_with(naming));
    match p.is_thin() {
        true => say!(dose_patch_thin, area, surface, x, y, z, why),
        false => say!(dose_patch_dark, area, surface, x, y, z, why),
    }
}

/// Why it stays unclean, and what helps where that is known.
impl NamedSentence for PatchReport {
    fn sentence_with(&self, naming: &Naming<'_>) -> String {
        if let Some(mm) = self.closer_than_mm.filter(|mm| *mm >= 0.01) {
            // Rounded down: what is said has to be enough.
            return say!(patch_between_lines, spacing = fixed((100.0 * mm).floor() / 100.0, 2));
        }
        let by = self.by_surface.map(|n| naming.surface(SurfaceId(n)));
        match (self.cause, by) {
            (PatchCause::Thin, _) => say!(patch_too_little),
            (PatchCause::Missed, _) => say!(patch_missed),
            (PatchCause::Blocked, Some(by)) => say!(patch_blocked_by, by),
            (PatchCause::Blocked, None) => say!(patch_blocked),
            (PatchCause::Shaded, Some(by)) => say!(patch_shaded_by, by),
            (PatchCause::Shaded, None) => say!(patch_shaded),
        }
    }
}
