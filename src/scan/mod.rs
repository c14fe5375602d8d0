//! What was measured of the part on the bench: clouds of points, cleaned, laid on the model, compared with it (P3).
//!
//! A cloud comes in the frame of its scan and in the unit of its file; [`mod@file`] reads it, [`cleaning`] takes out what is
//! none of the part, [`merging`] brings several into one frame, [`registration`] finds `model_from_scan`, [`deviation`]
//! tells how far the part as it is lies off the model, and where that is wear: a patch. Without a model [`slices`] cut
//! the cloud itself. Lengths mm. Nothing here knows of surfaces that are worked, beams or robots.

pub mod assessment;
pub mod cleaning;
pub mod cloud;
pub mod continuation;
pub mod deviation;
pub mod file;
#[cfg(test)]
mod made_up;
pub mod marker_file;
pub mod merging;
pub mod meshing;
pub mod neighbours;
pub mod normals;
pub mod ply_file;
pub mod registration;
pub mod slices;
pub mod transform_file;
pub mod unscanned_space;

pub use cloud::Cloud;

/// Standard deviation of normal numbers by the median of their distances from the middle.
pub(crate) const SIGMA_OF_MEDIAN: f64 = 1.4826;
