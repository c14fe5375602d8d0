//! How a scan lies on the model, in numbers that scripts rely on: `register --json`, and `scan` of `report.json`.

use crate::scan::registration::{Registration, Rival, Sliding, SlidingKind, SlidingMotion, TellingPatch};
use crate::scan::transform_file;
use nalgebra::Isometry3;
use serde::Serialize;

/// How a scan lies on the model. Lengths mm, matrices row by row.
#[derive(Clone, Debug, Serialize)]
pub struct RegistrationReport {
    /// From the scan's frame to the part's.
    pub model_from_scan: [f64; 16],
    /// Root of the mean square of the distances to the model, each counted up to 4.685 σ.
    pub rms_mm: f64,
    /// Standard deviation of the points off the model, by their median.
    pub sigma_mm: f64,
    /// Noise of the scan by itself, as a standard deviation.
    pub noise_mm: f64,
    /// Share of the points nearer than 3 σ.
    pub overlap: f64,
    /// Share of the model that has points.
    pub coverage: f64,
    /// Steps of the fine fits.
    pub iterations: usize,
    /// Motions that nothing holds, and those that are weakly held.
    pub sliding: Vec<SlidingReport>,
    /// Other poses that fit nearly as well, the best first.
    pub rivals: Vec<RivalReport>,
    /// How far the fit with worn places lies off the one without, mm; null where nothing was left out.
    pub moved_by_wear_mm: Option<f64>,
    /// Where the scan stands in the robot's base; only where markers tell it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base_from_scan: Option<PlacedScan>,
}

/// A scan in the robot's base by markers that the robot touched.
#[derive(Clone, Debug, Serialize)]
pub struct PlacedScan {
    /// Row by row.
    pub base_from_scan: [f64; 16],
    /// Where the part stands by that: `base_from_scan · model_from_scan⁻¹` (P3 4.4).
    pub base_from_part: [f64; 16],
    /// How far each marker is off.
    pub residuals_mm: Vec<MarkerResidual>,
}

/// How far a marker is off what was fitted to all of them.
#[derive(Clone, Debug, Serialize)]
pub struct MarkerResidual {
    /// Its name.
    pub marker: String,
    /// Its distance.
    pub residual_mm: f64,
}

/// A motion that hardly shows in the distances.
#[derive(Clone, Debug, Serialize)]
pub struct SlidingReport {
    /// `slides` or `weakly_held`.
    pub kind: &'static str,
    /// `turn`, `shift` or `screw`.
    pub motion: &'static str,
    /// What it turns about or shifts along.
    pub axis: AxisReport,
    /// The way that makes the rms √2 σ; null where it slides.
    pub slack_mm: Option<f64>,
}

/// An axis in the part frame.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct AxisReport {
    /// A point of it.
    pub point_mm: [f64; 3],
    /// Its direction, of unit length.
    pub direction: [f64; 3],
}

/// Another pose that fits nearly as well.
#[derive(Clone, Debug, Serialize)]
pub struct RivalReport {
    /// The pose, row by row.
    pub model_from_scan: [f64; 16],
    /// As above.
    pub rms_mm: f64,
    /// Whether both are right, because the part is symmetric.
    pub same_by_symmetry: bool,
    /// Where the two can be told apart.
    pub telling: Option<TellingReport>,
}

/// Where the deviations of two poses differ most, part frame.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct TellingReport {
    /// Its middle.
    pub centre_mm: [f64; 3],
    /// Radius of a ball that holds it.
    pub radius_mm: f64,
    /// By how much the distances differ there.
    pub difference_mm: f64,
}

impl RegistrationReport {
    /// Of a registration; where the scan stands in the base is not known yet.
    pub fn new(of: &Registration) -> RegistrationReport {
        RegistrationReport {
            model_from_scan: transform_file::rows(&of.model_from_scan),
            rms_mm: of.rms_mm,
            sigma_mm: of.sigma_mm,
            noise_mm: of.noise_mm,
            overlap: of.overlap,
            coverage: of.coverage,
            iterations: of.iterations,
            sliding: of.sliding.iter().map(SlidingReport::new).collect(),
            rivals: of.rivals.iter().map(RivalReport::new).collect(),
            moved_by_wear_mm: of.with_worn.map(|w| w.moved_mm),
            base_from_scan: None,
        }
    }

    /// Whether an operator has to look before the pose is taken: it slides, or another one fits as well.
    pub fn is_in_doubt(&self) -> bool {
        self.sliding.iter().any(|s| s.kind == SLIDES) || self.rivals.iter().any(|r| !r.same_by_symmetry)
    }
}

impl PlacedScan {
    /// The scan in the base, and the part with it.
    pub fn new(
        base_from_scan: &Isometry3<f64>,
        model_from_scan: &Isometry3<f64>,
        residuals_mm: Vec<MarkerResidual>,
    ) -> PlacedScan {
        PlacedScan {
            base_from_scan: transform_file::rows(base_from_scan),
            base_from_part: transform_file::rows(&(base_from_scan * model_from_scan.inverse())),
            residuals_mm,
        }
    }
}

const SLIDES: &str = "slides";

impl SlidingReport {
    fn new(of: &Sliding) -> SlidingReport {
        SlidingReport {
            kind: match of.kind {
                SlidingKind::Slides => SLIDES,
                SlidingKind::WeaklyHeld => "weakly_held",
            },
            motion: match of.motion {
                SlidingMotion::Turn => "turn",
                SlidingMotion::Shift => "shift",
                SlidingMotion::Screw { .. } => "screw",
            },
            axis: AxisReport { point_mm: of.point.coords.into(), direction: of.direction.into() },
            slack_mm: of.slack_mm,
        }
    }
}

impl RivalReport {
    fn new(of: &Rival) -> RivalReport {
        let telling = |t: TellingPatch| TellingReport {
            centre_mm: t.centre.coords.into(),
            radius_mm: t.radius_mm,
            difference_mm: t.difference_mm,
        };
        RivalReport {
            model_from_scan: transform_file::rows(&of.model_from_scan),
            rms_mm: of.rms_mm,
            same_by_symmetry: of.same_by_symmetry,
            telling: of.telling.map(telling),
        }
    }
}
