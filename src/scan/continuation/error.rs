//! Why no surface is continued: what the sound points are not, or do not tell. The limits stand in `told`.

use crate::progress::Cancelled;
use thiserror::Error;

/// Why nothing is continued.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ContinuationError {
    /// The work was cancelled.
    #[error("cancelled")]
    Cancelled,
    /// Lists of different lengths, or a noise that is none.
    #[error("no region")]
    NoRegion,
    /// Too few finite points are sound.
    #[error("{sound} sound points")]
    TooFewPoints {
        /// How many.
        sound: usize,
    },
    /// The sound points are of no surface of this kind: they lie further off the best one than three times their
    /// noise, or a third of them lies off it; `None` where there is no best one.
    #[error("not of this kind: {rms_mm:?} mm off")]
    OtherKind {
        /// Root mean square of their distances, mm.
        rms_mm: Option<f64>,
    },
    /// The arc of sound points rises so little above its chord that its radius is anyone's guess.
    #[error("the arc rises by {rise_mm} mm")]
    ArcTooShort {
        /// Height of the arc over its chord, mm.
        rise_mm: f64,
    },
    /// The points hold the axis, or the direction, in no place.
    #[error("the axis is told to {spread_deg} degrees")]
    AxisOpen {
        /// Standard deviation of its direction, degrees.
        spread_deg: f64,
    },
    /// So far from sound points the surface might as well be elsewhere.
    #[error("told to {spread_mm} mm across the damage")]
    GapTooWide {
        /// Standard deviation of the surface at the worst of the damaged points, mm.
        spread_mm: f64,
    },
}

impl From<Cancelled> for ContinuationError {
    fn from(_: Cancelled) -> ContinuationError {
        ContinuationError::Cancelled
    }
}
