//! Packs the job with all its files into one, to hand over. The document stays where it is kept.

use super::App;
use crate::document::files::{self, JobError, package};
use crate::part::Hasher;
use crate::picture::{part_with_lines, png, still};
use crate::planning::{Failure, PlannedJob};
use crate::progress::Activity;
use crate::text::{Sentence as _, say};
use crate::view::{HeadlessGl, StandardView};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Pixels of a package's picture.
const THUMBNAIL: [u32; 2] = [320, 240];

impl App {
    /// Whether a job that is saved under this name becomes a package: one that is kept there as it is stays so.
    pub(super) fn is_for_package(&self, path: &Path) -> bool {
        let has_ending = path.extension().is_some_and(|e| e.eq_ignore_ascii_case(package::ENDING));
        has_ending && self.document.file() != Some(path)
    }

    /// Packs the job as it is into a file.
    pub(super) fn pack(&mut self, path: PathBuf) {
        let (job, file) = (self.document.job().clone(), self.document.file().map(Path::to_path_buf));
        let planned = self.derived.current_plan(&self.document).cloned();
        let executor = self.derived.pipeline.executor().clone();
        self.session.said = say!(window_packing, file = path.display().to_string());
        self.packing.clear();
        self.packing.start(Hasher::default().finish(), Activity::Packing, &*executor, move |progress| {
            let thumbnail = planned.and_then(|planned| thumbnail(&planned));
            let refused = |e: JobError| Failure::Refused(Arc::new(e));
            let packed = package::pack(&job, file.as_deref(), thumbnail.as_deref()).map_err(refused)?;
            progress.check()?;
            files::write_atomic(&path, &packed).map_err(refused)?;
            Ok(path)
        });
    }

    /// Tells how the packing ended.
    pub(super) fn take_packed(&mut self) {
        let Some(outcome) = self.packing.take_result() else { return };
        self.session.said = String::new();
        match outcome {
            Ok(path) => {
                self.session.said = say!(window_packed, file = path.display().to_string());
                self.go_on();
            }
            Err(Failure::Cancelled) => self.session.after_guard = None,
            Err(why) => {
                self.session.after_guard = None;
                self.session.error = Some(why.sentence());
            }
        }
    }
}

/// A small picture of the planned part; none where nothing can be drawn.
fn thumbnail(planned: &PlannedJob) -> Option<Vec<u8>> {
    let gl = HeadlessGl::new().ok()?;
    let (scene, bounds) = part_with_lines(planned);
    png(&still(&gl, &scene, bounds, (StandardView::Iso, THUMBNAIL)).ok()?).ok()
}
