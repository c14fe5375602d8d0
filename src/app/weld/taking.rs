//! Asks for the images of a weld, grey, then depth, then the camera, each by a dialog of its own, and takes them into a job:
//! a new one, the present one, or as the images after a pass.

use super::super::App;
use super::super::context::Context;
use super::super::dialogs::Purpose;
use super::super::session::AfterGuard;
use super::asking::GivenImages;
use crate::document::files::{relative_to, resolved};
use crate::document::model::{GroundPass, JobWeld};
use crate::document::{Edit, Job, WeldEdit};
use crate::planning::Failure;
use crate::text::{Sentence as _, say};
use std::path::PathBuf;

impl Context<'_> {
    /// Whether images that are opened begin a new job: there is no part for them, or it is the depth image of others.
    fn begins_weld(self) -> bool {
        self.derived.part.is_none() || self.document.job().is_on_depth_image()
    }

    /// The height that the passes of the program should leave; `None`: nothing of it is known as the job is, or none is
    /// left.
    pub fn planned_height_mm(self) -> Option<f64> {
        let ground = self.derived.pipeline.welded()?.ground?;
        ground.passes.levels_mm(self.document.job().weld.at_once).last().copied()
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
                let camera = resolved(self.document.file(), camera);
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

    fn read_given(&mut self, files: [PathBuf; 2], is_next: bool) {
        let executor = self.derived.pipeline.executor().clone();
        self.asking.read(files, is_next, &*executor);
    }

    /// Takes images that were read by now into a job.
    pub(in super::super) fn take_weld_images(&mut self) {
        match self.asking.taken() {
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
        let height_mm = ground.and_then(|g| Some(g.measured.bead()?.max_height_mm)).unwrap_or(0.0);
        let pass = GroundPass { images, height_mm, planned_mm };
        let next = given.named(self.document.file());
        self.edit(Edit::Grind(Box::new(WeldEdit::Ground(pass, next))));
    }
}
