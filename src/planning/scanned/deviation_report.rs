//! How far a part is off its model, in numbers that scripts rely on: `deviation --json`, and `patches` of `report.json`.

use super::ComparedScan;
use crate::part::patched::PatchLayer;
use crate::scan::deviation::{Patch, PatchKind};
use serde::Serialize;

/// How far a part is off its model. Lengths mm, areas mm², volumes mm³, part frame.
#[derive(Clone, Debug, Serialize)]
pub struct DeviationReport {
    /// Points that lie on the model.
    pub points: usize,
    /// Points beyond a rim of the model, and points that are none of the part.
    pub points_off_model: usize,
    /// Greatest depth of a patch, 0 without one.
    pub deepest_mm: f64,
    /// Greatest surplus of a patch, 0 without one.
    pub highest_mm: f64,
    /// What is off by more is a patch.
    pub threshold_mm: f64,
    /// Mean of the signed distances, above 0 outside.
    pub mean_mm: f64,
    /// Root of their mean square.
    pub rms_mm: f64,
    /// Their standard deviation, by the median.
    pub sigma_mm: f64,
    /// Points per mm² of the model where it was scanned.
    pub density_per_mm2: f64,
    /// Area of the model without points.
    pub unscanned_mm2: f64,
    /// Patches that are too small for the scan's density, and not told.
    pub too_small: usize,
    /// What is worn or built up, the farthest off first.
    pub patches: Vec<WornPatch>,
}

/// A patch. Lengths mm, part frame.
#[derive(Clone, Debug, Serialize)]
pub struct WornPatch {
    /// `missing` or `surplus`.
    pub kind: &'static str,
    /// Area above the threshold, mm².
    pub area_mm2: f64,
    /// Greatest depth or surplus.
    pub depth_mm: f64,
    /// Volume over that area, mm³.
    pub volume_mm3: f64,
    /// Its middle.
    pub centre: [f64; 3],
    /// Where on the model it is farthest off.
    pub deepest_at: [f64; 3],
    /// The layers of beads that fill it, in the order in which they are laid; none where nothing is laid on.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<FillingLayer>,
}

/// A layer of the beads that fill a patch. Lengths mm.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct FillingLayer {
    /// It is needed where the patch is deeper than this.
    pub above_mm: f64,
    /// What it has to fill where the patch is deepest: the bead's height, and in the last layer what is left.
    pub height_mm: f64,
    /// Where it is needed, mm².
    pub area_mm2: f64,
}

impl DeviationReport {
    /// Of a comparison with this threshold.
    pub fn new(of: &ComparedScan, threshold_mm: f64) -> DeviationReport {
        let most = |kind: PatchKind| {
            let of_kind = of.patches.patches.iter().filter(|p| p.kind == kind);
            of_kind.map(|p| p.depth_mm).fold(0.0, f64::max)
        };
        let s = &of.statistics;
        DeviationReport {
            points: s.count(),
            points_off_model: s.no_model + s.far,
            deepest_mm: most(PatchKind::Missing),
            highest_mm: most(PatchKind::Surplus),
            threshold_mm,
            mean_mm: s.mean_mm,
            rms_mm: s.rms_mm,
            sigma_mm: s.sigma_mm,
            density_per_mm2: of.density_per_mm2,
            unscanned_mm2: of.unscanned_mm2,
            too_small: of.patches.too_small,
            patches: of.patches.patches.iter().map(|p| WornPatch::new(p, &[])).collect(),
        }
    }
}

impl WornPatch {
    /// Of a patch, and the layers that fill it.
    pub fn new(of: &Patch, layers: &[PatchLayer]) -> WornPatch {
        let layer =
            |l: &PatchLayer| FillingLayer { above_mm: l.above_mm, height_mm: l.height_mm, area_mm2: l.area_mm2 };
        WornPatch {
            kind: match of.kind {
                PatchKind::Missing => "missing",
                PatchKind::Surplus => "surplus",
            },
            area_mm2: of.area_mm2,
            depth_mm: of.depth_mm,
            volume_mm3: of.volume_mm3,
            centre: of.centre.coords.into(),
            deepest_at: of.deepest_at.coords.into(),
            layers: layers.iter().map(layer).collect(),
        }
    }
}
