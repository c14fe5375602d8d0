//! The stages of a job's weld: its images read, masked, measured, and the part with the areas that are ground. Each waits for
//! the one before; without a weld they are idle.

use super::super::executor::Executor;
use super::super::failure::Failure;
use super::super::key::WeldKeys;
use super::super::stage::Stage;
use super::super::welded::{
    MeasuredWeld, ReadWeld, WeldError, WeldOnPart, Welded, mask_weld, measure_weld, read_weld, weld_on_part,
};
use crate::document::Job;
use crate::part::{Part, Surfaces};
use crate::progress::{Activity, Progress};
use crate::weld::masking::MaskedImage;
use std::path::Path;
use std::sync::Arc;

/// The stages of a weld.
#[derive(Default)]
pub(super) struct WeldStages {
    pub(super) read: Stage<ReadWeld, WeldError>,
    pub(super) masked: Stage<MaskedImage, WeldError>,
    pub(super) measured: Stage<MeasuredWeld, WeldError>,
    pub(super) ground: Stage<WeldOnPart, WeldError>,
}

impl WeldStages {
    /// Takes what has arrived and starts what can be. Work that is done at once brings the next stage along.
    pub(super) fn sync(
        &mut self,
        part: &Arc<Part>,
        surfaces: &Arc<Surfaces>,
        job: &Job,
        job_file: Option<&Path>,
        keys: &WeldKeys,
        executor: &dyn Executor,
    ) {
        self.read.poll();
        if self.read.lacks(keys.read) {
            let (weld, job_file) = (job.weld.clone(), job_file.map(Path::to_path_buf));
            self.read.start(keys.read, Activity::ReadingImages, executor, move |progress| {
                Ok(read_weld(&weld, job_file.as_deref(), progress)?)
            });
        }
        let Some(read) = self.read.of(keys.read) else { return };
        self.masked.poll();
        if self.masked.lacks(keys.masked) {
            let (weld, read) = (job.weld.clone(), read.clone());
            self.masked.start(keys.masked, Activity::MaskingImage, executor, move |progress| {
                Ok(mask_weld(&read, &weld, progress)?)
            });
        }
        let Some(masked) = self.masked.of(keys.masked) else { return };
        self.measured.poll();
        if self.measured.lacks(keys.measured) {
            let (read, masked, weld) = (read.clone(), masked.clone(), job.weld.clone());
            self.measured.start(keys.measured, Activity::MeasuringBead, executor, move |progress| {
                Ok(measure_weld(&read, &masked, &weld, progress)?)
            });
        }
        let Some(measured) = self.measured.of(keys.measured) else { return };
        self.ground.poll();
        if self.ground.lacks(keys.ground) {
            let (job, read, measured) = (job.clone(), read.clone(), measured.clone());
            let (part, surfaces) = (part.clone(), surfaces.clone());
            self.ground.start(keys.ground, Activity::CuttingAreas, executor, move |progress| {
                Ok(weld_on_part((&read, &measured), (&part, &surfaces), &job, progress)?)
            });
        }
    }

    /// What there is for these keys; `None` while nothing was read.
    pub(super) fn of(&self, keys: &WeldKeys) -> Option<Welded> {
        Some(Welded {
            read: self.read.of(keys.read)?.clone(),
            masked: self.masked.of(keys.masked).cloned(),
            measured: self.measured.of(keys.measured).cloned(),
            ground: self.ground.of(keys.ground).cloned(),
        })
    }

    /// Why the weld says nothing.
    pub(super) fn failure(&self, keys: &WeldKeys) -> Option<&Failure<WeldError>> {
        let before = self.read.failure(keys.read).or_else(|| self.masked.failure(keys.masked));
        before.or_else(|| self.measured.failure(keys.measured)).or_else(|| self.ground.failure(keys.ground))
    }

    /// Whether work is going on.
    pub(super) fn is_running(&self) -> bool {
        self.progress().is_some()
    }

    /// How far it is.
    pub(super) fn progress(&self) -> Option<&Progress> {
        let before = self.read.progress().or(self.masked.progress());
        before.or(self.measured.progress()).or(self.ground.progress())
    }

    /// Ends the work.
    pub(super) fn cancel(&mut self) {
        self.read.cancel();
        self.masked.cancel();
        self.measured.cancel();
        self.ground.cancel();
    }

    /// Ends the work, and lets go of what there is: the job grinds nothing.
    pub(super) fn stop(&mut self) {
        if self.read.newest().is_some() || self.is_running() {
            self.cancel();
            *self = WeldStages::default();
        }
    }

    /// Tries again what failed.
    pub(super) fn try_again(&mut self) {
        self.read.try_again();
        self.masked.try_again();
        self.measured.try_again();
        self.ground.try_again();
    }
}
