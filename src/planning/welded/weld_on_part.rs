//! A weld on its part, made ready for planning: where the camera's points lie, the passes, the surfaces, and what there is to
//! report.

use super::grinding::{GroundWeld, ground};
use super::on_part::{WeldPart, weld_part};
use super::{MeasuredWeld, ReadWeld, WeldError, WeldProgress, WeldReport};
use crate::cell::{Frame, Mount};
use crate::document::Job;
use crate::part::{Part, Surfaces};
use crate::progress::Progress;
use nalgebra::Isometry3;
use std::borrow::Cow;
use std::sync::Arc;

/// A weld on its part.
#[derive(Clone, Debug)]
pub struct WeldOnPart {
    /// What was measured.
    pub measured: Arc<MeasuredWeld>,
    /// The part without it.
    pub on: WeldPart,
    /// The part as it is ground.
    pub ground: GroundWeld,
    /// The passes that are left, and those that were ground.
    pub passes: WeldProgress,
    /// What there is to report.
    pub report: WeldReport,
    /// Where the camera stood in the robot's base; `None`: nobody knows.
    pub base_from_camera: Option<Isometry3<f64>>,
}

/// Puts a weld on the part. `model`: the job's part and surfaces.
///
/// # Errors
/// The camera's points lie nowhere on the part, or the work was cancelled.
pub fn weld_on_part(
    (read, measured): (&ReadWeld, &Arc<MeasuredWeld>),
    model: (&Arc<Part>, &Arc<Surfaces>),
    job: &Job,
    progress: &Progress,
) -> Result<WeldOnPart, WeldError> {
    let on = weld_part(read, measured, model, job, progress)?;
    let passes = WeldProgress::new(measured, &job.weld)?;
    let ground = ground((read, measured, &on), &passes, job, progress)?;
    let report = WeldReport::new(measured, (&on, &ground), (&passes, read.seen_from.as_ref()), job, progress)?;
    let base_from_camera = read.seen_from.as_ref().and_then(|seen| seen.base_from_camera);
    let measured = measured.clone();
    Ok(WeldOnPart { measured, on, ground, passes, report, base_from_camera })
}

impl WeldOnPart {
    /// The job with the part where the camera saw it: `base_from_part = base_from_camera · part_from_camera⁻¹`. A camera
    /// that nobody knows the place of leaves it where the job has it, and so does a part that the robot carries.
    pub fn placed<'a>(&self, job: &'a Job) -> Cow<'a, Job> {
        let Some(base_from_camera) = self.base_from_camera.filter(|_| job.cell.mount != Some(Mount::PartInHand)) else {
            return Cow::Borrowed(job);
        };
        let mut placed = job.clone();
        placed.cell.base_from_part = Some(Frame::of(&(base_from_camera * self.on.part_from_camera.inverse())));
        placed.cell.mount = Some(Mount::ToolInHand);
        Cow::Owned(placed)
    }
}
