//! A scan on its part is compared with it: how far each point is off, and which patches are worn or built up. What
//! becomes of the part is in `worn`.

use super::LaidScan;
use crate::document::model::JobScan;
use crate::progress::{Cancelled, Progress};
use crate::scan::deviation::unscanned::unscanned_mm2;
use crate::scan::deviation::{Deviation, DeviationRules, DeviationStatistics, PatchRules, Patches, SmoothedDepths};

/// What is farther off than this share of the part's diagonal is none of the part: the width from which the fine
/// registration begins, so that whatever it used is looked at.
const WITHIN_SHARE: f64 = 0.05;

/// How far a part is off its model.
#[derive(Clone, Debug)]
pub struct ComparedScan {
    /// Of each point.
    pub deviation: Deviation,
    /// Depth of each point, smoothed over its neighbours, mm; NaN where it is not on the model.
    pub depth_mm: Vec<f32>,
    /// Of all points.
    pub statistics: DeviationStatistics,
    /// What is worn, and built up, the deepest first.
    pub patches: Patches,
    /// Area of the model without points, mm².
    pub unscanned_mm2: f64,
    /// Points per mm² of the model where it was scanned.
    pub density_per_mm2: f64,
}

impl ComparedScan {
    /// How far each point is off the model, smoothed over its neighbours, mm, above 0 outside; NaN where it is not on it.
    pub fn smoothed_mm(&self) -> Vec<f32> {
        self.depth_mm.iter().map(|depth| -depth).collect()
    }
}

/// Compares a scan with the model that it was laid on.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub fn compare(laid: &LaidScan, scan: &JobScan, progress: &Progress) -> Result<ComparedScan, Cancelled> {
    let (cloud, part) = (&laid.cloud_in_part, &*laid.model.part);
    let rules = DeviationRules { within_mm: WITHIN_SHARE * part.mesh.diagonal() };
    let deviation = Deviation::new(part, cloud, &rules, progress)?;
    let depths = SmoothedDepths::new(part, cloud, &deviation, progress)?;
    let rules = PatchRules { min_depth_mm: scan.min_depth_mm, min_area_mm2: 0.0 };
    let patches = Patches::new(part, &depths, &rules, progress)?;
    let unscanned_mm2 = unscanned_mm2(part, &depths, progress)?;
    let (depth_mm, density_per_mm2) = (depths.of_points_mm(cloud.len()), depths.density_per_mm2());
    let statistics = DeviationStatistics::of(&deviation);
    Ok(ComparedScan { deviation, depth_mm, statistics, patches, unscanned_mm2, density_per_mm2 })
}
