//! The steps of cleaning, as they stand in a job.

use serde::{Deserialize, Serialize};

/// One step. Lengths mm, places in the scan's frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "step", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Step {
    /// Takes out points that are far from their neighbours.
    Outliers {
        /// To how many the mean distance is measured.
        neighbours: u32,
        /// How many standard deviations above the mean of all points is too far.
        sigma: f64,
    },
    /// One point for each voxel: the mean of those in it, with normal, colour and intensity.
    Thin {
        /// Side of a voxel.
        voxel_mm: f64,
    },
    /// Moves points onto the surface that their neighbours tell, without rounding sharp edges.
    Smooth {
        /// How far a neighbour may be.
        radius_mm: f64,
        /// Standard deviation of the noise; without it the cloud's own is measured. No point moves more than 3 of it.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        noise_mm: Option<f64>,
    },
    /// Keeps what is in a box, or what is not.
    CutBox {
        /// Lowest corner.
        min: [f64; 3],
        /// Highest corner; what lies on the box's faces is inside.
        max: [f64; 3],
        /// Which side.
        keep: Keep,
    },
    /// Keeps one side of a plane, and what is in it.
    CutPlane {
        /// A point of it.
        point: [f64; 3],
        /// Points to the side that is kept; of any length.
        normal: [f64; 3],
    },
    /// Takes out what a brush went over.
    Erase {
        /// Where the brush was: middles of balls.
        centres: Vec<[f64; 3]>,
        /// Radius of the balls.
        radius_mm: f64,
    },
}

/// Which side of a box is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Keep {
    /// The points in it.
    Inside,
    /// The others.
    Outside,
}

impl Step {
    /// Outliers by 20 neighbours and 2 standard deviations: what Open3D's and PCL's examples take.
    pub const OUTLIERS: Step = Step::Outliers { neighbours: 20, sigma: 2.0 };
}
