//! Images of a weld that are on their way into a job: the files that were picked so far, and their reading on a thread, so
//! that what cannot be used is told before anything changes, and the job knows them again. What becomes of them is in
//! `taking`.

use crate::document::files::relative_to;
use crate::document::model::{NamedImage, WeldFiles};
use crate::part::Hasher;
use crate::planning::welded::WeldError;
use crate::planning::{Executor, Failure, Stage};
use crate::progress::{Activity, Progress};
use crate::weld::camera_file;
use crate::weld::image_file::{check_pair, read_depth, read_grey};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Images that are on their way into a job.
#[derive(Default)]
pub(in super::super) struct WeldAsking {
    /// The grey image that was picked.
    pub(super) gray: Option<PathBuf>,
    /// The depth image that was picked.
    pub(super) depth: Option<PathBuf>,
    reading: Stage<GivenImages, WeldError>,
}

/// Images that can be used.
pub(super) struct GivenImages {
    gray: PathBuf,
    depth: PathBuf,
    camera: PathBuf,
    /// SHA-256 of both images, hexadecimal.
    sha256: [String; 2],
    /// A pass was ground before they were taken.
    pub is_next: bool,
}

impl WeldAsking {
    /// How far the reading is.
    pub fn progress(&self) -> Option<&Progress> {
        self.reading.progress()
    }

    /// Asks it to end: nothing is taken.
    pub fn cancel(&mut self) {
        self.reading.cancel();
    }

    /// Whether nothing is on its way.
    pub fn is_at_rest(&self) -> bool {
        !self.reading.is_running()
    }

    /// Begins to read the grey image that was picked, a depth image and a camera.
    pub(super) fn read(&mut self, [depth, camera]: [PathBuf; 2], is_next: bool, executor: &dyn Executor) {
        let Some(gray) = self.gray.take() else { return };
        self.reading.clear();
        self.reading.start(Hasher::default().finish(), Activity::ReadingImages, executor, move |progress| {
            Ok(given([gray, depth, camera], is_next, progress)?)
        });
    }

    /// The images that were read, or why they cannot be used.
    pub(super) fn taken(&mut self) -> Option<Result<GivenImages, Failure<WeldError>>> {
        self.reading.take_result()
    }
}

impl GivenImages {
    /// As a job in `job_file` names them.
    pub fn named(&self, job_file: Option<&Path>) -> WeldFiles {
        let named = |path: &Path, sha256: &str| NamedImage { file: relative_to(path, job_file), sha256: sha256.into() };
        let [gray, depth] = &self.sha256;
        WeldFiles { gray: named(&self.gray, gray), depth: named(&self.depth, depth), camera: named(&self.camera, "") }
    }
}

/// Reads images and camera, and checks them against each other.
fn given([gray, depth, camera]: [PathBuf; 3], is_next: bool, progress: &Progress) -> Result<GivenImages, WeldError> {
    let image = |e| WeldError::Image(Arc::new(e));
    let grays = read_grey(&gray, progress).map_err(image)?;
    let depths = read_depth(&depth, progress).map_err(image)?;
    check_pair(&grays.image, &depths.image).map_err(WeldError::Pair)?;
    let of = camera_file::read(&camera).map_err(|e| WeldError::CameraFile(Arc::new(e)))?;
    let file = camera.display().to_string();
    let (width, height) = (grays.image.width, grays.image.height);
    of.fits(width, height).map_err(|fault| WeldError::DepthCamera { file, fault })?;
    Ok(GivenImages { gray, depth, camera, sha256: [grays.sha256, depths.sha256], is_next })
}
