//! What is asked of overlap, and what it tells: where a scan lies beside the others and how sure that is, or why nowhere.

use crate::progress::Cancelled;
use crate::scan::registration::Sliding;
use nalgebra::Isometry3;

/// From where a scan is brought to the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OverlapStart {
    /// From any pose.
    Anywhere,
    /// From a `common_from_scan` that is off by 15° and a twentieth of the diagonal at the most.
    Near(Isometry3<f64>),
}

/// Where a scan lies beside the others. Lengths mm.
#[derive(Clone, Debug, PartialEq)]
pub struct OverlapFit {
    /// The motion.
    pub common_from_scan: Isometry3<f64>,
    /// Root of the mean square distance of the points that lie on the other cloud.
    pub rms_mm: f64,
    /// What is expected of it: the noise of both clouds together.
    pub noise_mm: f64,
    /// Share of the scan's points that lie on the other cloud.
    pub overlap_share: f64,
    /// Motions that the shared area does not hold, or hardly; common frame.
    pub sliding: Vec<Sliding>,
}

/// Why overlap tells no motion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum OverlapError {
    /// One of the clouds has too few.
    #[error("{found} points, {needed} needed")]
    TooFewPoints {
        /// How many there are.
        found: usize,
        /// How many there must be.
        needed: usize,
    },
    /// At the best pose too little of the scan lies on the other cloud, or too much of it beside.
    #[error("overlap {overlap_share}, of what meets {agreeing_share} agrees")]
    NoOverlap {
        /// Share of the scan's points that lie on the other cloud.
        overlap_share: f64,
        /// Share of those with a partner.
        agreeing_share: f64,
    },
    /// It fits, but further from the start that was given than that may be off.
    #[error("{moved_mm} mm and {turned_deg}° from the start")]
    FarFromStart {
        /// How far the scan's middle was moved.
        moved_mm: f64,
        /// How far it was turned.
        turned_deg: f64,
    },
    /// Several poses fit as well.
    #[error("{} poses fit as well", poses.len())]
    Ambiguous {
        /// Each of them as `common_from_scan`, the best first.
        poses: Vec<Isometry3<f64>>,
    },
    /// Somebody ended it.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for OverlapError {
    fn from(_: Cancelled) -> OverlapError {
        OverlapError::Cancelled
    }
}
