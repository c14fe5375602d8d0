//! Why poses tell no camera.

use thiserror::Error;

/// Why poses tell no camera.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum HandEyeError {
    /// There are too few.
    #[error("{count} poses")]
    FewPoses {
        /// How many.
        count: usize,
    },
    /// No two of them are turned enough against each other.
    #[error("turned by {most_deg} degrees at most")]
    SmallTurns {
        /// The greatest turn between two poses, degrees.
        most_deg: f64,
    },
    /// All turns are about one axis.
    #[error("turned about {axis:?} only")]
    OneAxis {
        /// The axis in the flange's frame (camera on the hand) or the base's (camera fixed).
        axis: [f64; 3],
    },
    /// A pose that is no number, or nothing fits.
    #[error("no camera fits")]
    NoFit,
}
