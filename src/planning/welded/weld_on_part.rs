//! A weld on its part, made ready for planning: where the camera's points lie, the passes, and the surfaces.

use super::grinding::{GroundWeld, ground};
use super::on_part::{WeldPart, weld_part};
use super::{MeasuredWeld, ReadWeld, WeldError, WeldProgress};
use crate::cell::hand_eye::file::CameraStand;
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
    /// Where the camera stood; `None`: nobody knows.
    pub seen_from: Option<CameraStand>,
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
    let open = on.open_place().filter(|_| base_from_camera(read.seen_from.as_ref(), job).is_none());
    let passes = WeldProgress::new(measured, &job.weld, open)?;
    let ground = ground((read, measured, &on), &passes, job, progress)?;
    Ok(WeldOnPart { measured: measured.clone(), on, ground, passes, seen_from: read.seen_from.clone() })
}

impl WeldOnPart {
    /// The job with the part where the camera saw it: `base_from_part = base_from_camera · part_from_camera⁻¹`. A camera
    /// that nobody knows the place of leaves it where the job has it, and so does a part that the robot carries.
    pub fn placed<'a>(&self, job: &'a Job) -> Cow<'a, Job> {
        let Some(base_from_camera) = base_from_camera(self.seen_from.as_ref(), job) else { return Cow::Borrowed(job) };
        let mut placed = job.clone();
        placed.cell.base_from_part = Some(Frame::of(&(base_from_camera * self.on.part_from_camera.inverse())));
        placed.cell.mount = Some(Mount::ToolInHand);
        Cow::Owned(placed)
    }

    /// Whether the part stands in the cell where the camera saw it.
    pub fn is_placed(&self, job: &Job) -> bool {
        base_from_camera(self.seen_from.as_ref(), job).is_some()
    }
}

/// Where the camera stood, if that says where the part stands: not of a part that the robot carries.
fn base_from_camera(seen_from: Option<&CameraStand>, job: &Job) -> Option<Isometry3<f64>> {
    let seen_from = seen_from.filter(|_| job.cell.mount != Some(Mount::PartInHand));
    seen_from.and_then(|seen| seen.base_from_camera)
}
