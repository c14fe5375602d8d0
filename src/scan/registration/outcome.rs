//! What comes out of a registration: where the scan lies and how sure that is, or why it lies nowhere.

use super::{Rival, Sliding};
use crate::progress::Cancelled;
use nalgebra::Isometry3;

/// Where a scan lies on the model. Lengths mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Registration {
    /// From the scan's frame to the part's; of the fit without what is worn.
    pub model_from_scan: Isometry3<f64>,
    /// Root of the mean square of min(d, 4.685 σ), d a point's distance to the model: worn places and outliers count, but
    /// however far off they are only as the edge of the noise.
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
    /// Weighted rms at each of those, mm. It rises where the next fit takes in more points, or leaves out others.
    pub convergence_mm: Vec<f64>,
    /// Motions that nothing holds, and those that are weakly held.
    pub sliding: Vec<Sliding>,
    /// Other poses that fit nearly as well, the best first; only where it was looked for from anywhere.
    pub rivals: Vec<Rival>,
    /// The fit before what is worn was left out; `None` where nothing was.
    pub with_worn: Option<WithWorn>,
}

impl Registration {
    /// How far the part may lie off along what is weakly held, mm; 0 where all is held. What slides is not counted: it may
    /// lie anywhere.
    pub fn slack_mm(&self) -> f64 {
        self.sliding.iter().filter_map(|s| s.slack_mm).fold(0.0, f64::max)
    }
}

/// The fit of everything, worn places too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithWorn {
    /// From the scan's frame to the part's.
    pub model_from_scan: Isometry3<f64>,
    /// Share of the points that were left out afterwards.
    pub share: f64,
    /// How far that moved the corner of the model's box that it moved most, mm.
    pub moved_mm: f64,
}

/// Why a scan lies nowhere.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RegistrationError {
    /// The model has no skin.
    #[error("the model has no facet with area")]
    NoModel,
    /// Of the points not left out, too few.
    #[error("{found} points, {needed} needed")]
    TooFewPoints {
        /// How many there are.
        found: usize,
        /// How many there must be.
        needed: usize,
    },
    /// Pairs that leave the turn about a line open, or fewer than three.
    #[error("{pairs} pairs tell no motion")]
    PairsTellNoMotion {
        /// How many there are.
        pairs: usize,
    },
    /// Nothing found fits as a scan of the part would.
    #[error("not the same part: sigma {sigma_mm} mm at noise {noise_mm} mm, overlap {overlap}")]
    NotSamePart {
        /// Standard deviation of the points off the model at the best pose.
        sigma_mm: f64,
        /// That of the scan by itself, mm.
        noise_mm: f64,
        /// What the former would have had to be below, mm.
        limit_mm: f64,
        /// Share of points nearer than 3 σ.
        overlap: f64,
    },
    /// Somebody ended it.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for RegistrationError {
    fn from(_: Cancelled) -> RegistrationError {
        RegistrationError::Cancelled
    }
}
