//! What is to be known of the part's file, its surfaces as the job cuts them counted.

use crate::document::Job;
use crate::part::{Part, PartFinding, Surfaces};
use crate::progress::{Cancelled, Progress};

/// What was found in the part's file, the worst first.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn in_file(
    part: &Part,
    surfaces: &Surfaces,
    job: &Job,
    progress: &Progress,
) -> Result<Vec<PartFinding>, Cancelled> {
    // What a camera saw of a skin is open around, and says nothing of a file.
    if job.is_on_depth_image() {
        return Ok(Vec::new());
    }
    let (rule, spot_mm2) = (job.surfaces.rule(), job.beam.spot_area_mm2());
    let shattered = PartFinding::shattered(part, surfaces, &rule, spot_mm2, progress)?;
    Ok(PartFinding::with(PartFinding::of(part), shattered))
}
