//! What was measured of the part on the bench: clouds of points, cleaned, laid on the model, compared with it (P3).
//!
//! A cloud comes in the frame of its scan and in the unit of its file; [`mod@file`] reads it, [`cleaning`] takes out what is
//! none of the part, [`registration`] finds `model_from_scan`, [`deviation`] tells how far the part as it is lies off
//! the model, and where that is wear: a patch. Where no model exists, [`meshing`] makes one of a sound part's scan, and
//! [`continuation`] of what is left of a worn one. Lengths mm. Nothing here knows of section planes, beams or robots.

pub mod assessment;
pub mod cleaning;
pub mod cloud;
pub mod continuation;
pub mod deviation;
pub mod file;
#[cfg(test)]
pub(crate) mod made_up;
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
/// Width of Tukey's biweight in standard deviations, for 95 % of the mean's efficiency on normal noise.
pub(crate) const TUKEY: f64 = 4.685;

/// The middle one of some numbers, of two the greater; `None` without any. They change their order.
pub(crate) fn upper_median(of: &mut [f64]) -> Option<f64> {
    let middle = of.len() / 2;
    (!of.is_empty()).then(|| *of.select_nth_unstable_by(middle, f64::total_cmp).1)
}
