//! A depth image as a job's part: where no model is at hand, what the camera sees is the part, in the camera's frame. Which
//! camera took it is told by the job's weld; an image alone is none.

use super::error::JobError;
use super::paths::resolved;
use crate::document::model::Job;
use crate::part::Source;
use crate::part::raw_part::RawPart;
use crate::progress::Progress;
use crate::weld::camera_file;
use crate::weld::depth_mesh::depth_mesh;
use crate::weld::image_file::{self, ImageFileError};
use std::path::{Path, PathBuf};

impl Job {
    /// Whether its part is what the camera of its weld sees: a depth image.
    pub fn is_on_depth_image(&self) -> bool {
        let first = self.weld.history.first().map_or(&self.weld.images, |pass| &pass.images);
        self.weld.is_there() && self.part.file == first.depth.file
    }

    /// The camera that took the depth image which is its part; `None`: its part is a file like any other.
    pub fn depth_camera(&self, job_file: Option<&Path>) -> Option<PathBuf> {
        self.is_on_depth_image().then(|| resolved(job_file, &self.weld.images.camera.file))
    }
}

/// Lays facets over a depth image. `None`: the work was cancelled.
///
/// # Errors
/// Image or camera cannot be used.
pub(super) fn depth_source(file: &Path, camera: &Path, progress: &Progress) -> Result<Option<Source>, JobError> {
    let camera = camera_file::read(camera)?;
    let read = match image_file::read_depth(file, progress) {
        Err(ImageFileError::Cancelled) => return Ok(None),
        read => read?,
    };
    let raw = RawPart { facets: depth_mesh(&read.image, &camera), solids: 1, ..RawPart::default() };
    Ok(Some(Source { raw, sha256: read.sha256 }))
}
