//! The images of a job's weld and the camera that took them, read and checked against each other.

use super::WeldError;
use crate::cell::hand_eye::file::{self as hand_eye_file, CameraStand};
use crate::document::files::resolved;
use crate::document::model::{JobWeld, NamedImage, WeldFiles};
use crate::progress::Progress;
use crate::weld::camera::DepthCamera;
use crate::weld::camera_file;
use crate::weld::image_file::{self, ImageFile, ImageFileError, check_pair};
use crate::weld::raster::{DepthImage, GreyImage};
use std::path::Path;
use std::sync::Arc;

/// A grey image and a depth image of one moment.
#[derive(Clone, Debug)]
pub struct ReadWeld {
    /// Levels from 0 to 255.
    pub grey: GreyImage,
    /// Depths in the units of the file.
    pub depth: DepthImage,
    /// The camera that took both.
    pub camera: DepthCamera,
    /// The grey image and the depth image before the first pass; `None`: nothing was ground yet. They tell where the bead is,
    /// of which too little may stand by now to be found.
    pub before: Option<(GreyImage, DepthImage)>,
    /// Where it stood; `None`: nobody knows.
    pub seen_from: Option<CameraStand>,
}

/// Reads the images that a job in `job_file` names.
///
/// # Errors
/// A file cannot be used, is another one than when the job was saved, or they do not belong together.
pub fn read_weld(weld: &JobWeld, job_file: Option<&Path>, progress: &Progress) -> Result<ReadWeld, WeldError> {
    let images = &weld.images;
    let read = |named: &NamedImage, by: fn(&Path, &Progress) -> Result<ImageFile, ImageFileError>| {
        let made = by(&resolved(job_file, &named.file), progress).map_err(|e| WeldError::Image(Arc::new(e)))?;
        if !named.sha256.is_empty() && named.sha256 != made.sha256 {
            return Err(WeldError::Changed { file: named.file.clone(), sha256: made.sha256 });
        }
        Ok(made.image)
    };
    let pair = |of: &WeldFiles| {
        let (grey, depth) = (read(&of.gray, image_file::read_grey)?, read(&of.depth, image_file::read_depth)?);
        check_pair(&grey, &depth).map_err(WeldError::Pair)?;
        Ok::<_, WeldError>((grey, depth))
    };
    let (grey, depth) = pair(images)?;
    let before = weld.history.first().map(|pass| pair(&pass.images)).transpose()?;
    if let Some((first, _)) = before.as_ref().filter(|(first, _)| first.size() != grey.size()) {
        return Err(WeldError::OtherSize { before: first.size(), now: grey.size() });
    }
    let camera = camera_file::read(&resolved(job_file, &images.camera.file));
    let camera = camera.map_err(|e| WeldError::CameraFile(Arc::new(e)))?;
    let named = || images.camera.file.clone();
    camera.fits(grey.width, grey.height).map_err(|fault| WeldError::DepthCamera { file: named(), fault })?;
    let seen_from = Some(&weld.hand_eye).filter(|file| !file.is_empty());
    let seen_from = seen_from.map(|file| hand_eye_file::read(&resolved(job_file, file))).transpose();
    let seen_from = seen_from.map_err(|e| WeldError::HandEye(Arc::new(e)))?;
    Ok(ReadWeld { grey, depth, before, camera, seen_from })
}
