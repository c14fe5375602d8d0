//! Images of a weld that the operator gives: grey, depth and camera, each by a dialog of its own. They are read once on a
//! thread, so that what cannot be used is told before anything changes, and the job knows them again.

use super::super::App;
use super::super::context::Context;
use super::super::dialogs::Purpose;
use super::super::session::AfterGuard;
use crate::document::files::relative_to;
use crate::document::model::{GroundPass, JobWeld, NamedImage, WeldFiles};
use crate::document::{Edit, Job, WeldEdit};
use crate::part::Hasher;
use crate::planning::welded::{WeldError, WeldReport};
use crate::planning::{Failure, Stage};
use crate::progress::{Activity, Progress};
use crate::text::{Sentence as _, say};
use crate::weld::camera_file;
use crate::weld::image_file::{check_pair, read_depth, read_grey};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Images that are on their way into a job.
#[derive(Default)]
pub(in super::super) struct WeldAsking {
    gray: Option<PathBuf>,
    depth: Option<PathBuf>,
    reading: Stage<GivenImages, WeldError>,
}

/// Images that can be used.
struct GivenImages {
    gray: PathBuf,
    depth: PathBuf,
    camera: PathBuf,
    /// SHA-256 of both images, hexadecimal.
    sha256: [String; 2],
    /// A pass was ground before they were taken.
    is_next: bool,
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
}

impl Context<'_> {
    /// Whether images that are opened begin a new job: there is no part for them, or it is the depth image of others.
    fn begins_weld(self) -> bool {
        self.derived.part.is_none() || self.document.job().is_on_depth_image()
    }
}

impl App {
    /// Asks for the images of a weld, once unsaved changes are dealt with.
    pub(in super::super) fn ask_weld(&mut self) {
        if self.context().begins_weld() && self.document.is_dirty() {
            self.session.after_guard = Some(AfterGuard::AskWeld);
        } else {
            self.ask(Purpose::WeldGray);
        }
    }

    /// Takes a file, and asks for the one after it.
    pub(in super::super) fn picked_for_weld(&mut self, purpose: Purpose, path: PathBuf) {
        match purpose {
            Purpose::WeldGray | Purpose::NextGray => {
                self.asking.gray = Some(path);
                self.ask(if purpose == Purpose::NextGray { Purpose::NextDepth } else { Purpose::WeldDepth });
            }
            Purpose::WeldDepth => {
                self.asking.depth = Some(path);
                self.ask(Purpose::WeldCamera);
            }
            Purpose::WeldCamera => {
                if let Some(depth) = self.asking.depth.take() {
                    self.read_given([depth, path], false);
                }
            }
            Purpose::NextDepth => {
                let camera = &self.document.job().weld.images.camera.file;
                let camera = crate::document::files::resolved(self.document.file(), camera);
                self.read_given([path, camera], true);
            }
            Purpose::HandEye => {
                let named = relative_to(&path, self.document.file());
                self.edit(Edit::Grind(Box::new(WeldEdit::HandEye(named))));
            }
            Purpose::GrindingTool => {
                let named = relative_to(&path, self.document.file());
                self.edit(Edit::Grind(Box::new(WeldEdit::Tool(named))));
            }
            _ => {}
        }
    }

    fn read_given(&mut self, [depth, camera]: [PathBuf; 2], is_next: bool) {
        let Some(gray) = self.asking.gray.take() else { return };
        let executor = self.derived.pipeline.executor().clone();
        let reading = &mut self.asking.reading;
        reading.clear();
        reading.start(Hasher::default().finish(), Activity::ReadingImages, &*executor, move |progress| {
            Ok(given([gray, depth, camera], is_next, progress)?)
        });
    }

    /// Takes images that were read by now into a job.
    pub(in super::super) fn take_weld_images(&mut self) {
        match self.asking.reading.take_result() {
            Some(Ok(given)) if given.is_next => self.take_next(&given),
            Some(Ok(given)) if self.context().begins_weld() => {
                let job = Job::grinding(JobWeld { images: given.named(None), ..JobWeld::default() });
                self.open_job(job);
            }
            Some(Ok(given)) => {
                let images = given.named(self.document.file());
                self.edit(Edit::Grind(Box::new(WeldEdit::Images(images))));
            }
            Some(Err(Failure::Refused(why))) => self.session.error = Some(why.sentence()),
            Some(Err(Failure::Panicked(why))) => self.session.error = Some(say!(window_fault, error = why)),
            Some(Err(Failure::Cancelled)) | None => {}
        }
    }

    /// A pass was ground: these are the images after it.
    fn take_next(&mut self, given: &GivenImages) {
        let images = self.document.job().weld.images.clone();
        let Some(planned_mm) = self.context().planned_height_mm() else { return };
        let ground = self.derived.pipeline.welded().and_then(|w| w.ground);
        let height_mm = ground.map_or(0.0, |g| g.report.max_height_mm);
        let pass = GroundPass { images, height_mm, planned_mm };
        let next = given.named(self.document.file());
        self.edit(Edit::Grind(Box::new(WeldEdit::Ground(pass, next))));
    }
}

impl Context<'_> {
    /// The height that the passes of the program should leave; `None`: nothing of it is known as the job is, or none is
    /// left.
    pub fn planned_height_mm(self) -> Option<f64> {
        let ground = self.derived.pipeline.welded()?.ground?;
        let WeldReport { schedule, .. } = &ground.report;
        let at_once = self.document.job().weld.at_once.max(1) as usize;
        schedule.iter().take(at_once).last().map(|pass| pass.level_mm)
    }
}

impl GivenImages {
    fn named(&self, job_file: Option<&Path>) -> WeldFiles {
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
